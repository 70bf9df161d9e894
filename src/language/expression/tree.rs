//! What an expression means: numbers and conditions over leaves.
//!
//! The same two trees serve rows (leaves are columns) and expectations (leaves are aggregates over
//! rows). That numbers and conditions are different types leaves nothing to check while running.

use crate::language::number;
use std::fmt;

/// What joins two numbers to a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Arithmetic {
    Plus,
    Minus,
    Times,
    Over,
    Smaller,
    Larger,
}

/// What is made of one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Function {
    Absolute,
    Root,
    Exponential,
    Logarithm,
    Sine,
    Cosine,
    ArcTangent,
}

impl Function {
    /// With their names.
    pub(super) const ALL: [(&str, Self); 7] = [
        ("abs", Self::Absolute),
        ("sqrt", Self::Root),
        ("exp", Self::Exponential),
        ("ln", Self::Logarithm),
        ("sin", Self::Sine),
        ("cos", Self::Cosine),
        ("atan", Self::ArcTangent),
    ];

    pub(super) fn named(name: &str) -> Option<Self> {
        let found = Self::ALL.iter().find(|(known, _)| *known == name);
        found.map(|(_, function)| *function)
    }

    fn name(self) -> &'static str {
        let found = Self::ALL.iter().find(|(_, known)| *known == self);
        found.map_or("abs", |(name, _)| name)
    }

    fn apply(self, x: f64) -> f64 {
        match self {
            Self::Absolute => x.abs(),
            Self::Root => x.sqrt(),
            Self::Exponential => libm::exp(x),
            Self::Logarithm => libm::log(x),
            Self::Sine => libm::sin(x),
            Self::Cosine => libm::cos(x),
            Self::ArcTangent => libm::atan(x),
        }
    }
}

/// What compares two numbers. Whatever is compared with nan does not hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Comparison {
    AtLeast,
    More,
    AtMost,
    Less,
    Equal,
}

/// Something with a value.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Number<L> {
    Constant(f64),
    Leaf(L),
    Negative(Box<Self>),
    Applied(Function, Box<Self>),
    Joined(Arithmetic, Box<Self>, Box<Self>),
}

/// Something that holds or does not.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Condition<L> {
    Compared(Comparison, Number<L>, Number<L>),
    Both(Box<Self>, Box<Self>),
    Either(Box<Self>, Box<Self>),
}

impl<L> Number<L> {
    pub(super) fn value(&self, leaf: &mut dyn FnMut(&L) -> f64) -> f64 {
        match self {
            Self::Constant(value) => *value,
            Self::Leaf(l) => leaf(l),
            Self::Negative(of) => -of.value(leaf),
            Self::Applied(function, of) => function.apply(of.value(leaf)),
            Self::Joined(how, a, b) => how.apply(a.value(leaf), b.value(leaf)),
        }
    }

    /// How much there is to compute.
    pub(super) fn parts(&self) -> usize {
        match self {
            Self::Constant(_) | Self::Leaf(_) => 1,
            Self::Negative(of) | Self::Applied(_, of) => 1 + of.parts(),
            Self::Joined(_, a, b) => 1 + a.parts() + b.parts(),
        }
    }

    /// The same with other leaves.
    pub(super) fn map<M>(self, leaf: &dyn Fn(L) -> Number<M>) -> Number<M> {
        match self {
            Self::Constant(value) => Number::Constant(value),
            Self::Leaf(l) => leaf(l),
            Self::Negative(of) => Number::Negative(Box::new(of.map(leaf))),
            Self::Applied(function, of) => Number::Applied(function, Box::new(of.map(leaf))),
            Self::Joined(how, a, b) => {
                Number::Joined(how, Box::new(a.map(leaf)), Box::new(b.map(leaf)))
            }
        }
    }

    fn binding(&self) -> u8 {
        match self {
            Self::Joined(Arithmetic::Plus | Arithmetic::Minus, ..) => 1,
            Self::Joined(Arithmetic::Times | Arithmetic::Over, ..) => 2,
            Self::Negative(_) => 3,
            _ => 4,
        }
    }
}

