//! Numbers as text. The same bits always give the same characters, and the characters give the same
//! bits back: the shortest decimal that reads back as itself. Undefined is `nan`, never nothing.

use std::borrow::Cow;

/// One cell of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell<'a> {
    /// A real number; undefined is `nan`.
    Real(f64),
    /// A whole number.
    Count(u64),
    /// A hash, shown as sixteen hexadecimal digits.
    Hash(u64),
    /// A name.
    Text(Cow<'a, str>),
}

impl<'a> Cell<'a> {
    /// What stands in the file, before any quoting.
    pub fn text(&self) -> Cow<'_, str> {
        match self {
            Self::Real(value) => Cow::Owned(real(*value)),
            Self::Count(value) => Cow::Owned(value.to_string()),
            Self::Hash(value) => Cow::Owned(format!("{value:016x}")),
            Self::Text(text) => Cow::Borrowed(text),
        }
    }

    /// A cell that holds a name.
    pub fn name(text: impl Into<Cow<'a, str>>) -> Self {
        Self::Text(text.into())
    }
}

/// Shortest text that reads back as the same number: `0.1`, `1e-9`, `-0.0`, `inf`, `nan`.
pub fn real(value: f64) -> String {
    if value.is_nan() {
        "nan".to_owned()
    } else {
        // Debug, not Display: Display writes 1e300 with three hundred zeros.
        format!("{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn special_values_have_names() {
        for (value, text) in [
            (f64::NAN, "nan"),
            (-f64::NAN, "nan"),
            (f64::INFINITY, "inf"),
            (f64::NEG_INFINITY, "-inf"),
            (-0.0, "-0.0"),
            (0.1, "0.1"),
            (3.0, "3.0"),
            (1e-9, "1e-9"),
            (1e300, "1e300"),
            (f64::from_bits(1), "5e-324"),
        ] {
            assert_eq!(real(value), text);
        }
    }

    #[test]
    fn counts_and_hashes_are_whole() {
        assert_eq!(Cell::Count(u64::MAX).text(), "18446744073709551615");
        assert_eq!(Cell::Hash(0xbeef).text(), "000000000000beef");
        assert_eq!(Cell::name("shear").text(), "shear");
    }

    proptest! {
        #[test]
        fn every_number_reads_back_as_its_own_bits(bits in any::<u64>()) {
            let value = f64::from_bits(bits);
            let back: f64 = real(value).parse().unwrap();
            prop_assert!(back.to_bits() == bits || value.is_nan() && back.is_nan());
        }
    }
}
