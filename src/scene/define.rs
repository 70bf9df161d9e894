//! `[history.define]`: columns that the preset makes from others. Read before all other tables, since
//! conditions, commands and expectations may name them; that what they name is there is checked when
//! everything has been read that can be named.

use std::sync::Arc;

use super::document::{Table, Value};
use super::draft::Draft;
use super::phrase;
use super::problem::Problem;

/// Reads the definitions of a document, in order: later ones may name earlier ones.
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
        let place = entry.node.place;
        let definitions = &mut draft.known.definitions;
        let defined = definitions.define(&entry.key, text).map(Arc::clone);
        if let Some(definition) = phrase::accept(draft.report, defined, text, place) {
            draft.definitions.push((definition, text, place));
        }
    }
}
