//! Rolling resistance: an elastic-plastic spring (Ai, Chen, Rotter & Ooi 2011, model C).
//!
//! The moment M = -k_r θ of the relative rolling angle θ is limited to μ_r R_r N, with the rolling
//! radius R_r = R* and k_r = c k_n (μ_r R_r)², c = 2.25 for spheres and 3 for discs. As k_n follows
//! the load, the moment is kept and rescaled like a Hertz-Mindlin shear force.

use serde::{Deserialize, Serialize};

use super::history::{follow, stored};
use super::inner::Inner;
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Rolling, RollingMoment};
use super::quantities::{Basis, Load, Roll, Touch};
use crate::engine::lanes::Lanes;

/// None.
#[derive(Debug, Clone, Copy)]
pub struct Unresisted;

numbers!(Unresisted);

impl<V: Lanes> RollingMoment<V> for Unresisted {
    type Memory = ();
    const ACTIVE: bool = false;

    #[inline(always)]
    fn moment(&self, _: &Touch<V>, _: &Load<V>, (): &mut ()) -> Roll<V> {
        let zero = V::all(0.0);
        Roll {
            moment: zero,
            loss: zero,
        }
    }
}

impl Rolling for Unresisted {
    type Memo = ();
    type On<V: Lanes> = Self;

    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    fn stiffness(&self, _: f64) -> f64 {
        0.0
    }

    fn energy(&self, (): &()) -> f64 {
        0.0
    }

    fn refit(&self, _: &Self, (): &()) {}

    fn part(&self, _: f64, (): &()) -> f64 {
        0.0
    }
}

/// Moment [N m] and the stiffness it was held at [N m].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct HeldMoment<V = f64> {
    moment: V,
    stiffness: V,
}

numbers!(HeldMoment {
    moment: V,
    stiffness: V
});

impl Memory for HeldMoment {
    kept_as_columns!(HeldMoment);

    fn reduced(&self) -> [f64; 2] {
        [0.0; 2]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.moment);
        see(self.stiffness);
    }
}

/// Spring and limit.
#[derive(Debug, Clone, Copy)]
pub struct RollingSpring<V = f64> {
    /// k_r over k_n [m²].
    shape: V,
    /// μ_r R_r [m].
    arm: V,
}

numbers!(RollingSpring { shape: V, arm: V });

impl<V: Lanes> RollingMoment<V> for RollingSpring<V> {
    type Memory = HeldMoment<V>;
    const ACTIVE: bool = true;

    #[inline(always)]
    fn moment(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut HeldMoment<V>) -> Roll<V> {
        let zero = V::all(0.0);
        let k = self.shape * load.stiffness;
        let resists = k.above(zero);
        let limit = (self.arm * load.total).positive();
        let angle = touch.roll * touch.dt;
        let now = follow(memory.moment, memory.stiffness, k, true, angle, limit);
        let moment = V::pick(resists, now.force, zero);
        *memory = HeldMoment {
            moment,
            stiffness: V::pick(resists, k, zero),
        };
        Roll {
            moment,
            loss: V::pick(resists, now.loss[0] + now.loss[1], zero),
        }
    }
}

impl Rolling for RollingSpring {
    type Memo = HeldMoment;
    type On<V: Lanes> = RollingSpring<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        let arm = basis.pair.rolling_friction * basis.r_eff;
        Self {
            shape: basis.pair.rolling_shape * arm * arm,
            arm,
        }
    }

    fn stiffness(&self, normal: f64) -> f64 {
        self.shape * normal
    }

    fn energy(&self, memory: &HeldMoment) -> f64 {
        stored(memory.moment, memory.stiffness)
    }

    fn refit(&self, before: &Self, memory: &HeldMoment) -> HeldMoment {
        // A changed spring starts afresh: it is no longer known what it was bent against.
        if self.shape == before.shape {
            *memory
        } else {
            HeldMoment::default()
        }
    }

    fn part(&self, angle: f64, memory: &HeldMoment) -> f64 {
        self.energy(memory) + 0.5 * memory.moment * angle
    }

    fn inner(&self, _: f64, memory: &HeldMoment) -> Vec<Inner> {
        vec![Inner::number("rolling moment", memory.moment, "N m")]
    }
}
