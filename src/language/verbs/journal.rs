//! `journal` and `source`: commands to and from a file.

use crate::language::command::Command;
use crate::language::list::Card;

/// Row of `journal` in the list.
pub const CARD: Card = Card {
    name: "journal",
    aliases: &[],
    usage: "journal FILE",
    summary: "writes the commands of this session",
    detail: "Each with the cycle it took effect at; `ballast run FILE` repeats them to the same \
             bits.",
    examples: &["journal monday.journal"],
    parse: |words| words.file().map(Command::Journal),
    changes_world: false,
};

/// Row of `source` in the list.
pub const SOURCE: Card = Card {
    name: "source",
    aliases: &[],
    usage: "source FILE",
    summary: "executes the commands in a file",
    detail: "One in a line; empty lines and comments after # are skipped.",
    examples: &["source load.txt"],
    parse: |words| words.file().map(Command::Source),
    changes_world: false,
};
