//! Linear springs with a Coulomb and cohesion limit.
//!
//! Cundall & Strack 1979, equations (16) to (19). The normal force is k_n α; the historical form
//! that sums k_n Δn is kept for replay, it drifts from the overlap.

use serde::{Deserialize, Serialize};

use super::card::{COHESION, Card, FRICTION, NORMAL, SHEAR, Slip};
use super::dashpot::Constant;
use super::history::clipped;
use super::inner::Inner;
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Normal, NormalForce, Tangential, TangentialForce};
use super::pass::ContactPass;
use super::quantities::{Basis, Load, Shear, Touch};
use crate::engine::lanes::Lanes;
use crate::engine::plan::Plan;
use crate::engine::setup::NormalForm;

/// Row in the list.
pub const CARD: Card = Card {
    name: "linear",
    summary: "linear springs, Coulomb and cohesion limit, dashpots",
    parameters: &[NORMAL, SHEAR, FRICTION, COHESION],
    slip: Slip::Whole,
    memory: [0, 8],
    gain: None,
    source: "Cundall & Strack 1979, (16)-(19), (26)-(28)",
    pass,
};

fn pass(plan: &Plan) -> Box<dyn ContactPass> {
    match plan.normal {
        NormalForm::Total => with::<LinearNormal>(plan),
        NormalForm::Incremental => with::<IncrementalNormal>(plan),
    }
}

fn with<N: Normal>(plan: &Plan) -> Box<dyn ContactPass> {
    if plan.friction {
        plan.light::<N, LinearShear, Constant>()
    } else {
        plan.light::<N, Frictionless, Constant>()
    }
}

/// Normal spring, force from the overlap.
#[derive(Debug, Clone, Copy)]
pub struct LinearNormal<V = f64> {
    k: V,
}

numbers!(LinearNormal { k: V });

impl<V: Lanes> NormalForce<V> for LinearNormal<V> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, (): &mut ()) -> V {
        self.k * touch.overlap
    }

    #[inline(always)]
    fn tangent(&self, _: V, (): &()) -> V {
        self.k
    }
}

impl Normal for LinearNormal {
    type Memo = ();
    type On<V: Lanes> = LinearNormal<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            k: basis.pair.normal_stiffness,
        }
    }

    fn energy(&self, overlap: f64, (): &()) -> f64 {
        0.5 * self.k * overlap * overlap
    }

    fn held(&self, overlap: f64, (): &()) -> f64 {
        self.k * overlap
    }

    fn seed(&self, _: f64) {}
}

/// Normal force summed so far [N].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SummedNormal<V = f64> {
    force: V,
}

numbers!(SummedNormal { force: V });

impl Memory for SummedNormal {
    kept_as_columns!(SummedNormal);

    fn reduced(&self) -> [f64; 2] {
        [self.force, 0.0]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.force);
    }
}

/// Normal spring, force summed from increments, (16) and (18).
#[derive(Debug, Clone, Copy)]
pub struct IncrementalNormal<V = f64> {
    k: V,
}

numbers!(IncrementalNormal { k: V });

impl<V: Lanes> NormalForce<V> for IncrementalNormal<V> {
    type Memory = SummedNormal<V>;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, memory: &mut SummedNormal<V>) -> V {
        memory.force = memory.force + self.k * (touch.approach * touch.dt);
        memory.force
    }

    #[inline(always)]
    fn tangent(&self, _: V, _: &SummedNormal<V>) -> V {
        self.k
    }
}

impl Normal for IncrementalNormal {
    type Memo = SummedNormal;
    type On<V: Lanes> = IncrementalNormal<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            k: basis.pair.normal_stiffness,
        }
    }

    fn energy(&self, _: f64, memory: &SummedNormal) -> f64 {
        if self.k > 0.0 {
            0.5 * memory.force * memory.force / self.k
        } else {
            0.0
        }
    }

    fn held(&self, _: f64, memory: &SummedNormal) -> f64 {
        memory.force
    }

    fn seed(&self, force: f64) -> SummedNormal {
        SummedNormal { force }
    }

    fn inner(&self, _: f64, memory: &SummedNormal) -> Vec<Inner> {
        vec![Inner::number("N summed", memory.force, "N")]
    }
}

/// No tangential force.
#[derive(Debug, Clone, Copy)]
pub struct Frictionless;

numbers!(Frictionless);

impl<V: Lanes> TangentialForce<V> for Frictionless {
    type Memory = ();
    const ACTIVE: bool = false;
    const WITHIN: bool = true;

