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
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Normal, NormalForce};
use super::quantities::{Basis, Touch};
use crate::engine::lanes::Lanes;

/// Normal force summed so far [N].
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SummedHertz<V = f64> {
    force: V,
}

numbers!(SummedHertz { force: V });

impl SummedHertz {
    /// Memory that holds this force [N].
    pub fn new(force: f64) -> Self {
        Self { force }
    }
}

/// Hertz's normal force, summed from increments.
#[derive(Debug, Clone, Copy)]
pub struct IncrementalHertz<V = f64> {
    young_eff: V,
    r_eff: V,
}

numbers!(IncrementalHertz {
    young_eff: V,
    r_eff: V
});

impl<V: Lanes> IncrementalHertz<V> {
    /// From E\* [Pa] and R\* [m].
    pub fn new(young_eff: V, r_eff: V) -> Self {
        Self { young_eff, r_eff }
    }

    /// Radius a of the contact [m] (4.14).
    #[inline(always)]
    pub fn radius(&self, memory: &SummedHertz<V>) -> V {
        (V::all(0.75) * memory.force * self.r_eff / self.young_eff).each(libm::cbrt)
    }

    /// The overlap a²/R\* [m] that Hertz's law gives the summed force: what the tangential law has
    /// to see.
    #[inline(always)]
    pub fn depth(&self, memory: &SummedHertz<V>) -> V {
        let a = self.radius(memory);
        a * a / self.r_eff
    }

    /// Force [N] after the approach dn [m].
    #[inline(always)]
    pub fn sum(&self, dn: V, memory: &mut SummedHertz<V>) -> V {
        let zero = V::all(0.0);
        let first = V::all(4.0 / 3.0) * self.young_eff * (self.r_eff * dn * dn * dn).sqrt();
        let later = V::all(2.0) * self.young_eff * self.radius(memory) * dn;
        let begun = V::pick(dn.above(zero), first, zero);
        let rise = V::pick(memory.force.above(zero), later, begun);
        memory.force = (memory.force + rise).positive();
        memory.force
    }
}

impl Memory for SummedHertz {
    kept_as_columns!(SummedHertz);

    fn reduced(&self) -> [f64; 2] {
        [self.force, 0.0]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        see(self.force);
    }
}

impl<V: Lanes> NormalForce<V> for IncrementalHertz<V> {
    type Memory = SummedHertz<V>;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, memory: &mut SummedHertz<V>) -> V {
        self.sum(touch.approach * touch.dt, memory)
    }

    #[inline(always)]
    fn tangent(&self, _: V, memory: &SummedHertz<V>) -> V {
        V::all(2.0) * self.young_eff * self.radius(memory)
    }

    #[inline(always)]
    fn depth(&self, _: V, memory: &SummedHertz<V>) -> V {
        Self::depth(self, memory)
    }
}

impl Normal for IncrementalHertz {
    type Memo = SummedHertz;
    type On<V: Lanes> = IncrementalHertz<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self::new(basis.pair.young, basis.r_eff)
    }

    fn energy(&self, _: f64, memory: &SummedHertz) -> f64 {
        0.4 * memory.force * Self::depth(self, memory)
    }

    fn held(&self, _: f64, memory: &SummedHertz) -> f64 {
        memory.force
    }

    fn seed(&self, force: f64) -> SummedHertz {
        SummedHertz::new(force)
    }

    fn inner(&self, _: f64, memory: &SummedHertz) -> Vec<Inner> {
        vec![
            Inner::number("N summed", memory.force, "N"),
            Inner::number("alpha of it", Self::depth(self, memory), "m"),
        ]
    }
}
