//! `rotation`: lets particles turn or not.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "rotation",
    aliases: &[],
    usage: "rotation on|off",
    summary: "lets particles turn or not",
    detail: "Off, tangential forces act but turn nothing.",
    examples: &["rotation off"],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let on = words.choose(&[("on", true), ("off", false)])?;
    Ok(Command::Rotation(on))
}
