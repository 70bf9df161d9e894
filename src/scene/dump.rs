//! `[dump]`: tables of all particles or contacts in the course of a run.

use super::draft::Draft;
use super::key::{Absent, COUNT_MAX, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::language::command::DumpOf;

/// What is written besides the history.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Dump {
    /// Tables are written every so many cycles.
    pub every: u64,
    /// Which, each once.
    pub what: Vec<DumpOf>,
    /// Form of the files.
    pub format: Format,
}

/// Form of the files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// Tables.
    Csv,
    /// Legacy VTK.
    Vtk,
}

impl Format {
    /// Ending of the names.
    pub fn ending(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Vtk => "vtk",
        }
    }
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "dump",
    shape: Shape::Single,
    required: false,
    summary: "tables of all particles or contacts, one file each, at cycle 0, every so many cycles \
              and at the end of each stage",
    keys: KEYS,
    read,
};

const WHAT: &[&str] = &["particles", "contacts"];

const KEYS: &[Key] = &[
    Key {
        name: "every",
        form: Form::Count(1, COUNT_MAX),
        unit: "cycles",
        absent: Absent::Said("required with `what`"),
        summary: "number of cycles from table to table",
    },
    Key {
        name: "what",
        form: Form::Words(WHAT),
        unit: "-",
        absent: Absent::Said("no dumps"),
        summary: "which tables: STEM.particles.CYCLE.csv, STEM.contacts.CYCLE.csv beside the history",
    },
    Key {
        name: "format",
        form: Form::Word(&["csv", "vtk"]),
        unit: "-",
        absent: Absent::Word("csv"),
        summary: "form of the files: tables, or legacy VTK for ParaView, whose names end in .vtk",
    },
];

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let format = match reader.word("format") {
        Some("vtk") => Format::Vtk,
        _ => Format::Csv,
    };
    let (every, words) = (reader.count("every"), reader.words("what"));
    match (reader.has("every"), reader.has("what")) {
        (false, false) => return,
        (true, true) => {}
        (true, false) => {
            return reader.refuse(
                "every",
                "[dump] says how often, but not what",
                "`what` is missing",
                "add what = [\"particles\"], or \"contacts\", or both",
            );
        }
        (false, true) => {
            return reader.refuse(
                "what",
                "[dump] says what, but not how often",
                "`every` is missing",
                "add every = number of cycles",
            );
        }
    }
    let (Some(every), Some(words)) = (every, words) else {
        return;
    };
    let mut what = Vec::new();
    for word in words {
        let of = DumpOf::of(word);
        if what.contains(&of) {
            reader.refuse(
                "what",
                &format!("`{word}` is listed twice in [dump]"),
                "each is written once",
                "leave one of them out",
            );
            return;
        }
        what.push(of);
    }
    if what.is_empty() {
        reader.refuse(
            "what",
            "[dump] lists nothing",
            "expected \"particles\", \"contacts\" or both",
            "leave [dump] out for no dumps",
        );
        return;
    }
    draft.dump = Some(Dump {
        every,
        what,
        format,
    });
}
