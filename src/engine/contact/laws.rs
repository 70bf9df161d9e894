//! The list of contact laws: presets are checked against it, help and README print it.

use crate::engine::setup::LawChoice;

/// One material or model key a law reads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// Key in the preset.
    pub key: &'static str,
    /// Unit, `-` if none.
    pub unit: &'static str,
    /// One line.
    pub summary: &'static str,
}

/// A law's row in the list.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Card {
    /// Value of `model.law`.
    pub name: &'static str,
    /// What the engine calls it.
    pub choice: LawChoice,
    /// One line.
    pub summary: &'static str,
    /// Material keys it reads.
    pub parameters: &'static [Parameter],
    /// Memory of one contact [bytes]: without and with friction.
    pub memory: [usize; 2],
    /// Paper and equation.
    pub source: &'static str,
}

const FRICTION: Parameter = Parameter {
    key: "friction",
    unit: "-",
    summary: "tan φ_μ, the smaller of the pair",
};

/// All laws.
pub const LAWS: &[Card] = &[Card {
    name: "linear",
    choice: LawChoice::Linear,
    summary: "linear springs, Coulomb and cohesion limit, dashpots",
    parameters: &[
        Parameter {
            key: "normal_stiffness",
            unit: "N/m",
            summary: "normal spring",
        },
        Parameter {
            key: "shear_stiffness",
            unit: "N/m",
            summary: "shear spring",
        },
        FRICTION,
        Parameter {
            key: "cohesion",
            unit: "N",
            summary: "added to the shear limit",
        },
    ],
    memory: [0, 8],
    source: "Cundall & Strack 1979, (16)-(19), (26)-(28)",
}];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::contact::linear::{Frictionless, LinearNormal, LinearShear};
    use crate::engine::contact::{Normal, Tangential};

    #[test]
    fn cards_tell_the_memory_that_is_used() {
        let normal = size_of::<<LinearNormal as Normal>::Memory>();
        assert_eq!(
            LAWS[0].memory[0],
            normal + size_of::<<Frictionless as Tangential>::Memory>()
        );
        assert_eq!(
            LAWS[0].memory[1],
            normal + size_of::<<LinearShear as Tangential>::Memory>()
        );
    }
}
