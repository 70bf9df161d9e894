//! Gives syntax its type: numbers join to numbers, comparisons to conditions.

use super::syntax::{Form, Operator, Syntax};
use super::tree::{Arithmetic, Comparison, Condition, Function, Number};
use crate::language::mistake::Mistake;
use crate::measure::columns::near;

/// Either type of expression.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Meaning<L> {
    Number(Number<L>),
    Condition(Condition<L>),
}

/// Reads the leaves of one kind of expression, or what stands for several of them: `None` leaves the
/// part to the common rules.
pub(super) type Leaf<'a, L> = dyn FnMut(&Syntax) -> Result<Option<Number<L>>, Mistake> + 'a;

/// What the text is as a whole.
pub(super) fn meaning<L>(
    syntax: &Syntax,
    text: &str,
    leaf: &mut Leaf<'_, L>,
) -> Result<Meaning<L>, Mistake> {
    let Form::Operation(operator, a, b) = &syntax.form else {
        return number(syntax, text, leaf).map(Meaning::Number);
    };
    let operands = match typed(*operator) {
        Typed::Joins(_) => return number(syntax, text, leaf).map(Meaning::Number),
        Typed::Compares(how) => {
            Condition::Compared(how, number(a, text, leaf)?, number(b, text, leaf)?)
        }
        Typed::Both => Condition::Both(
            Box::new(condition(a, text, "`and`", leaf)?),
            Box::new(condition(b, text, "`and`", leaf)?),
        ),
        Typed::Either => Condition::Either(
            Box::new(condition(a, text, "`or`", leaf)?),
            Box::new(condition(b, text, "`or`", leaf)?),
        ),
    };
    Ok(Meaning::Condition(operands))
}

/// A part that has to hold or not, because `needed_by` needs it so.
pub(super) fn condition<L>(
    syntax: &Syntax,
    text: &str,
    needed_by: &str,
    leaf: &mut Leaf<'_, L>,
) -> Result<Condition<L>, Mistake> {
    match meaning(syntax, text, leaf)? {
        Meaning::Condition(condition) => Ok(condition),
        Meaning::Number(_) => Err(Mistake::new(
            format!(
                "{} is a number where {needed_by} needs a condition",
                written(syntax, text)
            ),
            "compare it with something, for instance `> 0`",
            syntax.span.clone(),
        )),
    }
}

/// A part that has to have a value.
pub(super) fn number<L>(
    syntax: &Syntax,
    text: &str,
    leaf: &mut Leaf<'_, L>,
) -> Result<Number<L>, Mistake> {
    if let Some(found) = leaf(syntax)? {
        return Ok(found);
    }
    match &syntax.form {
        Form::Number(value) => Ok(Number::Constant(*value)),
        Form::Negative(of) => Ok(Number::Negative(Box::new(number(of, text, leaf)?))),
        Form::Operation(operator, a, b) => {
            let Typed::Joins(how) = typed(*operator) else {
                return Err(Mistake::new(
                    format!(
                        "{} is a condition where a number is needed",
                        written(syntax, text)
                    ),
                    "comparisons do not chain or add up: join them with `and` or `or`",
                    syntax.span.clone(),
                ));
            };
            joined(how, a, b, text, leaf)
        }
        Form::Call(function, arguments) => match (function.as_str(), arguments.as_slice()) {
            ("min", [a, b]) => joined(Arithmetic::Smaller, a, b, text, leaf),
            ("max", [a, b]) => joined(Arithmetic::Larger, a, b, text, leaf),
            (name @ ("min" | "max"), _) => Err(arguments_expected(
                syntax,
                name,
                "two values",
                arguments.len(),
            )),
            (name, arguments) => match (Function::named(name), arguments) {
                (Some(applied), [of]) => {
                    Ok(Number::Applied(applied, Box::new(number(of, text, leaf)?)))
                }
                (Some(_), _) => Err(arguments_expected(
                    syntax,
                    name,
                    "one value",
                    arguments.len(),
                )),
                (None, _) => {
                    let known = Function::ALL.map(|(name, _)| name);
                    let known = [&known[..], &["min", "max"]].concat();
                    Err(unknown_function(function, &known, syntax))
                }
            },
        },
        // Every kind of expression has its own names, and its leaves refuse the others.
        Form::Name(name) => Err(Mistake::new(
            format!("`{name}` is not known here"),
            "write a column or a number",
            syntax.span.clone(),
        )),
    }
}

fn joined<L>(
    how: Arithmetic,
    a: &Syntax,
    b: &Syntax,
    text: &str,
    leaf: &mut Leaf<'_, L>,
) -> Result<Number<L>, Mistake> {
    let a = number(a, text, leaf)?;
    let b = number(b, text, leaf)?;
    Ok(Number::Joined(how, Box::new(a), Box::new(b)))
}

enum Typed {
    Joins(Arithmetic),
    Compares(Comparison),
    Both,
    Either,
}

fn typed(operator: Operator) -> Typed {
    match operator {
        Operator::Or => Typed::Either,
        Operator::And => Typed::Both,
        Operator::AtLeast => Typed::Compares(Comparison::AtLeast),
        Operator::More => Typed::Compares(Comparison::More),
        Operator::AtMost => Typed::Compares(Comparison::AtMost),
        Operator::Less => Typed::Compares(Comparison::Less),
        Operator::Equal => Typed::Compares(Comparison::Equal),
        Operator::Plus => Typed::Joins(Arithmetic::Plus),
        Operator::Minus => Typed::Joins(Arithmetic::Minus),
        Operator::Times => Typed::Joins(Arithmetic::Times),
        Operator::Over => Typed::Joins(Arithmetic::Over),
    }
}

pub(super) fn arguments_expected(
    syntax: &Syntax,
    function: &str,
    takes: &str,
    given: usize,
) -> Mistake {
    Mistake::new(
        format!("`{function}` takes {takes}, not {given}"),
        "separate values by commas",
        syntax.span.clone(),
    )
}

pub(super) fn unknown_function(function: &str, known: &[&str], syntax: &Syntax) -> Mistake {
    let remedy = match near(function, known.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("there is {}", known.join(", ")),
    };
    let message = format!("{} is no function", super::shown(function));
    let name = syntax.span.start..syntax.span.start + function.len();
    Mistake::new(message, remedy, name)
}

/// A part as it was typed.
pub(super) fn written(syntax: &Syntax, text: &str) -> String {
    super::shown(&text[syntax.span.clone()])
}
