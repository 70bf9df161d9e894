//! `delete`: removes particles.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "delete",
    aliases: &[],
    usage: "delete I|I-J",
    summary: "removes particles",
    detail: "The others keep their numbers. Walls are removed with `wall NAME delete`.",
    examples: &["delete 3", "delete 10-25"],
    parse,
    changes_world: true,
};

/// Particles with consecutive numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ParticleRange {
    /// Lowest number.
    pub first: u32,
    /// Highest number, not below `first`.
    pub last: u32,
}

impl ParticleRange {
    /// Whether a particle of this number is meant.
    pub fn contains(self, id: u32) -> bool {
        (self.first..=self.last).contains(&id)
    }
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.particles().map(Command::Delete)
}

impl fmt::Display for ParticleRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.first == self.last {
            write!(f, "{}", self.first)
        } else {
            write!(f, "{}-{}", self.first, self.last)
        }
    }
}
