//! `help`: shows the commands.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "help",
    aliases: &["?"],
    usage: "help [COMMAND]",
    summary: "shows all commands, or one",
    detail: "Commands and keywords can be shortened as long as they stay unambiguous.",
    examples: &["help", "help solve"],
    parse,
    changes_world: false,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let card = words.command_if_any()?;
    Ok(Command::Help(card.map(|card| card.name)))
}
