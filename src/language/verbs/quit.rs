//! `quit`: ends the session.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "quit",
    aliases: &["q", "quit!", "q!"],
    usage: "quit|quit!",
    summary: "ends the session",
    detail: "It asks when cycles have run since the last save; with `!` it does not.",
    examples: &["quit", "q", "quit!", "q!"],
    parse,
    changes_world: false,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let anyway = words.verb().ends_with('!');
    Ok(Command::Quit { anyway })
}
