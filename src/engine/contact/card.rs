//! What a law says of itself: its row in the list of laws.

use super::pass::ContactPass;
use crate::engine::plan::Plan;

/// One material key a law reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Key in the preset.
    pub key: &'static str,
    /// Unit, `-` if none.
    pub unit: &'static str,
    /// One line.
    pub summary: &'static str,
}

const fn parameter(key: &'static str, unit: &'static str, summary: &'static str) -> Parameter {
    Parameter { key, unit, summary }
}

pub(super) const FRICTION: Parameter =
    parameter("friction", "-", "tan φ_μ, the smaller of the pair");
pub(super) const COHESION: Parameter = parameter("cohesion", "N", "added to the shear limit");
pub(super) const BOND_TENSION: Parameter =
    parameter("bond_tension", "N", "normal pull that a bond bears");
pub(super) const BOND_SHEAR: Parameter = parameter(
    "bond_shear",
    "N",
    "shear that a bond bears without normal force",
);
pub(super) const YOUNG: Parameter = parameter("young", "Pa", "Young's modulus");
pub(super) const POISSON: Parameter = parameter("poisson", "-", "Poisson's ratio");
pub(super) const NORMAL: Parameter = parameter("normal_stiffness", "N/m", "normal spring");
pub(super) const SHEAR: Parameter = parameter("shear_stiffness", "N/m", "shear spring");

/// How a law carries shear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slip {
    /// Not at all.
    Frictionless,
    /// The whole contact sticks or slides.
    Whole,
    /// Outer parts of a contact slip before all of it slides.
    Partial,
}

/// A law's row in the list.
#[derive(Debug, Clone, Copy)]
pub struct Card {
    /// Value of `model.law`.
    pub name: &'static str,
    /// One line.
    pub summary: &'static str,
    /// Material keys it reads.
    pub parameters: &'static [Parameter],
    /// How it carries shear.
    pub slip: Slip,
    /// Memory of one contact [bytes]: without and with friction.
    pub memory: [usize; 2],
    /// Largest energy that a closed cycle was found to gain, as a share of the energy lost by a
    /// full slide there and back over the same contact; `None`: none gains.
    pub gain: Option<f64>,
    /// Paper and equation.
    pub source: &'static str,
    /// The loop that runs it.
    pub pass: fn(&Plan) -> Box<dyn ContactPass>,
}

impl Card {
    /// Whether contacts of this law can carry a tangential force.
    pub fn shears(&self) -> bool {
        self.slip != Slip::Frictionless
    }

    /// Whether it reads a key of a material.
    pub fn reads(&self, key: &str) -> bool {
        self.parameters.iter().any(|parameter| parameter.key == key)
    }
}
