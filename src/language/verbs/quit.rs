//! `quit`: ends the session.

use crate::language::command::Command;
use crate::language::list::Card;

/// Row in the list.
pub const CARD: Card = Card {
    name: "quit",
    aliases: &["q", "quit!", "q!"],
    usage: "quit|quit!",
    summary: "ends the session",
    detail: "It asks when cycles have run since the last save; with `!` it does not.",
    examples: &["quit", "q", "quit!", "q!"],
    parse: |words| {
        let anyway = words.verb().ends_with('!');
        Ok(Command::Quit { anyway })
    },
    changes_world: false,
};