    #[inline(always)]
    fn force(&self, _: &Touch<V>, _: &Load<V>, (): &mut ()) -> Shear<V> {
        let zero = V::all(0.0);
        Shear {
            force: zero,
            loss: [zero; 2],
            sliding: V::mask(0),
            limit: zero,
        }
    }

    #[inline(always)]
    fn steepest(&self, _: V) -> V {
        V::all(0.0)
    }
}

impl Tangential for Frictionless {
    type Memo = ();
    type On<V: Lanes> = Self;
    type Plain<V: Lanes> = Self;

    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    fn held(&self, (): &()) -> f64 {
        0.0
    }

    fn stiffness(&self, _: f64) -> f64 {
        0.0
    }

    fn energy(&self, _: f64, (): &()) -> f64 {
        0.0
    }

    fn part(&self, _: f64, (): &()) -> [f64; 2] {
        [0.0; 2]
    }

    fn seed(&self, _: f64, _: f64) {}

    fn is_frictional(&self) -> bool {
        false
    }
}

/// Shear force of the spring [N].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct ShearForce<V = f64> {
    force: V,
}

numbers!(ShearForce { force: V });

impl Memory for ShearForce {
    kept_as_columns!(ShearForce);

    fn reduced(&self) -> [f64; 2] {
        [0.0, self.force]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.force);
    }
}

/// Shear spring with the limit F_n tan φ_μ + c, (17) to (19).
#[derive(Debug, Clone, Copy)]
pub struct LinearShear<V = f64> {
    k: V,
    friction: V,
    cohesion: V,
}

numbers!(LinearShear {
    k: V,
    friction: V,
    cohesion: V
});

impl<V: Lanes> TangentialForce<V> for LinearShear<V> {
    type Memory = ShearForce<V>;
    const ACTIVE: bool = true;
    const WITHIN: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut ShearForce<V>) -> Shear<V> {
        self.within(self.limit(load), touch, memory)
    }

    #[inline(always)]
    fn steepest(&self, _: V) -> V {
        self.k
    }
}

impl<V: Lanes> LinearShear<V> {
    /// Friction coefficient [-].
    #[inline(always)]
    pub(super) fn friction(&self) -> V {
        self.friction
    }

    /// The limit [N].
    #[inline(always)]
    pub(super) fn limit(&self, load: &Load<V>) -> V {
        load.limit(self.friction, self.cohesion)
    }

    /// The force after the step if nothing limits it [N].
    #[inline(always)]
    pub(super) fn trial(&self, touch: &Touch<V>, memory: &ShearForce<V>) -> V {
        memory.force + self.k * (touch.slide * touch.dt)
    }

    /// Advances the memory by one step and answers, within any limit [N].
    #[inline(always)]
    pub(super) fn within(
        &self,
        limit: V,
        touch: &Touch<V>,
        memory: &mut ShearForce<V>,
    ) -> Shear<V> {
        let zero = V::all(0.0);
        let old = memory.force;
        let trial = self.trial(touch, memory);
        let (force, over) = clipped(trial, limit);
        memory.force = force;
        // Without a spring (friction switched off under load) what was held is simply dropped.
        let sliding = over & self.k.above(zero);
        let loss = V::all(0.5) * (old + force) * ((trial - force) / self.k);
        Shear {
            force,
            loss: [V::pick(sliding, loss, zero), zero],
            sliding,
            limit,
        }
    }
}

impl Tangential for LinearShear {
    type Memo = ShearForce;
    type On<V: Lanes> = LinearShear<V>;
    type Plain<V: Lanes> = LinearShear<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        let Basis { pair, .. } = basis;
        let k = if pair.is_frictional() {
            pair.shear_stiffness
        } else {
            0.0
        };
        Self {
            k,
            friction: pair.friction,
            cohesion: pair.cohesion,
        }
    }

    fn held(&self, memory: &ShearForce) -> f64 {
        memory.force
    }

    fn stiffness(&self, _: f64) -> f64 {
        self.k
    }

    fn energy(&self, _: f64, memory: &ShearForce) -> f64 {
        if self.k > 0.0 {
            0.5 * memory.force * memory.force / self.k
        } else {
            0.0
        }
    }

    fn part(&self, displacement: f64, memory: &ShearForce) -> [f64; 2] {
        // A step to zero load: the spring gives its energy and the rest of the path to slip.
        let stored = self.energy(0.0, memory);
        [stored + 0.5 * memory.force * displacement, 0.0]
    }

    fn seed(&self, _: f64, force: f64) -> ShearForce {
        ShearForce { force }
    }

    fn is_frictional(&self) -> bool {
        (self.friction > 0.0 || self.cohesion > 0.0) && self.k > 0.0
    }
}
