//! What this scene models: the parts a contact is put together from, chosen once.
//!
//! A law's card names its normal and tangential part; what else there is follows from the scene.

use super::contact::dashpot::{Following, Undamped};
use super::contact::hertz::Hertz;
use super::contact::incremental_hertz::IncrementalHertz;
use super::contact::law::{Contact, Law};
use super::contact::laws::LawChoice;
use super::contact::linear::Frictionless;
use super::contact::parts::{Normal, Tangential, Viscosity};
use super::contact::pass::{ContactPass, Pass};
use super::contact::rolling::{RollingSpring, Unresisted};
use super::pair::PairTable;
use super::setup::{NormalForm, Setup, Unloading};

/// Which parts are needed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "what a scene models is a list of yes and no"
)]
pub struct Plan {
    /// Contact law.
    pub law: LawChoice,
    /// Form of its normal force.
    pub normal: NormalForm,
    /// What a Hertz-Mindlin shear force does while the normal force falls.
    pub unloading: Unloading,
    /// Most nodes in the memory of a contact with exact partial slip.
    pub nodes: usize,
    /// Whether any contact can carry a tangential force.
    pub friction: bool,
    /// Whether any contact resists rolling.
    pub rolling: bool,
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
            unloading: setup.unloading,
            nodes: usize::from(setup.nodes),
            friction: false,
            rolling: false,
            dashpots: setup.damping.overlap_critical.is_some(),
            ledger,
        };
        for &a in used {
            let others = used.iter().map(|&b| pairs.get(a, b, false));
            for pair in others.chain(walls.iter().map(|&b| pairs.get(a, b, true))) {
                plan.friction |= pair.is_frictional();
                plan.rolling |= pair.resists_rolling();
                plan.dashpots |= pair.is_damped();
            }
        }
        plan
    }

    /// The loop that models it.
    pub fn pass(&self) -> Box<dyn ContactPass> {
        (self.law.card().pass)(self)
    }

    /// Hertz contacts with this shear, if anything rubs.
    pub(super) fn hertzian<T: Tangential>(&self) -> Box<dyn ContactPass> {
        match self.normal {
            NormalForm::Total => self.shearing::<Hertz, T>(),
            NormalForm::Incremental => self.shearing::<IncrementalHertz, T>(),
        }
    }

    fn shearing<N: Normal, T: Tangential>(&self) -> Box<dyn ContactPass> {
        if self.friction {
            self.heavy::<N, T, Following>()
        } else {
            self.light::<N, Frictionless, Following>()
        }
    }

    /// A loop of a law so cheap that it has one of its own without dashpots.
    pub(super) fn light<N: Normal, T: Tangential, D: Viscosity>(&self) -> Box<dyn ContactPass> {
        if self.rolling || self.dashpots {
            self.heavy::<N, T, D>()
        } else {
            self.with_ledger::<Contact<N, T, Unresisted, Undamped>>()
        }
    }

    /// A loop in which dashpots, if only of no strength, are always part.
    pub(super) fn heavy<N: Normal, T: Tangential, D: Viscosity>(&self) -> Box<dyn ContactPass> {
        if self.rolling {
            self.with_ledger::<Contact<N, T, RollingSpring, D>>()
        } else {
            self.with_ledger::<Contact<N, T, Unresisted, D>>()
        }
    }

    fn with_ledger<L: Law>(&self) -> Box<dyn ContactPass> {
        if self.ledger {
            Box::new(Pass::<L, true>::new())
        } else {
            Box::new(Pass::<L, false>::new())
        }
    }
}
