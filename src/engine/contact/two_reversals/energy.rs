//! Energy in the tangential spring: a closed form of the state.
//!
//! The tractions are sums of Hertz distributions at smaller contact sizes (Jaeger 1998): with
//! T(η) and δ(η) for what the contact carries up to the approach η, the strain energy is the
//! integral of T dδ over η from 0 to α. On the three branches the slope dT/dN is ±μ between the
//! loads at which the annuli of slip end, and dδ/dη = ±μκ, so that each annulus adds a polynomial.
//!
//! | annulus, from inside | ends at the load | slope |
//! |---|---|---|
//! | stuck core | N - T\*/μ | 0 |
//! | slip of the loading | N - (T\* - T)/(2μ) | +μ |
//! | slip of the unloading | N - (T - T\*\*)/(2μ) | -μ |
//! | slip of the reloading | N | +μ |
//!
//! (the last named one always ends at N; fewer reversals, fewer rows). A stuck contact is taken as
//! one on its curve: what it would give back if N stayed as it is.
//!
//! # How well the ledger closes
//!
//! Work = change of energy + slip holds to round-off at constant N, and with the step along a
//! branch while N changes. A nested loop run backwards gives back what its way forwards lost, so
//! that slip is negative there. It does not hold where the law forgets: for a contact that was
//! stuck while N rose (.01 to .05 μN δ\* on the histories of `tests/two_reversals/energy.rs`), and
//! where a reversal comes while N falls faster; there the law can be driven round a closed cycle
//! and give energy, see [`WORST_GAIN`](super::WORST_GAIN).

use super::{Branch, Reversals, TwoReversals};

/// What the contact carries up to a load.
struct Sum {
    overlap: f64,
    load: f64,
    force: f64,
    energy: f64,
}

impl TwoReversals {
    /// Energy in the tangential spring [J].
    pub fn energy(&self, memory: &Reversals) -> f64 {
        if memory.overlap <= 0.0 || memory.force == 0.0 && memory.branch == Branch::Virgin {
            return 0.0;
        }
        let size = self.size(memory.overlap);
        let (mu, load) = (self.friction, size.limit / self.friction);
        let direction = memory.direction(0.0);
        let force = direction * memory.force;
        let top = direction * memory.unloaded_from;
        let bottom = direction * memory.reloaded_from;
        // Loads at which the annuli end, from inside.
        let ends = match memory.branch {
            Branch::Virgin => [load - force / mu, load, load, load],
            Branch::Unloading => [
                load - top / mu,
                load - (top - force) / (2.0 * mu),
                load,
                load,
            ],
            Branch::Reloading => [
                load - top / mu,
                load - (top - bottom) / (2.0 * mu),
                load - (force - bottom) / (2.0 * mu),
                load,
            ],
        };
        let mut sum = Sum {
            overlap: 0.0,
            load: 0.0,
            force: 0.0,
            energy: 0.0,
        };
        for (end, slope) in ends.into_iter().zip([0.0, 1.0, -1.0, 1.0]) {
            let end = end.clamp(sum.load, load);
            let root = libm::cbrt(end / load);
            sum.add(end, memory.overlap * root * root, slope * mu, self.kappa);
        }
        sum.energy
    }
}

impl Sum {
    /// Adds an annulus that ends at this load [N] and overlap [m].
    fn add(&mut self, load: f64, overlap: f64, slope: f64, kappa: f64) {
        let wide = overlap - self.overlap;
        // The integral of N over the overlap is 2/5 N α.
        let inner = 0.4 * (load * overlap - self.load * self.overlap) - self.load * wide;
        self.energy += slope * kappa * (self.force * wide + slope * inner);
        self.force += slope * (load - self.load);
        self.load = load;
        self.overlap = overlap;
    }
}
