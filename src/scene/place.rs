//! Where something stands: in the preset or in an option that overrides it.

use std::ops::Range;

/// A text that values come from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Source {
    /// What a report calls it: a path, the name of an embedded preset, `--set`.
    pub(crate) title: String,
    /// All of it.
    pub(crate) text: String,
}

/// A stretch of one of the sources.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Place {
    /// Index of the source; the preset is 0.
    pub(crate) source: usize,
    /// First byte.
    pub(crate) start: usize,
    /// Byte after the last.
    pub(crate) end: usize,
}

impl Place {
    /// A stretch of a source.
    pub(crate) fn new(source: usize, span: Range<usize>) -> Self {
        Self {
            source,
            start: span.start,
            end: span.end.max(span.start),
        }
    }

    /// The place as it is written, quotes included; nothing if it lies outside its text.
    pub(crate) fn written(self, sources: &[Source]) -> &str {
        sources
            .get(self.source)
            .and_then(|source| source.text.get(self.start..self.end))
            .unwrap_or_default()
    }

    /// The part of a quoted text that a parser complains about. Only a text without escapes is
    /// the same inside and outside of the quotes; any other is pointed at as a whole.
    pub(crate) fn within(self, value: &str, part: Range<usize>, sources: &[Source]) -> Self {
        match self.written(sources).find(value) {
            Some(offset) if !value.is_empty() => {
                let first = self.start + offset;
                let start = first + part.start.min(value.len());
                let end = first + part.end.clamp(part.start, value.len().max(part.start));
                Self::new(self.source, start..end)
            }
            _ => self,
        }
    }
}

/// User text for a message: quoted, cut to a length that fits a line, without control characters.
pub(crate) fn quoted(text: &str) -> String {
    const LONGEST: usize = 40;
    let mut shown: String = text
        .chars()
        .take(LONGEST)
        .map(|c| if c.is_control() { '?' } else { c })
        .collect();
    if text.chars().nth(LONGEST).is_some() {
        shown.push_str("...");
    }
    format!("`{shown}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(text: &str) -> Vec<Source> {
        vec![Source {
            title: "t".into(),
            text: text.into(),
        }]
    }

    #[test]
    fn a_word_inside_a_quoted_text_is_found() {
        let sources = source(r#"until = "cycle > tme""#);
        let whole = Place::new(0, 8..21);
        assert_eq!(
            whole
                .within("cycle > tme", 8..11, &sources)
                .written(&sources),
            "tme"
        );
    }

    #[test]
    fn a_text_with_escapes_is_shown_whole() {
        let sources = source(r#"until = "cycle \u003e 1""#);
        let whole = Place::new(0, 8..24);
        assert_eq!(whole.within("cycle > 1", 0..5, &sources), whole);
    }

    #[test]
    fn user_text_is_cut_and_cleaned() {
        assert_eq!(quoted("a\u{1b}[2J"), "`a?[2J`");
        assert!(quoted(&"x".repeat(1000)).len() < 60);
    }
}
