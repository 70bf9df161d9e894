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

impl Card {
    /// Whether contacts of this law can carry a tangential force.
    pub fn shears(&self) -> bool {
        self.choice != LawChoice::Hertz
    }

    /// Whether it reads a key of a material.
    pub fn reads(&self, key: &str) -> bool {
        self.parameters.iter().any(|parameter| parameter.key == key)
    }

    /// Whether outer parts of a contact slip before all of it slides.
    pub fn slips_partially(&self) -> bool {
        matches!(
            self.choice,
            LawChoice::MindlinDeresiewicz | LawChoice::MindlinDeresiewiczExact
        )
    }

    /// Whether a closed cycle can gain energy.
    pub fn can_gain(&self) -> bool {
        self.choice == LawChoice::MindlinDeresiewicz
    }
}

const fn parameter(key: &'static str, unit: &'static str, summary: &'static str) -> Parameter {
    Parameter { key, unit, summary }
}

const FRICTION: Parameter = parameter("friction", "-", "tan φ_μ, the smaller of the pair");
const COHESION: Parameter = parameter("cohesion", "N", "added to the shear limit");
const YOUNG: Parameter = parameter("young", "Pa", "Young's modulus");
const POISSON: Parameter = parameter("poisson", "-", "Poisson's ratio");

/// All laws.
pub const LAWS: &[Card] = &[
    Card {
        name: "linear",
        choice: LawChoice::Linear,
        summary: "linear springs, Coulomb and cohesion limit, dashpots",
        parameters: &[
            parameter("normal_stiffness", "N/m", "normal spring"),
            parameter("shear_stiffness", "N/m", "shear spring"),
            FRICTION,
            COHESION,
        ],
        memory: [0, 8],
        source: "Cundall & Strack 1979, (16)-(19), (26)-(28)",
    },
    Card {
        name: "hertz",
        choice: LawChoice::Hertz,
        summary: "Hertz spheres without friction",
        parameters: &[YOUNG, POISSON],
        memory: [0, 0],
        source: "Hertz 1882; Randall 1989, (3.13)",
    },
    Card {
        name: "hertz-mindlin",
        choice: LawChoice::HertzMindlin,
        summary: "Hertz with Mindlin's initial shear stiffness 8 G* a, no slip before all slides",
        parameters: &[YOUNG, POISSON, FRICTION, COHESION],
        memory: [0, 16],
        source: "Mindlin 1949; Thornton, Cummins & Cleary 2011",
    },
    Card {
        name: "mindlin-deresiewicz",
        choice: LawChoice::MindlinDeresiewicz,
        summary: "Hertz with partial slip, two reversals remembered: what the program of 1989 ran",
        parameters: &[YOUNG, POISSON, FRICTION],
        memory: [0, 48],
        source: "Mindlin & Deresiewicz 1953; Randall 1989, 4.3, corrected",
    },
    Card {
        name: "mindlin-deresiewicz-exact",
        choice: LawChoice::MindlinDeresiewiczExact,
        summary: "Hertz with partial slip, the whole history remembered in up to `nodes` numbers",
        parameters: &[YOUNG, POISSON, FRICTION],
        memory: [0, 528],
        source: "Mindlin & Deresiewicz 1953; Jäger 1993, Ciavarella 1998",
    },
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

/// The law of a name.
pub fn choice(name: &str) -> Option<LawChoice> {
    let card = LAWS.iter().find(|card| card.name == name)?;
    Some(card.choice)
}

/// The row of a law.
///
/// # Panics
/// If a law is missing in the list.
pub fn card(choice: LawChoice) -> &'static Card {
    let card = LAWS.iter().find(|card| card.choice == choice);
    card.expect("every law has its row")
}

/// The name of a law.
pub fn name(choice: LawChoice) -> &'static str {
    card(choice).name
}
