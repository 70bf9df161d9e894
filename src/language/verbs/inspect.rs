//! `inspect`: shows one contact in detail.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "inspect",
    aliases: &[],
    usage: "inspect contact I-J|I-WALL",
    summary: "shows a contact in detail",
    detail: "Forces, overlap, sliding and the memory of its law.",
    examples: &["inspect contact 1-2", "inspect contact 4-floor"],
    parse,
    changes_world: false,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.keyword(&["contact"])?;
    let (id, partner) = words.contact()?;
    Ok(Command::InspectContact(id, partner))
}
