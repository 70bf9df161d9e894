//! `inspect`: shows one contact in detail, and follows it.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "inspect",
    aliases: &[],
    usage: "inspect contact I-J|I-WALL | off",
    summary: "shows a contact in detail and follows it; off ends that",
    detail: "Forces, overlap, stresses, sliding and the memory of its law. From then on overlap, \
             displacement and forces of the contact are kept from every cycle (every second, \
             fourth ... of a long run): the pane `contact` draws them, `export path` and \
             `export svg contact` write them. Looking changes nothing in the run.",
    examples: &[
        "inspect contact 1-2",
        "inspect contact 4-floor",
        "inspect off",
    ],
    parse,
    changes_world: false,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    if words.keyword(&["contact", "off"])? == "off" {
        return Ok(Command::InspectOff);
    }
    let (id, partner) = words.contact()?;
    Ok(Command::InspectContact(id, partner))
}
