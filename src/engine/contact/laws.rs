//! The list of contact laws: presets are checked against it, help and README print it. Adding a law
//! is a file with its parts and its card, and a line here.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer};

pub use super::card::{Card, Parameter, Slip};
use super::{bonded, exact, hertz, hertz_mindlin, linear, mindlin_deresiewicz};

/// All laws. A static: every crate that used a constant would compile their loops again.
pub static LAWS: &[Card] = &[
    linear::CARD,
    bonded::CARD,
    hertz::CARD,
    hertz_mindlin::CARD,
    mindlin_deresiewicz::CARD,
    exact::CARD,
];

/// Their names, for keys of presets.
pub const NAMES: [&str; LAWS.len()] = {
    let mut names = [""; LAWS.len()];
    let mut k = 0;
    while k < names.len() {
        names[k] = LAWS[k].name;
        k += 1;
    }
    names
};

/// A law of the list.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct LawChoice(usize);

impl LawChoice {
    /// The law of a name.
    pub fn named(name: &str) -> Option<Self> {
        NAMES.iter().position(|known| *known == name).map(Self)
    }

    fn listed(name: &str) -> Self {
        Self::named(name).expect("it is in the list")
    }

    /// The law of 1979, for discs.
    pub fn linear() -> Self {
        Self::listed("linear")
    }

    /// The law of spheres unless another is named.
    pub fn exact() -> Self {
        Self::listed("mindlin-deresiewicz-exact")
    }

    /// Its row.
    pub fn card(self) -> &'static Card {
        &LAWS[self.0]
    }

    /// Whether its contacts can be bonded.
    pub fn has_bonds(self) -> bool {
        self.card().reads("bond_tension")
    }

    /// Whether its springs are constant and given as such; else they follow from elastic constants.
    pub fn has_constant_springs(self) -> bool {
        self.card().reads("normal_stiffness")
    }
}

impl fmt::Debug for LawChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.card().name)
    }
}

/// By name, so that checkpoints outlive the order of the list.
impl Serialize for LawChoice {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.card().name.serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for LawChoice {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Self::named(&name).ok_or_else(|| serde::de::Error::custom(format!("no law {name}")))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_named_ones_are_where_they_should_be() {
        assert_eq!(LawChoice::linear().card().name, "linear");
        assert_eq!(LawChoice::exact().card().name, "mindlin-deresiewicz-exact");
    }
}
