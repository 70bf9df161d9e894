//! Straight walls: a stretch of a line that moves and turns as it is told.
//!
//! Cundall & Strack 1979, fig. 4: a point, a direction and two scalars give the end points.

use serde::{Deserialize, Serialize};

use super::setup::WallSetup;
use super::wall_contact::distance;

/// A wall and where it stands. Positions are relative to the origin of the world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Wall {
    /// Name in the preset.
    pub name: String,
    /// Index of the material.
    pub material: usize,
    /// Point the wall turns about [m].
    pub about: [f64; 2],
    /// Angle turned so far [rad].
    pub angle: f64,
    /// From `about` to the point P, at angle 0 [m].
    arm: [f64; 2],
    /// Direction at angle 0.
    heading: [f64; 2],
    /// The wall begins at P + h1 e [m].
    pub h1: f64,
    /// The wall ends at P + h2 e [m].
    pub h2: f64,
    /// Velocity of `about` [m/s].
    pub velocity: [f64; 2],
    /// Angular velocity [rad/s].
    pub spin: f64,
    /// Point P now [m].
    pub point: [f64; 2],
    /// Direction now.
    pub direction: [f64; 2],
    /// Where an end of this one stands on another wall.
    pub(super) joints: Vec<Joint>,
}

/// An end of a wall that stands on another wall.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Joint {
    /// Which end.
    pub(super) own: usize,
    /// Index of the other wall.
    pub(super) other: usize,
    /// Its end that is met; `None`: its face.
    pub(super) end: Option<usize>,
}

impl Joint {
    /// Whether it still holds, to within `reach` [m]: walls move.
    pub(super) fn holds(self, walls: &[Wall], corner: [f64; 2], reach: f64) -> bool {
        let other = &walls[self.other];
        match self.end {
            Some(end) => near(corner, other.end(end), reach),
            None => distance(other, corner) <= reach,
        }
    }
}

impl Wall {
    /// From the setup.
    pub fn new(w: &WallSetup, origin: [f64; 2]) -> Self {
        Self {
            name: w.name.clone(),
            material: w.material,
            about: [w.about[0] - origin[0], w.about[1] - origin[1]],
            angle: 0.0,
            arm: [w.point[0] - w.about[0], w.point[1] - w.about[1]],
            heading: w.direction,
            h1: w.h1,
            h2: w.h2,
            velocity: w.velocity,
            spin: w.angular_velocity,
            point: [w.point[0] - origin[0], w.point[1] - origin[1]],
            direction: w.direction,
            joints: Vec::new(),
        }
    }

    /// End points: 0 at h1, 1 at h2 [m].
    pub fn end(&self, end: usize) -> [f64; 2] {
        let h = if end == 0 { self.h1 } else { self.h2 };
        [
            self.point[0] + h * self.direction[0],
            self.point[1] + h * self.direction[1],
        ]
    }

    /// The middle of the wall, or the point P of one without end [m].
    pub fn middle(&self) -> [f64; 2] {
        let h = 0.5 * (self.h1 + self.h2);
        let h = if h.is_finite() { h } else { 0.0 };
        [0, 1].map(|k| self.point[k] + h * self.direction[k])
    }

    /// Velocity of the point of the wall at x [m/s].
    pub fn velocity_at(&self, x: [f64; 2]) -> [f64; 2] {
        [
            self.velocity[0] - self.spin * (x[1] - self.about[1]),
            self.velocity[1] + self.spin * (x[0] - self.about[0]),
        ]
    }

    /// Whether it moves at all.
    pub fn is_moving(&self) -> bool {
        self.velocity != [0.0; 2] || self.spin != 0.0
    }

    /// Moves on by one step.
    pub fn advance(&mut self, dt: f64) {
        if !self.is_moving() {
            return;
        }
        self.about[0] += self.velocity[0] * dt;
        self.about[1] += self.velocity[1] * dt;
        let turn = |v: [f64; 2], c: f64, s: f64| [c * v[0] - s * v[1], s * v[0] + c * v[1]];
        let arm = if self.spin == 0.0 && self.angle == 0.0 {
            self.arm
        } else {
            self.angle += self.spin * dt;
            let (s, c) = libm::sincos(self.angle);
            self.direction = turn(self.heading, c, s);
            turn(self.arm, c, s)
        };
        self.point = [self.about[0] + arm[0], self.about[1] + arm[1]];
    }

    /// Finds the ends of walls that stand on others, to within `reach` [m]: first on their ends.
    pub fn join(walls: &mut [Self], reach: f64) {
        for w in 0..walls.len() {
            let mut joints = Vec::new();
            for own in 0..2 {
                let corner = walls[w].end(own);
                for other in (0..walls.len()).filter(|&other| other != w) {
                    let joint = |end| Joint { own, other, end };
                    let places = [joint(Some(0)), joint(Some(1)), joint(None)];
                    joints.extend(places.into_iter().find(|j| j.holds(walls, corner, reach)));
                }
            }
            walls[w].joints = joints;
        }
    }
}

/// Whether two points are within `reach` of each other; never for infinite ones.
pub(super) fn near(a: [f64; 2], b: [f64; 2], reach: f64) -> bool {
    let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
    dx * dx + dy * dy <= reach * reach
}
