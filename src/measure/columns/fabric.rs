//! Which way contacts point.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional(
        "anisotropy",
        "-",
        "difference of the principal values of the fabric tensor",
        |r| r.fabric().anisotropy(),
    )
    .usual(),
    regional(
        "anisotropy_angle",
        "deg",
        "major axis of the fabric tensor, 0 to 180",
        |r| r.fabric().principal().angle,
    )
    .usual(),
    regional(
        "anisotropy_weighted",
        "-",
        "anisotropy weighted by normal force",
        |r| r.fabric().anisotropy_weighted(),
    )
    .usual(),
];
