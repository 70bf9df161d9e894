//! From tokens to a tree that knows what binds to what, but not yet what it means.
//!
//! Binding, loosest first: `or`, `and`, comparisons (which do not chain), `+ -`, `* /`, unary `-`.

use super::token::{Kind, Token, token};
use crate::language::mistake::{Mistake, shown};
use std::ops::Range;

/// Parentheses, functions and signs within each other. Recursion is this deep, so noise cannot
/// overflow the stack.
const DEEPEST: usize = 64;

/// Tokens of one expression. A chain such as `1 + 1 + ...` grows a tree without any parentheses,
/// and walking or dropping it recurses too.
const LONGEST: usize = 1024;

/// What joins two operands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Operator {
    Or,
    And,
    AtLeast,
    More,
    AtMost,
    Less,
    Equal,
    Plus,
    Minus,
    Times,
    Over,
}

impl Operator {
    fn of(kind: &Kind<'_>) -> Option<Self> {
        Some(match kind {
            Kind::Or => Self::Or,
            Kind::And => Self::And,
            Kind::AtLeast => Self::AtLeast,
            Kind::More => Self::More,
            Kind::AtMost => Self::AtMost,
            Kind::Less => Self::Less,
            Kind::Equal => Self::Equal,
            Kind::Plus => Self::Plus,
            Kind::Minus => Self::Minus,
            Kind::Times => Self::Times,
            Kind::Over => Self::Over,
            _ => return None,
        })
    }

    fn binding(self) -> u8 {
        match self {
            Self::Or => 1,
            Self::And => 2,
            Self::AtLeast | Self::More | Self::AtMost | Self::Less | Self::Equal => 3,
            Self::Plus | Self::Minus => 4,
            Self::Times | Self::Over => 5,
        }
    }
}

/// A part of an expression and the bytes it was read from.
#[derive(Debug)]
pub(super) struct Syntax {
    pub(super) form: Form,
    pub(super) span: Range<usize>,
}

/// The ways to write a part.
#[derive(Debug)]
pub(super) enum Form {
    Number(f64),
    Name(String),
    Negative(Box<Syntax>),
    Operation(Operator, Box<Syntax>, Box<Syntax>),
    /// Function, in lower case, and its arguments.
    Call(String, Vec<Syntax>),
}

/// Reads an expression that is all of the text.
pub(super) fn parse(text: &str) -> Result<Syntax, Mistake> {
    let mut parser = Parser::new(text)?;
    let syntax = parser.operation(0)?;
    match parser.ahead.kind {
        Kind::End => Ok(syntax),
        Kind::Close => Err(Mistake::new(
            "`)` closes nothing",
            "remove it or open a parenthesis before",
            parser.ahead.span,
        )),
        _ => Err(Mistake::new(
            format!("{} follows a complete expression", parser.word()),
            "join expressions with an operator, `and` or `or`",
            parser.ahead.span,
        )),
    }
}

/// Reads an expression from the beginning of the text, and says where what follows it begins.
pub(super) fn parse_leading(text: &str) -> Result<(Syntax, usize), Mistake> {
    let mut parser = Parser::new(text)?;
    let syntax = parser.operation(0)?;
    Ok((syntax, parser.ahead.span.start))
}

struct Parser<'a> {
    text: &'a str,
    ahead: Token<'a>,
    depth: usize,
    tokens: usize,
}

impl<'a> Parser<'a> {
    fn new(text: &'a str) -> Result<Self, Mistake> {
        Ok(Self {
            text,
            ahead: token(text, 0)?,
            depth: 0,
            tokens: 1,
        })
    }

    fn word(&self) -> String {
        shown(&self.text[self.ahead.span.clone()])
    }

    fn advance(&mut self) -> Result<Token<'a>, Mistake> {
        self.tokens += 1;
        if self.tokens > LONGEST {
            return Err(Mistake::new(
                format!("the expression has more than {LONGEST} parts"),
                "make it shorter",
                self.ahead.span.clone(),
            ));
        }
        let next = token(self.text, self.ahead.span.end)?;
        Ok(std::mem::replace(&mut self.ahead, next))
    }

    /// Operators that bind tighter than `loosest`, and their operands.
    fn operation(&mut self, loosest: u8) -> Result<Syntax, Mistake> {
        let mut left = self.operand()?;
        while let Some(operator) = Operator::of(&self.ahead.kind)
            && operator.binding() > loosest
        {
            self.advance()?;
            let right = self.operation(operator.binding())?;
            left = Syntax {
                span: left.span.start..right.span.end,
                form: Form::Operation(operator, Box::new(left), Box::new(right)),
            };
        }
        Ok(left)
    }

    fn operand(&mut self) -> Result<Syntax, Mistake> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return Err(Mistake::new(
                format!("the expression is nested more than {DEEPEST} deep"),
                "use fewer parentheses",
                self.ahead.span.clone(),
            ));
        }
        let operand = self.shallow_operand();
        self.depth -= 1;
        operand
    }

    fn shallow_operand(&mut self) -> Result<Syntax, Mistake> {
        let start = self.ahead.span.start;
        match self.ahead.kind {
            Kind::Number(value) => {
                let span = self.advance()?.span;
                let form = Form::Number(value);
                Ok(Syntax { form, span })
            }
            Kind::Name(name) => {
                let span = self.advance()?.span;
                if self.ahead.kind == Kind::Open {
                    return self.call(name, start);
                }
                let form = Form::Name(name.to_owned());
                Ok(Syntax { form, span })
            }
            Kind::Minus => {
                self.advance()?;
                let of = self.operand()?;
                Ok(Syntax {
                    span: start..of.span.end,
                    form: Form::Negative(Box::new(of)),
                })
            }
            Kind::Open => {
                self.advance()?;
                let inner = self.operation(0)?;
                let end = self.close(start)?;
                Ok(Syntax {
                    span: start..end,
                    ..inner
                })
            }
            Kind::End => Err(Mistake::new(
                "the text ends where a value is expected",
                "write a column, a number or a parenthesis",
                self.ahead.span.clone(),
            )),
            _ => Err(Mistake::new(
                format!("{} stands where a value is expected", self.word()),
                "write a column, a number or a parenthesis",
                self.ahead.span.clone(),
            )),
        }
    }

    fn call(&mut self, function: &str, start: usize) -> Result<Syntax, Mistake> {
        let opened = self.advance()?.span.start;
        let mut arguments = vec![self.operation(0)?];
        while self.ahead.kind == Kind::Comma {
            self.advance()?;
            arguments.push(self.operation(0)?);
        }
        let end = self.close(opened)?;
        Ok(Syntax {
            form: Form::Call(function.to_ascii_lowercase(), arguments),
            span: start..end,
        })
    }

    fn close(&mut self, opened: usize) -> Result<usize, Mistake> {
        match self.ahead.kind {
            Kind::Close => Ok(self.advance()?.span.end),
            Kind::End => Err(Mistake::new(
                "this parenthesis is never closed",
                "add `)`",
                opened..opened + 1,
            )),
            _ => Err(Mistake::new(
                format!(
                    "{} stands where `)` or an operator is expected",
                    self.word()
                ),
                "close the parenthesis or join the parts",
                self.ahead.span.clone(),
            )),
        }
    }
}
