//! Expressions: what `until` waits for, what an expectation measures.
//!
//! Columns, `cycle`, `time` and `stage_cycle`, numbers, `+ - * /`, `min max`, functions of one number,
//! `>= > <= < ==`, `and`, `or`, parentheses. `and` binds before `or`.

mod meaning;
mod quantity;
mod syntax;
mod term;
mod token;
mod tree;

pub use quantity::Quantity;
pub use term::Term;

use super::definition::Definitions;
use super::mistake::{Mistake, shown};
use crate::measure::columns::{Column, Names};
use meaning::Meaning;
use std::fmt;
use std::ops::Range;
use std::str::FromStr;
use syntax::Syntax;
use term::{Places, Scope, terms};
use tree::{Arithmetic, Function, Number};

/// Whether this is the name of a function of one number.
pub(super) fn is_function(name: &str) -> bool {
    Function::named(name).is_some()
}

/// An expression over one row of a history: a number or a condition.
#[derive(Debug, Clone)]
pub struct Expression {
    meaning: Meaning<Term>,
    places: Places,
}

/// Where the columns were written is no part of what an expression is.
impl PartialEq for Expression {
    fn eq(&self, other: &Self) -> bool {
        self.meaning == other.meaning
    }
}

impl Expression {
    /// Reads an expression of either type.
    pub fn parse(text: &str) -> Result<Self, Mistake> {
        Self::parse_with(text, &Definitions::default())
    }

    /// The same in a preset that defines columns: their expressions take their places.
    pub fn parse_with(text: &str, definitions: &Definitions) -> Result<Self, Mistake> {
        Self::understand(&syntax::parse(text)?, text, definitions)
    }

    /// Reads an expression that holds or does not, as `until` needs it.
    pub fn parse_condition(text: &str) -> Result<Self, Mistake> {
        Self::parse_condition_with(text, &Definitions::default())
    }

    /// The same in a preset that defines columns.
    pub fn parse_condition_with(text: &str, definitions: &Definitions) -> Result<Self, Mistake> {
        Self::parse_with(text, definitions)?.into_condition(text)
    }

    /// Reads a condition from the beginning of a text, and says at which byte what follows begins.
    pub(crate) fn parse_leading_condition(
        text: &str,
        definitions: &Definitions,
    ) -> Result<(Self, usize), Mistake> {
        let (syntax, end) = syntax::parse_leading(text)?;
        let written = text[..end].trim_end();
        let expression = Self::understand(&syntax, text, definitions)?.into_condition(written)?;
        Ok((expression, end))
    }

    fn understand(syntax: &Syntax, text: &str, definitions: &Definitions) -> Result<Self, Mistake> {
        let mut places = Places::new();
        let scope = Scope {
            inside: "",
            definitions,
        };
        let meaning = meaning::meaning(syntax, text, &mut *terms(scope, &mut places))?;
        Ok(Self { meaning, places })
    }

    /// What takes the place of its name in another expression, which stands at these bytes.
    fn as_number(&self, span: &Range<usize>) -> Result<Number<Term>, Mistake> {
        match &self.meaning {
            Meaning::Number(number) => Ok(number.clone()),
            Meaning::Condition(_) => Err(Mistake::new(
                "a condition stands where a number is needed",
                "compare in the expression itself",
                span.clone(),
            )),
        }
    }

    /// Constants, variables and what joins them: how much there is to compute.
    pub(crate) fn parts(&self) -> usize {
        match &self.meaning {
            Meaning::Number(number) => number.parts(),
            Meaning::Condition(condition) => condition.parts(),
        }
    }

    /// The same for a run whose steps are shorter or longer: `own` of its cycles take the time of
    /// `preset` cycles that the expression counts in.
    #[must_use]
    pub fn counting(self, own: f64, preset: f64) -> Self {
        let leaf = |term: Term| match term {
            Term::Cycle | Term::StageCycle => {
                let scaled =
                    |how, a, by| Number::Joined(how, Box::new(a), Box::new(Number::Constant(by)));
                // Multiplied first: whole numbers of cycles stay whole.
                let product = scaled(Arithmetic::Times, Number::Leaf(term), preset);
                scaled(Arithmetic::Over, product, own)
            }
            other => Number::Leaf(other),
        };
        let meaning = match self.meaning {
            Meaning::Number(number) => Meaning::Number(number.map(&leaf)),
            Meaning::Condition(condition) => Meaning::Condition(condition.map(&leaf)),
        };
        Self { meaning, ..self }
    }

    fn into_condition(self, text: &str) -> Result<Self, Mistake> {
        if self.is_condition() {
            return Ok(self);
        }
        let start = text.len() - text.trim_start().len();
        Err(Mistake::new(
            format!(
                "{} is a number where a condition is needed",
                shown(text.trim())
            ),
            "compare it with something, for instance `> 0`",
            start..text.trim_end().len(),
        ))
    }

    /// The columns it reads, each once, in the order they are written.
    pub fn columns(&self) -> Vec<Column> {
        each_once(self.places.iter().map(|(column, _)| column))
    }

    /// Whether it reads any column; false when only `cycle`, `time` and `stage_cycle` appear.
    pub fn needs_sample(&self) -> bool {
        !self.places.is_empty()
    }

    /// Whether it holds or not, rather than having a value.
    pub fn is_condition(&self) -> bool {
        matches!(self.meaning, Meaning::Condition(_))
    }

    /// Its value; a condition counts 1 while it holds and 0 otherwise.
    pub fn number(&self, values: &mut dyn FnMut(&Term) -> f64) -> f64 {
        match &self.meaning {
            Meaning::Number(number) => number.value(values),
            Meaning::Condition(condition) => f64::from(u8::from(condition.holds(values))),
        }
    }

    /// Whether it holds. What is compared with nan does not; a number holds unless it is 0 or nan.
    pub fn holds(&self, values: &mut dyn FnMut(&Term) -> f64) -> bool {
        match &self.meaning {
            Meaning::Number(number) => {
                let value = number.value(values);
                !value.is_nan() && value != 0.0
            }
            Meaning::Condition(condition) => condition.holds(values),
        }
    }

    /// Whether the walls and particles that its columns name exist.
    pub fn check(&self, names: &Names) -> Result<(), Mistake> {
        check(&self.places, names)
    }

    /// The same expression, read from a longer text in which it begins at byte `by`.
    pub(crate) fn moved(mut self, by: usize) -> Self {
        for (_, span) in &mut self.places {
            *span = span.start + by..span.end + by;
        }
        self
    }
}

fn each_once<'a>(columns: impl Iterator<Item = &'a Column>) -> Vec<Column> {
    let mut found: Vec<Column> = Vec::new();
    for column in columns {
        if !found.contains(column) {
            found.push(column.clone());
        }
    }
    found
}

fn check(places: &Places, names: &Names) -> Result<(), Mistake> {
    for (column, span) in places {
        column
            .check(names)
            .map_err(|unknown| Mistake::new(unknown.message, unknown.remedy, span.clone()))?;
    }
    Ok(())
}

impl fmt::Display for Expression {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.meaning {
            Meaning::Number(number) => write!(f, "{number}"),
            Meaning::Condition(condition) => write!(f, "{condition}"),
        }
    }
}

impl FromStr for Expression {
    type Err = Mistake;

    fn from_str(text: &str) -> Result<Self, Mistake> {
        Self::parse(text)
    }
}

#[cfg(test)]
mod round_trip;
#[cfg(test)]
mod tests;
