//! `save` and `restore`: checkpoints.

use crate::language::command::Command;
use crate::language::list::Card;

/// Row of `save` in the list.
pub const CARD: Card = Card {
    name: "save",
    aliases: &[],
    usage: "save FILE",
    summary: "writes a checkpoint",
    detail: "It holds everything the run needs to continue to the same bits. Quote names with \
             spaces.",
    examples: &["save loaded.ballast", "save \"after shear.ballast\""],
    parse: |words| words.file().map(Command::Save),
    changes_world: false,
};

/// Row of `restore` in the list.
pub const RESTORE: Card = Card {
    name: "restore",
    aliases: &[],
    usage: "restore FILE",
    summary: "continues from a checkpoint",
    detail: "What was not saved before is gone.",
    examples: &["restore loaded.ballast"],
    parse: |words| words.file().map(Command::Restore),
    changes_world: true,
};
