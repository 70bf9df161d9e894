//! Linear springs, and bonds that pull.
//!
//! The bonding contact of Mathematical Physics II, chapter 6, fig. 6.19 (c) and (6.65): the normal
//! spring -k_n u_n acts in tension, too, the shear spring is incremental, and the shear force is limited
//! by f_coh + μ f_n. A bond is a point: it resists no bending.
//!
//! A bond breaks for good where the pull of its normal spring exceeds `bond_tension`, or its shear
//! force f_coh + μ f_n with f_coh = `bond_shear`; a pull takes nothing from that limit. What counts are
//! the springs: the strength does not depend on the rate, and dashpots act both ways while a bond
//! holds. From the step in which a bond breaks its bodies are any others of the law `linear`: they
//! come apart if there is a gap; where they overlap, the shear force is set back to the limit of
//! friction and cohesion, and they may slide.
//!
//! The springs of a bond are at rest where the bodies just touch, whatever the gap or overlap it was made at.

use serde::{Deserialize, Serialize};

use super::card::{BOND_SHEAR, BOND_TENSION, COHESION, Card, FRICTION, NORMAL, SHEAR, Slip};
use super::dashpot::Constant;
use super::inner::Inner;
use super::linear::{LinearNormal, LinearShear, ShearForce};
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Tangential, TangentialForce};
use super::pass::ContactPass;
use super::quantities::{Basis, Load, Shear, Touch};
use crate::engine::lanes::Lanes;
use crate::engine::plan::Plan;

/// Row in the list.
pub const CARD: Card = Card {
    name: "bonded",
    summary: "the linear law with bonds that pull until they break: `bond` makes them",
    parameters: &[NORMAL, SHEAR, FRICTION, COHESION, BOND_TENSION, BOND_SHEAR],
    slip: Slip::Whole,
    memory: [16, 16],
    gain: None,
    source: "Mathematical Physics II, fig. 6.19 (c), (6.65)",
    pass,
};

/// Only with forces from the overlap, which is where a bond is at rest.
fn pass(plan: &Plan) -> Box<dyn ContactPass> {
    plan.light::<LinearNormal, BondedShear, Constant>()
}

/// Shear force of the spring [N], and whether there is a bond: 1 or 0.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct BondedForce<V = f64> {
    shear: ShearForce<V>,
    bond: V,
}

numbers!(BondedForce {
    shear: ShearForce<V>,
    bond: V
});

impl Memory for BondedForce {
    kept_as_columns!(BondedForce);

    fn reduced(&self) -> [f64; 2] {
        self.shear.reduced()
    }

    /// Without a bond it is what the linear law remembers.
    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.shear.visit(see);
        if self.is_bonded() {
            see(self.bond);
        }
    }

    fn is_bonded(&self) -> bool {
        self.bond > 0.0
    }

    fn bond(&mut self) {
        self.bond = 1.0;
    }
}

/// The shear spring of the linear law, with a bond beside it.
#[derive(Debug, Clone, Copy)]
pub struct BondedShear<V = f64> {
    shear: LinearShear<V>,
    /// Stiffness of the normal spring [N/m].
    normal: V,
    tension: V,
    strength: V,
}

numbers!(BondedShear {
    shear: LinearShear<V>,
    normal: V,
    tension: V,
    strength: V
});

impl<V: Lanes> BondedShear<V> {
    /// Shear that a bond bears beside a normal force of the spring [N].
    #[inline(always)]
    fn limit(&self, elastic: V) -> V {
        self.strength + self.shear.friction() * elastic.positive()
    }
}

impl<V: Lanes> TangentialForce<V> for BondedShear<V> {
    type Memory = BondedForce<V>;
    const ACTIVE: bool = true;
    const WITHIN: bool = true;
    const BONDS: bool = true;

    #[inline(always)]
    fn holds(&self, touch: &Touch<V>, memory: &BondedForce<V>) -> V::Mask {
        let elastic = self.normal * touch.overlap;
        let trial = self.shear.trial(touch, &memory.shear);
        memory.bond.above(V::all(0.0))
            & elastic.at_least(-self.tension)
            & self.limit(elastic).at_least(trial.abs())
    }

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut BondedForce<V>) -> Shear<V> {
        let (zero, one) = (V::all(0.0), V::all(1.0));
        let holds = self.holds(touch, memory);
        let breaks = memory.bond.above(zero) & !holds;
        let limit = V::pick(holds, self.limit(load.elastic), self.shear.limit(load));
        let shear = self.shear.within(limit, touch, &mut memory.shear);
        memory.bond = V::pick(holds, one, zero);
        // What breaking takes out of the shear spring is not lost by sliding.
        let [lost, _] = shear.loss;
        Shear {
            loss: [V::pick(breaks, zero, lost), V::pick(breaks, lost, zero)],
            ..shear
        }
    }

    #[inline(always)]
    fn steepest(&self, overlap: V) -> V {
        self.shear.steepest(overlap)
    }
}

impl Tangential for BondedShear {
    type Memo = BondedForce;
    type On<V: Lanes> = BondedShear<V>;
    type Plain<V: Lanes> = BondedShear<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        let pair = basis.pair;
        Self {
            shear: LinearShear::prepare(basis),
            normal: pair.normal_stiffness,
            tension: pair.bond_tension,
            strength: pair.bond_shear,
        }
    }

    fn held(&self, memory: &BondedForce) -> f64 {
        self.shear.held(&memory.shear)
    }

    fn stiffness(&self, overlap: f64) -> f64 {
        Tangential::stiffness(&self.shear, overlap)
    }

    fn energy(&self, overlap: f64, memory: &BondedForce) -> f64 {
        self.shear.energy(overlap, &memory.shear)
    }

    fn part(&self, displacement: f64, memory: &BondedForce) -> [f64; 2] {
        self.shear.part(displacement, &memory.shear)
    }

    fn seed(&self, overlap: f64, force: f64) -> BondedForce {
        BondedForce {
            shear: self.shear.seed(overlap, force),
            bond: 0.0,
        }
    }

    fn is_frictional(&self) -> bool {
        self.shear.is_frictional() || self.strength > 0.0 && self.shear.stiffness(0.0) > 0.0
    }

    fn inner(&self, _: f64, memory: &BondedForce) -> Vec<Inner> {
        vec![Inner::word(
            "bond",
            if memory.is_bonded() { "holds" } else { "none" },
        )]
    }
}
