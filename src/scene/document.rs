//! A TOML document as a tree whose every part knows where it was written. Never knows what the
//! keys mean.

use toml::de::{DeTable, DeValue};

use super::place::{Place, Source, quoted};
use super::problem::Problem;

/// A value with its place.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// Where it was written; a table's is its header.
    pub(crate) place: Place,
    /// The value.
    pub(crate) value: Value,
}

/// What a node holds.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Value {
    /// A string.
    Text(String),
    /// An integer or a float.
    Number(Number),
    /// true or false.
    Flag(bool),
    /// A date or a time: no key wants one.
    Date,
    /// An array, of values or of tables.
    List(Vec<Node>),
    /// A table, inline or under a header.
    Table(Table),
}

/// A number as TOML has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Number {
    /// The nearest float; infinite for an integer beyond all floats.
    pub(crate) float: f64,
    /// The integer, if it was written as one that fits.
    pub(crate) whole: Option<i128>,
}

/// Keys and values in the order they were written.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Table {
    /// One per key; keys are unique.
    pub(crate) entries: Vec<Entry>,
}

/// One key of a table.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Entry {
    /// The key.
    pub(crate) key: String,
    /// Where the key was written.
    pub(crate) place: Place,
    /// Its value.
    pub(crate) node: Node,
}

impl Table {
    /// The entry of a key.
    pub(crate) fn get(&self, key: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.key == key)
    }

    /// The entry of a key, to change it.
    pub(crate) fn get_mut(&mut self, key: &str) -> Option<&mut Entry> {
        self.entries.iter_mut().find(|entry| entry.key == key)
    }
}

impl Node {
    /// What kind of value it is, for messages.
    pub(crate) fn kind(&self) -> &'static str {
        match &self.value {
            Value::Text(_) => "a text",
            Value::Number(_) => "a number",
            Value::Flag(_) => "true or false",
            Value::Date => "a date",
            Value::List(items) if items.is_empty() => "an empty list",
            Value::List(_) => "a list",
            Value::Table(_) => "a table",
        }
    }
}

/// Reads source 0 as a document.
pub(crate) fn read(source: &Source) -> Result<Table, Problem> {
    // NOTE: only the first syntax error is reported. What the parser says after it is guessed,
    // and its list of guesses can outgrow the text a hundredfold.
    let document = DeTable::parse(&source.text).map_err(|error| syntax(0, 0, source, &error))?;
    Ok(table(document.get_ref(), 0, 0))
}

/// Reads the end of a source as one value.
pub(crate) fn read_value(source: &Source, index: usize, offset: usize) -> Result<Node, Problem> {
    let text = source.text.get(offset..).unwrap_or_default();
    let value = DeValue::parse(text).map_err(|error| syntax(index, offset, source, &error))?;
    Ok(node(value.get_ref(), value.span(), index, offset))
}

fn node(value: &DeValue<'_>, span: std::ops::Range<usize>, source: usize, offset: usize) -> Node {
    let place = Place::new(source, span.start + offset..span.end + offset);
    let value = match value {
        DeValue::String(text) => Value::Text(text.to_string()),
        DeValue::Integer(number) => {
            let whole = i128::from_str_radix(number.as_str(), number.radix()).ok();
            Value::Number(Number {
                float: whole.map_or(f64::INFINITY, |whole| whole as f64),
                whole,
            })
        }
        DeValue::Float(number) => Value::Number(Number {
            float: number.as_str().parse().unwrap_or(f64::NAN),
            whole: None,
        }),
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(items) => Value::List(
            items
                .iter()
                .map(|item| node(item.get_ref(), item.span(), source, offset))
                .collect(),
        ),
        DeValue::Table(entries) => Value::Table(table(entries, source, offset)),
    };
    Node { place, value }
}

fn table(entries: &DeTable<'_>, source: usize, offset: usize) -> Table {
    let mut entries: Vec<Entry> = entries
        .iter()
        .map(|(key, value)| Entry {
            key: key.get_ref().to_string(),
            place: Place::new(source, key.span().start + offset..key.span().end + offset),
            node: node(value.get_ref(), value.span(), source, offset),
        })
        .collect();
    // The parser sorts by name; order matters to us (materials, and the report).
    entries.sort_by_key(|entry| entry.place);
    Table { entries }
}

