//! The box around points.

use serde::{Deserialize, Serialize};

use super::lanes::Lanes;

/// Lower and upper corner of a box around points; without any, the lower is infinitely far up.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Extent {
    pub(super) low: [f64; 2],
    pub(super) high: [f64; 2],
}

impl Default for Extent {
    fn default() -> Self {
        Self {
            low: [f64::INFINITY; 2],
            high: [f64::NEG_INFINITY; 2],
        }
    }
}

impl Extent {
    /// Around one point.
    pub(super) fn of(x: [f64; 2]) -> Self {
        Self { low: x, high: x }
    }

    /// Takes a point in; one that is nowhere (NaN) is not.
    #[inline(always)]
    pub(super) fn take_in(&mut self, x: [f64; 2]) {
        self.low = [0, 1].map(|k| x[k].smaller(self.low[k]));
        self.high = [0, 1].map(|k| x[k].larger(self.high[k]));
    }

    /// Around two.
    #[inline(always)]
    pub(super) fn and(mut self, other: Self) -> Self {
        self.low = [0, 1].map(|k| other.low[k].smaller(self.low[k]));
        self.high = [0, 1].map(|k| other.high[k].larger(self.high[k]));
        self
    }

    /// Width and height.
    #[inline(always)]
    pub(super) fn size(&self) -> [f64; 2] {
        [0, 1].map(|k| self.high[k] - self.low[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_holds_all_points_and_no_more() {
        let around = |points: &[[f64; 2]]| {
            let mut extent = Extent::default();
            for x in points {
                extent.take_in(*x);
            }
            extent
        };
        let some = around(&[[1.0, -2.0], [f64::NAN, 5.0], [-3.0, 4.0]]);
        assert_eq!((some.low, some.high), ([-3.0, -2.0], [1.0, 5.0]));
        assert_eq!(some.size(), [4.0, 7.0]);
        let both = some.and(Extent::of([0.0, 9.0]));
        assert_eq!((both.low, both.high), ([-3.0, -2.0], [1.0, 9.0]));
        assert_eq!(around(&[]).and(some), some);
        assert_eq!(some.and(around(&[])), some);
    }
}
