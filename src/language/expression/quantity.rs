//! What an expectation measures: numbers computed over all recorded rows.

use super::meaning::{
    Leaf, Meaning, arguments_expected, condition, meaning, number, unknown_function, written,
};
use super::syntax::{self, Form, Syntax};
use super::term::{AGGREGATES, Places, Scope, Term, terms};
use super::tree::{Condition, Function, Number};
use super::{check, each_once, shown};
use crate::language::definition::Definitions;
use crate::language::mistake::Mistake;
use crate::measure::columns::{Column, Names};
use std::fmt;
use std::str::FromStr;

/// Arithmetic over aggregates: `last(e)`, `max(e)`, `min(e)`, `mean(e)` and `at(condition, e)`,
/// the value of `e` in the first row where the condition holds.
///
/// Rows where `e` is nan are undefined: `max`, `min` and `mean` leave them out, and are nan when
/// nothing is left.
#[derive(Debug, Clone)]
pub struct Quantity {
    number: Number<Aggregate>,
    places: Places,
}

/// Where the columns were written is no part of what a quantity is.
impl PartialEq for Quantity {
    fn eq(&self, other: &Self) -> bool {
        self.number == other.number
    }
}

/// One number made of all rows.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Aggregate {
    Last(Number<Term>),
    Largest(Number<Term>),
    Smallest(Number<Term>),
    Mean(Number<Term>),
    At(Condition<Term>, Number<Term>),
}

type Cells<'a> = dyn FnMut(usize, &Term) -> f64 + 'a;

impl Aggregate {
    fn value(&self, rows: usize, cell: &mut Cells<'_>) -> Result<f64, String> {
        if rows == 0 {
            return Err(format!("{self} has no value: no rows were recorded"));
        }
        let mut at = |of: &Number<Term>, row: usize| of.value(&mut |term| cell(row, term));
        Ok(match self {
            Self::Last(of) => at(of, rows - 1),
            Self::Largest(of) => (0..rows).map(|row| at(of, row)).fold(f64::NAN, f64::max),
            Self::Smallest(of) => (0..rows).map(|row| at(of, row)).fold(f64::NAN, f64::min),
            Self::Mean(of) => {
                let mut count = 0;
                let mut sum = 0.0;
                for value in (0..rows).map(|row| at(of, row)).filter(|v| !v.is_nan()) {
                    count += 1;
                    sum += value;
                }
                sum / f64::from(count)
            }
            Self::At(when, of) => {
                let first = (0..rows).find(|&row| when.holds(&mut |term| cell(row, term)));
                let row = first.ok_or_else(|| format!("`{when}` holds in no recorded row"))?;
                of.value(&mut |term| cell(row, term))
            }
        })
    }
}

impl fmt::Display for Aggregate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Last(of) => write!(f, "last({of})"),
            Self::Largest(of) => write!(f, "max({of})"),
            Self::Smallest(of) => write!(f, "min({of})"),
            Self::Mean(of) => write!(f, "mean({of})"),
            Self::At(when, of) => write!(f, "at({when}, {of})"),
        }
    }
}

impl Quantity {
    /// Reads a quantity.
    pub fn parse(text: &str) -> Result<Self, Mistake> {
        Self::parse_with(text, &Definitions::default())
    }

    /// The same in a preset that defines columns: their expressions take their places.
    pub fn parse_with(text: &str, definitions: &Definitions) -> Result<Self, Mistake> {
        let syntax = syntax::parse(text)?;
        let mut places = Places::new();
        let mut any = false;
        let mut leaf = |syntax: &Syntax| {
            let found = aggregate(syntax, text, definitions, &mut places)?;
            any |= found.is_some();
            Ok(found.map(Number::Leaf))
        };
        let meaning = meaning(&syntax, text, &mut leaf as &mut Leaf<'_, Aggregate>)?;
        let Meaning::Number(number) = meaning else {
            return Err(Mistake::new(
                format!(
                    "{} is a condition, and an expectation measures a number",
                    written(&syntax, text)
                ),
                "give the number here, and the bounds as `value` and `within`",
                syntax.span,
            ));
        };
        if !any {
            return Err(Mistake::new(
                format!("{} measures nothing", shown(text.trim())),
                "measure a column, for instance last(kinetic)",
                syntax.span,
            ));
        }
        Ok(Self { number, places })
    }

    /// The columns it reads, each once, in the order they are written.
    pub fn columns(&self) -> Vec<Column> {
        each_once(self.places.iter().map(|(column, _)| column))
    }

    /// Whether the walls and particles that its columns name exist.
    pub fn check(&self, names: &Names) -> Result<(), Mistake> {
        check(&self.places, names)
    }

    /// Its value over `rows` recorded rows. Fails when there are none, or when the condition of an
    /// `at` holds in none of them.
    pub fn value(
        &self,
        rows: usize,
        cell: &mut dyn FnMut(usize, &Term) -> f64,
    ) -> Result<f64, String> {
        let mut failure = None;
        let value = self.number.value(&mut |aggregate| {
            aggregate.value(rows, cell).unwrap_or_else(|why| {
                failure.get_or_insert(why);
                f64::NAN
            })
        });
        failure.map_or(Ok(value), Err)
    }
}

/// Reads what an aggregate applies to with the rules of a row.
fn aggregate(
    syntax: &Syntax,
    text: &str,
    definitions: &Definitions,
    places: &mut Places,
) -> Result<Option<Aggregate>, Mistake> {
    let scope = |inside| Scope {
        inside,
        definitions,
    };
    let (function, arguments) = match &syntax.form {
        Form::Call(function, arguments) => (function.as_str(), arguments.as_slice()),
        Form::Name(name) => {
            // A word that is no column at all deserves that answer first.
            let known = number(syntax, text, &mut *terms(scope(""), places))?;
            let meant = match definitions.find(name) {
                Some(definition) => definition.name.clone(),
                None => known.to_string(),
            };
            return Err(Mistake::new(
                format!("{} has a value in every row", shown(name)),
                format!("say which is meant: last({meant}), max(...), min(...) or mean(...)"),
                syntax.span.clone(),
            ));
        }
        _ => return Ok(None),
    };
    let mut of = |part: &Syntax| number(part, text, &mut *terms(scope(function), places));
    Ok(Some(match (function, arguments) {
        ("last", [e]) => Aggregate::Last(of(e)?),
        ("max", [e]) => Aggregate::Largest(of(e)?),
        ("min", [e]) => Aggregate::Smallest(of(e)?),
        ("mean", [e]) => Aggregate::Mean(of(e)?),
        ("at", [when, e]) => {
            let when = condition(when, text, "`at`", &mut *terms(scope("at"), places))?;
            let e = number(e, text, &mut *terms(scope("at"), places))?;
            Aggregate::At(when, e)
        }
        ("last" | "mean", _) => {
            return Err(arguments_expected(
                syntax,
                function,
                "one value",
                arguments.len(),
            ));
        }
        ("at", _) => {
            let takes = "a condition and a value";
            return Err(arguments_expected(syntax, function, takes, arguments.len()));
        }
        ("min" | "max", _) => return Ok(None),
        (name, _) if Function::named(name).is_some() => return Ok(None),
        _ => {
            let mut known = AGGREGATES.to_vec();
            known.extend(Function::ALL.map(|(name, _)| name));
            return Err(unknown_function(function, &known, syntax));
        }
    }))
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.number)
    }
}

impl FromStr for Quantity {
    type Err = Mistake;

    fn from_str(text: &str) -> Result<Self, Mistake> {
        Self::parse(text)
    }
}
