//! The list of commands. Reading, help, completion and the table in the README derive from it.

use super::command::Command;
use super::mistake::{Mistake, either, shown};
use super::verbs;
use super::words::Words;
use crate::measure::columns::near;
use std::fmt::Write as _;
use std::ops::Range;

/// A command's row in the list.
#[derive(Debug)]
pub struct Card {
    /// The verb.
    pub name: &'static str,
    /// Other words for it.
    pub aliases: &'static [&'static str],
    /// How it is written: capitals stand for values, brackets for what may be left out.
    pub usage: &'static str,
    /// One line.
    pub summary: &'static str,
    /// What one has to know to use it.
    pub detail: &'static str,
    /// Lines that can be typed as they are.
    pub examples: &'static [&'static str],
    /// Reads what follows the verb.
    pub parse: fn(&mut Words<'_>) -> Result<Command, Mistake>,
    /// Whether it changes the world itself, rather than running, showing or keeping it.
    pub changes_world: bool,
}

/// All commands, in the order help shows them.
pub const COMMANDS: &[Card] = &[
    verbs::create::CARD,
    verbs::generate::CARD,
    verbs::grow::CARD,
    verbs::delete::CARD,
    verbs::wall::CARD,
    verbs::particle::CARD,
    verbs::property::CARD,
    verbs::friction::CARD,
    verbs::bond::CARD,
    verbs::frac::CARD,
    verbs::damp::CARD,
    verbs::con1::CARD,
    verbs::gravity::CARD,
    verbs::boundary::CARD,
    verbs::strain::CARD,
    verbs::strain::STRESS,
    verbs::servo::CARD,
    verbs::strain::CONTINUUM,
    verbs::rotation::CARD,
    verbs::zero::CARD,
    verbs::reference::CARD,
    verbs::cycle::CARD,
    verbs::solve::CARD,
    verbs::cycle::STEP,
    verbs::cycle::GO,
    verbs::cycle::PAUSE,
    verbs::print::CARD,
    verbs::inspect::CARD,
    verbs::history::CARD,
    verbs::save::CARD,
    verbs::save::RESTORE,
    verbs::export::CARD,
    verbs::journal::CARD,
    verbs::journal::SOURCE,
    verbs::help::CARD,
    verbs::quit::CARD,
];

impl Card {
    /// The verb and its aliases.
    pub fn words(&self) -> impl Iterator<Item = &'static str> {
        std::iter::once(self.name).chain(self.aliases.iter().copied())
    }

    /// The page that `help` shows of it.
    pub fn page(&self) -> String {
        let mut lines = vec![
            self.usage.to_owned(),
            format!("{}. {}", self.summary, self.detail),
        ];
        if !self.aliases.is_empty() {
            lines.push(format!("also: {}", self.aliases.join(", ")));
        }
        lines.extend(self.examples.iter().map(|example| format!("  {example}")));
        lines.join("\n") + "\n"
    }
}

/// Finds a command by its verb, an alias or a prefix that fits no other command.
pub fn find(word: &str, span: Range<usize>) -> Result<&'static Card, Mistake> {
    let typed = word.to_lowercase();
    if let Some(card) = COMMANDS.iter().find(|c| c.words().any(|w| w == typed)) {
        return Ok(card);
    }
    let fits: Vec<&'static Card> = COMMANDS
        .iter()
        .filter(|card| card.words().any(|w| w.starts_with(&typed)))
        .collect();
    match fits.as_slice() {
        [card] => Ok(card),
        [] => {
            let remedy = match near(&typed, COMMANDS.iter().flat_map(Card::words)) {
                Some(best) => format!("did you mean `{best}`?"),
                None => "`help` lists them".into(),
            };
            let message = format!("{} is no command", shown(word));
            Err(Mistake::new(message, remedy, span))
        }
        several => {
            let mut names: Vec<&str> = several.iter().map(|card| card.name).collect();
            names.sort_unstable();
            let message = format!("{} could be {}", shown(word), either(&names));
            Err(Mistake::new(message, "write more of it", span))
        }
    }
}

/// The commands as a Markdown table.
pub fn reference_table() -> String {
    let mut table = String::from("| command | what it does |\n|---|---|\n");
    for card in COMMANDS {
        // A bar inside a cell would begin the next one.
        let usage = card.usage.replace('|', "\\|");
        writeln!(table, "| `{usage}` | {} |", card.summary).expect("strings take any text");
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_example_is_understood_by_its_own_card() {
        for card in COMMANDS {
            assert!(!card.examples.is_empty(), "{} has no example", card.name);
            for example in card.examples {
                let command = Command::parse(example).unwrap_or_else(|m| panic!("{example}: {m}"));
                assert_eq!(command.card().name, card.name, "{example}");
                assert_eq!(
                    Command::parse(&command.to_string()),
                    Ok(command),
                    "{example}"
                );
            }
        }
    }

    #[test]
    fn words_are_unique_and_cards_complete() {
        let mut words: Vec<&str> = COMMANDS.iter().flat_map(Card::words).collect();
        words.sort_unstable();
        let count = words.len();
        words.dedup();
        assert_eq!(words.len(), count);
        for card in COMMANDS {
            assert!(card.usage.starts_with(card.name), "{}", card.name);
            assert!(card.detail.ends_with('.'), "{}", card.name);
            assert!(!card.summary.ends_with('.'), "{}", card.name);
            assert!(card.page().contains(card.examples[0]));
        }
    }

    #[test]
    fn the_table_has_a_row_for_every_command() {
        let table = reference_table();
        assert_eq!(table.lines().count(), COMMANDS.len() + 2);
        for row in table.lines() {
            let bars = row.replace("\\|", "").matches('|').count();
            assert_eq!(bars, 3, "{row}");
        }
    }
}
