//! Contacts and forces as waves over directions.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional("fourier_a", "-", "wave of contacts over directions", |r| {
        r.fourier().contacts.amplitude()
    }),
    regional(
        "fourier_a_angle",
        "deg",
        "direction of most contacts, 0 to 180",
        |r| r.fourier().contacts.angle(),
    ),
    regional(
        "fourier_b",
        "-",
        "wave of contacts over directions, of fourth order",
        |r| r.fourier().fourfold.amplitude(),
    ),
    regional(
        "fourier_b_angle",
        "deg",
        "direction of the wave b, 0 to 90",
        |r| r.fourier().fourfold.angle(),
    ),
    regional(
        "fourier_a_n",
        "-",
        "wave of normal force over directions",
        |r| r.fourier().normal.amplitude(),
    ),
    regional(
        "fourier_a_n_angle",
        "deg",
        "direction of the largest normal forces, 0 to 180",
        |r| r.fourier().normal.angle(),
    ),
    regional(
        "fourier_a_t",
        "-",
        "wave of tangential force over directions",
        |r| r.fourier().tangential.amplitude(),
    ),
    regional(
        "fourier_a_t_angle",
        "deg",
        "direction of the stress by tangential forces, 0 to 180",
        |r| r.fourier().tangential.angle(),
    ),
    regional(
        "sin_phi_fourier",
        "-",
        "sin_phi that the waves of second order explain",
        |r| r.fourier().sin_phi(),
    ),
];
