//! Journals: one text file from which a run can be repeated to the bit.
//!
//! ```text
//! ballast journal 1
//! program "0.1.0"
//! preset "nine-disc-compression"
//! seed 7
//! set "model.frac=0.2"
//! begin preset
//! | [model]
//! | law = "linear"
//! |
//! end preset
//! @0 stage load
//! @0 : wall left velocity 0.12 0
//! @40 friction 0.3
//! @100 end
//! ```
//!
//! `@40 friction 0.3` was typed or pressed before cycle 41; `@0 : ...` was issued by a stage and
//! stands there for the reader: in a replay the stage issues it again. `@90 fault ...` says that the
//! run could not go on there; what follows it was done nevertheless. `@90 back 60 3 a.ballast` says
//! that `restore a.ballast` set the world back to cycle 60 as it was after the first 3 events: a
//! replay needs no file for that. Text that could be taken for something else is put in quotes. The
//! number of threads is not in it, for it changes no bit.

mod parse;
mod quotes;
mod writer;

use std::fmt;

use serde::{Deserialize, Serialize};

pub use parse::JournalError;
pub use writer::JournalWriter;

/// How the first line starts, whatever the format.
const TITLE: &str = "ballast journal";

/// The format this program writes and reads.
const FORMAT: &str = "1";

/// Everything that decides a run, and what happened in it.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Journal {
    /// Version of the program that ran.
    pub program: String,
    /// Name or path of the preset.
    pub preset_name: String,
    /// The whole preset.
    pub preset_text: String,
    /// Seed given instead of the preset's.
    pub seed: Option<u64>,
    /// `KEY=VALUE` of each `--set`, in order.
    pub overrides: Vec<String>,
    /// What happened, in order. Cycles go back only where a command has set the world back.
    pub events: Vec<Event>,
    /// Whether a last, unfinished line was left out: the run was killed while it wrote.
    pub cut: bool,
}

/// One thing that happened.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Event {
    /// Cycles done when it took effect.
    pub cycle: u64,
    /// What it was.
    pub kind: EventKind,
}

/// Kinds of event.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub enum EventKind {
    /// A command that somebody typed or pressed.
    Typed(String),
    /// A command that a stage of the preset issued.
    Staged(String),
    /// The start of a stage, by name.
    Stage(String),
    /// The end of the run.
    End,
    /// The run could not go on, for this reason.
    Fault(String),
    /// A state of this run was restored.
    Back {
        /// Which state.
        to: Moment,
        /// The file that held it.
        file: String,
    },
}

/// A state that a run has gone through: nothing but cycles passes between two events.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Moment {
    /// Events before it.
    pub events: usize,
    /// Cycles done.
    pub cycle: u64,
}

impl Journal {
    /// Reads a journal; an unfinished last line and a missing end are allowed.
    pub fn parse(text: &str) -> Result<Self, JournalError> {
        parse::journal(text)
    }

    /// Whether the run came to its end, rather than being killed.
    pub fn is_complete(&self) -> bool {
        matches!(self.events.last(), Some(event) if event.kind == EventKind::End)
    }

    /// The last moment of `earlier`, at this cycle, if it is one that this run went through too.
    pub fn moment_of(&self, earlier: &Self, cycle: u64) -> Option<Moment> {
        let events = earlier.events.len();
        let passed = |next: &Event| cycle <= next.cycle;
        let through =
            self.events.starts_with(&earlier.events) && self.events.get(events).is_none_or(passed);
        through.then_some(Moment { events, cycle })
    }
}

/// Whether a text is meant as a journal: presets start otherwise.
pub fn looks_like_journal(text: &str) -> bool {
    without_mark(text).starts_with(TITLE)
}

/// The text less the byte order mark that some editors put first.
fn without_mark(text: &str) -> &str {
    text.strip_prefix('\u{feff}').unwrap_or(text)
}

