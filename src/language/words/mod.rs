//! Takes a line apart, word by word, as the verbs ask for them.
//!
//! The verbs say what they expect, so the same code that reads a line also knows, at its end, what
//! could come next: that is where completions come from.

mod keywords;
mod values;

use super::definition::Definitions;
use super::list::{self, Card};
use super::mistake::{Mistake, shown};
use super::number;
use std::borrow::Cow;
use std::ops::Range;

/// A word and the bytes it was read from. Quotes belong to the bytes, not to the text.
#[derive(Debug, Clone)]
struct Word<'a> {
    text: Cow<'a, str>,
    span: Range<usize>,
}

/// What could stand where the line ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Wanted {
    /// A command.
    Verb,
    /// One of these words.
    Keyword(&'static str),
    /// The name of a wall.
    Wall,
    /// The name of a region.
    Region,
    /// The name of a material.
    Material,
    /// The name of a column.
    Column,
    /// A variable of an expression that is no column.
    Variable,
}

/// A line that is being read.
#[derive(Debug)]
pub struct Words<'a> {
    /// The line without its comment.
    line: &'a str,
    at: usize,
    verb: &'a str,
    usage: &'static str,
    wanted: Vec<Wanted>,
    /// Columns that the preset makes itself.
    definitions: &'a Definitions,
}

impl<'a> Words<'a> {
    /// Begins to read a line. Fails if a quote is left open or nothing is there to read.
    pub(crate) fn new(line: &'a str, definitions: &'a Definitions) -> Result<Self, Mistake> {
        let mut words = Self {
            line,
            at: 0,
            verb: "",
            usage: "",
            wanted: Vec::new(),
            definitions,
        };
        words.cut_comment()?;
        Ok(words)
    }

    /// Reads the verb.
    pub(crate) fn card(&mut self) -> Result<&'static Card, Mistake> {
        let start = self.skip_space();
        let end = self.line[start..]
            .find(char::is_whitespace)
            .map_or(self.line.len(), |length| start + length);
        if start == end {
            self.wanted.push(Wanted::Verb);
            return Err(Mistake::new(
                "the line is empty",
                "write a command, or `help` for the list",
                start..start,
            ));
        }
        self.verb = &self.line[start..end];
        self.at = end;
        let card = list::find(self.verb, start..end)?;
        self.usage = card.usage;
        Ok(card)
    }

    /// The verb as it was typed.
    pub(crate) fn verb(&self) -> &'a str {
        self.verb
    }

    /// What could stand at the end of the line.
    pub(crate) fn wanted(self) -> Vec<Wanted> {
        self.wanted
    }

    /// Finds where the line ends: at a `#` outside quotes.
    fn cut_comment(&mut self) -> Result<(), Mistake> {
        if self.line.trim().contains('\n') {
            return Err(Mistake::new(
                "the text has several lines",
                "write one command in a line",
                0..self.line.len(),
            ));
        }
        let bytes = self.line.as_bytes();
        let mut at = 0;
        let mut opened = None;
        while at < bytes.len() {
            match (bytes[at], opened) {
                (b'\\', Some(_)) => at += 1,
                (b'"', Some(_)) => opened = None,
                (b'"', None) => opened = Some(at),
                (b'#', None) => break,
                _ => {}
            }
            at += 1;
        }
        if let Some(opened) = opened {
            let span = opened..opened + 1;
            return Err(Mistake::new("this quote is never closed", "add `\"`", span));
        }
        self.line = &self.line[..at.min(bytes.len())];
        Ok(())
    }

    fn skip_space(&mut self) -> usize {
        let rest = &self.line[self.at..];
        self.at += rest.len() - rest.trim_start().len();
        self.at
    }

    /// Where the next word begins, if there is one.
    fn peek(&mut self) -> Option<&'a str> {
        let start = self.skip_space();
        let rest = &self.line[start..];
        (!rest.is_empty()).then_some(rest)
    }

    /// The next word, or a mistake that says what it should have been.
    fn word(&mut self, what: &str) -> Result<Word<'a>, Mistake> {
        let Some(rest) = self.peek() else {
            return Err(self.missing(what));
        };
        let start = self.at;
        let (text, length) = if let Some(quoted) = rest.strip_prefix('"') {
            unquoted(quoted)
        } else {
            let length = rest.find(char::is_whitespace).unwrap_or(rest.len());
            (Cow::Borrowed(&rest[..length]), length)
        };
        self.at = start + length;
        Ok(Word {
            text,
            span: start..self.at,
        })
    }

    fn missing(&self, what: &str) -> Mistake {
        let end = self.line.trim_end().len();
        Mistake::new(
            format!("the line ends where {what} is expected"),
            format!("usage: {}", self.usage),
            end..end,
        )
    }

    fn refused(&self, word: &Word<'_>, why: &str, what: &str) -> Mistake {
        Mistake::new(
            format!("{} {why} where {what} is expected", shown(&word.text)),
            format!("usage: {}", self.usage),
            word.span.clone(),
        )
    }

    fn out_of_range(what: &str, word: &Word<'_>, needed: &str) -> Mistake {
        Mistake::new(
            format!("{what} is {}", shown(&word.text)),
            format!("it must be {needed}"),
            word.span.clone(),
        )
    }

    /// Whether the line is read to its end.
    pub(crate) fn is_at_end(&mut self) -> bool {
        self.peek().is_none()
    }

    /// Refuses whatever is left of the line.
    pub(crate) fn end(&mut self) -> Result<(), Mistake> {
        if self.is_at_end() {
            return Ok(());
        }
        let word = self.word("nothing")?;
        Err(Mistake::new(
            format!("{} is one word too many", shown(&word.text)),
            format!("usage: {}", self.usage),
            word.span,
        ))
    }

    /// The byte that is read next.
    pub(crate) fn position(&mut self) -> usize {
        self.skip_space()
    }

    /// Whether the next word is a number.
    pub(crate) fn is_at_number(&mut self) -> bool {
        self.peek().is_some_and(|rest| {
            let word = rest.split_whitespace().next().unwrap_or("");
            number::parse(word).is_some()
        })
    }
}

/// The text up to the closing quote, and how many bytes it takes with both quotes. A backslash
/// stands before a quote or another backslash; elsewhere it is itself.
fn unquoted(rest: &str) -> (Cow<'_, str>, usize) {
    let mut text = String::new();
    let mut letters = rest.char_indices();
    while let Some((at, c)) = letters.next() {
        match c {
            '"' => return (Cow::Owned(text), at + 2),
            '\\' if letters.as_str().starts_with(['"', '\\']) => {
                text.extend(letters.next().map(|(_, c)| c));
            }
            _ => text.push(c),
        }
    }
    // Open quotes were refused before.
    (Cow::Owned(text), rest.len() + 1)
}

/// A word as it has to be written to be read as one.
pub(crate) fn quoted(word: &str) -> Cow<'_, str> {
    let plain = |c: char| !c.is_whitespace() && !matches!(c, '"' | '#' | '\\');
    if word.chars().all(plain) {
        return Cow::Borrowed(word);
    }
    let escaped = word.replace('\\', "\\\\").replace('"', "\\\"");
    Cow::Owned(format!("\"{escaped}\""))
}
