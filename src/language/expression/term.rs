//! The variables of an expression over one row.

use super::meaning::{Leaf, arguments_expected};
use super::syntax::{Form, Syntax};
use super::tree::{Function, Number};
use crate::language::definition::Definitions;
use crate::language::mistake::{Mistake, shown};
use crate::language::name::numeric_column;
use crate::measure::columns::{Column, near};
use std::fmt;
use std::ops::Range;

/// Functions that run over rows, and so belong to expectations.
pub(super) const AGGREGATES: [&str; 5] = ["last", "max", "min", "mean", "at"];

/// A variable.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Term {
    /// A column of the history, in the column's unit.
    Column(Column),
    /// Cycles since the start of the run.
    Cycle,
    /// Simulated time [s].
    Time,
    /// Cycles since the stage was entered.
    StageCycle,
}

impl fmt::Display for Term {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Column(column) => f.write_str(&column.name()),
            Self::Cycle => f.write_str("cycle"),
            Self::Time => f.write_str("time"),
            Self::StageCycle => f.write_str("stage_cycle"),
        }
    }
}

/// Columns and where the text names them.
pub(super) type Places = Vec<(Column, Range<usize>)>;

/// Where a variable stands: in which function over rows, if in any, and what its preset defines.
#[derive(Clone, Copy)]
pub(super) struct Scope<'a> {
    pub(super) inside: &'a str,
    pub(super) definitions: &'a Definitions,
}

/// Reads variables, and notes where columns stand.
fn term(
    syntax: &Syntax,
    scope: Scope<'_>,
    places: &mut Places,
) -> Result<Option<Number<Term>>, Mistake> {
    let inside = scope.inside;
    match &syntax.form {
        Form::Name(name) => named(name, syntax.span.clone(), scope, places).map(Some),
        Form::Call(function, arguments) => match (function.as_str(), arguments.len()) {
            (name @ ("min" | "max"), 1) if inside.is_empty() => {
                Err(arguments_expected(syntax, name, "two values", 1))
            }
            ("min" | "max", 1) | ("last" | "mean" | "at", _) => {
                let (message, remedy) = if inside.is_empty() {
                    (
                        format!("`{function}` looks at all rows, and here there is only one"),
                        "it belongs to the `what` of an [[expect]]".to_owned(),
                    )
                } else {
                    (
                        format!("`{function}` cannot stand inside `{inside}`"),
                        "both run over all rows: compute with their results".to_owned(),
                    )
                };
                Err(Mistake::new(message, remedy, syntax.span.clone()))
            }
            _ => Ok(None),
        },
        _ => Ok(None),
    }
}

fn named(
    name: &str,
    span: Range<usize>,
    scope: Scope<'_>,
    places: &mut Places,
) -> Result<Number<Term>, Mistake> {
    let lower = name.to_ascii_lowercase();
    match lower.as_str() {
        "cycle" => return Ok(Number::Leaf(Term::Cycle)),
        "time" => return Ok(Number::Leaf(Term::Time)),
        "stage_cycle" => return Ok(Number::Leaf(Term::StageCycle)),
        bare if AGGREGATES.contains(&bare) || Function::named(bare).is_some() => {
            let message = format!("`{bare}` is a function");
            let remedy = format!("write what it applies to: {bare}(...)");
            return Err(Mistake::new(message, remedy, span));
        }
        _ => {}
    }
    if let Some(definition) = scope.definitions.find(name) {
        let columns = definition.expression.columns();
        places.extend(columns.into_iter().map(|column| (column, span.clone())));
        return definition.expression.as_number(&span);
    }
    let column = numeric_column(name, span.clone(), scope.definitions).map_err(|mistake| {
        // The list of columns does not know the variables.
        let variables = ["cycle", "time", "stage_cycle"];
        let all = scope.definitions.names().chain(variables);
        match near(name, all).filter(|best| variables.contains(best)) {
            Some(best) => Mistake::new(
                format!("{} is no column", shown(name)),
                format!("did you mean `{best}`?"),
                span.clone(),
            ),
            None => mistake,
        }
    })?;
    places.push((column.clone(), span));
    Ok(Number::Leaf(Term::Column(column)))
}

/// The reader of terms, as the rules of meaning want it.
pub(super) fn terms<'a>(scope: Scope<'a>, places: &'a mut Places) -> Box<Leaf<'a, Term>> {
    Box::new(move |syntax| term(syntax, scope, places))
}
