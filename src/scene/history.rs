//! `[history]`: which columns are recorded, and how often.

use super::draft::Draft;
use super::key::{Absent, COUNT_MAX, Form, Key};
use super::phrase;
use super::place::quoted;
use super::problem::Problem;
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::language::Observable;

/// What is recorded of a run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// A row is written every so many cycles.
    pub every: u64,
    /// Columns after cycle, time and stage.
    pub columns: Vec<Observable>,
    /// Whether the preset names the columns, rather than leaving them to the default.
    pub named: bool,
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "history",
    shape: Shape::Single,
    required: false,
    summary: "which columns are recorded, and how often",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        name: "every",
        form: Form::Count(1, COUNT_MAX),
        unit: "cycles",
        absent: Absent::Count(100),
        summary: "number of cycles from row to row",
    },
    Key {
        name: "columns",
        form: Form::Texts,
        unit: "-",
        absent: Absent::Said("the usual ones"),
        summary: "list of columns after cycle, time and stage",
    },
    Key {
        name: "define",
        form: Form::Definitions,
        unit: "-",
        absent: Absent::Said("none"),
        summary: "columns computed from others, for histories, conditions and expectations",
    },
    Key {
        name: "check_every",
        form: Form::Count(1, COUNT_MAX),
        unit: "cycles",
        absent: Absent::Said("`every`"),
        summary: "number of cycles between tests of conditions that read columns",
    },
];

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    for (definition, text, place) in &draft.definitions {
        let checked = definition.expression.check(&draft.ever);
        phrase::accept(reader.report, checked, text, *place);
    }
    let mut columns = Vec::new();
    for (text, place) in reader.texts("columns").unwrap_or_default() {
        let parsed = Observable::parse(text, 0..text.len(), &draft.known.definitions);
        let Some(column) = phrase::accept(reader.report, parsed, text, place) else {
            continue;
        };
        if columns.contains(&column) {
            reader.report.add(
                Problem::new(format!("column {} is listed twice", quoted(text)), place)
                    .expected("a second one of this name")
                    .remedy("leave it out: every column has one name in the CSV"),
            );
            continue;
        }
        draft.check_column(&column, text, place);
        columns.push(column);
    }
    let named = reader.has("columns");
    if named && columns.is_empty() && reader.is_sound() {
        reader.refuse(
            "columns",
            "[history] lists no columns",
            "expected at least one column",
            "leave `columns` out for the usual ones, or name some: `ballast columns` lists them",
        );
    }
    draft.history = History {
        every: reader.count("every").unwrap_or_default(),
        columns: if named { columns } else { Observable::usual() },
        named,
    };
    draft.check_every = reader.count("check_every");
}