/// What to do about the complaints of the parser, by a part of their text.
const REMEDIES: &[(&str, &str)] = &[
    (
        "duplicate key",
        "each key and each [table] is written once; merge the two, or write [[...]] for a list",
    ),
    (
        "unquoted key",
        "keys are letters a to z, digits, `_` and `-`; others stand in quotes",
    ),
    ("recursion", "no key of a preset is nested that deeply"),
    (
        "must be quoted",
        "give a number, true, false, a list, or a text in straight quotes",
    ),
    ("string", "close the quotes on the same line"),
    (
        "array",
        "separate elements with commas and close the list with `]`",
    ),
    ("unclosed table", "close the header with `]`"),
    (
        "inline table",
        "write { key = value, key = value } and close it with `}`",
    ),
    ("boolean", "write true or false, in small letters"),
    (
        "date",
        "no key of a preset is a date: give a number or a text in quotes",
    ),
    ("float", "write numbers like 0.5, -3 or 1e-3"),
    ("integer", "write numbers like 0.5, -3 or 1e-3"),
    ("number", "write numbers like 0.5, -3 or 1e-3"),
    (
        "",
        "write lines `key = value` under headers like [model] or [[particle]]; texts need quotes",
    ),
];

fn syntax(index: usize, offset: usize, source: &Source, error: &toml::de::Error) -> Problem {
    let span = error.span().unwrap_or(0..0);
    let place = Place::new(index, span.start + offset..span.end + offset);
    let message = error.message();
    let (what, expected) = message.split_once(", ").unwrap_or((message, ""));
    let remedy = REMEDIES
        .iter()
        .find(|(part, _)| what.contains(part))
        .map_or("", |(_, remedy)| remedy);
    if what == "duplicate key" {
        // The place alone would be looked up in the wrong text for an override.
        let key = source.text.get(place.start..place.end).unwrap_or_default();
        return Problem::new(format!("{} is defined twice", quoted(key)), place)
            .expected("defined before")
            .remedy(remedy);
    }
    let expected = match (what, expected) {
        ("string values must be quoted", _) => "expected a value",
        (_, "expected nothing") => "not expected here",
        (_, expected) => expected,
    };
    Problem::new(format!("not valid TOML: {what}"), place)
        .expected(expected)
        .remedy(remedy)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn source(text: &str) -> Source {
        Source {
            title: "t".into(),
            text: text.into(),
        }
    }

    #[test]
    fn order_and_places_survive() {
        let source = source("[b]\nx = 1\n[a]\ny = [0x10, 2.5]\n");
        let document = read(&source).unwrap();
        let keys: Vec<&str> = document.entries.iter().map(|e| e.key.as_str()).collect();
        assert_eq!(keys, ["b", "a"]);
        let Value::Table(a) = &document.get("a").unwrap().node.value else {
            panic!("a table was written");
        };
        let y = &a.get("y").unwrap().node;
        assert_eq!(
            y.place.written(std::slice::from_ref(&source)),
            "[0x10, 2.5]"
        );
        let Value::List(items) = &y.value else {
            panic!("a list was written");
        };
        assert_eq!(
            items[0].value,
            Value::Number(Number {
                float: 16.0,
                whole: Some(16)
            })
        );
    }

    #[test]
    fn deep_nesting_is_refused_not_followed() {
        for text in [
            format!("a = {}", "[".repeat(100_000)),
            format!("a = {}1{}", "[".repeat(5000), "]".repeat(5000)),
            format!("a = {}", "{a=".repeat(100_000)),
            format!("[{}a]", "a.".repeat(100_000)),
            format!("{}a = 1", "a.".repeat(100_000)),
            format!("{}a{}", "[[".repeat(100_000), "]]".repeat(100_000)),
        ] {
            assert!(read(&source(&text)).is_err());
        }
    }
}
