//! `[history.define]`: columns that the preset makes from others. Read before all other tables, since
//! conditions, commands and expectations may name them; that what they name is there is checked when
//! everything has been read that can be named.

use std::sync::Arc;

use super::document::{Table, Value};
use super::draft::Draft;
use super::phrase;
use super::place::Place;
use super::problem::Problem;

/// Reads the definitions of a document. They may name each other, in any order, as long as none comes
/// back to itself.
pub(crate) fn read<'a>(document: &'a Table, draft: &mut Draft<'a>) {
    let inside = |table: &'a Table, key: &str| table.get(key).map(|entry| &entry.node);
    let Some(Value::Table(history)) = inside(document, "history").map(|node| &node.value) else {
        return;
    };
    let Some(node) = inside(history, "define") else {
        return;
    };
    let Value::Table(definitions) = &node.value else {
        let found = format!("expected a table of expressions, found {}", node.kind());
        draft.report.add(
            Problem::new("`define` of [history] names no columns", node.place)
                .expected(found)
                .remedy("write [history.define] with lines NAME = \"EXPRESSION\""),
        );
        return;
    };
    let mut texts = Vec::new();
    for entry in &definitions.entries {
        let Value::Text(text) = &entry.node.value else {
            let found = format!(
                "expected an expression in quotes, found {}",
                entry.node.kind()
            );
            draft.report.add(
                Problem::new(
                    format!("`{}` is defined by no text", entry.key),
                    entry.node.place,
                )
                .expected(found)
                .remedy("write for instance ratio = \"stress_11 / stress_22\""),
            );
            continue;
        };
        texts.push((entry.key.as_str(), text.as_str(), entry.node.place));
    }
    // Those first that name nothing that is still to come.
    while !texts.is_empty() {
        let waits = |(_, text, _): &(&str, &str, Place)| {
            words(text).any(|name| texts.iter().any(|(other, ..)| *other == name))
        };
        let Some(next) = texts.iter().position(|text| !waits(text)) else {
            let names: Vec<String> = texts.iter().map(|(key, ..)| format!("`{key}`")).collect();
            let message = match names.as_slice() {
                [name] => format!("{name} is defined by itself"),
                names => format!("{} are defined by each other", names.join(", ")),
            };
            draft.report.add(
                Problem::new(message, texts[0].2)
                    .expected("definitions that come down to columns of the program")
                    .remedy("write one of them without the others"),
            );
            return;
        };
        let (key, text, place) = texts.remove(next);
        let definitions = &mut draft.known.definitions;
        let defined = definitions.define(key, text).map(Arc::clone);
        if let Some(definition) = phrase::accept(draft.report, defined, text, place) {
            draft.definitions.push((definition, text, place));
        }
    }
}

/// The names in an expression; the x in `particle:1:x` is none.
fn words(text: &str) -> impl Iterator<Item = &str> {
    let ends = |c: char| !(c.is_alphanumeric() || "_:".contains(c));
    text.split(ends).filter(|word| !word.is_empty())
}
