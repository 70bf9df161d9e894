//! Words that only the screen understands, typed like commands. Reading, help and completion derive
//! from one list.

use super::{App, Effect};
use crate::language::COMMANDS;
use crate::language::mistake::{either, shown};
use crate::measure::columns::{near, nearest};
use crate::scene::catalogue::PRESETS;
use crate::session::worker::Order;
use crate::tui::panes::PANES;

/// What is said, and what has to be done; or why nothing is.
type Outcome = Result<(String, Effect), String>;

/// A word's row in the list.
pub struct Word {
    /// The word.
    pub name: &'static str,
    /// How it is written: capitals stand for values.
    pub usage: &'static str,
    /// One line.
    pub summary: &'static str,
    /// What one has to know to use it.
    pub detail: &'static str,
    /// A line that can be typed as it is.
    pub example: &'static str,
    /// What could follow it.
    pub values: fn() -> Vec<&'static str>,
    /// Does it with what follows the word.
    act: fn(&mut App, &str) -> Outcome,
}

/// All words of the screen, in the order help shows them.
pub const WORDS: &[Word] = &[
    Word {
        name: "load",
        usage: "load PRESET",
        summary: "starts a preset that is part of the program",
        detail: "The run so far ends with its state and journal saved; b browses the presets.",
        example: "load disc-pile",
        values: || PRESETS.iter().map(|preset| preset.name).collect(),
        act: |_, name| match PRESETS.iter().find(|preset| preset.name == name) {
            Some(preset) => Ok((String::new(), Effect::Load(preset.name))),
            None if name.is_empty() => Err("`load` needs a preset; b browses them".to_owned()),
            None => {
                let near = nearest(name, PRESETS.iter().map(|preset| preset.name));
                let name = shown(name);
                Err(format!("there is no preset {name}; {near}; b browses them"))
            }
        },
    },
    Word {
        name: "pace",
        usage: "pace N | max",
        summary: "sets how many cycles per second are aimed at",
        detail: "max or 0 stands for as many as possible. { and } halve and double it, | is max.",
        example: "pace 200",
        values: || vec!["max"],
        act: |_, number| match Rate::read(number) {
            Some(pace) => Ok((
                match pace {
                    Rate::To(pace) => format!("{pace} cycles per second are aimed at"),
                    Rate::Nothing => "as many cycles per second as possible".to_owned(),
                },
                Effect::Order(Order::Pace(pace.limit())),
            )),
            None => Err(refused(number, "pace N | max", "cycles per second")),
        },
    },
    Word {
        name: "pane",
        usage: "pane NAME",
        summary: "puts this pane in the place in focus, as p does",
        detail: "The beginning of its name will do. The assembly keeps its place, but on a screen with room \
                 for one pane only.",
        example: "pane mohr circle",
        values: || PANES.iter().map(|(_, pane)| pane.name).collect(),
        act: |app, name| {
            app.place_by_name(name)
                .map(|()| (String::new(), Effect::None))
        },
    },
    Word {
        name: "set",
        usage: "set kbps N | max",
        summary: "sets how many kB/s the screen may use",
        detail: "What the line cannot carry is left out, never queued. max or 0 stands for any number.",
        example: "set kbps 20",
        values: || vec!["kbps"],
        act: |app, rest| {
            let (what, number) = rest.split_once(' ').unwrap_or((rest, ""));
            match Rate::read(number.trim()) {
                Some(kbps) if what == "kbps" => {
                    app.link.budget = kbps.limit().map(|kbps| 1000.0 * kbps);
                    let answer = match kbps {
                        Rate::To(kbps) => format!("the screen uses {kbps} kB/s at most"),
                        Rate::Nothing => "the screen may use any number of kB/s".to_owned(),
                    };
                    Ok((answer, Effect::None))
                }
                _ => Err(refused(rest, "set kbps N | max", "kB/s")),
            }
        },
    },
];

/// What a rate is limited to.
enum Rate {
    To(f64),
    Nothing,
}

