//! `damp`: sets how motion is damped.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "damp",
    aliases: &[],
    usage: "damp contact|wall|tangential|beta|global|local X",
    summary: "sets a kind of damping",
    detail: "contact, wall and tangential are fractions of critical damping at a contact. beta [s] \
             makes the dashpot proportional to the stiffness instead. global [1/s] is proportional \
             to mass. local is the fraction of the out-of-balance force that opposes the motion, \
             0 to 1. 0 switches any of them off.",
    examples: &["damp contact 0.1", "damp beta 1e-3", "damp local 0.7"],
    parse,
    changes_world: true,
};

/// A kind of damping.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Damper {
    /// Normal dashpot between particles, as a fraction of critical [-].
    Contact,
    /// Normal dashpot between particle and wall, as a fraction of critical [-].
    Wall,
    /// Tangential dashpot, as a fraction of critical [-].
    Tangential,
    /// Stiffness-proportional dashpot [s].
    Beta,
    /// Mass-proportional damping [1/s].
    Global,
    /// Fraction of the out-of-balance force against the motion [-].
    Local,
}

const KINDS: [(&str, Damper); 6] = [
    ("contact", Damper::Contact),
    ("wall", Damper::Wall),
    ("tangential", Damper::Tangential),
    ("beta", Damper::Beta),
    ("global", Damper::Global),
    ("local", Damper::Local),
];

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let damper = words.choose(&KINDS)?;
    let value = match damper {
        Damper::Local => words.fraction("local damping")?,
        _ => words.not_negative("the damping")?,
    };
    Ok(Command::Damp(damper, value))
}

impl fmt::Display for Damper {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let row = KINDS.iter().find(|(_, damper)| damper == self);
        f.write_str(row.expect("every kind has its row").0)
    }
}
