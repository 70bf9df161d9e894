//! Columns of one wall, written `wall:NAME:f1`.

use super::card::Row;
use crate::measure::wall_force::WallForce;

/// How a column of a wall is read.
pub type ReadWall = fn(&WallForce) -> f64;

/// All of them.
pub const WALL: &[Row<ReadWall>] = &[
    Row::new(
        "f1",
        "N",
        "force of the particles on the wall, direction 1",
        |on| on.force[0],
    ),
    Row::new(
        "f2",
        "N",
        "force of the particles on the wall, direction 2",
        |on| on.force[1],
    ),
    Row::new(
        "moment",
        "N m",
        "moment of that force about the wall's turning point",
        |on| on.moment,
    ),
    Row::new(
        "eccentricity",
        "-",
        "distance of the normal force from mid-length / half length",
        |on| on.eccentricity,
    ),
];
