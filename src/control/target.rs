//! A value to hold, or to reach linearly over a number of cycles.

use serde::{Deserialize, Serialize};

/// What a servo aims at.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Target {
    from: f64,
    to: f64,
    start: u64,
    over: u64,
}

impl Target {
    /// From what is there at cycle `start` to a value in so many cycles; 0: at once.
    pub fn new(from: f64, to: f64, start: u64, over: u64) -> Self {
        Self {
            from,
            to,
            start,
            over,
        }
    }

    /// The value at a cycle.
    pub fn at(&self, cycle: u64) -> f64 {
        let done = cycle.saturating_sub(self.start);
        if done >= self.over {
            return self.to;
        }
        self.from + (self.to - self.from) * (done as f64 / self.over as f64)
    }

    /// The value it ends at.
    pub fn end(&self) -> f64 {
        self.to
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_target_is_reached_linearly() {
        let target = Target::new(1.0, 3.0, 10, 4);
        let seen: Vec<f64> = (8..16).map(|cycle| target.at(cycle)).collect();
        assert_eq!(seen, [1.0, 1.0, 1.0, 1.5, 2.0, 2.5, 3.0, 3.0]);
        assert_eq!(Target::new(1.0, 3.0, 10, 0).at(10), 3.0);
    }
}
