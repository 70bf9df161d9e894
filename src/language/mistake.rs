//! What is wrong with a line or an expression, where, and what would be right.

use std::ops::Range;

/// How much of a wrong word is repeated back: noise must not flood the screen.
const LONGEST_SHOWN: usize = 40;

/// A text that cannot be understood.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}; {remedy}")]
pub struct Mistake {
    /// What is wrong.
    pub message: String,
    /// What would be right.
    pub remedy: String,
    /// The bytes of the text it is about; empty where something is missing.
    pub span: Range<usize>,
}

impl Mistake {
    /// A mistake at these bytes of the text.
    pub fn new(message: impl Into<String>, remedy: impl Into<String>, span: Range<usize>) -> Self {
        Self {
            message: message.into(),
            remedy: remedy.into(),
            span,
        }
    }

    /// The same mistake in a longer text, of which this one begins at byte `by`.
    #[must_use]
    pub fn moved(self, by: usize) -> Self {
        Self {
            span: self.span.start + by..self.span.end + by,
            ..self
        }
    }
}

/// A word in backticks, shortened and without control characters.
pub(crate) fn shown(word: &str) -> String {
    let mut letters = word.chars();
    let mut text: String = letters
        .by_ref()
        .take(LONGEST_SHOWN)
        .map(|c| if c.is_control() { '\u{fffd}' } else { c })
        .collect();
    if letters.next().is_some() {
        text.push_str("...");
    }
    format!("`{text}`")
}

/// "`a`, `b` or `c`".
pub(crate) fn either(options: &[&str]) -> String {
    match options {
        [] => "nothing".into(),
        [one] => format!("`{one}`"),
        [most @ .., last] => format!("`{}` or `{last}`", most.join("`, `")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_and_unprintable_words_are_tamed() {
        assert_eq!(shown("cyc\u{7}le"), "`cyc\u{fffd}le`");
        assert_eq!(shown(&"x".repeat(1000)).len(), LONGEST_SHOWN + 5);
    }

    #[test]
    fn options_read_as_a_sentence() {
        assert_eq!(either(&["on", "off"]), "`on` or `off`");
        assert_eq!(either(&["a", "b", "c"]), "`a`, `b` or `c`");
    }

    #[test]
    fn moving_keeps_the_length() {
        let mistake = Mistake::new("a", "b", 2..5).moved(10);
        assert_eq!(mistake.span, 12..15);
        assert_eq!(mistake.to_string(), "a; b");
    }
}