impl fmt::Display for Journal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{TITLE} {FORMAT}")?;
        writeln!(f, "program {}", quotes::quoted(&self.program))?;
        writeln!(f, "preset {}", quotes::quoted(&self.preset_name))?;
        if let Some(seed) = self.seed {
            writeln!(f, "seed {seed}")?;
        }
        for setting in &self.overrides {
            writeln!(f, "set {}", quotes::quoted(setting))?;
        }
        writeln!(f, "begin preset")?;
        // Not `lines()`: it hides whether the last line ended.
        for line in self.preset_text.split('\n') {
            writeln!(f, "| {line}")?;
        }
        writeln!(f, "end preset")?;
        self.events
            .iter()
            .try_for_each(|event| writeln!(f, "{event}"))
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "@{} ", self.cycle)?;
        match &self.kind {
            EventKind::Typed(command) if parse::is_reserved(command) => {
                f.write_str(&quotes::quoted(command))
            }
            EventKind::Typed(command) => f.write_str(&quotes::quoted_if_needed(command)),
            EventKind::Staged(command) => {
                write!(f, ": {}", quotes::quoted_if_needed(command))
            }
            EventKind::Stage(name) => write!(f, "stage {}", quotes::quoted_if_needed(name)),
            EventKind::End => f.write_str("end"),
            EventKind::Fault(why) => write!(f, "fault {}", quotes::quoted_if_needed(why)),
            EventKind::Back { to, file } => {
                let Moment { events, cycle } = to;
                write!(
                    f,
                    "back {cycle} {events} {}",
                    quotes::quoted_if_needed(file)
                )
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    /// Texts that try to break the format.
    fn nasty() -> impl Strategy<Value = String> {
        prop_oneof![
            any::<String>(),
            "[ -~]{0,20}",
            "(stage|end|:|@3|\"|\\\\|\\||begin preset|end preset| |\n|\r|\t|x){0,6}",
        ]
    }

    prop_compose! {
        fn event()(cycle in any::<u64>(), kind in prop_oneof![
            nasty().prop_map(EventKind::Typed),
            nasty().prop_map(EventKind::Staged),
            nasty().prop_map(EventKind::Stage),
            nasty().prop_map(EventKind::Fault),
            (any::<usize>(), any::<u64>(), nasty()).prop_map(|(events, cycle, file)| {
                EventKind::Back { to: Moment { events, cycle }, file }
            }),
        ]) -> Event {
            Event { cycle, kind }
        }
    }

    prop_compose! {
        fn journal()(
            program in nasty(),
            preset_name in nasty(),
            preset_text in nasty(),
            seed in any::<Option<u64>>(),
            overrides in vec(nasty(), 0..4),
            mut events in vec(event(), 0..6),
            ended in any::<bool>(),
        ) -> Journal {
            if ended {
                events.push(Event { cycle: 9, kind: EventKind::End });
            }
            Journal { program, preset_name, preset_text, seed, overrides, events, cut: false }
        }
    }

    proptest! {
        #[test]
        fn every_journal_survives_being_written_and_read(journal in journal()) {
            prop_assert_eq!(Journal::parse(&journal.to_string()), Ok(journal));
        }

        #[test]
        fn a_killed_writer_costs_the_unfinished_line_only(journal in journal(), at in 0.0..1.0) {
            let text = journal.to_string();
            let mut length = (text.len() as f64 * at) as usize;
            while !text.is_char_boundary(length) {
                length -= 1;
            }
            let header = text.find("\nend preset\n").unwrap() + "\nend preset\n".len();
            match Journal::parse(&text[..length]) {
                Ok(read) => {
                    let whole_lines = text[..length].matches('\n').count();
                    let lines_before = text[..header].matches('\n').count();
                    let events = &journal.events[..whole_lines - lines_before];
                    prop_assert_eq!(read.events, events);
                    prop_assert_eq!(read.cut, !text[..length].ends_with('\n'));
                    prop_assert_eq!(read.preset_text, journal.preset_text);
                }
                Err(error) => prop_assert!(length < header, "{}", error),
            }
        }

        #[test]
        fn noise_never_panics(text in nasty()) {
            let _ = Journal::parse(&text);
            let _ = Journal::parse(&format!("ballast journal 1\n{text}"));
        }
    }

    fn small() -> Journal {
        let event = |cycle, kind| Event { cycle, kind };
        let back = EventKind::Back {
            to: Moment {
                events: 3,
                cycle: 60,
            },
            file: "my runs/a.ballast".into(),
        };
        Journal {
            program: "0.1.0".into(),
            preset_name: "nine-disc-compression".into(),
            preset_text: "[model]\nlaw = \"linear\"\n".into(),
            seed: Some(7),
            overrides: vec!["model.frac=0.2".into()],
            events: vec![
                event(0, EventKind::Stage("load".into())),
                event(0, EventKind::Staged("wall left velocity 0.12 0".into())),
                event(40, EventKind::Typed("friction 0.3".into())),
                event(41, EventKind::Typed("end".into())),
                event(90, EventKind::Fault("particle 1 ran away".into())),
                event(90, back),
                event(100, EventKind::End),
            ],
            cut: false,
        }
    }

    #[test]
    fn the_text_is_as_documented() {
        let text = "ballast journal 1\nprogram \"0.1.0\"\npreset \"nine-disc-compression\"\nseed 7\n\
                    set \"model.frac=0.2\"\nbegin preset\n| [model]\n| law = \"linear\"\n| \n\
                    end preset\n@0 stage load\n@0 : wall left velocity 0.12 0\n@40 friction 0.3\n\
                    @41 \"end\"\n@90 fault particle 1 ran away\n\
                    @90 back 60 3 my runs/a.ballast\n@100 end\n";
        assert_eq!(small().to_string(), text);
        assert!(looks_like_journal(text));
        assert!(!looks_like_journal(
            "[about]\ntitle = \"ballast journal\"\n"
        ));
    }

    #[test]
    fn editors_may_change_line_ends_and_strip_spaces() {
        let text = small().to_string().replace("| \n", "|\n");
        assert_eq!(Journal::parse(&text), Ok(small()));
        let windows = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        assert_eq!(Journal::parse(&windows), Ok(small()));
    }

    #[test]
    fn the_carriage_returns_of_a_preset_are_its_own() {
        let preset_text = "a = 1\r\nb = 2\r\n".to_owned();
        let journal = Journal {
            preset_text,
            ..small()
        };
        assert_eq!(Journal::parse(&journal.to_string()), Ok(journal));
    }
}
