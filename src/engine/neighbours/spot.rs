//! A particle or an image of one, as the boxes know it, and what all of them span.

use crate::engine::lanes::Lanes;

/// A particle, or an image of one, for which there is a box.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Spot {
    /// Centre [m].
    pub(super) x: [f64; 2],
    /// Radius [m].
    pub(super) radius: f64,
    /// Which box.
    pub(super) home: u32,
}

impl Spot {
    pub(super) fn new(x: [f64; 2], radius: f64) -> Self {
        let home = 0;
        Self { x, radius, home }
    }

    /// Whether the surfaces are nearer than `tol` [m].
    #[cfg(test)]
    pub(super) fn is_near(&self, other: &Self, tol: f64) -> bool {
        let d = [other.x[0] - self.x[0], other.x[1] - self.x[1]];
        let reach = self.radius + other.radius + tol;
        d[0] * d[0] + d[1] * d[1] < reach * reach
    }
}

/// What spots span.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// Lower and upper corner [m].
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
    /// Smallest and largest radius [m].
    pub(super) radii: [f64; 2],
    /// Sum of the squares of what each reaches [m²]; its last bits are those of the number of threads, and
    /// nothing but how boxes are laid depends on them.
    pub(super) squares: f64,
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
            radii: [f64::INFINITY, 0.0],
            squares: 0.0,
        }
    }
}

impl Bounds {
    /// Spans this one, too; `tol` [m] is what it reaches beyond its surface.
    #[inline(always)]
    pub(super) fn take_in(&mut self, &Spot { x, radius, .. }: &Spot, tol: f64) {
        self.low = [0, 1].map(|k| x[k].smaller(self.low[k]));
        self.high = [0, 1].map(|k| x[k].larger(self.high[k]));
        self.radii = [radius.smaller(self.radii[0]), radius.larger(self.radii[1])];
        let reach = 2.0 * radius + tol;
        self.squares += reach * reach;
    }

    /// What two stretches of them span together.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            low: [0, 1].map(|k| self.low[k].smaller(other.low[k])),
            high: [0, 1].map(|k| self.high[k].larger(other.high[k])),
            radii: [
                self.radii[0].smaller(other.radii[0]),
                self.radii[1].larger(other.radii[1]),
            ],
            squares: self.squares + other.squares,
        }
    }
}
