//! Columns of one wall, written `wall:NAME:f1`.

use super::card::Row;
use crate::engine::World;
use crate::measure::wall_force::WallForce;

/// How a column of a wall is read, from its index.
pub type ReadWall = fn(&World, usize) -> f64;

/// All of them. Walls move and turn as their turning point does.
pub const WALL: &[Row<ReadWall>] = &[
    Row::new(
        "f1",
        "N",
        "force of the particles on the wall, direction 1",
        |world, w| WallForce::of(world, w).force[0],
    ),
    Row::new(
        "f2",
        "N",
        "force of the particles on the wall, direction 2",
        |world, w| WallForce::of(world, w).force[1],
    ),
    Row::new(
        "moment",
        "N m",
        "moment of that force about the wall's turning point",
        |world, w| WallForce::of(world, w).moment,
    ),
    Row::new(
        "eccentricity",
        "-",
        "distance of the normal force from mid-length / half length",
        |world, w| WallForce::of(world, w).eccentricity,
    ),
    Row::new(
        "x",
        "m",
        "position of the wall's turning point, direction 1",
        |world, w| world.walls()[w].about[0] + world.origin()[0],
    ),
    Row::new(
        "y",
        "m",
        "position of the wall's turning point, direction 2",
        |world, w| world.walls()[w].about[1] + world.origin()[1],
    ),
    Row::new(
        "angle",
        "rad",
        "rotation since the wall was made, counter-clockwise",
        |world, w| world.walls()[w].angle,
    ),
    Row::new(
        "vx",
        "m/s",
        "velocity of the wall's turning point, direction 1",
        |world, w| world.walls()[w].velocity[0],
    ),
    Row::new(
        "vy",
        "m/s",
        "velocity of the wall's turning point, direction 2",
        |world, w| world.walls()[w].velocity[1],
    ),
    Row::new(
        "spin",
        "rad/s",
        "angular velocity of the wall, counter-clockwise",
        |world, w| world.walls()[w].spin,
    ),
];
