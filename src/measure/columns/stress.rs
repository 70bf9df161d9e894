//! Stress, compression positive.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional("stress_11", "Pa", "stress, compression positive", |r| {
        r.stress().total[(0, 0)]
    })
    .usual(),
    regional(
        "stress_12",
        "Pa",
        "stress: branches along 1, forces along 2",
        |r| r.stress().total[(0, 1)],
    )
    .usual(),
    regional(
        "stress_21",
        "Pa",
        "stress: branches along 2, forces along 1",
        |r| r.stress().total[(1, 0)],
    )
    .usual(),
    regional("stress_22", "Pa", "stress, compression positive", |r| {
        r.stress().total[(1, 1)]
    })
    .usual(),
    regional("stress_1", "Pa", "major principal stress", |r| {
        r.stress().principal().major
    }),
    regional("stress_2", "Pa", "minor principal stress", |r| {
        r.stress().principal().minor
    }),
    regional(
        "stress_angle",
        "deg",
        "direction of the major principal stress, 0 to 180",
        |r| r.stress().principal().angle,
    ),
    regional("isotropic_stress", "Pa", "mean principal stress", |r| {
        r.stress().isotropic()
    })
    .usual(),
    regional(
        "deviator_stress",
        "Pa",
        "major - minor principal stress",
        |r| r.stress().deviator(),
    )
    .usual(),
    regional(
        "sin_phi",
        "-",
        "mobilised friction (s1 - s2)/(s1 + s2)",
        |r| r.stress().sin_phi(),
    )
    .usual(),
];
