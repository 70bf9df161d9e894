//! `print`: shows tables.

use super::delete::ParticleRange;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "print",
    aliases: &[],
    usage: "print balls|contacts [I|I-J] | walls|types|boundary|energy|step | averages|all",
    summary: "shows a table",
    detail: "balls and contacts can be limited to particle numbers; types are the materials. \
             `averages` makes later tables end with averages only, `all` shows every row again.",
    examples: &[
        "print balls",
        "print contacts 1-9",
        "print energy",
        "print averages",
    ],
    parse,
    changes_world: false,
};

/// What to show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Printout {
    /// Particles, all or those in a range.
    Balls(Option<ParticleRange>),
    /// Contacts, all or those of particles in a range.
    Contacts(Option<ParticleRange>),
    /// Walls.
    Walls,
    /// Materials.
    Types,
    /// Boundary particles.
    Boundary,
    /// Energies and their balance.
    Energy,
    /// Time step and its limits.
    Step,
    /// From now on, tables hold averages only.
    Averages,
    /// From now on, tables hold every row.
    All,
}

type Reader = fn(&mut Words<'_>) -> Result<Printout, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let what = words.choose::<Reader>(&[
        ("balls", |w| range(w).map(Printout::Balls)),
        ("contacts", |w| range(w).map(Printout::Contacts)),
        ("walls", |_| Ok(Printout::Walls)),
        ("types", |_| Ok(Printout::Types)),
        ("boundary", |_| Ok(Printout::Boundary)),
        ("energy", |_| Ok(Printout::Energy)),
        ("step", |_| Ok(Printout::Step)),
        ("averages", |_| Ok(Printout::Averages)),
        ("all", |_| Ok(Printout::All)),
    ])?(words)?;
    Ok(Command::Print(what))
}

fn range(words: &mut Words<'_>) -> Result<Option<ParticleRange>, Mistake> {
    if words.is_at_end() {
        return Ok(None);
    }
    words.particles().map(Some)
}

impl fmt::Display for Printout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (word, range) = match self {
            Self::Balls(range) => ("balls", *range),
            Self::Contacts(range) => ("contacts", *range),
            Self::Walls => ("walls", None),
            Self::Types => ("types", None),
            Self::Boundary => ("boundary", None),
            Self::Energy => ("energy", None),
            Self::Step => ("step", None),
            Self::Averages => ("averages", None),
            Self::All => ("all", None),
        };
        f.write_str(word)?;
        match range {
            Some(range) => write!(f, " {range}"),
            None => Ok(()),
        }
    }
}
