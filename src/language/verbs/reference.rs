//! `reference`: remembers the state that differences are measured from.

use crate::language::command::Command;
use crate::language::list::Card;

/// Row in the list.
pub const CARD: Card = Card {
    name: "reference",
    aliases: &[],
    usage: "reference",
    summary: "measures state differences from now on",
    detail: "Displacements, differences and sliding ways shown later start at 0 here.",
    examples: &["reference"],
    parse: |_| Ok(Command::Reference),
    changes_world: true,
};
