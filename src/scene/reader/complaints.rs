//! What a reader says about keys and values that are not as declared.

use super::Reader;
use crate::measure::columns::{near, nearest};
use crate::scene::document::{Entry, Node, Value};
use crate::scene::key::{Absent, Bounds, Form, Key};
use crate::scene::place::{Place, quoted};
use crate::scene::problem::Problem;

impl Reader<'_> {
    pub(super) fn unknown(&self, entry: &Entry) -> Problem {
        let near = near(&entry.key, self.keys.iter().map(|key| key.name));
        let elsewhere: Vec<String> = crate::scene::SECTIONS
            .iter()
            .filter(|section| section.keys.iter().any(|key| key.name == entry.key))
            .map(|section| section.header("NAME"))
            .collect();
        let remedy = match (elsewhere.first(), near) {
            (Some(_), _) => format!("`{}` is a key of {}", entry.key, elsewhere.join(" and of ")),
            (None, Some(name)) => format!("did you mean `{name}`?"),
            (None, None) => self.list(),
        };
        let message = format!("{} is no key of {}", quoted(&entry.key), self.title);
        Problem::new(message, entry.place)
            .expected("unknown key")
            .remedy(remedy)
    }

    fn list(&self) -> String {
        let names: Vec<&str> = self.keys.iter().map(|key| key.name).collect();
        format!("there is {}", names.join(", "))
    }

    pub(super) fn missing(&self, key: &Key) -> Problem {
        let (name, wanted) = (key.name, key.wanted());
        Problem::new(format!("{} has no `{name}`", self.title), self.place)
            .expected(format!("`{name}` is missing here"))
            .remedy(format!("add {name} = {wanted}: {}", key.summary))
    }

    pub(super) fn listed(
        &self,
        key: &Key,
        words: &'static [&'static str],
        text: &str,
        place: Place,
    ) -> Option<&'static str> {
        let found = words.iter().copied().find(|&word| word == text);
        if found.is_none() {
            let message = format!(
                "`{}` of {} cannot be {}",
                key.name,
                self.title,
                quoted(text)
            );
            self.report.add(
                Problem::new(message, place)
                    .expected(format!("expected {}", key.wanted()))
                    .remedy(nearest(text, words.iter().copied())),
            );
        }
        found
    }

    /// Reports an element of a list of numbers; nothing was read.
    pub(super) fn wrong_element<T>(&self, key: &Key, bounds: Bounds, item: &Node) -> Option<T> {
        let found = quoted(item.place.written(&self.report.sources));
        let message = format!("`{}` of {} cannot hold {found}", key.name, self.title);
        self.report.add(
            Problem::new(message, item.place)
                .expected(format!("expected {bounds}"))
                .remedy(format!("`{}`: {}", key.name, key.summary)),
        );
        None
    }

    /// Reports a value of the wrong kind or size; nothing was read.
    pub(super) fn wrong<T>(&self, key: &Key, node: &Node) -> Option<T> {
        let found = quoted(node.place.written(&self.report.sources));
        let found = match node.value {
            Value::Table(_) => "a table".to_owned(),
            _ => found,
        };
        let message = format!("`{}` of {} cannot be {found}", key.name, self.title);
        let advice = match (&key.form, &node.value) {
            (Form::Number(_) | Form::Count(..) | Form::WordOrNumber(..), Value::Text(text))
                if text.parse::<f64>().is_ok() =>
            {
                "numbers stand without quotes; ".to_owned()
            }
            (Form::Flag, Value::Text(_)) => "true and false stand without quotes; ".to_owned(),
            (Form::Vector | Form::VectorOrTable(_) | Form::TwoTexts, Value::List(items))
                if items.len() != 2 =>
            {
                format!("elements found: {}; ", items.len())
            }
            (Form::Texts | Form::Words(_), Value::Text(_)) => {
                "put the text in brackets; ".to_owned()
            }
            (Form::Numbers(_), Value::Number(_)) => "put the number in brackets; ".to_owned(),
            _ => String::new(),
        };
        let default = match &key.absent {
            Absent::Wrong => String::new(),
            Absent::Said(said) if said.starts_with("required") => format!("; {said}"),
            absent => format!("; default: {absent}"),
        };
        let remedy = format!("{advice}`{}`: {}{default}", key.name, key.summary);
        let expected = match (&key.form, &node.value) {
            (Form::Number(_), Value::Number(_)) => format!("expected {}", key.wanted()),
            _ => format!("expected {}, found {}", key.wanted(), node.kind()),
        };
        self.report.add(
            Problem::new(message, node.place)
                .expected(expected)
                .remedy(remedy),
        );
        None
    }
}
