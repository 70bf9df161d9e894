//! What a history can record: a column that is measured, or one that the preset defines.

use std::ops::Range;
use std::sync::Arc;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

use super::definition::{Definition, Definitions};
use super::expression::{Expression, Term};
use super::mistake::Mistake;
use super::name;
use crate::measure::columns::{Column, Kind, Names};
use crate::measure::sample::Sample;

/// A column of a history.
#[derive(Debug, Clone, PartialEq)]
pub enum Observable {
    /// It is measured.
    Column(Column),
    /// It is computed from what is measured.
    Defined(Arc<Definition>),
}

impl Observable {
    /// Looks a name up, among the definitions first.
    pub fn parse(
        text: &str,
        span: Range<usize>,
        definitions: &Definitions,
    ) -> Result<Self, Mistake> {
        match definitions.find(text) {
            Some(definition) => Ok(Self::Defined(Arc::clone(definition))),
            None => name::column(text, span, definitions).map(Self::Column),
        }
    }

    /// The columns of a history that names none.
    pub fn usual() -> Vec<Self> {
        Column::usual().into_iter().map(Self::Column).collect()
    }

    /// The name it is written by.
    pub fn name(&self) -> String {
        match self {
            Self::Column(column) => column.name(),
            Self::Defined(definition) => definition.name.clone(),
        }
    }

    /// The name without the body or region it is of.
    pub fn bare_name(&self) -> &str {
        match self {
            Self::Column(column) => column.card().name,
            Self::Defined(definition) => &definition.name,
        }
    }

    /// Its unit, `-` if it has none or none is known.
    pub fn unit(&self) -> &'static str {
        match self {
            Self::Column(column) => column.card().unit,
            Self::Defined(_) => "-",
        }
    }

    /// One line.
    pub fn summary(&self) -> String {
        match self {
            Self::Column(column) => column.card().summary.to_owned(),
            Self::Defined(definition) => definition.expression.to_string(),
        }
    }

    /// What its cells hold.
    pub fn kind(&self) -> Kind {
        match self {
            Self::Column(column) => column.kind(),
            Self::Defined(_) => Kind::Real,
        }
    }

    /// Whether energies must be booked in every cycle for it.
    pub fn needs_ledger(&self) -> bool {
        match self {
            Self::Column(column) => column.card().ledger,
            Self::Defined(definition) => {
                let columns = definition.expression.columns();
                columns.iter().any(|column| column.card().ledger)
            }
        }
    }

    /// Whether what it names exists. A mistake about a part of a definition is told of the whole.
    pub fn check(&self, names: &Names, span: Range<usize>) -> Result<(), Mistake> {
        let checked = match self {
            Self::Column(column) => column
                .check(names)
                .map_err(|unknown| Mistake::new(unknown.message, unknown.remedy, span.clone())),
            Self::Defined(definition) => definition.expression.check(names),
        };
        checked.map_err(|mistake| Mistake { span, ..mistake })
    }

    /// Its value in a sample, so many cycles into a stage.
    pub fn value(&self, sample: &Sample<'_>, stage_cycle: u64) -> f64 {
        let world = sample.world();
        match self {
            Self::Column(column) => sample.value(column),
            Self::Defined(definition) => definition.expression.number(&mut |term| match term {
                Term::Column(column) => sample.value(column),
                Term::Cycle => world.cycle_number() as f64,
                Term::Time => world.time(),
                Term::StageCycle => stage_cycle as f64,
            }),
        }
    }
}

/// A definition goes with its expression: whoever reads it back need not know the preset.
impl Serialize for Observable {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let expression = match self {
            Self::Column(_) => None,
            Self::Defined(definition) => Some(definition.expression.to_string()),
        };
        (self.name(), expression).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Observable {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        use serde::de::Error;
        let (name, expression): (String, Option<String>) = Deserialize::deserialize(deserializer)?;
        let Some(text) = expression else {
            return Column::parse(&name)
                .map(Self::Column)
                .map_err(D::Error::custom);
        };
        let expression = Expression::parse(&text).map_err(D::Error::custom)?;
        Ok(Self::Defined(Arc::new(Definition { name, expression })))
    }
}
