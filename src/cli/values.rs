//! Values of options: what is taken, and what is said about the rest.

use clap::builder::RangedI64ValueParser;

use crate::engine::threads::MAX_THREADS;

/// A number of threads.
pub(super) fn threads() -> RangedI64ValueParser<u16> {
    clap::value_parser!(u16).range(1..=MAX_THREADS as i64)
}

/// A number above 0.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err("a number above 0 is expected".into()),
    }
}

/// A time that somebody waits.
pub(super) fn seconds(text: &str) -> Result<f64, String> {
    // Above this a Duration cannot hold it; some thousand years mean never just as well.
    const LONGEST: f64 = 1e11;
    positive(text).map(|seconds| seconds.min(LONGEST))
}

/// Cycles per second, or 0.
pub(super) fn pace(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok();
    let fits = |pace: &f64| *pace >= 0.0 && pace.is_finite();
    (number.filter(fits)).ok_or_else(|| "cycles per second are expected, or 0".into())
}

/// A whole number of cycles, which may be written 1e6.
pub(super) fn cycles(text: &str) -> Result<u64, String> {
    // Up to here every whole number is one of f64, too.
    const EXACT: f64 = (1_u64 << f64::MANTISSA_DIGITS) as f64;
    if let Ok(cycles) = text.parse() {
        return Ok(cycles);
    }
    let number = text.parse::<f64>().ok();
    let fits = |number: &f64| (0.0..=EXACT).contains(number) && number.fract() == 0.0;
    number
        .filter(fits)
        .map(|number| number as u64)
        .ok_or_else(|| "a whole number of cycles is expected, as 1000000 or 1e6".into())
}

/// The same, at least one.
pub(super) fn some_cycles(text: &str) -> Result<u64, String> {
    match cycles(text)? {
        0 => Err("at least one cycle is expected".into()),
        some => Ok(some),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_may_be_written_with_an_exponent() {
        for (text, expected) in [
            ("0", Some(0)),
            ("1e6", Some(1_000_000)),
            ("1.5e3", Some(1500)),
            ("18446744073709551615", Some(u64::MAX)),
            ("1e300", None),
            ("1.5", None),
            ("1e-3", None),
            ("-5", None),
            ("nan", None),
            ("inf", None),
            ("many", None),
        ] {
            assert_eq!(cycles(text).ok(), expected, "{text}");
        }
        assert!(some_cycles("0").is_err() && some_cycles("1e0") == Ok(1));
    }

    #[test]
    fn numbers_are_above_nothing_and_end_somewhere() {
        for text in ["0", "-1", "nan", "inf", "x"] {
            assert!(positive(text).is_err() && seconds(text).is_err(), "{text}");
        }
        assert_eq!(positive("1e300"), Ok(1e300));
        let longest = seconds("1e300").unwrap();
        assert!(std::time::Duration::try_from_secs_f64(longest).is_ok());
        assert_eq!(pace("0"), Ok(0.0));
        assert!(pace("-1").is_err() && pace("inf").is_err());
    }
}
