//! The values a line can hold: numbers, particles, names, columns, conditions.

use super::{Wanted, Word, Words};
use crate::language::command::ParticleRange;
use crate::language::expression::Expression;
use crate::language::mistake::{Mistake, shown};
use crate::language::name::{is_name, no_name, no_wall_name};
use crate::language::number;
use crate::language::observable::Observable;
use crate::measure::columns::Partner;

impl<'a> Words<'a> {
    fn numeral(&mut self, what: &str) -> Result<(f64, Word<'a>), Mistake> {
        let word = self.word(what)?;
        match number::parse(&word.text) {
            // Adding 0 makes -0 an ordinary 0: the canonical line leaves zeros out.
            Some(value) if value.is_finite() => Ok((value + 0.0, word)),
            Some(_) => Err(Self::out_of_range(what, &word, "at most about 1.8e308")),
            None => Err(self.refused(&word, "is no number", what)),
        }
    }

    /// A finite number.
    pub(crate) fn number(&mut self, what: &str) -> Result<f64, Mistake> {
        self.numeral(what).map(|(value, _)| value)
    }

    /// A number that satisfies a condition, described in words.
    pub(crate) fn number_that(
        &mut self,
        what: &str,
        needed: &str,
        fits: fn(f64) -> bool,
    ) -> Result<f64, Mistake> {
        let (value, word) = self.numeral(what)?;
        if fits(value) {
            Ok(value)
        } else {
            Err(Self::out_of_range(what, &word, needed))
        }
    }

    /// A number greater than 0.
    pub(crate) fn positive(&mut self, what: &str) -> Result<f64, Mistake> {
        self.number_that(what, "greater than 0", |v| v > 0.0)
    }

    /// A number that is 0 or greater.
    pub(crate) fn not_negative(&mut self, what: &str) -> Result<f64, Mistake> {
        self.number_that(what, "0 or greater", |v| v >= 0.0)
    }

    /// A number from 0 to 1.
    pub(crate) fn fraction(&mut self, what: &str) -> Result<f64, Mistake> {
        self.number_that(what, "between 0 and 1", |v| (0.0..=1.0).contains(&v))
    }

    /// Two numbers, for the directions 1 and 2.
    pub(crate) fn vector(&mut self, what: &str) -> Result<[f64; 2], Mistake> {
        let x = self.number(&format!("{what} in x"))?;
        let y = self.number(&format!("{what} in y"))?;
        Ok([x, y])
    }

    /// A whole number from 1 to a limit.
    pub(crate) fn count_up_to(&mut self, what: &str, most: u64) -> Result<u64, Mistake> {
        self.skip_space();
        let start = self.at;
        let count = self.count(what)?;
        if count <= most {
            return Ok(count);
        }
        let message = format!("{what} is `{count}`");
        Err(Mistake::new(
            message,
            format!("it must be at most {most}"),
            start..self.at,
        ))
    }

    /// A whole number from 1.
    pub(crate) fn count(&mut self, what: &str) -> Result<u64, Mistake> {
        let (value, word) = self.numeral(what)?;
        match number::parse_count(&word.text) {
            Some(count) if count > 0 => Ok(count),
            _ if value >= 1.0 && value.fract() == 0.0 => {
                Err(Self::out_of_range(what, &word, "at most 9007199254740992"))
            }
            _ => Err(Self::out_of_range(what, &word, "a whole number from 1")),
        }
    }

    /// The number of a particle.
    pub(crate) fn particle(&mut self) -> Result<u32, Mistake> {
        let word = self.word("a particle number")?;
        self.particle_number(&word.text, &word)
    }

    fn particle_number(&self, text: &str, word: &Word<'_>) -> Result<u32, Mistake> {
        match number::parse_count(text).map(u32::try_from) {
            Some(Ok(id)) if id > 0 => Ok(id),
            Some(_) => Err(Mistake::new(
                format!("{} is no particle number", shown(text)),
                format!("particles are numbered from 1 to at most {}", u32::MAX),
                word.span.clone(),
            )),
            None => Err(self.refused(word, "stands", "a particle number")),
        }
    }

    /// One particle or a range of them.
    pub(crate) fn particles(&mut self) -> Result<ParticleRange, Mistake> {
        let word = self.word("a particle number or a range I-J")?;
        let Some((first, last)) = word.text.split_once('-') else {
            let id = self.particle_number(&word.text, &word)?;
            return Ok(ParticleRange {
                first: id,
                last: id,
            });
        };
        let range = ParticleRange {
            first: self.particle_number(first, &word)?,
            last: self.particle_number(last, &word)?,
        };
        if range.first > range.last {
            return Err(Mistake::new(
                format!("{} runs backwards", shown(&word.text)),
                format!("write {}-{}", range.last, range.first),
                word.span,
            ));
        }
        Ok(range)
    }

