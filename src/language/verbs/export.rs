//! `export`: writes the history for other programs.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "export",
    aliases: &[],
    usage: "export csv FILE",
    summary: "writes the history recorded so far",
    detail: "One header row, then a row for each sample.",
    examples: &["export csv shear.csv"],
    parse,
    changes_world: false,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.keyword(&["csv"])?;
    words.file().map(Command::ExportCsv)
}
