//! `friction`: sets friction coefficients.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "friction",
    aliases: &[],
    usage: "friction X [material M | wall NAME | pair A B]",
    summary: "sets a friction coefficient",
    detail: "X is tan(phi). Bare, it holds for every contact; a material's value meets the other \
             material's, and the smaller counts; a pair of materials overrides both.",
    examples: &[
        "friction 0.3",
        "friction 0.5 material glass",
        "friction 0 wall left",
        "friction 0.2 pair glass steel",
    ],
    parse,
    changes_world: true,
};

/// What gets a friction coefficient.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FrictionOf {
    /// Every contact.
    Everything,
    /// A material, by name.
    Material(String),
    /// Contacts with a wall, by name.
    Wall(String),
    /// Contacts between two materials, by name.
    Pair(String, String),
}

type Reader = fn(&mut Words<'_>) -> Result<FrictionOf, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let value = words.not_negative("the coefficient")?;
    let options: [(&'static str, Reader); 3] = [
        ("material", |w| w.material().map(FrictionOf::Material)),
        ("wall", |w| w.wall().map(FrictionOf::Wall)),
        ("pair", |w| {
            Ok(FrictionOf::Pair(w.material()?, w.material()?))
        }),
    ];
    let of = match words.choose_if_any(&options)? {
        Some(read) => read(words)?,
        None => FrictionOf::Everything,
    };
    Ok(Command::Friction(value, of))
}

impl fmt::Display for FrictionOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Everything => Ok(()),
            Self::Material(name) => write!(f, " material {}", quoted(name)),
            Self::Wall(name) => write!(f, " wall {name}"),
            Self::Pair(a, b) => write!(f, " pair {} {}", quoted(a), quoted(b)),
        }
    }
}
