//! `--set PATH=VALUE`: puts a value in the place of what the preset says, or adds a key that it
//! leaves out.
//!
//! A path is `section.key` (`model.frac`), `section.NAME.key` (`material.glass.friction`,
//! `wall.floor.velocity`, `stage.shear.until`), `particle.NUMBER.key` with the number that columns
//! use, from 1, or `section.INDEX.key` from 0 for tables without a name (`pair.0.friction`). A
//! further part goes into a list by index from 0 (`stage.shear.do.0`) or into a table by key
//! (`model.gravity.g`), as deep as there is something (`generate.0.grading.1.count`). Parts with other characters than letters, digits, `_` and `-` are quoted.
//! The value is TOML; what begins with a letter and is no TOML value is a text.

mod elsewhere;
mod path;

use super::document::{Entry, Node, Table, Value, read_value};
use super::key::{Form, Key};
use super::place::{Place, Source, quoted};
use super::problem::Problem;
use super::section::{Section, Shape, nearest_table};
use crate::measure::columns::{near, nearest};
use path::{Part, parts};

/// Applies the option that is source `index` to a document.
pub(crate) fn apply(document: &mut Table, source: &Source, index: usize) -> Result<(), Problem> {
    let (path, offset) = parts(source, index)?;
    let node = value(source, index, offset)?;
    let mut path = path.iter();
    let start = Place::new(index, 0..0);
    let Some(first) = path.next() else {
        return Err(short("the path is empty", start, "model.frac=0.2"));
    };
    let section = super::SECTIONS
        .iter()
        .find(|section| section.name == first.text)
        .ok_or_else(|| {
            let near = elsewhere::elsewhere(&first.text);
            let near = near.unwrap_or_else(|| nearest_table(&first.text));
            unknown(first, "table of presets", near)
        })?;

    let table = match section.shape {
        Shape::Single => Ok(single(document, section, first)),
        Shape::Named | Shape::Listed => {
            let Some(selector) = path.next() else {
                let example = format!("{}.{}", section.name, selectors(section, document));
                return Err(short("the path names no table", first.place, &example));
            };
            select(document, section, selector)
        }
    }?;
    let Some(table) = table else {
        // The section is misshapen in the preset itself, which is reported there.
        return Ok(());
    };
    let Some(key) = path.next() else {
        let example = section.keys.first().map_or("", |key| key.name);
        return Err(short("the path names no key", first.place, example));
    };
    let Some(declared) = section.keys.iter().find(|known| known.name == key.text) else {
        let names = section.keys.iter().map(|known| known.name);
        let what = format!("key of {}", section.header("NAME"));
        return Err(unknown(key, &what, nearest(&key.text, names)));
    };
    descend(table, key, &declared.form, &mut path, node)
}

/// The value after the `=`; a bare word is a text.
fn value(source: &Source, index: usize, offset: usize) -> Result<Node, Problem> {
    let written = source.text.get(offset..).unwrap_or_default();
    let text = written.trim();
    let start = offset + (written.len() - written.trim_start().len());
    let place = Place::new(index, start..start + text.len());
    if text.is_empty() {
        return Err(Problem::new("the option has no value", place)
            .expected("expected a value after `=`")
            .remedy("write for instance --set model.frac=0.2"));
    }
    match read_value(source, index, start) {
        Ok(node) => Ok(node),
        Err(_) if text.starts_with(char::is_alphabetic) => Ok(Node {
            place,
            value: Value::Text(text.to_owned()),
        }),
        Err(problem) => Err(problem.remedy("write a number, true, [x, y], or a text in quotes")),
    }
}

type Found<'t> = Result<Option<&'t mut Table>, Problem>;

fn single<'t>(document: &'t mut Table, section: &Section, part: &Part) -> Option<&'t mut Table> {
    if document.get(section.name).is_none() {
        put(
            document,
            part,
            Node {
                place: part.place,
                value: Value::Table(Table::default()),
            },
        );
    }
    as_table(&mut document.get_mut(section.name)?.node)
}

fn select<'t>(document: &'t mut Table, section: &Section, selector: &Part) -> Found<'t> {
    let missing = {
        let what = format!("{} of the preset", section.name);
        unknown(
            selector,
            &what,
            format!("there is {}", selectors(section, document)),
        )
    };
    let names = names(section, document);
    let missing = match near(&selector.text, names.iter().map(String::as_str)) {
        Some(name) => missing.remedy(format!("did you mean `{name}`?")),
        None => missing,
    };
    let Some(entry) = document.get_mut(section.name) else {
        return Err(missing);
    };
    match &mut entry.node.value {
        Value::Table(tables) if section.shape == Shape::Named => {
            let entry = tables.get_mut(&selector.text).ok_or(missing)?;
            Ok(as_table(&mut entry.node))
        }
        Value::List(items) if section.shape == Shape::Listed => {
            let number: Option<usize> = selector.text.parse().ok();
            let index = match number {
                Some(number) if section.name == "particle" => number.checked_sub(1),
                Some(number) => Some(number),
                None => items
                    .iter()
                    .position(|item| name(item) == Some(&selector.text)),
            };
            let item = index.and_then(|index| items.get_mut(index));
            Ok(as_table(item.ok_or(missing)?))
        }
        _ => Ok(None),
    }
}

