//! Reads one table of a preset by the declarations of its keys. What is wrong goes to the report
//! and comes back as nothing, so that the caller reads on.

mod complaints;

use super::document::{Entry, Node, Table, Value};
use super::key::{Absent, Form, Key};
use super::place::Place;
use super::problem::{Problem, Report};

/// A table of the preset under its declaration.
pub(crate) struct Reader<'a> {
    /// Where problems go.
    pub(crate) report: &'a Report,
    /// What the table is called: `[model]`, `[[particle]] 3`.
    pub(crate) title: String,
    /// Its header.
    pub(crate) place: Place,
    /// The name a named table stands under.
    pub(crate) entry: Option<&'a Entry>,
    /// Problems there were before this table.
    before: usize,
    keys: &'static [Key],
    table: &'a Table,
}

/// A word or a number, whichever was written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum WordOrNumber {
    /// One of the words.
    Word(&'static str),
    /// The number.
    Number(f64),
}

impl<'a> Reader<'a> {
    /// Opens a table: reports its unknown and its missing keys.
    pub(crate) fn open(
        report: &'a Report,
        title: String,
        place: Place,
        keys: &'static [Key],
        table: &'a Table,
    ) -> Self {
        let reader = Self {
            report,
            title,
            place,
            entry: None,
            before: report.count(),
            keys,
            table,
        };
        for entry in &table.entries {
            if keys.iter().all(|key| key.name != entry.key) {
                report.add(reader.unknown(entry));
            }
        }
        for key in keys.iter().filter(|key| key.absent == Absent::Wrong) {
            if !reader.has(key.name) {
                report.add(reader.missing(key));
            }
        }
        reader
    }

    /// Whether nothing was wrong with this table so far.
    pub(crate) fn is_sound(&self) -> bool {
        self.report.count() == self.before
    }

    /// Whether a key was written.
    pub(crate) fn has(&self, name: &str) -> bool {
        self.table.get(name).is_some()
    }

    /// Where a key's value was written; the header if it was left out.
    pub(crate) fn place_of(&self, name: &str) -> Place {
        self.table
            .get(name)
            .map_or(self.place, |entry| entry.node.place)
    }

    /// The key that was written of several that exclude each other; reports a second one.
    pub(crate) fn one_of(&self, names: &[&'static str]) -> Option<&'static str> {
        let mut written = names
            .iter()
            .filter_map(|&name| self.table.get(name).map(|entry| (name, entry)));
        let (first, kept) = written.next()?;
        for (name, entry) in written {
            let message = format!(
                "`{first}` and `{name}` of {} exclude each other",
                self.title
            );
            self.report.add(
                Problem::new(message, entry.place)
                    .expected("one of the two is too many")
                    .also(kept.place, "the other one")
                    .remedy(format!("keep `{first}` or `{name}`, whichever is meant")),
            );
        }
        Some(first)
    }

    /// Reports a value that is wrong for a reason its declaration does not know.
    pub(crate) fn refuse(&self, name: &str, message: &str, expected: &str, remedy: &str) {
        self.report.add(
            Problem::new(message, self.place_of(name))
                .expected(expected)
                .remedy(remedy),
        );
    }

    /// A number; the declared default if it was left out.
    pub(crate) fn number(&self, name: &str) -> Option<f64> {
        let key = self.key(name);
        let Some(node) = self.node(name) else {
            return match key.absent {
                Absent::Number(number) => Some(number),
                _ => None,
            };
        };
        match (&key.form, &node.value) {
            (Form::Number(bounds), Value::Number(number)) if bounds.contains(number.float) => {
                Some(number.float)
            }
            _ => self.wrong(key, node),
        }
    }

    /// A whole number.
    pub(crate) fn count(&self, name: &str) -> Option<u64> {
        let key = self.key(name);
        let Some(node) = self.node(name) else {
            return match key.absent {
                Absent::Count(count) => Some(count),
                _ => None,
            };
        };
        let whole = match &node.value {
            Value::Number(number) => number.whole.or_else(|| {
                // 2e6 is a float to TOML and a count to everyone else.
                let float = number.float;
                (float.fract() == 0.0 && float.abs() <= super::key::COUNT_MAX as f64)
                    .then_some(float as i128)
            }),
            _ => None,
        };
        match (&key.form, whole.and_then(|whole| u64::try_from(whole).ok())) {
            (Form::Count(low, high), Some(count)) if (low..=high).contains(&&count) => Some(count),
            _ => self.wrong(key, node),
        }
    }

    /// true or false.
    pub(crate) fn flag(&self, name: &str) -> Option<bool> {
        let key = self.key(name);
        match (self.node(name), &key.absent) {
            (None, Absent::Flag(flag)) => Some(*flag),
            (None, _) => None,
            (Some(node), _) => match node.value {
                Value::Flag(flag) => Some(flag),
                _ => self.wrong(key, node),
            },
        }
    }

    /// Free text and its place.
    pub(crate) fn text(&self, name: &str) -> Option<(&'a str, Place)> {
        let node = self.node(name)?;
        match &node.value {
            Value::Text(text) => Some((text, node.place)),
            _ => self.wrong(self.key(name), node),
        }
    }

    /// One of the declared words.
    pub(crate) fn word(&self, name: &str) -> Option<&'static str> {
        let key = self.key(name);
        match self.word_or_number(name)? {
            WordOrNumber::Word(word) => Some(word),
            WordOrNumber::Number(_) => self.wrong(key, self.node(name)?),
        }
    }

    /// One of the declared words, or a number.
    pub(crate) fn word_or_number(&self, name: &str) -> Option<WordOrNumber> {
        let key = self.key(name);
        let Some(node) = self.node(name) else {
            return match key.absent {
                Absent::Word(word) => Some(WordOrNumber::Word(word)),
                _ => None,
            };
        };
        match (&key.form, &node.value) {
            // A number in quotes is no misspelt word.
            (Form::WordOrNumber(..), Value::Text(text)) if text.parse::<f64>().is_ok() => {
                self.wrong(key, node)
            }
            (Form::Word(words) | Form::WordOrNumber(words, _), Value::Text(text)) => self
                .listed(key, words, text, node.place)
                .map(WordOrNumber::Word),
            (Form::WordOrNumber(_, bounds), Value::Number(number))
                if bounds.contains(number.float) =>
            {
                Some(WordOrNumber::Number(number.float))
            }
            _ => self.wrong(key, node),
        }
    }

    /// Some of the declared words.
    pub(crate) fn words(&self, name: &str) -> Option<Vec<&'static str>> {
        let key = self.key(name);
        let Form::Words(words) = key.form else {
            return None;
        };
        let mut found = Vec::new();
        for (text, place) in self.texts(name)? {
            found.push(self.listed(key, words, text, place)?);
        }
        Some(found)
    }

