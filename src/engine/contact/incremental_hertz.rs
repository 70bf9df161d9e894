//! The Hertzian normal force as the program BALL summed it, for historical replay.
//!
//! Literal (Randall 1989, 4.3.1):
//!
//! - (4.11) the first increment is 4/3 E\* sqrt(R\* Δn³) with the whole approach Δn of the step,
//!   although the pair touched only in the course of it: the force starts ahead of the overlap;
//! - (4.12) later increments are 2 E\* a Δn, forward Euler;
//! - a force that would become negative ends the contact: it and the memory are zero, although
//!   the pair may still overlap, and the next increment is a first one again.
//!
//! Put right: a = (3 N R\*/(4 E\*))^(1/3), (4.14), is taken from the elastic force, not from the sum
//! N_t with the dashpot of (4.13), which would feed the damping back into the stiffness.
//!
//! The force drifts from the overlap and loses energy: see `tests/two_reversals.rs` for how much.

use serde::{Deserialize, Serialize};

use super::inner::Inner;
use super::memory::Memory;
use super::parts::Normal;
use super::quantities::{Basis, Touch};

/// Normal force summed so far [N].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SummedHertz(f64);

impl SummedHertz {
    /// Memory that holds this force [N].
    pub fn new(force: f64) -> Self {
        Self(force)
    }
}

/// Hertz's normal force, summed from increments.
#[derive(Debug, Clone, Copy)]
pub struct IncrementalHertz {
    young_eff: f64,
    r_eff: f64,
}

impl IncrementalHertz {
    /// From E\* [Pa] and R\* [m].
    pub fn new(young_eff: f64, r_eff: f64) -> Self {
        Self { young_eff, r_eff }
    }

    /// Radius a of the contact [m] (4.14).
    pub fn radius(&self, memory: &SummedHertz) -> f64 {
        libm::cbrt(0.75 * memory.0 * self.r_eff / self.young_eff)
    }

    /// The overlap a²/R\* [m] that Hertz's law gives the summed force: what the tangential law has
    /// to see.
    pub fn depth(&self, memory: &SummedHertz) -> f64 {
        let a = self.radius(memory);
        a * a / self.r_eff
    }

    /// Force [N] after the approach dn [m].
    #[inline]
    pub fn sum(&self, dn: f64, memory: &mut SummedHertz) -> f64 {
        let rise = if memory.0 > 0.0 {
            2.0 * self.young_eff * self.radius(memory) * dn
        } else if dn > 0.0 {
            4.0 / 3.0 * self.young_eff * (self.r_eff * dn * dn * dn).sqrt()
        } else {
            0.0
        };
        let sum = memory.0 + rise;
        memory.0 = if sum > 0.0 { sum } else { 0.0 };
        memory.0
    }
}

impl Memory for SummedHertz {
    fn reduced(&self) -> [f64; 2] {
        [self.0, 0.0]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.0);
    }
}

impl Normal for IncrementalHertz {
    type Memory = SummedHertz;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self::new(basis.pair.young, basis.r_eff)
    }

    #[inline(always)]
    fn force(&self, touch: &Touch, memory: &mut SummedHertz) -> f64 {
        self.sum(touch.approach * touch.dt, memory)
    }

    fn stiffness(&self, _: f64, memory: &SummedHertz) -> f64 {
        2.0 * self.young_eff * self.radius(memory)
    }

    fn energy(&self, _: f64, memory: &SummedHertz) -> f64 {
        0.4 * memory.0 * self.depth(memory)
    }

    fn held(&self, _: f64, memory: &SummedHertz) -> f64 {
        memory.0
    }

    fn seed(&self, force: f64) -> SummedHertz {
        SummedHertz::new(force)
    }

    fn inner(&self, _: f64, memory: &SummedHertz) -> Vec<Inner> {
        vec![
            Inner::number("N summed", memory.0, "N"),
            Inner::number("alpha of it", self.depth(memory), "m"),
        ]
    }

    fn overlap(&self, _: f64, memory: &SummedHertz) -> f64 {
        self.depth(memory)
    }
}
