//! `solve`: runs until something holds.

use crate::language::command::Command;
use crate::language::expression::Expression;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "solve",
    aliases: &[],
    usage: "solve [ratio R | until EXPRESSION] [max N]",
    summary: "runs until balanced, or until a condition holds",
    detail: "ratio is what the column `unbalanced` has to fall below. An expression compares \
             columns, cycle, time or stage_cycle, and joins comparisons with `and` and `or`. max \
             bounds the number of cycles.",
    examples: &[
        "solve",
        "solve ratio 1e-4",
        "solve until kinetic < 1e-9 and coordination > 3 max 200_000",
    ],
    parse,
    changes_world: false,
};

/// What to run for.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Solve {
    /// What has to hold; `None`: the session's usual balance.
    pub goal: Option<Goal>,
    /// Largest number of cycles; `None`: no bound.
    pub max: Option<u64>,
}

/// What has to hold.
#[derive(Debug, Clone, PartialEq)]
pub enum Goal {
    /// The column `unbalanced` is below this [-].
    Ratio(f64),
    /// This condition holds.
    Until(Expression),
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let mut solve = Solve::default();
    let mut left = vec!["ratio", "until", "max"];
    while let Some(option) = words.next_option(&mut left)? {
        if option == "max" {
            solve.max = Some(words.count("the number of cycles")?);
            continue;
        }
        // There is one goal: the other word for it goes too.
        left.retain(|word| *word == "max");
        solve.goal = Some(match option {
            "ratio" => Goal::Ratio(words.positive("the ratio")?),
            _ => Goal::Until(words.condition()?),
        });
    }
    Ok(Command::Solve(solve))
}

impl fmt::Display for Solve {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.goal {
            Some(Goal::Ratio(ratio)) => write!(f, " ratio {}", number::format(*ratio))?,
            Some(Goal::Until(condition)) => write!(f, " until {condition}")?,
            None => {}
        }
        match self.max {
            Some(max) => write!(f, " max {max}"),
            None => Ok(()),
        }
    }
}