impl Rate {
    fn read(text: &str) -> Option<Self> {
        if text == "max" {
            return Some(Self::Nothing);
        }
        match text.parse::<f64>() {
            Ok(0.0) => Some(Self::Nothing),
            Ok(rate) if rate > 0.0 && rate.is_finite() => Some(Self::To(rate)),
            _ => None,
        }
    }

    fn limit(&self) -> Option<f64> {
        match self {
            Self::To(rate) => Some(*rate),
            Self::Nothing => None,
        }
    }
}

fn refused(what: &str, usage: &str, unit: &str) -> String {
    let stands = if what.is_empty() {
        format!("a number of {unit} is missing")
    } else {
        format!("{} is no number of {unit}", shown(what))
    };
    format!("{stands}; usage: {usage}")
}

impl Word {
    /// The page that `help` shows of it.
    fn page(&self) -> Vec<String> {
        vec![
            self.usage.to_owned(),
            format!("{}. {}", self.summary, self.detail),
            format!("  {}", self.example),
        ]
    }
}

/// The word that a line begins with, or with a beginning of that no command shares, and what
/// follows it.
pub fn find(line: &str) -> Option<(&'static Word, &str)> {
    let (verb, rest) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
    let verb = verb.to_lowercase();
    let found = WORDS.iter().find(|word| word.name == verb).or_else(|| {
        let mut fitting = words_of(&verb);
        let first = fitting.next()?;
        (fitting.next().is_none() && commands_of(&verb).is_empty()).then_some(first)
    });
    found.map(|word| (word, rest.trim()))
}

fn words_of(beginning: &str) -> impl Iterator<Item = &'static Word> {
    WORDS
        .iter()
        .filter(move |word| !beginning.is_empty() && word.name.starts_with(beginning))
}

/// Names of the commands that begin like this.
fn commands_of(beginning: &str) -> Vec<&'static str> {
    let fits = |card: &&crate::language::Card| card.words().any(|word| word.starts_with(beginning));
    COMMANDS.iter().filter(fits).map(|card| card.name).collect()
}

/// Whether a verb asks for help.
pub fn asks_for_help(verb: &str) -> bool {
    let verb = verb.to_lowercase();
    verb == "?" || commands_of(&verb) == ["help"]
}

/// The page of the word that a line asks help about, if it is one of the screen's.
pub fn help(line: &str) -> Option<Vec<String>> {
    let (verb, about) = line.split_once(char::is_whitespace)?;
    if !asks_for_help(verb) {
        return None;
    }
    match find(about.trim()) {
        Some((word, "")) => Some(word.page()),
        _ => None,
    }
}

/// What `help` adds to the list of commands.
pub fn listing() -> impl Iterator<Item = String> {
    let rows = WORDS
        .iter()
        .map(|word| format!("{:9}  {}", word.name, word.summary));
    std::iter::once("of the screen only:".to_owned()).chain(rows)
}

/// What to answer to a verb that neither is a command nor a word of the screen, where a word of the
/// screen may have been meant; `None`: commands know better.
pub fn mistaken(line: &str) -> Option<String> {
    let typed = line.split_whitespace().next()?;
    let verb = typed.to_lowercase();
    let commands = commands_of(&verb);
    let words: Vec<&str> = words_of(&verb).map(|word| word.name).collect();
    if commands.is_empty() && words.is_empty() {
        let known = COMMANDS.iter().flat_map(crate::language::Card::words);
        let best = near(&verb, known.chain(WORDS.iter().map(|word| word.name)))?;
        let is_ours = WORDS.iter().any(|word| word.name == best);
        return is_ours.then(|| format!("{} is no command; did you mean `{best}`?", shown(typed)));
    }
    // One command that fits is that command, as it is in a journal.
    if words.is_empty() || commands.len() == 1 || commands.contains(&verb.as_str()) {
        return None;
    }
    let mut names = [commands, words].concat();
    names.sort_unstable();
    Some(format!(
        "{} could be {}; write more of it",
        shown(typed),
        either(&names)
    ))
}

impl App {
    /// Does what a word of the screen says.
    pub(super) fn act_on(&mut self, word: &Word, rest: &str) -> Outcome {
        (word.act)(self, rest)
    }
}
