//! Numbers as people read them: six significant digits, nothing after them that says nothing.
//!
//! For tables and replies only. What is read back by a machine keeps all its digits: see
//! `record::number` and `language::number`.

/// Widest text that [`figure`] gives [characters].
pub const WIDEST: usize = 12;

/// Decimal exponents between which a number is written without one.
const PLAIN: std::ops::RangeInclusive<i32> = -4..=5;

/// Six significant digits in the shortest form: `0.1`, `19681.7`, `1.35e9`, `-3.18310e-6` without
/// its zero. Undefined is `nan`.
pub fn figure(x: f64) -> String {
    if x.is_nan() {
        return "nan".into();
    }
    if x.is_infinite() {
        return if x > 0.0 { "inf" } else { "-inf" }.into();
    }
    if x == 0.0 {
        return "0".into();
    }
    let text = with_digits(x, 5);
    if text.len() > WIDEST {
        with_digits(x, 4)
    } else {
        text
    }
}

/// Three significant digits, for what is not known better: times, rates, errors.
pub fn rough(x: f64) -> String {
    let rounded = format!("{x:.2e}").parse();
    figure(rounded.unwrap_or(x))
}

/// Two figures with a blank between them, as commands take them.
pub fn vector(v: [f64; 2]) -> String {
    format!("{} {}", figure(v[0]), figure(v[1]))
}

/// A share as per cent, `7.25 %`.
pub fn per_cent(share: f64) -> String {
    format!("{} %", figure(100.0 * share))
}

/// One digit before the point of the exponential form, so many after it.
fn with_digits(x: f64, after: u8) -> String {
    // Rounding first: 999999.7 has an exponent more than it seems.
    let scientific = format!("{x:.*e}", usize::from(after));
    let Some((mantissa, exponent)) = scientific.split_once('e') else {
        return scientific;
    };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if PLAIN.contains(&exponent) {
        let decimals = (i32::from(after) - exponent).max(0) as usize;
        trimmed(&format!("{x:.decimals$}")).to_owned()
    } else {
        format!("{}e{exponent}", trimmed(mantissa))
    }
}

fn trimmed(text: &str) -> &str {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.')
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn figures_are_short() {
        for (x, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-0.1, "-0.1"),
            (19_681.690_113_816, "19681.7"),
            (636.619_772_367, "636.62"),
            (1.35e9, "1.35e9"),
            (100_000.0, "100000"),
            (999_999.4, "999999"),
            (999_999.7, "1e6"),
            (1_234_567.0, "1.23457e6"),
            (0.000_123_456_78, "0.000123457"),
            (0.000_099_999_99, "0.0001"),
            (0.000_012_3, "1.23e-5"),
            (3.183_098_861_8e-6, "3.1831e-6"),
            (-1.234_567_8e-100, "-1.2346e-100"),
            (f64::MAX, "1.79769e308"),
            (-f64::MAX, "-1.79769e308"),
            (f64::NAN, "nan"),
            (f64::NEG_INFINITY, "-inf"),
        ] {
            assert_eq!(figure(x), text);
        }
        assert_eq!(rough(0.012_349), "0.0123");
        assert_eq!(rough(-9_996_000.0), "-1e7");
        assert_eq!(rough(f64::NAN), "nan");
        assert_eq!(vector([0.5, -2e-9]), "0.5 -2e-9");
        assert_eq!(per_cent(0.0725), "7.25 %");
    }

    proptest! {
        #[test]
        fn figures_fit_and_lose_no_more_than_they_say(x in any::<f64>()) {
            let text = figure(x);
            prop_assert!(text.len() <= WIDEST, "{}", text);
            if x.is_normal() {
                let back: f64 = text.parse().unwrap();
                // Half a unit of the sixth digit; of the fifth where the exponent takes room. Halved
                // first, for the largest numbers round to infinity otherwise.
                prop_assert!((back / 2.0 - x / 2.0).abs() <= 2.5e-5 * x.abs() + 1e-320, "{}", text);
                prop_assert!(x.abs() < 1e-99 || x.abs() > 1e99
                    || (back - x).abs() <= 5.01e-6 * x.abs(), "{}", text);
            }
        }
    }
}
