//! `frac`: changes the time step.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "frac",
    aliases: &[],
    usage: "frac X",
    summary: "sets the time step as a multiple of the reference step",
    detail: "The reference is what model.time_step names: the Rayleigh step, the critical step or a \
             number of seconds. Large values cost accuracy, then stability; the columns fracc and \
             frac_limit show how far that is.",
    examples: &["frac 0.1"],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.positive("frac").map(Command::Frac)
}
