//! A strain rate that is imposed, and the strain it has made so far.

use serde::{Deserialize, Serialize};

/// Components [[11, 12], [21, 22]], compression positive: the first index belongs to the velocity.
pub type Tensor = [[f64; 2]; 2];

/// Nothing in any component.
pub const NONE: Tensor = [[0.0; 2]; 2];

/// An imposed strain rate, approached linearly over a number of cycles, and its integral.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Straining {
    /// What was asked for, as far as it has been reached [1/s].
    rate: Tensor,
    /// What a servo adds [1/s].
    servo: Tensor,
    ramp: Option<Ramp>,
    /// Integral of the rate over time.
    strain: Tensor,
}

/// On the way from one value to another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Ramp {
    from: Tensor,
    to: Tensor,
    start: u64,
    over: u64,
}

impl Ramp {
    pub(super) fn new(from: Tensor, to: Tensor, start: u64, over: u64) -> Self {
        Self {
            from,
            to,
            start,
            over,
        }
    }

    /// The value at a cycle, and whether it stays: the first cycle after the start makes the N-th part
    /// of the way, the N-th arrives.
    pub(super) fn at(&self, cycle: u64) -> (Tensor, bool) {
        let done = cycle.saturating_sub(self.start);
        if done >= self.over {
            return (self.to, true);
        }
        let share = done as f64 / self.over as f64;
        let between = |a: f64, b: f64| a + share * (b - a);
        let row = |k: usize| {
            [
                between(self.from[k][0], self.to[k][0]),
                between(self.from[k][1], self.to[k][1]),
            ]
        };
        ([row(0), row(1)], false)
    }

    pub(super) fn target(&self) -> Tensor {
        self.to
    }
}

impl Straining {
    /// Imposes a rate [1/s], reached over so many cycles; 0: at once.
    pub fn set(&mut self, rate: Tensor, cycle: u64, over: u64) {
        self.ramp = None;
        if over == 0 {
            self.rate = rate;
        } else {
            self.ramp = Some(Ramp::new(self.rate, rate, cycle, over));
        }
    }

    /// What a servo adds from now on [1/s].
    pub fn steer(&mut self, servo: Tensor) {
        self.servo = servo;
    }

    /// The rate that was asked for goes on as far as it was reached; strain counts from zero.
    pub(in crate::engine) fn restart(&mut self) {
        *self = Self {
            rate: self.rate,
            ..Self::default()
        };
    }

    /// Rate that was asked for, at the end of its ramp [1/s].
    pub fn target(&self) -> Tensor {
        self.ramp.as_ref().map_or(self.rate, Ramp::target)
    }

    /// Rate of the last step, the servo's share included [1/s].
    pub fn rate(&self) -> Tensor {
        plus(self.rate, self.servo, 1.0)
    }

    /// Strain imposed so far.
    pub fn strain(&self) -> Tensor {
        self.strain
    }

    /// Whether nothing is imposed, now and in the next step.
    pub fn is_still(&self) -> bool {
        self.ramp.is_none() && self.rate() == NONE
    }

    /// Takes the step of `dt` [s] that follows `cycle`.
    pub(super) fn advance(&mut self, cycle: u64, dt: f64) {
        if let Some(ramp) = &self.ramp {
            let (rate, arrived) = ramp.at(cycle + 1);
            self.rate = rate;
            if arrived {
                self.ramp = None;
            }
        }
        self.strain = plus(self.strain, self.rate(), dt);
    }
}

/// a + share b.
pub(super) fn plus(a: Tensor, b: Tensor, share: f64) -> Tensor {
    let row = |k: usize| [a[k][0] + share * b[k][0], a[k][1] + share * b[k][1]];
    [row(0), row(1)]
}

/// Velocity that a strain rate gives to what is at `d` from the point at rest [m/s].
#[inline(always)]
pub fn velocity(rate: &Tensor, d: [f64; 2]) -> [f64; 2] {
    [
        -(rate[0][0] * d[0] + rate[0][1] * d[1]),
        -(rate[1][0] * d[0] + rate[1][1] * d[1]),
    ]
}

/// No direction is strained faster than this [1/s].
pub(in crate::engine) fn size(rate: &Tensor) -> f64 {
    rate.iter()
        .flatten()
        .fold(0.0, |sum: f64, x| sum + x * x)
        .sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ramp_reaches_its_end_in_as_many_cycles_as_asked() {
        let mut straining = Straining::default();
        let rate = [[4.0, 0.0], [0.0, -2.0]];
        straining.set(rate, 10, 4);
        let mut seen = Vec::new();
        for cycle in 10..16 {
            straining.advance(cycle, 0.5);
            seen.push(straining.rate()[0][0]);
        }
        assert_eq!(seen, [1.0, 2.0, 3.0, 4.0, 4.0, 4.0]);
        assert_eq!(straining.strain(), [[9.0, 0.0], [0.0, -4.5]]);
    }

    #[test]
    fn a_positive_rate_compresses() {
        let rate = [[1.0, 0.0], [0.0, 0.0]];
        assert_eq!(velocity(&rate, [2.0, 3.0]), [-2.0, -0.0]);
    }
}
