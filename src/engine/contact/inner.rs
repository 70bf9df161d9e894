//! A law's own numbers, for people: what an inspector prints beside force and overlap.

/// One of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inner {
    /// What it is.
    pub name: &'static str,
    /// What it is now.
    pub value: Value,
}

/// A number with its unit, or a word.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number and its unit, `-` if none.
    Number(f64, &'static str),
    /// A word.
    Word(&'static str),
}

impl Inner {
    /// A number.
    pub const fn number(name: &'static str, value: f64, unit: &'static str) -> Self {
        Self {
            name,
            value: Value::Number(value, unit),
        }
    }

    /// A word.
    pub const fn word(name: &'static str, word: &'static str) -> Self {
        Self {
            name,
            value: Value::Word(word),
        }
    }
}
