//! Which way contacts point, to second order.

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
    regional(
        "fabric_trace",
        "1/m^2",
        "contacts times mean diameter / volume",
        |r| r.fabric().trace(r.world(), r.content()),
    ),
    regional("fabric_11", "-", "mean of n1 n1", |r| {
        r.fabric().plain[(0, 0)]
    }),
    regional("fabric_12", "-", "mean of n1 n2", |r| {
        r.fabric().plain[(0, 1)]
    }),
    regional("fabric_22", "-", "mean of n2 n2", |r| {
        r.fabric().plain[(1, 1)]
    }),
    regional(
        "fabric_n_11",
        "-",
        "mean of n1 n1 weighted by normal force",
        |r| r.fabric().weighted[(0, 0)],
    ),
    regional(
        "fabric_n_12",
        "-",
        "mean of n1 n2 weighted by normal force",
        |r| r.fabric().weighted[(0, 1)],
    ),
    regional(
        "fabric_n_22",
        "-",
        "mean of n2 n2 weighted by normal force",
        |r| r.fabric().weighted[(1, 1)],
    ),
    regional(
        "fabric_t_11",
        "-",
        "mean of n1 n1 weighted by the size of the tangential force",
        |r| r.fabric().by_tangential[(0, 0)],
    ),
    regional(
        "fabric_t_12",
        "-",
        "mean of n1 n2 weighted by the size of the tangential force",
        |r| r.fabric().by_tangential[(0, 1)],
    ),
    regional(
        "fabric_t_22",
        "-",
        "mean of n2 n2 weighted by the size of the tangential force",
        |r| r.fabric().by_tangential[(1, 1)],
    ),
];
