//! Columns of one particle, written `particle:I:x`.

use super::card::Row;
use crate::engine::World;

/// How a column of a particle is read, from its index.
pub type ReadParticle = fn(&World, usize) -> f64;

/// All of them.
pub const PARTICLE: &[Row<ReadParticle>] = &[
    Row::new("x", "m", "position, direction 1", |world, p| {
        world.position(p)[0]
    }),
    Row::new("y", "m", "position, direction 2", |world, p| {
        world.position(p)[1]
    }),
    Row::new("angle", "rad", "rotation, counter-clockwise", |world, p| {
        world.particles().row[p].angle
    }),
    Row::new("vx", "m/s", "velocity, direction 1", |world, p| {
        world.velocity(p).0[0]
    }),
    Row::new("vy", "m/s", "velocity, direction 2", |world, p| {
        world.velocity(p).0[1]
    }),
    Row::new(
        "spin",
        "rad/s",
        "angular velocity, counter-clockwise",
        |world, p| world.velocity(p).1,
    ),
];
