//! Mindlin's initial stiffness, 8 G* a, as a spring that keeps its force: what most programs call
//! Hertz-Mindlin (B17; Thornton, Cummins & Cleary 2011).
//!
//! No slip inside the contact before all of it slides. While the normal force falls the shear force
//! is rescaled with the contact radius; `unloading = "keep"` leaves it, and can then gain energy.

use serde::{Deserialize, Serialize};

use super::card::{COHESION, Card, FRICTION, POISSON, Slip, YOUNG};
use super::history::{follow, stored};
use super::inner::Inner;
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Tangential, TangentialForce};
use super::quantities::{Basis, Load, Shear, Touch};
use crate::engine::lanes::Lanes;
use crate::engine::setup::Unloading;

/// Row in the list.
pub const CARD: Card = Card {
    name: "hertz-mindlin",
    summary: "Hertz with Mindlin's initial shear stiffness 8 G* a, no slip before all slides",
    parameters: &[YOUNG, POISSON, FRICTION, COHESION],
    slip: Slip::Whole,
    memory: [0, 16],
    gain: None,
    source: "Mindlin 1949; Thornton, Cummins & Cleary 2011",
    pass: |plan| match plan.unloading {
        Unloading::Rescale => plan.hertzian::<HertzMindlin<f64, false>>(),
        Unloading::Keep => plan.hertzian::<HertzMindlin<f64, true>>(),
    },
};

/// Shear force [N] and the stiffness it was held at [N/m].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct HeldShear<V = f64> {
    force: V,
    stiffness: V,
}

numbers!(HeldShear {
    force: V,
    stiffness: V
});

impl Memory for HeldShear {
    kept_as_columns!(HeldShear);

    fn reduced(&self) -> [f64; 2] {
        [0.0, self.force]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.force);
        see(self.stiffness);
    }
}

/// Shear spring of stiffness 8 G* a with Coulomb's limit; `KEEP`: the force stays while N falls.
#[derive(Debug, Clone, Copy)]
pub struct HertzMindlin<V, const KEEP: bool> {
    /// 8 G* √R* [N/m^1.5].
    mindlin: V,
    friction: V,
    cohesion: V,
}

numbers!(HertzMindlin<const KEEP> { mindlin: V, friction: V, cohesion: V });

impl<V: Lanes, const KEEP: bool> TangentialForce<V> for HertzMindlin<V, KEEP> {
    type Memory = HeldShear<V>;
    const ACTIVE: bool = true;
    const WITHIN: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut HeldShear<V>) -> Shear<V> {
        let zero = V::all(0.0);
        let rubs = self.friction.above(zero) | self.cohesion.above(zero);
        self.shear(touch, load, memory, rubs)
    }

    #[inline(always)]
    fn steepest(&self, overlap: V) -> V {
        self.mindlin * overlap.sqrt()
    }
}

impl<V: Lanes, const KEEP: bool> HertzMindlin<V, KEEP> {
    /// The answer, and whether there is friction at all.
    #[inline(always)]
    fn shear(
        &self,
        touch: &Touch<V>,
        load: &Load<V>,
        memory: &mut HeldShear<V>,
        rubs: V::Mask,
    ) -> Shear<V> {
        let k = self.mindlin * touch.overlap.sqrt();
        let limit = load.limit(self.friction, self.cohesion);
        let d = touch.slide * touch.dt;
        let now = follow(memory.force, memory.stiffness, k, !KEEP, d, limit);
        *memory = HeldShear {
            force: now.force,
            stiffness: k,
        };
        Shear {
            force: now.force,
            loss: now.loss,
            sliding: now.sliding & rubs,
            limit,
        }
    }
}

/// The same where there is friction everywhere.
#[derive(Debug, Clone, Copy)]
pub struct Rubbing<V, const KEEP: bool>(HertzMindlin<V, KEEP>);

impl<V: Lanes, const KEEP: bool> Numbers<V> for Rubbing<V, KEEP> {
    const COUNT: usize = <HertzMindlin<V, KEEP> as Numbers<V>>::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        Self(HertzMindlin::take(from))
    }
}

impl<V: Lanes, const KEEP: bool> TangentialForce<V> for Rubbing<V, KEEP> {
    type Memory = HeldShear<V>;
    const ACTIVE: bool = true;
    const WITHIN: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut HeldShear<V>) -> Shear<V> {
        self.0.shear(touch, load, memory, V::mask(u32::MAX))
    }

    #[inline(always)]
    fn steepest(&self, overlap: V) -> V {
        self.0.steepest(overlap)
    }
}

impl<const KEEP: bool> Tangential for HertzMindlin<f64, KEEP> {
    type Memo = HeldShear;
    type On<V: Lanes> = HertzMindlin<V, KEEP>;
    type Plain<V: Lanes> = Rubbing<V, KEEP>;

    fn all_plain(common: &[Option<f64>]) -> bool {
        let [_, friction, cohesion] = common else {
            return false;
        };
        [friction, cohesion]
            .into_iter()
            .flatten()
            .any(|&limit| limit > 0.0)
    }

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            mindlin: 8.0 * basis.pair.shear * basis.r_eff.sqrt(),
            friction: basis.pair.friction,
            cohesion: basis.pair.cohesion,
        }
    }

    fn held(&self, memory: &HeldShear) -> f64 {
        memory.force
    }

    fn stiffness(&self, overlap: f64) -> f64 {
        self.steepest(overlap.max(0.0))
    }

    fn energy(&self, _: f64, memory: &HeldShear) -> f64 {
        stored(memory.force, memory.stiffness)
    }

    fn part(&self, displacement: f64, memory: &HeldShear) -> [f64; 2] {
        // A step to zero load: all that is held, and the path of the mean force, goes to slip.
        let held = stored(memory.force, memory.stiffness);
        [0.0, held + 0.5 * memory.force * displacement]
    }

    fn seed(&self, overlap: f64, force: f64) -> HeldShear {
        HeldShear {
            force,
            stiffness: self.stiffness(overlap),
        }
    }

    fn is_frictional(&self) -> bool {
        self.friction > 0.0 || self.cohesion > 0.0
    }

    fn inner(&self, _: f64, memory: &HeldShear) -> Vec<Inner> {
        vec![Inner::number("held at k_t", memory.stiffness, "N/m")]
    }
}
