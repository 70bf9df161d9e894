//! `[[stage]]`: what is done, and until when the scene then runs.

use super::draft::Draft;
use super::key::{Absent, COUNT_MAX, Form, Key};
use super::phrase;
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::language::command::{Export, HistoryChange};
use crate::language::{Command, Expression, Mistake};

/// One stage of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Stage {
    /// Name in histories and messages.
    pub name: String,
    /// Commands executed at its beginning.
    pub commands: Vec<Command>,
    /// It ends when this holds; `None`: after `max_cycles`.
    pub until: Option<Expression>,
    /// It ends after this many cycles at the latest.
    pub max_cycles: Option<u64>,
    /// `until` is tested every so many cycles if it reads columns; `None`: as the scene says.
    pub check_every: Option<u64>,
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "stage",
    shape: Shape::Listed,
    required: false,
    summary: "what is done, and until when the scene then runs; stages run in order",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        name: "name",
        form: Form::Text,
        unit: "-",
        absent: Absent::Wrong,
        summary: "name in histories, [[expect]] and --set",
    },
    Key {
        name: "do",
        form: Form::Texts,
        unit: "-",
        absent: Absent::Said("nothing"),
        summary: "list of console commands executed at its beginning",
    },
    Key {
        name: "until",
        form: Form::Text,
        unit: "-",
        absent: Absent::Said("`max_cycles` is its length"),
        summary: "condition that ends it, such as unbalanced < 1e-3 and stage_cycle > 100",
    },
    Key {
        name: "max_cycles",
        form: Form::Count(1, COUNT_MAX),
        unit: "cycles",
        absent: Absent::Said("no limit"),
        summary: "number of cycles after which it ends in any case",
    },
    Key {
        name: "check_every",
        form: Form::Count(1, COUNT_MAX),
        unit: "cycles",
        absent: Absent::Said("history.check_every"),
        summary: "number of cycles between tests of `until` if it reads columns",
    },
];

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let name = reader.text("name");
    if let Some((name, place)) = name {
        draft.check_name(name, place);
        let taken = draft
            .stages
            .iter()
            .map(|(stage, place)| (stage.name.as_str(), *place));
        draft.check_unique(name, place, taken);
    }
    let mut commands = Vec::new();
    for (text, place) in reader.texts("do").unwrap_or_default() {
        let parsed = Command::parse_with(text, &draft.known.definitions)
            .and_then(|command| belongs(command, text));
        if let Some(command) = phrase::accept(reader.report, parsed, text, place) {
            draft.follow(&command, text, place);
            commands.push(command);
        }
    }
    let until = reader.text("until").and_then(|(text, place)| {
        let parsed = Expression::parse_condition_with(text, &draft.known.definitions);
        let until = phrase::accept(reader.report, parsed, text, place)?;
        let checked = until.check(&draft.known.names);
        phrase::accept(reader.report, checked, text, place).map(|()| until)
    });
    if ["do", "until", "max_cycles"]
        .iter()
        .all(|key| !reader.has(key))
    {
        reader.refuse(
            "",
            &format!("{} does nothing", reader.title),
            "neither `do` nor `until` nor `max_cycles`",
            "add `max_cycles` for its length, `until` for a condition, `do` for commands",
        );
    }
    let stage = Stage {
        name: name.map_or_else(String::new, |(name, _)| name.to_owned()),
        commands,
        until,
        max_cycles: reader.count("max_cycles"),
        check_every: reader.count("check_every"),
    };
    let place = name.map_or(reader.place, |(_, place)| place);
    draft.stages.push((stage, place));
}

/// A run is what its preset says: a stage neither waits for a person nor touches files.
fn belongs(command: Command, text: &str) -> Result<Command, Mistake> {
    let why = match &command {
        Command::Go | Command::Pause | Command::Quit { .. } | Command::Help(_) => {
            "stages run by themselves: `until` and `max_cycles` say how long"
        }
        Command::Save(_) | Command::Restore(_) | Command::Source(_) | Command::Journal(_) => {
            "put the commands themselves here; files are named on the command line"
        }
        Command::History(HistoryChange::Columns(_)) => "name them in [history] columns",
        Command::Export(Export::History, _) => "`ballast run PRESET --csv FILE` writes the history",
        Command::Export(Export::Contact(_), _) => {
            "type it, or send it to `ballast PRESET --plain`; `inspect contact` itself may stand here"
        }
        Command::Export(..) => "[dump] writes tables in the course of a run",
        _ => return Ok(command),
    };
    let verb = command.card().name;
    let message = format!("`{verb}` has no place in a preset");
    Err(Mistake::new(message, why, 0..text.len()))
}
