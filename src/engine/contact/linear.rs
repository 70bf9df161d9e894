//! Linear springs with a Coulomb and cohesion limit.
//!
//! Cundall & Strack 1979, equations (16) to (19). The normal force is k_n α; the historical form
//! that sums k_n Δn is kept for replay, it drifts from the overlap.

use serde::{Deserialize, Serialize};

use super::card::{COHESION, Card, FRICTION, NORMAL, SHEAR, Slip};
use super::dashpot::Constant;
use super::inner::Inner;
use super::memory::Memory;
use super::parts::{Normal, Tangential};
use super::pass::ContactPass;
use super::quantities::{Basis, Load, Shear, Touch};
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
pub struct LinearNormal {
    k: f64,
}

impl Normal for LinearNormal {
    type Memory = ();

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            k: basis.pair.normal_stiffness,
        }
    }

    #[inline(always)]
    fn force(&self, touch: &Touch, (): &mut ()) -> f64 {
        self.k * touch.overlap
    }

    #[inline(always)]
    fn stiffness(&self, _: f64, (): &()) -> f64 {
        self.k
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
pub struct SummedNormal(f64);

impl Memory for SummedNormal {
    fn reduced(&self) -> [f64; 2] {
        [self.0, 0.0]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.0);
    }
}

/// Normal spring, force summed from increments, (16) and (18).
#[derive(Debug, Clone, Copy)]
pub struct IncrementalNormal {
    k: f64,
}

impl Normal for IncrementalNormal {
    type Memory = SummedNormal;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            k: basis.pair.normal_stiffness,
        }
    }

    #[inline(always)]
    fn force(&self, touch: &Touch, memory: &mut SummedNormal) -> f64 {
        memory.0 += self.k * (touch.approach * touch.dt);
        memory.0
    }

    #[inline(always)]
    fn stiffness(&self, _: f64, _: &SummedNormal) -> f64 {
        self.k
    }

    fn energy(&self, _: f64, memory: &SummedNormal) -> f64 {
        if self.k > 0.0 {
            0.5 * memory.0 * memory.0 / self.k
        } else {
            0.0
        }
    }

    fn held(&self, _: f64, memory: &SummedNormal) -> f64 {
        memory.0
    }

    fn seed(&self, force: f64) -> SummedNormal {
        SummedNormal(force)
    }

    fn inner(&self, _: f64, memory: &SummedNormal) -> Vec<Inner> {
        vec![Inner::number("N summed", memory.0, "N")]
    }
}

/// No tangential force.
#[derive(Debug, Clone, Copy)]
pub struct Frictionless;

impl Tangential for Frictionless {
    type Memory = ();
    const ACTIVE: bool = false;

    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    #[inline(always)]
    fn force(&self, _: &Touch, _: &Load, (): &mut ()) -> Shear {
        Shear::default()
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
pub struct ShearForce(f64);

impl Memory for ShearForce {
    fn reduced(&self) -> [f64; 2] {
        [0.0, self.0]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.0);
    }
}

/// Shear spring with the limit F_n tan φ_μ + c, (17) to (19).
#[derive(Debug, Clone, Copy)]
pub struct LinearShear {
    k: f64,
    friction: f64,
    cohesion: f64,
}

impl Tangential for LinearShear {
    type Memory = ShearForce;
    const ACTIVE: bool = true;

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

    #[inline(always)]
    fn force(&self, touch: &Touch, load: &Load, memory: &mut ShearForce) -> Shear {
        let old = memory.0;
        let trial = old + self.k * (touch.slide * touch.dt);
        let limit = self.friction * load.total + self.cohesion;
        // A dashpot that pulls must not turn the limit negative.
        let limit = if limit > 0.0 { limit } else { 0.0 };
        let sliding = trial.abs() > limit;
        let force = if sliding {
            limit.copysign(trial)
        } else {
            trial
        };
        memory.0 = force;
        // Without a spring (friction switched off under load) what was held is simply dropped.
        let loss = if sliding && self.k > 0.0 {
            0.5 * (old + force) * ((trial - force) / self.k)
        } else {
            0.0
        };
        Shear {
            force,
            loss: [loss, 0.0],
            sliding: sliding && self.k > 0.0,
            limit,
        }
    }

    fn held(&self, memory: &ShearForce) -> f64 {
        memory.0
    }

    fn stiffness(&self, _: f64) -> f64 {
        self.k
    }

    fn energy(&self, _: f64, memory: &ShearForce) -> f64 {
        if self.k > 0.0 {
            0.5 * memory.0 * memory.0 / self.k
        } else {
            0.0
        }
    }

    fn part(&self, displacement: f64, memory: &ShearForce) -> [f64; 2] {
        // A step to zero load: the spring gives its energy and the rest of the path to slip.
        let stored = self.energy(0.0, memory);
        [stored + 0.5 * memory.0 * displacement, 0.0]
    }

    fn seed(&self, _: f64, force: f64) -> ShearForce {
        ShearForce(force)
    }

    fn is_frictional(&self) -> bool {
        self.friction > 0.0 && self.k > 0.0
    }
}
