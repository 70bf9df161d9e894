//! Numbers as they are written: `1_000`, `-2.5e-3`, `.5`.

/// Reads a number with an optional sign. Underscores stand between digits only. `None` if the text
/// is no number; infinite if it is one too large to hold.
pub fn parse(text: &str) -> Option<f64> {
    let unsigned = text.strip_prefix(['-', '+']).unwrap_or(text);
    let (mantissa, exponent) = match unsigned.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, Some(exponent)),
        None => (unsigned, None),
    };
    let (whole, fraction) = match mantissa.split_once('.') {
        Some((whole, fraction)) => (whole, fraction),
        None => (mantissa, ""),
    };
    let grouped = |digits: &str| digits.is_empty() || are_digits(digits);
    if whole.is_empty() && fraction.is_empty() || !grouped(whole) || !grouped(fraction) {
        return None;
    }
    if exponent.is_some_and(|e| !are_digits(e.strip_prefix(['-', '+']).unwrap_or(e))) {
        return None;
    }
    text.replace('_', "").parse().ok()
}

/// Digits, in groups that single underscores separate.
fn are_digits(text: &str) -> bool {
    text.split('_')
        .all(|group| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit()))
}

/// Largest count that every number in between can be told from.
pub const LARGEST_COUNT: u64 = 1 << 53;

/// Reads a count: a whole number, also written `1e6`.
pub fn parse_count(text: &str) -> Option<u64> {
    let value = parse(text)?;
    let whole = (0.0..=LARGEST_COUNT as f64).contains(&value) && value.fract() == 0.0;
    whole.then_some(value as u64)
}

/// The shortest text that reads back as the same bits.
pub fn format(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e15 {
        format!("{value}")
    } else {
        format!("{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_forms_that_are_numbers() {
        for (text, value) in [
            ("1_000", 1000.0),
            ("-2.5e-3", -2.5e-3),
            (".5", 0.5),
            ("5.", 5.0),
            ("+1E3", 1000.0),
            ("1_0.0_1e1_0", 10.01e10),
        ] {
            assert_eq!(parse(text), Some(value), "{text}");
        }
        assert_eq!(parse("1e999"), Some(f64::INFINITY));
    }

    #[test]
    fn the_forms_that_are_none() {
        for text in [
            "", "-", ".", "_1", "1_", "1__0", "1e", "e5", "inf", "nan", "0x10", "1.2.3", "--1",
            "1e-", "1 2", "1._5",
        ] {
            assert_eq!(parse(text), None, "{text}");
        }
    }

    #[test]
    fn counts_are_whole_and_told_apart() {
        assert_eq!(parse_count("1_000"), Some(1000));
        assert_eq!(parse_count("2e6"), Some(2_000_000));
        for text in ["1.5", "-1", "1e300", "ten"] {
            assert_eq!(parse_count(text), None, "{text}");
        }
    }

    proptest! {
        #[test]
        fn every_finite_number_reads_back(value in any::<f64>().prop_filter("finite", |v| v.is_finite())) {
            let back = parse(&format(value)).map(f64::to_bits);
            prop_assert_eq!(back, Some(value.to_bits()));
        }
    }
}