    /// The two bodies of a contact, particles in ascending order.
    pub(crate) fn contact(&mut self) -> Result<(u32, Partner), Mistake> {
        let word = self.word("a contact, I-J or I-WALL,")?;
        let Some((first, second)) = word.text.split_once('-') else {
            return Err(self.refused(&word, "stands", "a contact, I-J or I-WALL,"));
        };
        let i = self.particle_number(first, &word)?;
        if is_name(second) {
            return Ok((i, Partner::Wall(second.to_owned())));
        }
        let j = self.particle_number(second, &word)?;
        if i == j {
            return Err(Mistake::new(
                format!("{} names one particle twice", shown(&word.text)),
                "a contact joins two bodies",
                word.span,
            ));
        }
        Ok((i.min(j), Partner::Particle(i.max(j))))
    }

    /// The name of a wall.
    pub(crate) fn wall(&mut self) -> Result<String, Mistake> {
        if self.is_at_end() {
            self.wanted.push(Wanted::Wall);
        }
        let word = self.word("a wall name")?;
        if is_name(&word.text) {
            Ok(word.text.into_owned())
        } else {
            Err(no_wall_name(&word.text, word.span))
        }
    }

    /// The name of a region, where the line may also end.
    pub(crate) fn region_if_any(&mut self) -> Result<Option<String>, Mistake> {
        if self.is_at_end() {
            self.wanted.push(Wanted::Region);
            return Ok(None);
        }
        let word = self.word("a region")?;
        if is_name(&word.text) {
            return Ok(Some(word.text.into_owned()));
        }
        Err(no_name("region", &word.text, word.span))
    }

    /// The name of a material.
    pub(crate) fn material(&mut self) -> Result<String, Mistake> {
        if self.is_at_end() {
            self.wanted.push(Wanted::Material);
        }
        let word = self.word("a material name")?;
        self.printable(word, "a material name")
    }

    /// The name of a file.
    pub(crate) fn file(&mut self) -> Result<String, Mistake> {
        let word = self.word("a file name")?;
        self.printable(word, "a file name")
    }

    fn printable(&self, word: Word<'a>, what: &str) -> Result<String, Mistake> {
        if word.text.is_empty() || word.text.chars().any(char::is_control) {
            return Err(self.refused(&word, "stands", what));
        }
        Ok(word.text.into_owned())
    }

    /// A list of columns that commas or spaces separate, to the end of the line.
    pub(crate) fn columns(&mut self) -> Result<Vec<Observable>, Mistake> {
        let mut found = Vec::new();
        while let Some(rest) = self.peek() {
            if rest.starts_with(',') {
                self.at += 1;
                continue;
            }
            let length = rest
                .find(|c: char| c == ',' || c.is_whitespace())
                .unwrap_or(rest.len());
            let span = self.at..self.at + length;
            let name = Observable::parse(&rest[..length], span.clone(), self.definitions)?;
            if found.contains(&name) {
                let message = format!("`{}` is listed twice", name.name());
                return Err(Mistake::new(message, "name each column once", span));
            }
            found.push(name);
            self.at += length;
        }
        self.wanted.push(Wanted::Column);
        if found.is_empty() {
            return Err(self.missing("a column"));
        }
        Ok(found)
    }

    /// A condition, which ends where no operator joins what follows.
    pub(crate) fn condition(&mut self) -> Result<Expression, Mistake> {
        if self.is_at_end() {
            self.wanted.extend([Wanted::Column, Wanted::Variable]);
            return Err(self.missing("a condition"));
        }
        let start = self.at;
        match Expression::parse_leading_condition(&self.line[start..], self.definitions) {
            Ok((expression, length)) => {
                self.at = start + length;
                if self.is_at_end() {
                    self.wanted.push(Wanted::Keyword("and"));
                    self.wanted.push(Wanted::Keyword("or"));
                }
                Ok(expression.moved(start))
            }
            Err(mistake) => {
                let mistake = mistake.moved(start);
                if mistake.span.start >= self.line.trim_end().len() {
                    self.wanted.extend([Wanted::Column, Wanted::Variable]);
                }
                Err(mistake)
            }
        }
    }
}
