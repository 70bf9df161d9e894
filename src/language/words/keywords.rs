//! The fixed words of a line, in any case and shortened as long as one of them fits only.

use super::{Wanted, Words};
use crate::language::list::{self, Card};
use crate::language::mistake::{Mistake, either, shown};
use crate::measure::columns::near;
use std::borrow::Cow;

impl Words<'_> {
    /// One of these words or a prefix that fits one only.
    pub(crate) fn keyword(&mut self, options: &[&'static str]) -> Result<&'static str, Mistake> {
        self.keyword_of(options, &either(options))
    }

    /// The same where something else could stand as well; `what` names all of it.
    pub(crate) fn keyword_of(
        &mut self,
        options: &[&'static str],
        what: &str,
    ) -> Result<&'static str, Mistake> {
        if self.is_at_end() {
            self.wanted
                .extend(options.iter().map(|option| Wanted::Keyword(option)));
            return Err(self.missing(what));
        }
        let mut word = self.word("")?;
        // `until(cycle > 3)`: no keyword holds a parenthesis, so one begins what follows.
        if let Cow::Borrowed(text) = word.text
            && let Some(length) = text.find('(').filter(|length| *length > 0)
        {
            self.at = word.span.start + length;
            word.span.end = self.at;
            word.text = Cow::Borrowed(&text[..length]);
        }
        let typed = word.text.to_lowercase();
        let fits: Vec<&'static str> = match options.iter().find(|option| **option == typed) {
            Some(exact) => vec![exact],
            None => options
                .iter()
                .copied()
                .filter(|option| option.starts_with(&typed))
                .collect(),
        };
        match fits.as_slice() {
            [one] => Ok(one),
            [] => Err(match near(&typed, options.iter().copied()) {
                Some(best) => Mistake::new(
                    format!("{} is not known here", shown(&word.text)),
                    format!("did you mean `{best}`?"),
                    word.span,
                ),
                None => self.refused(&word, "stands", what),
            }),
            several => Err(Mistake::new(
                format!("{} could be {}", shown(&word.text), either(several)),
                "write more of it",
                word.span,
            )),
        }
    }

    /// What belongs to the one of these words that is typed.
    pub(crate) fn choose<T: Copy>(&mut self, options: &[(&'static str, T)]) -> Result<T, Mistake> {
        let keywords: Vec<&'static str> = options.iter().map(|(word, _)| *word).collect();
        let typed = self.keyword(&keywords)?;
        let chosen = options.iter().find(|(word, _)| *word == typed);
        Ok(chosen.expect("`keyword` returns one of its options").1)
    }

    /// The same where the line may also end.
    pub(crate) fn choose_if_any<T: Copy>(
        &mut self,
        options: &[(&'static str, T)],
    ) -> Result<Option<T>, Mistake> {
        if !self.is_at_end() {
            return self.choose(options).map(Some);
        }
        self.wanted
            .extend(options.iter().map(|(word, _)| Wanted::Keyword(word)));
        Ok(None)
    }

    /// A command, where the line may also end.
    pub(crate) fn command_if_any(&mut self) -> Result<Option<&'static Card>, Mistake> {
        if self.is_at_end() {
            self.wanted.push(Wanted::Verb);
            return Ok(None);
        }
        let word = self.word("a command")?;
        list::find(&word.text, word.span).map(Some)
    }

    /// One of these words, where the line may also end.
    pub(crate) fn optional_keyword(
        &mut self,
        options: &[&'static str],
    ) -> Result<Option<&'static str>, Mistake> {
        if !self.is_at_end() {
            return match options {
                [] => self.end().map(|()| None),
                _ => self.keyword(options).map(Some),
            };
        }
        self.wanted
            .extend(options.iter().map(|option| Wanted::Keyword(option)));
        Ok(None)
    }

    /// One of the options that has not been given yet, taken off the list.
    pub(crate) fn next_option(
        &mut self,
        left: &mut Vec<&'static str>,
    ) -> Result<Option<&'static str>, Mistake> {
        let option = self.optional_keyword(left)?;
        left.retain(|word| Some(*word) != option);
        Ok(option)
    }
}
