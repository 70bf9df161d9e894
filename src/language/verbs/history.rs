//! `history`: chooses what is recorded.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::observable::Observable;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "history",
    aliases: &[],
    usage: "history [every N | columns NAME,NAME,...]",
    summary: "shows or changes what is recorded",
    detail: "every is a number of cycles. Columns come in the order they are named, after cycle, \
             time and stage; `ballast columns` lists them.",
    examples: &[
        "history",
        "history every 100",
        "history columns kinetic, wall:left:f1, contact:1-2:n",
    ],
    parse,
    changes_world: false,
};

/// What to do about the history.
#[derive(Debug, Clone, PartialEq)]
pub enum HistoryChange {
    /// Nothing: show it.
    Show,
    /// Record a row every so many cycles.
    Every(u64),
    /// Record these columns.
    Columns(Vec<Observable>),
}

type Reader = fn(&mut Words<'_>) -> Result<HistoryChange, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let options: [(&'static str, Reader); 2] = [
        ("every", |w| {
            w.count("the number of cycles").map(HistoryChange::Every)
        }),
        ("columns", |w| w.columns().map(HistoryChange::Columns)),
    ];
    let change = match words.choose_if_any(&options)? {
        Some(read) => read(words)?,
        None => HistoryChange::Show,
    };
    Ok(Command::History(change))
}

impl fmt::Display for HistoryChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Show => Ok(()),
            Self::Every(count) => write!(f, " every {count}"),
            Self::Columns(columns) => {
                let names: Vec<String> = columns.iter().map(Observable::name).collect();
                write!(f, " columns {}", names.join(","))
            }
        }
    }
}