impl Arithmetic {
    /// `min` and `max` are selections that hand nan on: the platform's own treat it in ways that
    /// differ.
    fn apply(self, a: f64, b: f64) -> f64 {
        match self {
            Self::Plus => a + b,
            Self::Minus => a - b,
            Self::Times => a * b,
            Self::Over => a / b,
            Self::Smaller if a.is_nan() || a < b => a,
            Self::Larger if a.is_nan() || a > b => a,
            Self::Smaller | Self::Larger => b,
        }
    }
}

impl<L> Condition<L> {
    pub(super) fn holds(&self, leaf: &mut dyn FnMut(&L) -> f64) -> bool {
        match self {
            Self::Compared(how, a, b) => {
                let (a, b) = (a.value(leaf), b.value(leaf));
                match how {
                    Comparison::AtLeast => a >= b,
                    Comparison::More => a > b,
                    Comparison::AtMost => a <= b,
                    Comparison::Less => a < b,
                    Comparison::Equal => a == b,
                }
            }
            Self::Both(a, b) => a.holds(leaf) && b.holds(leaf),
            Self::Either(a, b) => a.holds(leaf) || b.holds(leaf),
        }
    }

    /// How much there is to compute.
    pub(super) fn parts(&self) -> usize {
        match self {
            Self::Compared(_, a, b) => 1 + a.parts() + b.parts(),
            Self::Both(a, b) | Self::Either(a, b) => 1 + a.parts() + b.parts(),
        }
    }

    /// The same with other leaves.
    pub(super) fn map<M>(self, leaf: &dyn Fn(L) -> Number<M>) -> Condition<M> {
        match self {
            Self::Compared(how, a, b) => Condition::Compared(how, a.map(leaf), b.map(leaf)),
            Self::Both(a, b) => Condition::Both(Box::new(a.map(leaf)), Box::new(b.map(leaf))),
            Self::Either(a, b) => Condition::Either(Box::new(a.map(leaf)), Box::new(b.map(leaf))),
        }
    }

    fn binding(&self) -> u8 {
        match self {
            Self::Either(..) => 1,
            Self::Both(..) => 2,
            Self::Compared(..) => 3,
        }
    }
}

/// Writes a part, in parentheses if what surrounds it binds tighter than the part itself.
fn part(
    f: &mut fmt::Formatter<'_>,
    part: &dyn fmt::Display,
    binding: u8,
    needed: u8,
) -> fmt::Result {
    if binding < needed {
        write!(f, "({part})")
    } else {
        write!(f, "{part}")
    }
}

impl<L: fmt::Display> fmt::Display for Number<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let sign = match self {
            Self::Constant(value) => return f.write_str(&number::format(*value)),
            Self::Leaf(leaf) => return write!(f, "{leaf}"),
            Self::Applied(function, of) => return write!(f, "{}({of})", function.name()),
            Self::Negative(of) => {
                f.write_str("-")?;
                return part(f, of, of.binding(), self.binding());
            }
            Self::Joined(Arithmetic::Smaller, a, b) => return write!(f, "min({a}, {b})"),
            Self::Joined(Arithmetic::Larger, a, b) => return write!(f, "max({a}, {b})"),
            Self::Joined(Arithmetic::Plus, ..) => "+",
            Self::Joined(Arithmetic::Minus, ..) => "-",
            Self::Joined(Arithmetic::Times, ..) => "*",
            Self::Joined(Arithmetic::Over, ..) => "/",
        };
        if let Self::Joined(_, a, b) = self {
            part(f, a, a.binding(), self.binding())?;
            write!(f, " {sign} ")?;
            // Chains lean to the left, so an equal binding on the right needs its parentheses.
            part(f, b, b.binding(), self.binding() + 1)?;
        }
        Ok(())
    }
}

impl<L: fmt::Display> fmt::Display for Condition<L> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (a, word, b) = match self {
            Self::Compared(how, a, b) => {
                let sign = match how {
                    Comparison::AtLeast => ">=",
                    Comparison::More => ">",
                    Comparison::AtMost => "<=",
                    Comparison::Less => "<",
                    Comparison::Equal => "==",
                };
                return write!(f, "{a} {sign} {b}");
            }
            Self::Both(a, b) => (a, "and", b),
            Self::Either(a, b) => (a, "or", b),
        };
        part(f, a, a.binding(), self.binding())?;
        write!(f, " {word} ")?;
        part(f, b, b.binding(), self.binding() + 1)
    }
}
