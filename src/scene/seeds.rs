//! Seeds of an ensemble: `1..10` means each from 1 to 10.

use std::fmt;
use std::str::FromStr;

/// More runs than this are a slip of the pen.
const MOST: u64 = 10_000;

/// A range of seeds, both ends included.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Seeds {
    first: u64,
    last: u64,
}

impl Seeds {
    /// How many there are.
    pub fn count(self) -> usize {
        (self.last - self.first) as usize + 1
    }

    /// Each of them, ascending.
    pub fn all(self) -> impl Iterator<Item = u64> {
        self.first..=self.last
    }

    /// Whether a seed is one of them.
    pub fn contains(self, seed: u64) -> bool {
        (self.first..=self.last).contains(&seed)
    }
}

impl FromStr for Seeds {
    type Err = String;

    /// `A..B`, or `A..=B` as some languages write it; the last one is always included.
    fn from_str(text: &str) -> Result<Self, String> {
        let wanted = || format!("expected FIRST..LAST, for instance 1..10, found `{text}`");
        let (first, last) = text.trim().split_once("..").ok_or_else(wanted)?;
        let last = last.strip_prefix('=').unwrap_or(last);
        let number = |text: &str| text.trim().parse::<u64>().map_err(|_| wanted());
        let (first, last) = (number(first)?, number(last)?);
        if first > last {
            return Err(format!(
                "the first seed is above the last one in `{text}`; write {last}..{first}"
            ));
        }
        if last - first >= MOST {
            return Err(format!("`{text}` are more than {MOST} seeds; name fewer"));
        }
        Ok(Self { first, last })
    }
}

impl fmt::Display for Seeds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}..{}", self.first, self.last)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_ends_are_included() {
        for (text, all, said) in [
            ("1..3", vec![1, 2, 3], "1..3"),
            ("1..=3", vec![1, 2, 3], "1..3"),
            (" 7 .. 7 ", vec![7], "7..7"),
            (
                "18446744073709551615..18446744073709551615",
                vec![u64::MAX],
                "18446744073709551615..18446744073709551615",
            ),
        ] {
            let seeds: Seeds = text.parse().unwrap();
            assert_eq!(seeds.all().collect::<Vec<u64>>(), all, "{text}");
            assert_eq!(seeds.count(), all.len());
            assert_eq!(seeds.to_string(), said);
            assert!(seeds.contains(all[0]) && !seeds.contains(all[0] - 1));
        }
    }

    #[test]
    fn what_is_no_range_is_told_so() {
        for (text, hint) in [
            ("", "1..10"),
            ("3", "1..10"),
            ("a..b", "1..10"),
            ("-1..3", "1..10"),
            ("1..", "1..10"),
            ("5..2", "write 2..5"),
            ("0..18446744073709551615", "name fewer"),
            ("1..10001", "name fewer"),
        ] {
            let error = text.parse::<Seeds>().unwrap_err();
            assert!(error.contains(hint), "{text}: {error}");
        }
        assert!("1..10000".parse::<Seeds>().is_ok());
    }
}
