//! Columns that a preset makes itself: a name for an expression over others.

use std::sync::Arc;

use super::expression::{Expression, is_function};
use super::mistake::Mistake;
use super::name::is_name;
use crate::measure::columns::{assembly, nearest};

/// Parts of a definition with those it is made of put in: definitions of definitions grow fast.
const LARGEST: usize = 4096;

/// Words of expressions that are no columns.
const WORDS: [&str; 11] = [
    "cycle",
    "time",
    "stage",
    "stage_cycle",
    "min",
    "max",
    "last",
    "mean",
    "at",
    "and",
    "or",
];

/// A column that a preset makes.
#[derive(Debug, Clone, PartialEq)]
pub struct Definition {
    /// Its name, in lower case.
    pub name: String,
    /// What its value is. Definitions it names have been put in.
    pub expression: Expression,
}

/// All columns that a preset makes, in order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Definitions(Vec<Arc<Definition>>);

impl Definitions {
    /// The definition of a name; upper and lower case are the same.
    pub fn find(&self, name: &str) -> Option<&Arc<Definition>> {
        let mut known = self.0.iter();
        known.find(|known| known.name.eq_ignore_ascii_case(name))
    }

    /// All of them.
    pub fn iter(&self) -> impl Iterator<Item = &Arc<Definition>> {
        self.0.iter()
    }

    /// Names of all columns that have one of their own, a preset's first.
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        let own = self.0.iter().map(|definition| definition.name.as_str());
        own.chain(assembly().map(|row| row.card.name))
    }

    /// Reads one more, which may name those before it. A mistake about the name has the whole text as
    /// its place, one about the expression a part of it.
    pub fn define(&mut self, name: &str, text: &str) -> Result<&Arc<Definition>, Mistake> {
        let name = name.to_lowercase();
        let refuse =
            |message: String, remedy: &str| Err(Mistake::new(message, remedy, 0..text.len()));
        if !is_name(&name) {
            return refuse(
                format!("`{name}` cannot name a column"),
                "a name is a letter followed by letters, digits and `_`",
            );
        }
        if WORDS.contains(&name.as_str())
            || is_function(&name)
            || assembly().any(|row| row.card.name == name)
        {
            return refuse(
                format!("`{name}` has a meaning of its own"),
                "choose another name",
            );
        }
        if self.find(&name).is_some() {
            return refuse(
                format!("`{name}` is defined twice"),
                "rename one of them; upper and lower case are the same here",
            );
        }
        let expression = Expression::parse_with(text, self)?;
        if expression.is_condition() {
            return refuse(
                format!("`{name}` would be a condition, and a column holds numbers"),
                "give an expression without a comparison",
            );
        }
        if expression.parts() > LARGEST {
            return refuse(
                format!("`{name}` has more than {LARGEST} parts"),
                "define it by fewer others",
            );
        }
        self.0.push(Arc::new(Definition { name, expression }));
        Ok(&self.0[self.0.len() - 1])
    }

    /// What to say of a name that no column has.
    pub(crate) fn near(&self, name: &str) -> String {
        nearest(name, self.names())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::columns::Column;

    #[test]
    fn definitions_take_the_place_of_their_names() {
        let mut definitions = Definitions::default();
        definitions.define("Sum", "kinetic + rotational").unwrap();
        definitions.define("half", "sum / 2 - -SUM").unwrap();
        let text = definitions.find("HALF").unwrap().expression.to_string();
        assert_eq!(text, "(kinetic + rotational) / 2 - -(kinetic + rotational)");
        // It reads back without its definitions.
        let value = |text: &str, with: &Definitions| {
            let expression = Expression::parse_with(text, with).unwrap();
            expression.number(&mut |_| 3.0)
        };
        assert_eq!(value(&text, &Definitions::default()), 9.0);
        assert_eq!(value("2 * half", &definitions), 18.0);
        let found = Expression::parse_condition_with("half > 1", &definitions).unwrap();
        let columns: Vec<String> = found.columns().iter().map(Column::name).collect();
        assert_eq!(columns, ["kinetic", "rotational"]);
        // A definition without columns needs no sample.
        definitions.define("two", "2").unwrap();
        let found = Expression::parse_condition_with("cycle > two", &definitions).unwrap();
        assert!(!found.needs_sample());
    }

    #[test]
    fn wrong_definitions_change_nothing() {
        let mut definitions = Definitions::default();
        definitions.define("a", "1").unwrap();
        for (name, text, hint) in [
            ("a", "2", "twice"),
            ("sin_phi", "2", "meaning of its own"),
            ("strain_11", "2", "meaning of its own"),
            ("and", "2", "meaning of its own"),
            ("1a", "2", "cannot name"),
            ("b", "c", "no column"),
            ("b", "cycle > 3", "condition"),
            ("b", "", "ends"),
            ("b", "state_hash", "hash"),
        ] {
            let mistake = definitions.define(name, text).unwrap_err();
            assert!(mistake.to_string().contains(hint), "{name}: {mistake}");
            assert!(text.get(mistake.span).is_some());
        }
        assert_eq!(definitions.iter().count(), 1);
    }
}
