//! The tables a preset is made of. A section declares its keys and reads one table into the
//! draft; here they are found in the document and opened.

use super::document::{Entry, Node, Table, Value};
use super::draft::{Draft, Wrote};
use super::key::Key;
use super::place::{Place, quoted};
use super::problem::{Problem, Report};
use super::reader::Reader;
use super::start::Given;
use crate::measure::columns::near;

/// A table of presets.
pub(crate) struct Section {
    /// Its name.
    pub(crate) name: &'static str,
    /// How often it is written.
    pub(crate) shape: Shape,
    /// Whether a preset must have one.
    pub(crate) required: bool,
    /// One line.
    pub(crate) summary: &'static str,
    /// Its keys, in the order of the reference.
    pub(crate) keys: &'static [Key],
    /// Reads one of them.
    pub(crate) read: for<'a> fn(&Reader<'a>, &mut Draft<'a>),
}

/// How a section is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// Once: `[model]`.
    Single,
    /// Once per name: `[material.glass]`.
    Named,
    /// Any number of times: `[[particle]]`.
    Listed,
}

impl Section {
    /// Its header in a preset; `name` stands for the name of a named one.
    pub(crate) fn header(&self, name: &str) -> String {
        match self.shape {
            Shape::Single => format!("[{}]", self.name),
            Shape::Named => format!("[{}.{name}]", self.name),
            Shape::Listed => format!("[[{}]]", self.name),
        }
    }

    /// Whether its keys are asked for by `name`: a listed table that has one.
    pub(crate) fn has_names(&self) -> bool {
        self.keys.iter().any(|key| key.name == "name")
    }
}

/// What an absent section holds.
static NOTHING: Table = Table {
    entries: Vec::new(),
};

/// Reads all sections of a document, in the order of the list: later ones name what earlier ones
/// declare.
pub(crate) fn read_all<'a>(document: &'a Table, report: &'a Report, given: Given<'a>) -> Draft<'a> {
    let mut draft = Draft::new(report);
    let wrote = |name: &str| document.get(name).is_some();
    draft.given = given;
    draft.wrote = Wrote {
        start: wrote("start"),
        particles: wrote("particle") || wrote("generate"),
        walls: wrote("wall"),
        boundary: wrote("boundary") || wrote("cell"),
    };
    for entry in &document.entries {
        if super::SECTIONS
            .iter()
            .all(|section| section.name != entry.key)
        {
            report.add(unknown(entry));
        }
    }
    super::define::read(document, &mut draft);
    for section in super::SECTIONS {
        match document.get(section.name) {
            Some(entry) => read(section, entry, &mut draft),
            None if section.required => {
                let header = section.header("NAME");
                report.add(
                    Problem::new(format!("the preset has no {header}"), Place::new(0, 0..0))
                        .expected(format!("{header} is missing"))
                        .remedy(format!("add {header}: {}", section.summary)),
                );
            }
            None if section.shape == Shape::Single => {
                let title = section.header("");
                let place = Place::new(0, 0..0);
                let reader = Reader::open(report, title, place, section.keys, &NOTHING);
                (section.read)(&reader, &mut draft);
            }
            None => {}
        }
    }
    if !draft.wrote.start && BODIES.iter().all(|name| is_absent(document, name)) {
        report.add(
            Problem::new(
                "the preset has no [[particle]] and no [[generate]]",
                Place::new(0, 0..0),
            )
            .expected("particles are missing")
            .remedy(
                "add [[particle]] for each one, or a [[generate]] that places many, or a [start] \
                 from where another run ended",
            ),
        );
    }
    draft
}

/// The tables that particles come from: a preset has one of them, or starts from a sample.
const BODIES: [&str; 2] = ["particle", "generate"];

/// Whether a listed table is written nowhere.
fn is_absent(document: &Table, name: &str) -> bool {
    let value = document.get(name).map(|entry| &entry.node.value);
    match value {
        None => true,
        Some(Value::List(items)) => items.is_empty(),
        Some(_) => false,
    }
}

fn read<'a>(section: &Section, entry: &'a Entry, draft: &mut Draft<'a>) {
    match (section.shape, &entry.node.value) {
        (Shape::Single, Value::Table(table)) => {
            let place = entry.node.place;
            open(section, section.header(""), place, table, None, draft);
        }
        (Shape::Named, Value::Table(tables)) => {
            if section.required && tables.entries.is_empty() {
                draft.report.add(misshapen(section, &entry.node));
            }
            for named in &tables.entries {
                let Value::Table(table) = &named.node.value else {
                    draft.report.add(misshapen(section, &named.node));
                    continue;
                };
                let title = section.header(&named.key);
                let place = named.node.place;
                open(section, title, place, table, Some(named), draft);
            }
        }
        (Shape::Listed, Value::List(items)) => {
            if section.required && items.is_empty() {
                draft.report.add(misshapen(section, &entry.node));
            }
            for (k, item) in items.iter().enumerate() {
                let Value::Table(table) = &item.value else {
                    draft.report.add(misshapen(section, item));
                    continue;
                };
                let title = format!("{} {}", section.name, title_of(section, table, k));
                open(section, title, item.place, table, None, draft);
            }
        }
        _ => draft.report.add(misshapen(section, &entry.node)),
    }
}

fn open<'a>(
    section: &Section,
    title: String,
    place: Place,
    table: &'a Table,
    entry: Option<&'a Entry>,
    draft: &mut Draft<'a>,
) {
    let mut reader = Reader::open(draft.report, title, place, section.keys, table);
    reader.entry = entry;
    (section.read)(&reader, draft);
}

/// What tells one table of a list from the others: its name, else its number from 1.
fn title_of(section: &Section, table: &Table, k: usize) -> String {
    let name = table.get("name").map(|entry| &entry.node.value);
    match name {
        Some(Value::Text(name)) if section.has_names() => quoted(name),
        _ => (k + 1).to_string(),
    }
}

fn misshapen(section: &Section, node: &Node) -> Problem {
    let header = section.header("NAME");
    let message = format!("`{}` is written as {header}", section.name);
    let (expected, remedy) = match section.shape {
        Shape::Single => ("one table", "write its header once, with single brackets"),
        Shape::Named => (
            "a table under a name",
            "give the table a name: [material.glass]",
        ),
        Shape::Listed => (
            "a list of tables",
            "write the header with double brackets, once for each",
        ),
    };
    Problem::new(message, node.place)
        .expected(format!("expected {expected}, found {}", node.kind()))
        .remedy(remedy)
}

/// "did you mean ...?" when a table is near a wrong name, else the list of all.
pub(crate) fn nearest_table(wrong: &str) -> String {
    let names: Vec<&str> = super::SECTIONS.iter().map(|section| section.name).collect();
    match near(wrong, names.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("there is {}", names.join(", ")),
    }
}

fn unknown(entry: &Entry) -> Problem {
    let owners: Vec<String> = super::SECTIONS
        .iter()
        .filter(|section| section.keys.iter().any(|key| key.name == entry.key))
        .map(|section| section.header("NAME"))
        .collect();
    let remedy = match (&entry.node.value, owners.first()) {
        (Value::Table(_) | Value::List(_), _) | (_, None) => nearest_table(&entry.key),
        (_, Some(_)) => format!("`{}` is a key of {}", entry.key, owners.join(" and of ")),
    };
    Problem::new(
        format!("there is no table {}", quoted(&entry.key)),
        entry.place,
    )
    .expected("unknown table")
    .remedy(remedy)
}
