//! Force of the particles on a wall.

use crate::engine::World;
use crate::engine::neighbours::Slot;

/// Force on one wall at a cycle boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WallForce {
    /// Force of the particles on the wall, global axes [N].
    pub force: [f64; 2],
    /// Its moment about the wall's turning point, counter-clockwise [N m].
    pub moment: f64,
    /// Distance of the normal force from mid-length, along the wall, over half its length; NaN for
    /// a wall without end or without normal force.
    pub eccentricity: f64,
}

impl WallForce {
    /// Force on wall w.
    pub fn of(world: &World, w: usize) -> Self {
        let wall = &world.walls()[w];
        let list = world.contacts();
        let (mut force, mut moment) = ([0.0; 2], 0.0);
        let (mut normal, mut first_moment) = (0.0, 0.0);
        let middle = 0.5 * (wall.h1 + wall.h2);
        for (k, pair) in list.walls.iter().enumerate() {
            if pair.wall as usize != w {
                continue;
            }
            let Slot([fx, fy, _, rolling]) = list.slots[list.pairs.len() + k];
            let at = list.touches[k].at;
            force[0] -= fx;
            force[1] -= fy;
            moment -= (at[0] - wall.about[0]) * fy - (at[1] - wall.about[1]) * fx - rolling;
            let along = (at[0] - wall.point[0]) * wall.direction[0]
                + (at[1] - wall.point[1]) * wall.direction[1];
            let share = fx * wall.direction[1] - fy * wall.direction[0];
            normal += share;
            first_moment += share * (along - middle);
        }
        let half = 0.5 * (wall.h2 - wall.h1);
        let eccentricity = first_moment / normal / half;
        let eccentricity = if eccentricity.is_finite() && half.is_finite() {
            eccentricity
        } else {
            f64::NAN
        };
        Self {
            force,
            moment,
            eccentricity,
        }
    }
}
