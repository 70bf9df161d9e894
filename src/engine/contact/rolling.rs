//! Rolling resistance: an elastic-plastic spring (Ai, Chen, Rotter & Ooi 2011, model C).
//!
//! The moment M = -k_r θ of the relative rolling angle θ is limited to μ_r R_r N, with the rolling
//! radius R_r = R* and k_r = c k_n (μ_r R_r)², c = 2.25 for spheres and 3 for discs. As k_n follows
//! the load, the moment is kept and rescaled like a Hertz-Mindlin shear force.

use serde::{Deserialize, Serialize};

use super::history::{follow, stored};
use super::inner::Inner;
use super::memory::Memory;
use super::parts::Rolling;
use super::quantities::{Basis, Load, Roll, Touch};

/// None.
#[derive(Debug, Clone, Copy)]
pub struct Unresisted;

impl Rolling for Unresisted {
    type Memory = ();
    const ACTIVE: bool = false;

    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    #[inline(always)]
    fn moment(&self, _: &Touch, _: &Load, (): &mut ()) -> Roll {
        Roll::default()
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
pub struct HeldMoment {
    moment: f64,
    stiffness: f64,
}

impl Memory for HeldMoment {
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
pub struct RollingSpring {
    /// k_r over k_n [m²].
    shape: f64,
    /// μ_r R_r [m].
    arm: f64,
}

impl Rolling for RollingSpring {
    type Memory = HeldMoment;
    const ACTIVE: bool = true;

    fn prepare(basis: &Basis<'_>) -> Self {
        let arm = basis.pair.rolling_friction * basis.r_eff;
        Self {
            shape: basis.pair.rolling_shape * arm * arm,
            arm,
        }
    }

    #[inline(always)]
    fn moment(&self, touch: &Touch, load: &Load, memory: &mut HeldMoment) -> Roll {
        let k = self.shape * load.stiffness;
        if k <= 0.0 {
            *memory = HeldMoment::default();
            return Roll::default();
        }
        let limit = self.arm * load.total;
        let limit = if limit > 0.0 { limit } else { 0.0 };
        let angle = touch.roll * touch.dt;
        let now = follow(memory.moment, memory.stiffness, k, true, angle, limit);
        *memory = HeldMoment {
            moment: now.force,
            stiffness: k,
        };
        Roll {
            moment: now.force,
            loss: now.loss[0] + now.loss[1],
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
