//! Columns of one particle, written `particle:I:x`, or their mean over several, `particle:I-J:x`.

use super::card::Row;
use crate::measure::sample::Sample;

/// How a column of a particle is read, from its index.
pub type ReadParticle = fn(&Sample<'_>, usize) -> f64;

/// Displacement and rotation since the reference; NaN for a particle that is newer.
fn change(sample: &Sample<'_>, p: usize) -> [f64; 3] {
    let world = sample.world();
    let reference = sample.reference();
    let change = reference.and_then(|then| then.change(world, world.particles().id[p]));
    change.map_or([f64::NAN; 3], |([x, y], turn)| [x, y, turn])
}

/// All of them.
pub const PARTICLE: &[Row<ReadParticle>] = &[
    Row::new("x", "m", "position, direction 1", |s, p| {
        s.world().position(p)[0]
    }),
    Row::new("y", "m", "position, direction 2", |s, p| {
        s.world().position(p)[1]
    }),
    Row::new("angle", "rad", "rotation, counter-clockwise", |s, p| {
        s.world().particles().row[p].angle
    }),
    Row::new("vx", "m/s", "velocity, direction 1", |s, p| {
        s.world().velocity(p).0[0]
    }),
    Row::new("vy", "m/s", "velocity, direction 2", |s, p| {
        s.world().velocity(p).0[1]
    }),
    Row::new("speed", "m/s", "magnitude of the velocity", |s, p| {
        let v = s.world().velocity(p).0;
        libm::hypot(v[0], v[1])
    }),
    Row::new(
        "spin",
        "rad/s",
        "angular velocity, counter-clockwise",
        |s, p| s.world().velocity(p).1,
    ),
    Row::new(
        "ux",
        "m",
        "displacement since the reference, direction 1",
        |s, p| change(s, p)[0],
    ),
    Row::new(
        "uy",
        "m",
        "displacement since the reference, direction 2",
        |s, p| change(s, p)[1],
    ),
    Row::new(
        "rotation",
        "rad",
        "rotation since the reference, counter-clockwise",
        |s, p| change(s, p)[2],
    ),
];
