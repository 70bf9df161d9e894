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
//! one whose outermost annulus, the load μ dN = 8 G\* a DD wide, carries no traction: right when N
//! rose without displacement.
//!
//! # How well the ledger closes
//!
//! At constant N, work = change of energy + slip to round-off on all branches, the backward run of
//! a reloading curve excepted in its sign: it gives back what the reloading lost. While N changes,
//! it closes with the step for states on a curve. It does not close where the law forgets: DD when
//! the displacement turns, and where DD stands for annuli that carry some traction.

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
        let short = self.shear * size.root * memory.shortfall;
        let force = direction * memory.force + memory.sense() * short;
        let top = direction * memory.unloaded_from;
        let bottom = direction * memory.reloaded_from;
        let outer = load - short / mu;
        // Loads at which the annuli end, from inside.
        let ends = match memory.branch {
            Branch::Virgin => [load - force / mu, outer, outer, outer],
            Branch::Unloading => [
                load - top / mu,
                load - (top - force) / (2.0 * mu),
                outer,
                outer,
            ],
            Branch::Reloading | Branch::Reunloading => [
                load - top / mu,
                load - (top - bottom) / (2.0 * mu),
                load - (force - bottom) / (2.0 * mu),
                outer,
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
