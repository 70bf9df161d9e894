//! What this scene models: the parts a contact is put together from, chosen once.
//!
//! Three small matches give every combination; none is written out by hand.

use super::contact::dashpot::{Undamped, Viscous};
use super::contact::linear::{Frictionless, IncrementalNormal, LinearNormal, LinearShear};
use super::contact::pass::{ContactPass, Pass};
use super::contact::{Contact, Law, Normal, Tangential};
use super::pair::PairTable;
use super::setup::{LawChoice, NormalForm, Setup};

/// Which parts are needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan {
    /// Contact law.
    pub law: LawChoice,
    /// Form of its normal force.
    pub normal: NormalForm,
    /// Whether any contact can carry a tangential force.
    pub friction: bool,
    /// Whether any contact has a dashpot.
    pub dashpots: bool,
    /// Whether energies are booked.
    pub ledger: bool,
}

impl Plan {
    /// What the materials that occur in the scene need.
    pub fn new(
        setup: &Setup,
        pairs: &PairTable,
        used: &[usize],
        walls: &[usize],
        ledger: bool,
    ) -> Self {
        let mut plan = Self {
            law: setup.law,
            normal: setup.normal,
            friction: false,
            dashpots: false,
            ledger,
        };
        for &a in used {
            let others = used.iter().map(|&b| pairs.get(a, b, false));
            for pair in others.chain(walls.iter().map(|&b| pairs.get(a, b, true))) {
                plan.friction |= pair.is_frictional();
                plan.dashpots |= pair.is_damped();
            }
        }
        plan
    }

    /// The pass that models it.
    pub fn pass(self) -> Box<dyn ContactPass> {
        match (self.law, self.normal) {
            (LawChoice::Linear, NormalForm::Total) => self.with_normal::<LinearNormal>(),
            (LawChoice::Linear, NormalForm::Incremental) => self.with_normal::<IncrementalNormal>(),
        }
    }

    fn with_normal<N: Normal>(self) -> Box<dyn ContactPass> {
        if self.friction {
            self.with_tangential::<N, LinearShear>()
        } else {
            self.with_tangential::<N, Frictionless>()
        }
    }

    fn with_tangential<N: Normal, T: Tangential>(self) -> Box<dyn ContactPass> {
        if self.dashpots {
            self.with_law::<Contact<N, T, Viscous>>()
        } else {
            self.with_law::<Contact<N, T, Undamped>>()
        }
    }

    fn with_law<L: Law>(self) -> Box<dyn ContactPass> {
        if self.ledger {
            Box::new(Pass::<L, true>::new())
        } else {
            Box::new(Pass::<L, false>::new())
        }
    }
}
