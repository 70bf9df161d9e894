//! Radii that change over a number of cycles.

use serde::{Deserialize, Serialize};

use super::Target;
use crate::engine::World;

/// All radii on their way to a multiple of what they were.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    factor: Target,
    /// What the radii are multiplied by so far.
    done: f64,
}

impl Growth {
    /// From the radii of this cycle to `factor` times as large in so many cycles; 0: at once.
    pub fn new(factor: f64, cycle: u64, over: u64) -> Self {
        Self {
            factor: Target::new(1.0, factor, cycle, over),
            done: 1.0,
        }
    }

    /// The share that is due for the step after this cycle. False when nothing is left to do.
    pub(super) fn steer(&mut self, world: &mut World) -> bool {
        let factor = self.factor.at(world.cycle_number() + 1);
        // Exact comparison: both come from the same sum.
        if factor != self.done {
            world.scale_radii(factor / self.done);
            self.done = factor;
        }
        factor != self.factor.end()
    }
}
