//! A servo that moves a wall until the particles press on it as wanted.

use serde::{Deserialize, Serialize};

use super::{EVERY, Target};
use crate::engine::World;
use crate::engine::wall::Wall;
use crate::measure::wall_force::WallForce;

/// Time constant with gain 1, in times 2 π √(m/k) of a mean particle at the wall.
const PERIODS: f64 = 20.0;

/// Largest inertial number that a wall may cause in the particles along it.
const INERTIAL: f64 = 1e-3;

/// What a wall is steered to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum WallGoal {
    /// The normal force of the particles on it [N]; it moves along its normal.
    Normal(Target),
    /// A force applied to it [N]: it moves until the particles hold it.
    Force([f64; 2]),
}

/// A servo on one wall.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WallServo {
    /// Name of the wall.
    pub wall: String,
    /// What it is steered to.
    pub goal: WallGoal,
    /// 1: as fast as is safe for most assemblies.
    pub gain: f64,
}

impl WallServo {
    /// False when the wall is gone.
    pub(super) fn steer(&mut self, world: &mut World) -> bool {
        let found = world.walls().iter().position(|wall| wall.name == self.wall);
        let Some(w) = found else { return false };
        let wall = &world.walls()[w];
        let pressed = WallForce::of(world, w).force;
        let normal = away(world, w);
        let along = |v: [f64; 2]| v[0] * normal[0] + v[1] * normal[1];
        // What pushes the wall, and where to.
        let (push, scale) = match &self.goal {
            WallGoal::Normal(target) => {
                let wanted = target.at(world.cycle_number());
                let missing = along(pressed) - wanted;
                (normal.map(|n| n * missing), wanted.abs())
            }
            WallGoal::Force(applied) => (
                [pressed[0] + applied[0], pressed[1] + applied[1]],
                (applied[0] * applied[0] + applied[1] * applied[1]).sqrt(),
            ),
        };
        let (stiffness, mass) = answer(world, w);
        let dt = world.dt();
        let time = if stiffness > 0.0 {
            std::f64::consts::TAU * PERIODS * (mass / stiffness).sqrt() / self.gain
        } else {
            0.0
        };
        let time = time.max(2.0 * EVERY as f64 * dt);
        let fastest = Some(fastest(world, wall, scale));
        // Without particles there is nothing to move to.
        let fastest = fastest.filter(|v| v.is_finite()).unwrap_or(0.0);
        let limit = |v: f64| v.clamp(-fastest, fastest);
        let velocity = if stiffness > 0.0 {
            push.map(|push| limit(push / (stiffness * time)))
        } else {
            let size = (push[0] * push[0] + push[1] * push[1]).sqrt();
            let share = if size > 0.0 { fastest / size } else { 0.0 };
            push.map(|push| push * share)
        };
        world.set_wall_velocity(w, velocity);
        true
    }
}

/// Unit normal of the wall, from the particles near it to it; of all particles if none is near.
fn away(world: &World, w: usize) -> [f64; 2] {
    let wall = &world.walls()[w];
    let [e1, e2] = wall.direction;
    let rows = &world.particles().row;
    let height = |x: [f64; 2]| (x[1] - wall.point[1]) * e1 - (x[0] - wall.point[0]) * e2;
    let near = world.contacts().walls.iter();
    let near = near.filter(|pair| pair.wall as usize == w);
    let mut sum: f64 = near
        .map(|pair| height(rows[pair.particle as usize].x))
        .sum();
    if sum == 0.0 {
        sum = rows.iter().map(|row| height(row.x)).sum();
    }
    if sum >= 0.0 { [e2, -e1] } else { [-e2, e1] }
}

/// Normal stiffness of the contacts at a wall [N/m], and the mean mass of a particle [kg].
fn answer(world: &World, w: usize) -> (f64, f64) {
    let list = world.contacts();
    let first = list.pairs.len();
    let at_wall = list.walls.iter().enumerate();
    let stiffness = at_wall
        .filter(|(_, pair)| pair.wall as usize == w)
        .map(|(k, _)| first + k)
        .filter(|&k| world.geometry(k).overlap > 0.0)
        .map(|k| world.pass().stiffness(k, world.geometry(k).overlap).k[0])
        .sum();
    let masses = &world.particles().mass;
    (stiffness, masses.iter().sum::<f64>() / masses.len() as f64)
}

/// Largest speed of a wall under such a force [m/s].
fn fastest(world: &World, wall: &Wall, force: f64) -> f64 {
    let particles = world.particles();
    let count = particles.len() as f64;
    let [low, high] = particles.extent();
    let span = (high[0] - low[0]).max(high[1] - low[1]);
    let radius = particles.row.iter().map(|row| row.radius).sum::<f64>() / count;
    let size = span + 2.0 * radius;
    let length = (wall.h2 - wall.h1).min(size);
    let area = std::f64::consts::PI * radius * radius * world.thickness();
    let density = particles.mass.iter().sum::<f64>() / (count * area);
    let stress = force / (length * world.thickness());
    INERTIAL * size / (2.0 * radius) * (stress / density).sqrt()
}
