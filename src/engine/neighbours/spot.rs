//! A particle or an image of one, as the boxes know it, and what all of them span.

use crate::engine::extent::Extent;
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
    /// Which tile of the halos.
    pub(super) tile: u32,
}

impl Spot {
    /// In the first of either.
    pub(super) fn new(x: [f64; 2], radius: f64) -> Self {
        let (home, tile) = (0, 0);
        Self {
            x,
            radius,
            home,
            tile,
        }
    }

    /// Whether the surfaces are nearer than `tol` [m].
    #[cfg(test)]
    pub(super) fn is_near(&self, other: &Self, tol: f64) -> bool {
        let d = [other.x[0] - self.x[0], other.x[1] - self.x[1]];
        let reach = self.radius + other.radius + tol;
        d[0] * d[0] + d[1] * d[1] < reach * reach
    }
}

/// What many spots are like.
#[derive(Clone, Copy)]
pub(super) struct Bounds {
    /// Around all centres [m].
    pub(super) extent: Extent,
    /// Smallest and largest radius [m].
    pub(super) radii: [f64; 2],
    /// Sums of radii [m] and of their squares [m²]: added up stretch by stretch, so that their last
    /// bits depend on the number of stretches.
    pub(super) sums: [f64; 2],
}

impl Default for Bounds {
    fn default() -> Self {
        Self {
            extent: Extent::default(),
            radii: [f64::INFINITY, 0.0],
            sums: [0.0; 2],
        }
    }
}

impl Bounds {
    /// Takes one in that is here [m] and so large [m].
    #[inline(always)]
    pub(super) fn take_in(&mut self, x: [f64; 2], radius: f64) {
        self.extent.take_in(x);
        self.radii = [radius.smaller(self.radii[0]), radius.larger(self.radii[1])];
        self.sums[0] += radius;
        self.sums[1] += radius * radius;
    }

    /// Of two stretches.
    pub(super) fn and(self, other: Self) -> Self {
        let [least, most] = other.radii;
        Self {
            extent: self.extent.and(other.extent),
            radii: [least.smaller(self.radii[0]), most.larger(self.radii[1])],
            sums: [0, 1].map(|k| self.sums[k] + other.sums[k]),
        }
    }

    /// Of so many spots that reach twice their radius and `tol` [m] far: the mean square of that [m²].
    pub(super) fn mean_square_of_reach(&self, count: usize, tol: f64) -> f64 {
        let [sum, squares] = self.sums;
        4.0 * (squares + tol * sum) / count as f64 + tol * tol
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_mean_square_of_reaches_is_that_of_each() {
        let mut bounds = [Bounds::default(); 2];
        let radii = [0.5, 2.0, 1.25];
        for (k, radius) in radii.into_iter().enumerate() {
            bounds[k % 2].take_in([0.0; 2], radius);
        }
        let all = bounds[0].and(bounds[1]);
        let squares = radii.map(|radius: f64| (2.0 * radius + 0.25) * (2.0 * radius + 0.25));
        // Halves and quarters: nothing is rounded before the division.
        let mean = squares.iter().sum::<f64>() / 3.0;
        assert!((all.mean_square_of_reach(3, 0.25) - mean).abs() <= 4.0 * f64::EPSILON * mean);
        assert_eq!(all.radii, [0.5, 2.0]);
    }
}
