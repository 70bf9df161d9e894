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
    usage: "damp contact|wall|tangential|beta|restitution|overlap|global|local X",
    summary: "sets a kind of damping",
    detail: "contact, wall and tangential are fractions of critical damping at a contact. beta [s] \
             makes the dashpot proportional to the stiffness, restitution gives what an impact is to \
             have. overlap damps critically where it is more than that share of the smallest \
             diameter. global [1/s] is proportional \
             to mass. local is the fraction of the out-of-balance force that opposes the motion, \
             0 to 1. 0 switches any of them off but restitution, which is off once contact or beta is set.",
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
    /// Coefficient of restitution of a normal impact [-].
    Restitution,
    /// Overlap over the smaller diameter above which a contact is damped critically [-].
    Overlap,
    /// Mass-proportional damping [1/s].
    Global,
    /// Fraction of the out-of-balance force against the motion [-].
    Local,
}

const KINDS: [(&str, Damper); 8] = [
    ("contact", Damper::Contact),
    ("wall", Damper::Wall),
    ("tangential", Damper::Tangential),
    ("beta", Damper::Beta),
    ("restitution", Damper::Restitution),
    ("overlap", Damper::Overlap),
    ("global", Damper::Global),
    ("local", Damper::Local),
];

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let damper = words.choose(&KINDS)?;
    let value = match damper {
        Damper::Local => words.fraction("local damping")?,
        Damper::Restitution => {
            words.number_that("the restitution", "above 0 and at most 1", |e| {
                e > 0.0 && e <= 1.0
            })?
        }
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
