//! What steers boundaries by what is measured: servos that hold or follow a stress, or the force on a
//! wall; and radii that change over a number of cycles.
//!
//! Control reads measures and gives the engine strain rates and wall velocities; it holds no world.
//! Servos act at cycles that are multiples of [`EVERY`], before the cycle; radii change before every
//! cycle. So a run does the same however it is cut into batches or resumed.

mod growth;
mod pace;
mod servo;
mod target;
mod wall_servo;

use serde::{Deserialize, Serialize};

pub use growth::Growth;
pub use servo::{Component, Servo};
pub use target::Target;
pub use wall_servo::{WallGoal, WallServo};

use crate::engine::World;
use crate::measure::region::{Region, Shape};

/// Cycles between two looks of a servo.
pub const EVERY: u64 = 10;

/// Everything that steers a world.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Control {
    /// What the boundary is steered to.
    pub servo: Option<Servo>,
    /// What walls are steered to.
    pub walls: Vec<WallServo>,
    /// How the radii change.
    pub growth: Option<Growth>,
}

impl Control {
    /// Steers, if it is time to. Stress is measured over the first region, or over everything.
    pub fn steer(&mut self, world: &mut World, regions: &[Region]) {
        if let Some(growth) = &mut self.growth
            && !growth.steer(world)
        {
            self.growth = None;
        }
        let idle = self.servo.is_none() && self.walls.is_empty();
        if idle || !world.cycle_number().is_multiple_of(EVERY) {
            return;
        }
        world.settle();
        if let Some(servo) = &mut self.servo {
            let shape = regions.first().map_or(Shape::All, |region| region.shape);
            servo.steer(world, shape);
        }
        self.walls.retain_mut(|servo| servo.steer(world));
    }

    /// Ends the servo of the boundary, and what it added to the strain rate.
    pub fn release(&mut self, world: &mut World) {
        if self.servo.take().is_some() {
            world.steer_boundary([[0.0; 2]; 2]);
        }
    }

    /// Ends the servo of a wall. Whether it had one.
    pub fn release_wall(&mut self, name: &str) -> bool {
        let before = self.walls.len();
        self.walls.retain(|servo| servo.wall != name);
        self.walls.len() < before
    }
}
