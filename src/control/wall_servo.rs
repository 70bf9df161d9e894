//! A servo that moves a wall until the particles press on it as wanted.
//!
//! Its velocity is in proportion to what is missing, and to its integral: a wall that has to keep moving,
//! in a biaxial test for instance, would otherwise miss its force by that velocity times k T for ever.
//! The proportional part is that of a dashpot, and both together still take energy from whatever swings
//! against the wall, for any time constant of the integral. The delay of the looks gives back some of it
//! at the highest frequencies: dashpots of half a per cent of critical take more, and an assembly without
//! any swings up, which no T above the least one prevents.
//!
//! The integral takes what is missing beyond what the proportional part is on the way to make good: that
//! dies out with the time constant of the force. A step of the goal is thus not overshot, as it would be
//! by 1/e² of its height, and a wall that travels towards what it shall meet learns nothing on the way.

use serde::{Deserialize, Serialize};

use super::{EVERY, Target};
use crate::engine::World;
use crate::engine::particles::Row;
use crate::engine::wall::Wall;
use crate::measure::wall_force::WallForce;

/// Time constant T with gain 1, in times 2 π √(M/K) of the particles that touch the wall, of mass M. The
/// wall is then a dashpot K T of 2 √2 π = 9 times the impedance n √(k m) of a lattice of such particles:
/// they are moved slowly, and waves are swallowed.
const PERIODS: f64 = 1.0;

/// Least time constant, in looks: a servo cannot be faster than it looks.
const LOOKS: f64 = 2.0;

/// Time constant of the integral, in those that the force has without it: what disturbs it dies out as
/// t exp(-t/2A), critically damped, if the assembly is as stiff as its layers in series; a softer one swings
/// with a damping ratio of the root of its share in that.
const INTEGRAL: f64 = 4.0;

/// Stiffness of a contact with a rigid wall over that between two equal particles: of the linear law
/// 2 k, of Hertz, as E*^(2/3) R*^(1/3), twice too.
const RIGID: f64 = 2.0;

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
    /// What has been missing so far, as a velocity [m/s].
    missed: [f64; 2],
    /// What may still be missing after a step of the goal, along the directions it moves in [N]; `None`
    /// before the first look.
    awaited: Option<[f64; 2]>,
}

impl WallServo {
    /// Ready to steer.
    pub fn new(wall: &str, goal: WallGoal, gain: f64) -> Self {
        Self {
            wall: wall.to_owned(),
            goal,
            gain,
            missed: [0.0; 2],
            awaited: None,
        }
    }

    /// The gain above which a servo on a wall is no faster; `None` while nothing touches the wall.
    pub fn highest_gain(world: &World, w: usize) -> Option<f64> {
        let touching = Touching::of(world, w);
        (touching.stiffness > 0.0).then(|| touching.time(&Grains::of(world)) / shortest(world))
    }

