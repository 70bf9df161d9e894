//! What this scene models: the parts a contact is put together from, chosen once.
//!
//! Three small matches give every combination; none is written out by hand.

use super::contact::dashpot::{Constant, Following, Undamped};
use super::contact::exact::ExactShear;
use super::contact::hertz::Hertz;
use super::contact::hertz_mindlin::HertzMindlin;
use super::contact::incremental_hertz::IncrementalHertz;
use super::contact::law::{Contact, Law};
use super::contact::linear::{Frictionless, IncrementalNormal, LinearNormal, LinearShear};
use super::contact::mindlin_deresiewicz::ReversalShear;
use super::contact::parts::{Normal, Tangential, Viscosity};
use super::contact::pass::{ContactPass, Pass};
use super::contact::rolling::{RollingSpring, Unresisted};
use super::pair::PairTable;
use super::setup::{LawChoice, NormalForm, Setup, Unloading};

/// Room for nodes in the memory of a contact with exact partial slip: by default, and at most.
const FEW_NODES: usize = 16;
const MANY_NODES: usize = 64;

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

    /// The pass that models it. A loop of its own has what is common and cheap: where friction or
    /// rolling cost more than dashpots do, dashpots of no strength are part of the loop.
    pub fn pass(self) -> Box<dyn ContactPass> {
        match (self.law, self.normal) {
            (LawChoice::Linear, NormalForm::Total) => self.linear::<LinearNormal>(),
            (LawChoice::Linear, NormalForm::Incremental) => self.linear::<IncrementalNormal>(),
            (_, NormalForm::Total) => self.hertzian::<Hertz>(),
            (_, NormalForm::Incremental) => self.hertzian::<IncrementalHertz>(),
        }
    }

    fn linear<N: Normal>(self) -> Box<dyn ContactPass> {
        if self.friction {
            self.light::<N, LinearShear, Constant>()
        } else {
            self.light::<N, Frictionless, Constant>()
        }
    }

    fn hertzian<N: Normal>(self) -> Box<dyn ContactPass> {
        match (self.friction, self.law, self.unloading) {
            (false, ..) | (true, LawChoice::Hertz | LawChoice::Linear, _) => {
                self.light::<N, Frictionless, Following>()
            }
            (true, LawChoice::HertzMindlin, Unloading::Rescale) => {
                self.heavy::<N, HertzMindlin<false>, Following>()
            }
            (true, LawChoice::HertzMindlin, Unloading::Keep) => {
                self.heavy::<N, HertzMindlin<true>, Following>()
            }
            (true, LawChoice::MindlinDeresiewicz, _) => self.heavy::<N, ReversalShear, Following>(),
            // The scene refuses sums of increments here: the memory belongs to the overlap.
            (true, LawChoice::MindlinDeresiewiczExact, _) if self.nodes <= FEW_NODES => {
                self.heavy::<Hertz, ExactShear<FEW_NODES>, Following>()
            }
            (true, LawChoice::MindlinDeresiewiczExact, _) => {
                self.heavy::<Hertz, ExactShear<MANY_NODES>, Following>()
            }
        }
    }

    fn light<N: Normal, T: Tangential, D: Viscosity>(self) -> Box<dyn ContactPass> {
        if self.rolling || self.dashpots {
            self.heavy::<N, T, D>()
        } else {
            self.with_ledger::<Contact<N, T, Unresisted, Undamped>>()
        }
    }

    fn heavy<N: Normal, T: Tangential, D: Viscosity>(self) -> Box<dyn ContactPass> {
        if self.rolling {
            Box::new(Pass::<Contact<N, T, RollingSpring, D>, true>::new())
        } else {
            self.with_ledger::<Contact<N, T, Unresisted, D>>()
        }
    }

    fn with_ledger<L: Law>(self) -> Box<dyn ContactPass> {
        if self.ledger {
            Box::new(Pass::<L, true>::new())
        } else {
            Box::new(Pass::<L, false>::new())
        }
    }
}