fn as_table(node: &mut Node) -> Option<&mut Table> {
    match &mut node.value {
        Value::Table(table) => Some(table),
        _ => None,
    }
}

/// What selects a table of a section, for messages.
fn selectors(section: &Section, document: &Table) -> String {
    let names = names(section, document);
    match (names.as_slice(), section.shape) {
        ([], Shape::Named) => "none".into(),
        ([], _) => {
            let count = match document.get(section.name).map(|entry| &entry.node.value) {
                Some(Value::List(items)) => items.len(),
                _ => 0,
            };
            match (count, section.name) {
                (0, _) => "none".into(),
                (count, "particle") => format!("1 to {count}"),
                (count, _) => format!("0 to {}", count - 1),
            }
        }
        (names, _) => names.join(", "),
    }
}

fn names(section: &Section, document: &Table) -> Vec<String> {
    match document.get(section.name).map(|entry| &entry.node.value) {
        Some(Value::Table(tables)) => tables
            .entries
            .iter()
            .map(|entry| entry.key.clone())
            .collect(),
        Some(Value::List(items)) => items.iter().filter_map(name).cloned().collect(),
        _ => Vec::new(),
    }
}

fn name(node: &Node) -> Option<&String> {
    let Value::Table(table) = &node.value else {
        return None;
    };
    match &table.get("name")?.node.value {
        Value::Text(name) => Some(name),
        _ => None,
    }
}

fn put(table: &mut Table, key: &Part, node: Node) {
    let entry = Entry {
        key: key.text.clone(),
        place: key.place,
        node,
    };
    match table.get_mut(&key.text) {
        Some(old) => *old = entry,
        None => table.entries.push(entry),
    }
}

/// Puts a value under a key, or replaces a part of the value there: an element of a list, or a key
/// of a table.
fn descend<'p>(
    table: &mut Table,
    key: &Part,
    form: &Form,
    path: &mut impl Iterator<Item = &'p Part>,
    node: Node,
) -> Result<(), Problem> {
    let Some(inner) = path.next() else {
        put(table, key, node);
        return Ok(());
    };
    if matches!(form, Form::Definitions) && table.get(&key.text).is_none() {
        let value = Value::Table(Table::default());
        let place = key.place;
        put(table, key, Node { place, value });
    }
    let held = table.get_mut(&key.text).map(|entry| &mut entry.node.value);
    match (form, held) {
        (_, Some(Value::List(items))) => {
            let item = element(items, key, inner)?;
            match (form, &mut item.value, path.next()) {
                (_, _, None) => *item = node,
                (Form::Tables(keys), Value::Table(inside), Some(part)) => {
                    let form = form_of(keys, key, part)?;
                    return descend(inside, part, form, path, node);
                }
                (_, _, Some(part)) => return Err(too_deep(part, inner)),
            }
            Ok(())
        }
        (Form::Definitions, Some(Value::Table(inside))) => {
            put(inside, inner, node);
            path.next()
                .map_or(Ok(()), |part| Err(too_deep(part, inner)))
        }
        (Form::Table(keys) | Form::VectorOrTable(keys), held) => {
            let form = form_of(keys, key, inner)?;
            match held {
                Some(Value::Table(inside)) => descend(inside, inner, form, path, node),
                _ => Err(holds_nothing(key, inner)),
            }
        }
        _ => Err(holds_nothing(key, inner)),
    }
}

/// The element of a list that a part of a path counts.
fn element<'t>(items: &'t mut [Node], key: &Part, part: &Part) -> Result<&'t mut Node, Problem> {
    let index: Option<usize> = part.text.parse().ok();
    let count = items.len();
    let item = index.and_then(|index| items.get_mut(index));
    item.ok_or_else(|| {
        let what = format!("element of `{}`", key.text);
        unknown(part, &what, format!("it has {count}, counted from 0"))
    })
}

/// The form of a key within a value.
fn form_of<'k>(keys: &'k [Key], within: &Part, part: &Part) -> Result<&'k Form, Problem> {
    let found = keys.iter().find(|known| known.name == part.text);
    found.map(|known| &known.form).ok_or_else(|| {
        let what = format!("key of `{}`", within.text);
        let names = keys.iter().map(|known| known.name);
        unknown(part, &what, nearest(&part.text, names))
    })
}

fn holds_nothing(key: &Part, inner: &Part) -> Problem {
    Problem::new("the path goes too deep", inner.place)
        .expected(format!("`{}` of the preset holds nothing inside", key.text))
        .remedy(format!("end the path at `{}`", key.text))
}

fn too_deep(part: &Part, last: &Part) -> Problem {
    Problem::new("the path goes too deep", part.place)
        .expected("there is nothing inside of a value")
        .remedy(format!("end the path at `{}`", last.text))
}

fn unknown(part: &Part, what: &str, remedy: String) -> Problem {
    Problem::new(format!("{} is no {what}", quoted(&part.text)), part.place)
        .expected("unknown name")
        .remedy(remedy)
}

fn short(message: &str, place: Place, example: &str) -> Problem {
    Problem::new(message, place)
        .expected("the path ends too early")
        .remedy(format!("go on, for instance with {example}"))
}
