//! Hertz: the elastic normal force of two spheres, N = (4/3) E* √R* α^{3/2}.
//!
//! Randall 1989, (3.13), with a² = R* α and the tangent stiffness 2 E* a of (4.12). The force
//! follows from the overlap itself; the increments of (4.11) and (4.12) are kept as
//! [`super::incremental_hertz`] for replay.

use super::card::{Card, POISSON, Slip, YOUNG};
use super::linear::Frictionless;
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Normal, NormalForce};
use super::quantities::{Basis, Touch};
use crate::engine::lanes::Lanes;

/// Row in the list.
pub const CARD: Card = Card {
    name: "hertz",
    summary: "Hertz spheres without friction",
    parameters: &[YOUNG, POISSON],
    slip: Slip::Frictionless,
    memory: [0, 0],
    gain: None,
    source: "Hertz 1882; Randall 1989, (3.13)",
    pass: |plan| plan.hertzian::<Frictionless>(),
};

/// Normal spring of two spheres.
#[derive(Debug, Clone, Copy)]
pub struct Hertz<V = f64> {
    /// (4/3) E* √R* [N/m^1.5].
    hertz: V,
}

numbers!(Hertz { hertz: V });

impl<V: Lanes> NormalForce<V> for Hertz<V> {
    type Memory = ();

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, (): &mut ()) -> V {
        self.hertz * touch.overlap * touch.overlap.sqrt()
    }

    #[inline(always)]
    fn tangent(&self, overlap: V, (): &()) -> V {
        V::all(1.5) * self.hertz * overlap.sqrt()
    }
}

impl Normal for Hertz {
    type Memo = ();
    type On<V: Lanes> = Hertz<V>;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            hertz: coefficient(basis.pair.young, basis.r_eff),
        }
    }

    fn energy(&self, overlap: f64, (): &()) -> f64 {
        let overlap = overlap.max(0.0);
        0.4 * self.hertz * overlap * overlap * overlap.sqrt()
    }

    fn held(&self, overlap: f64, (): &()) -> f64 {
        let overlap = overlap.max(0.0);
        self.hertz * overlap * overlap.sqrt()
    }

    fn seed(&self, _: f64) {}
}

/// (4/3) E* √R* [N/m^1.5].
pub(super) fn coefficient(young: f64, r_eff: f64) -> f64 {
    4.0 / 3.0 * young * r_eff.sqrt()
}
