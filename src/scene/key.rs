//! What a key of a preset is: declared once, and read, checked, documented and missed by that
//! declaration.

use std::fmt;

/// One key of a section.
#[derive(Debug, PartialEq)]
pub(crate) struct Key {
    /// The key as written.
    pub(crate) name: &'static str,
    /// What its value looks like.
    pub(crate) form: Form,
    /// Unit, `-` if none.
    pub(crate) unit: &'static str,
    /// What holds when it is left out.
    pub(crate) absent: Absent,
    /// One line.
    pub(crate) summary: &'static str,
}

/// What a value looks like.
#[derive(Debug, PartialEq)]
pub(crate) enum Form {
    /// A number within bounds.
    Number(Bounds),
    /// Two numbers: a point or a vector.
    Vector,
    /// A list of points.
    Vectors,
    /// A list of numbers within bounds.
    Numbers(Bounds),
    /// A whole number between two.
    Count(u64, u64),
    /// true or false.
    Flag,
    /// Free text.
    Text,
    /// A list of texts.
    Texts,
    /// Two texts.
    TwoTexts,
    /// One of a few words.
    Word(&'static [&'static str]),
    /// Some of a few words.
    Words(&'static [&'static str]),
    /// One of a few words, or a number.
    WordOrNumber(&'static [&'static str], Bounds),
    /// A table with these keys.
    Table(&'static [Key]),
    /// A list of tables with these keys.
    Tables(&'static [Key]),
    /// A vector, or a table with these keys.
    VectorOrTable(&'static [Key]),
    /// A table of expressions under names of their own.
    Definitions,
}

/// What holds when a key is left out.
#[derive(Debug, PartialEq)]
pub(crate) enum Absent {
    /// It must be there.
    Wrong,
    /// This number.
    Number(f64),
    /// This count.
    Count(u64),
    /// This flag.
    Flag(bool),
    /// This word.
    Word(&'static str),
    /// The zero vector.
    Zero,
    /// Something that is decided elsewhere, in words.
    Said(&'static str),
}

/// The numbers that are accepted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Bounds {
    low: f64,
    high: f64,
    /// Whether `low` itself is accepted.
    low_in: bool,
    /// Whether infinities are accepted.
    infinite: bool,
}

impl Bounds {
    /// Greater than zero.
    pub(crate) const POSITIVE: Self = Self::above(0.0, f64::MAX);
    /// Zero or greater.
    pub(crate) const NOT_NEGATIVE: Self = Self::from(0.0, f64::MAX);
    /// Any finite number.
    pub(crate) const FINITE: Self = Self::from(f64::MIN, f64::MAX);
    /// Any number, infinities too.
    pub(crate) const ANY: Self = Self {
        infinite: true,
        ..Self::FINITE
    };
    /// From 0 to 1.
    pub(crate) const SHARE: Self = Self::from(0.0, 1.0);

    /// Numbers from `low` to `high`.
    pub(crate) const fn from(low: f64, high: f64) -> Self {
        Self {
            low,
            high,
            low_in: true,
            infinite: false,
        }
    }

    /// Numbers above `low` up to `high`.
    pub(crate) const fn above(low: f64, high: f64) -> Self {
        Self {
            low_in: false,
            ..Self::from(low, high)
        }
    }

    /// Whether a number is accepted.
    pub(crate) fn contains(self, value: f64) -> bool {
        if value.is_infinite() {
            return self.infinite;
        }
        let above = value > self.low || (self.low_in && value == self.low);
        above && value <= self.high
    }
}

impl fmt::Display for Bounds {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = if self.low_in { ">=" } else { ">" };
        match (self.low > f64::MIN, self.high < f64::MAX) {
            (true, true) if self.low_in => write!(f, "number from {} to {}", self.low, self.high),
            (true, true) => write!(f, "number {sign} {} and <= {}", self.low, self.high),
            (true, false) => write!(f, "number {sign} {}", self.low),
            (false, _) if self.infinite => f.write_str("number, inf or -inf"),
            (false, _) => f.write_str("finite number"),
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number(bounds) => bounds.fmt(f),
            Self::Vector => f.write_str("[number, number]"),
            Self::Vectors => f.write_str("list of points [[number, number], ...]"),
            Self::Numbers(bounds) => write!(f, "list of numbers [...], each a {bounds}"),
            Self::Count(low, u64::MAX) => write!(f, "whole number from {low} to 2^64 - 1"),
            Self::Count(low, COUNT_MAX) => write!(f, "whole number from {low} to 2^53"),
            Self::Count(low, high) => write!(f, "whole number from {low} to {high}"),
            Self::Flag => f.write_str("true or false"),
            Self::Text => f.write_str("text in quotes"),
            Self::Texts => f.write_str("list of texts [\"...\", \"...\"]"),
            Self::TwoTexts => f.write_str("list of two texts [\"...\", \"...\"]"),
            Self::Word(words) => f.write_str(&any_of(words)),
            Self::Words(words) => write!(f, "list of {}", any_of(words)),
            Self::WordOrNumber(words, bounds) => write!(f, "{} or {bounds}", any_of(words)),
            Self::Definitions => f.write_str("{ NAME = \"EXPRESSION\", ... }"),
            Self::Table(keys) => within_braces(f, keys),
            Self::VectorOrTable(keys) => {
                f.write_str("[number, number] or ")?;
                within_braces(f, keys)
            }
            Self::Tables(keys) => {
                f.write_str("list of tables [")?;
                within_braces(f, keys)?;
                f.write_str(", ...]")
            }
        }
    }
}

impl Form {
    /// The keys of the table or tables that such a value consists of.
    pub(crate) fn inner(&self) -> Option<&'static [Key]> {
        match self {
            Self::Table(keys) | Self::Tables(keys) | Self::VectorOrTable(keys) => Some(keys),
            _ => None,
        }
    }
}

/// `{ key = form, key = form }`.
fn within_braces(f: &mut fmt::Formatter<'_>, keys: &[Key]) -> fmt::Result {
    f.write_str("{ ")?;
    for (k, key) in keys.iter().enumerate() {
        let comma = if k > 0 { ", " } else { "" };
        write!(f, "{comma}{} = {}", key.name, key.form)?;
    }
    f.write_str(" }")
}

impl Key {
    /// Its form and unit: "number > 0 [m]".
    pub(crate) fn wanted(&self) -> String {
        match self.unit {
            "-" => self.form.to_string(),
            unit => format!("{} [{unit}]", self.form),
        }
    }
}

impl fmt::Display for Absent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Wrong => f.write_str("required"),
            Self::Number(number) => write!(f, "{number}"),
            Self::Count(count) => write!(f, "{count}"),
            Self::Flag(flag) => write!(f, "{flag}"),
            Self::Word(word) => write!(f, "\"{word}\""),
            Self::Zero => f.write_str("[0, 0]"),
            Self::Said(said) => f.write_str(said),
        }
    }
}

/// Largest count that a float holds exactly, so that `2e6` may stand for a count too.
pub(crate) const COUNT_MAX: u64 = 1 << 53;

/// `"a", "b" or "c"`.
fn any_of(words: &[&str]) -> String {
    let words: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    match words.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_hold_what_they_say() {
        for (bounds, said, inside, outside) in [
            (Bounds::POSITIVE, "number > 0", 1e-300, 0.0),
            (Bounds::NOT_NEGATIVE, "number >= 0", 0.0, -1e-300),
            (Bounds::SHARE, "number from 0 to 1", 1.0, 1.000_001),
            (Bounds::FINITE, "finite number", f64::MIN, f64::INFINITY),
            (Bounds::ANY, "number, inf or -inf", f64::INFINITY, f64::NAN),
            (
                Bounds::above(-1.0, 0.5),
                "number > -1 and <= 0.5",
                0.5,
                -1.0,
            ),
        ] {
            assert_eq!(bounds.to_string(), said);
            assert!(bounds.contains(inside), "{said}");
            assert!(!bounds.contains(outside), "{said}");
            assert!(!bounds.contains(f64::NAN), "{said}");
        }
    }
}
