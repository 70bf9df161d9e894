//! `property`: changes a material.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "property",
    aliases: &["type"],
    usage: "property MATERIAL KEY VALUE",
    summary: "changes a property of a material",
    detail: "Keys: density [kg/m3], friction [-], cohesion [N], bond_tension and bond_shear [N], \
             rolling_friction [-], normal_stiffness and shear_stiffness [N/m], young [Pa], poisson [-]. The time step follows at once.",
    examples: &[
        "property steel density 7800",
        "property glass normal_stiffness 1.5e8",
    ],
    parse,
    changes_world: true,
};

/// A property of a material.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Property {
    /// Density [kg/m³].
    Density,
    /// Friction coefficient [-].
    Friction,
    /// Cohesion [N].
    Cohesion,
    /// Pull that a bond bears [N].
    BondTension,
    /// Shear that a bond bears without normal force [N].
    BondShear,
    /// Coefficient of rolling friction [-].
    RollingFriction,
    /// Normal stiffness [N/m].
    NormalStiffness,
    /// Shear stiffness [N/m].
    ShearStiffness,
    /// Young's modulus [Pa].
    Young,
    /// Poisson's ratio [-].
    Poisson,
}

/// Every property and the word for it.
const KEYS: [(&str, Property); 10] = [
    ("density", Property::Density),
    ("friction", Property::Friction),
    ("cohesion", Property::Cohesion),
    ("bond_tension", Property::BondTension),
    ("bond_shear", Property::BondShear),
    ("rolling_friction", Property::RollingFriction),
    ("normal_stiffness", Property::NormalStiffness),
    ("shear_stiffness", Property::ShearStiffness),
    ("young", Property::Young),
    ("poisson", Property::Poisson),
];

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let material = words.material()?;
    let key = words.choose(&KEYS)?;
    let what = key.name();
    let value = match key {
        Property::Density | Property::NormalStiffness | Property::Young => words.positive(what)?,
        Property::Friction
        | Property::Cohesion
        | Property::BondTension
        | Property::BondShear
        | Property::RollingFriction
        | Property::ShearStiffness => words.not_negative(what)?,
        Property::Poisson => {
            words.number_that(what, "above -1 and at most 0.5", |v| v > -1.0 && v <= 0.5)?
        }
    };
    Ok(Command::Property(material, key, value))
}

impl Property {
    /// The word for it, in presets and commands.
    pub fn name(self) -> &'static str {
        let row = KEYS.iter().find(|(_, key)| *key == self);
        row.expect("every property has its row").0
    }
}

impl fmt::Display for Property {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
