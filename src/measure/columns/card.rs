//! What a column is: declared once, and read, checked, documented and completed by that
//! declaration.

use std::hash::{Hash, Hasher};

/// What a cell of a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A real number.
    Real,
    /// A whole number.
    Count,
    /// Sixteen hexadecimal digits.
    Hash,
}

/// What is known of a column before anything is measured.
#[derive(Debug, Clone, Copy)]
pub struct Card {
    /// Name in presets, commands and CSV headers.
    pub name: &'static str,
    /// Unit, `-` if none.
    pub unit: &'static str,
    /// One line.
    pub summary: &'static str,
    /// What its cells hold.
    pub kind: Kind,
    /// Whether energies must be booked in every cycle for it.
    pub ledger: bool,
    /// Whether it is among the columns of a history that names none.
    pub usual: bool,
}

impl Card {
    /// Marks in lists, explained by [`MARKS`].
    pub fn marks(&self) -> &'static str {
        match (self.usual, self.ledger) {
            (true, _) => "*",
            (false, true) => "+",
            (false, false) => "",
        }
    }
}

/// What the marks of columns mean.
pub const MARKS: [&str; 2] = [
    "* recorded where a preset names no columns",
    "+ energies are booked in every cycle for it, which makes cycles two to three times as long",
];

/// A column's row in the list of its family: its card, and how its value is read.
#[derive(Debug)]
pub struct Row<R: 'static> {
    /// What is known of it.
    pub card: Card,
    /// How its value is read.
    pub(in crate::measure) read: R,
}

impl<R> Row<R> {
    /// A column of real numbers that a history has only if it is named.
    pub(super) const fn new(
        name: &'static str,
        unit: &'static str,
        summary: &'static str,
        read: R,
    ) -> Self {
        Self {
            card: Card {
                name,
                unit,
                summary,
                kind: Kind::Real,
                ledger: false,
                usual: false,
            },
            read,
        }
    }
}

impl<R: Copy> Row<R> {
    /// The same, recorded by histories that name no columns.
    pub(super) const fn usual(self) -> Self {
        Self {
            card: Card {
                usual: true,
                ..self.card
            },
            ..self
        }
    }

    /// The same, whose cells are whole numbers.
    pub(super) const fn counted(self) -> Self {
        Self {
            card: Card {
                kind: Kind::Count,
                ..self.card
            },
            ..self
        }
    }

    /// The same, whose cells are hashes.
    pub(super) const fn hashed(self) -> Self {
        Self {
            card: Card {
                kind: Kind::Hash,
                ..self.card
            },
            ..self
        }
    }

    /// The same, for which energies have to be booked.
    pub(super) const fn booked(self) -> Self {
        Self {
            card: Card {
                ledger: true,
                ..self.card
            },
            ..self
        }
    }
}

/// Within a family a name is a column.
impl<R> PartialEq for Row<R> {
    fn eq(&self, other: &Self) -> bool {
        self.card.name == other.card.name
    }
}

impl<R> Eq for Row<R> {}

impl<R> Hash for Row<R> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.card.name.hash(state);
    }
}