    /// False when the wall is gone.
    pub(super) fn steer(&mut self, world: &mut World) -> bool {
        let found = world.walls().iter().position(|wall| wall.name == self.wall);
        let Some(w) = found else { return false };
        let wall = &world.walls()[w];
        let pressed = WallForce::of(world, w).force;
        let normal = away(world, w);
        // The directions it moves in, and the force along them that the particles shall hold.
        let (frame, applied) = match &self.goal {
            WallGoal::Normal(target) => {
                let wanted = target.at(world.cycle_number());
                ([normal, [-normal[1], normal[0]]], [-wanted, 0.0])
            }
            WallGoal::Force(applied) => ([[1.0, 0.0], [0.0, 1.0]], *applied),
        };
        let mut push = [0, 1].map(|k| dot(pressed, frame[k]) + applied[k]);
        let slides = matches!(self.goal, WallGoal::Force(_));
        if !slides {
            push[1] = 0.0;
        }
        let scale = dot(applied, applied).sqrt();
        let grains = Grains::of(world);
        let fastest = Some(grains.fastest(world, wall, scale));
        // Without particles there is nothing to move to.
        let fastest = fastest.filter(|v| v.is_finite()).unwrap_or(0.0);
        let touching = Touching::of(world, w);
        let velocity = if touching.stiffness > 0.0 {
            let time = (touching.time(&grains) / self.gain).max(shortest(world));
            // Layers in series answer that much later than the contacts at the wall.
            let answer = RIGID * grains.layers(normal) * time;
            let interval = EVERY as f64 * world.dt();
            let limit = |v: f64| v.clamp(-fastest, fastest);
            let mut missed = frame.map(|e| dot(self.missed, e));
            if !slides {
                missed[1] = 0.0;
            }
            let mut awaited = self.awaited.unwrap_or(push);
            let mut velocity = [0.0; 2];
            for k in 0..2 {
                let velocity_for = |force: f64| force / (touching.stiffness * time);
                let proportional = velocity_for(push[k]);
                // On its way: as fast as it may be, or with less than half of the force to hold.
                let travels = proportional.abs() >= fastest
                    || push[k] * applied[k] > 0.5 * applied[k] * applied[k];
                if travels {
                    awaited[k] = push[k];
                    // What held it back before does not any more.
                    if missed[k] * push[k] < 0.0 {
                        missed[k] = 0.0;
                    }
                } else {
                    let beyond = velocity_for(push[k] - awaited[k]);
                    missed[k] += beyond * interval / (INTEGRAL * answer);
                    awaited[k] *= 1.0 - interval / answer;
                }
                missed[k] = limit(missed[k]);
                velocity[k] = limit(proportional + missed[k]);
            }
            self.awaited = Some(awaited);
            self.missed = along(frame, missed);
            along(frame, velocity)
        } else {
            let size = dot(push, push).sqrt();
            let share = if size > 0.0 { fastest / size } else { 0.0 };
            self.awaited = None;
            along(frame, push.map(|push| push * share))
        };
        world.set_wall_velocity(w, velocity);
        true
    }
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The vector with these components along the axes of a frame.
fn along(frame: [[f64; 2]; 2], v: [f64; 2]) -> [f64; 2] {
    [0, 1].map(|k| v[0] * frame[0][k] + v[1] * frame[1][k])
}

/// Least time constant [s].
fn shortest(world: &World) -> f64 {
    LOOKS * EVERY as f64 * world.dt()
}

/// Unit normal of the wall, from the particles that touch it to it; from the nearest if none does. Whoever
/// is listed beside depends on the halo, which decides nothing.
fn away(world: &World, w: usize) -> [f64; 2] {
    let wall = &world.walls()[w];
    let [e1, e2] = wall.direction;
    let rows = &world.particles().row;
    let height = |x: [f64; 2]| (x[1] - wall.point[1]) * e1 - (x[0] - wall.point[0]) * e2;
    let list = world.contacts();
    let first = list.pairs.len();
    let at_wall = list.walls.iter().enumerate();
    let touching = at_wall
        .filter(|(k, pair)| pair.wall as usize == w && world.geometry(first + k).overlap > 0.0);
    let mut sum: f64 = touching
        .map(|(_, pair)| height(rows[pair.particle as usize].x))
        .sum();
    if sum == 0.0 {
        let gap = |row: &Row| {
            let d = [row.x[0] - wall.point[0], row.x[1] - wall.point[1]];
            let along = (d[0] * e1 + d[1] * e2).max(wall.h1).min(wall.h2);
            let d = [d[0] - along * e1, d[1] - along * e2];
            (d[0] * d[0] + d[1] * d[1]).sqrt() - row.radius
        };
        let nearest = rows.iter().min_by(|a, b| gap(a).total_cmp(&gap(b)));
        sum = nearest.map_or(0.0, |row| height(row.x));
    }
    if sum >= 0.0 { [e2, -e1] } else { [-e2, e1] }
}

/// What touches a wall.
struct Touching {
    /// Normal stiffness of all these contacts [N/m].
    stiffness: f64,
    /// How many they are.
    count: f64,
}

impl Touching {
    fn of(world: &World, w: usize) -> Self {
        let list = world.contacts();
        let first = list.pairs.len();
        let (mut stiffness, mut count) = (0.0, 0.0);
        let at_wall = list.walls.iter().enumerate();
        for (k, _) in at_wall.filter(|(_, pair)| pair.wall as usize == w) {
            let overlap = world.geometry(first + k).overlap;
            if overlap > 0.0 {
                stiffness += world.pass().stiffness(first + k, overlap).k[0];
                count += 1.0;
            }
        }
        Self { stiffness, count }
    }

    /// Time constant with gain 1 [s].
    fn time(&self, grains: &Grains) -> f64 {
        std::f64::consts::TAU * PERIODS * (self.count * grains.mass / self.stiffness).sqrt()
    }
}

/// What a wall pushes on.
struct Grains {
    /// Mean mass [kg].
    mass: f64,
    /// Mean radius [m].
    radius: f64,
    /// Extent of all of them along the axes [m].
    size: [f64; 2],
}

impl Grains {
    fn of(world: &World) -> Self {
        let particles = world.particles();
        let count = particles.len() as f64;
        let [low, high] = particles.extent();
        let radius = particles.row.iter().map(|row| row.radius).sum::<f64>() / count;
        Self {
            mass: particles.mass.iter().sum::<f64>() / count,
            radius,
            size: [0, 1].map(|k| high[k] - low[k] + 2.0 * radius),
        }
    }

    /// How many of them lie behind each other along a direction. Too many is safe: the integral is slower.
    fn layers(&self, e: [f64; 2]) -> f64 {
        let [width, height] = self.size;
        (e[0].abs() * width + e[1].abs() * height) / (2.0 * self.radius)
    }

    /// Largest speed of a wall under such a force [m/s].
    fn fastest(&self, world: &World, wall: &Wall, force: f64) -> f64 {
        let size = self.size[0].max(self.size[1]);
        let length = (wall.h2 - wall.h1).min(size);
        let area = std::f64::consts::PI * self.radius * self.radius * world.thickness();
        let density = self.mass / area;
        let stress = force / (length * world.thickness());
        INERTIAL * size / (2.0 * self.radius) * (stress / density).sqrt()
    }
}
