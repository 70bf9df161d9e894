//! `con1`: scales velocities in each cycle.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "con1",
    aliases: &[],
    usage: "con1 X",
    summary: "multiplies the velocities by a factor in each cycle",
    detail: "1 changes nothing, 0 stops everything. Its effect depends on the time step: `damp \
             global` is the form that does not.",
    examples: &["con1 0.99"],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.fraction("con1").map(Command::Con1)
}