    /// A list of texts with their places.
    pub(crate) fn texts(&self, name: &str) -> Option<Vec<(&'a str, Place)>> {
        let node = self.node(name)?;
        let key = self.key(name);
        let Value::List(items) = &node.value else {
            return self.wrong(key, node);
        };
        let mut texts = Vec::with_capacity(items.len());
        for item in items {
            let Value::Text(text) = &item.value else {
                return self.wrong(key, item);
            };
            texts.push((text.as_str(), item.place));
        }
        match (&key.form, texts.len()) {
            (Form::TwoTexts, 2) | (Form::Texts | Form::Words(_), _) => Some(texts),
            _ => self.wrong(key, node),
        }
    }

    /// A list of numbers.
    pub(crate) fn numbers(&self, name: &str) -> Option<Vec<f64>> {
        let node = self.node(name)?;
        let key = self.key(name);
        let (Value::List(items), Form::Numbers(bounds)) = (&node.value, &key.form) else {
            return self.wrong(key, node);
        };
        let mut numbers = Vec::with_capacity(items.len());
        for item in items {
            match item.value {
                Value::Number(number) if bounds.contains(number.float) => {
                    numbers.push(number.float);
                }
                _ => return self.wrong_element(key, *bounds, item),
            }
        }
        Some(numbers)
    }

    /// Two finite numbers; zero if left out and declared so.
    pub(crate) fn vector(&self, name: &str) -> Option<[f64; 2]> {
        let key = self.key(name);
        let Some(node) = self.node(name) else {
            return (key.absent == Absent::Zero).then_some([0.0; 2]);
        };
        let Value::List(items) = &node.value else {
            return self.wrong(key, node);
        };
        let mut numbers = [0.0; 2];
        if items.len() != numbers.len() {
            return self.wrong(key, node);
        }
        for (number, item) in numbers.iter_mut().zip(items) {
            match item.value {
                Value::Number(found) if found.float.is_finite() => *number = found.float,
                _ => return self.wrong(key, item),
            }
        }
        Some(numbers)
    }

    /// A list of points; infinite and missing coordinates are reported.
    pub(crate) fn vectors(&self, name: &str) -> Option<Vec<[f64; 2]>> {
        let node = self.node(name)?;
        let key = self.key(name);
        let Value::List(items) = &node.value else {
            return self.wrong(key, node);
        };
        let mut vectors = Vec::with_capacity(items.len());
        for item in items {
            let coordinate = |node: &Node| match node.value {
                Value::Number(number) if number.float.is_finite() => Some(number.float),
                _ => None,
            };
            let point = match &item.value {
                Value::List(numbers) if numbers.len() == 2 => {
                    coordinate(&numbers[0]).zip(coordinate(&numbers[1]))
                }
                _ => None,
            };
            match point {
                Some((x, y)) => vectors.push([x, y]),
                None => return self.wrong(key, item),
            }
        }
        Some(vectors)
    }

    /// The tables a list consists of.
    pub(crate) fn tables(&self, name: &str) -> Option<Vec<Reader<'a>>> {
        let node = self.node(name)?;
        let key = self.key(name);
        let (Value::List(items), Form::Tables(keys)) = (&node.value, &key.form) else {
            return self.wrong(key, node);
        };
        let mut readers = Vec::with_capacity(items.len());
        for (k, item) in items.iter().enumerate() {
            let Value::Table(table) = &item.value else {
                return self.wrong(key, item);
            };
            let title = format!("`{name}` {}", k + 1);
            readers.push(Reader::open(self.report, title, item.place, keys, table));
        }
        Some(readers)
    }

    /// The table a value consists of, if it is one; reports another value where only one will do.
    pub(crate) fn table(&self, name: &str) -> Option<Reader<'a>> {
        let node = self.node(name)?;
        let key = self.key(name);
        match (&key.form, &node.value) {
            (Form::Table(keys) | Form::VectorOrTable(keys), Value::Table(table)) => {
                let title = format!("`{name}`");
                Some(Reader::open(self.report, title, node.place, keys, table))
            }
            (Form::Table(_), _) => self.wrong(key, node),
            _ => None,
        }
    }

    fn node(&self, name: &str) -> Option<&'a Node> {
        self.table.get(name).map(|entry| &entry.node)
    }

    fn key(&self, name: &str) -> &'static Key {
        self.keys
            .iter()
            .find(|key| key.name == name)
            .expect("sections read the keys they declare")
    }
}
