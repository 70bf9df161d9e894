//! `zero`: stops all motion.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "zero",
    aliases: &[],
    usage: "zero [velocities]",
    summary: "sets all velocities and spins to 0",
    detail: "Prescribed velocities of walls and fixed particles stay. The kinetic energy taken out \
             is booked as work of a command.",
    examples: &["zero", "zero velocities"],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.optional_keyword(&["velocities"])?;
    Ok(Command::Zero)
}
