//! What contacts carry, and what is left unbalanced.

use super::card::Row;
use super::read::{Read, regional, whole};

pub(super) const ROWS: &[Row<Read>] = &[
    regional("mean_force", "N", "mean contact force", |r| {
        r.assembly().mean_force
    })
    .usual(),
    regional("max_force", "N", "largest contact force", |r| {
        r.assembly().max_force
    })
    .usual(),
    whole(
        "unbalanced",
        "-",
        "mean out-of-balance force / mean contact force",
        |r| r.assembly().unbalanced,
    )
    .usual(),
    whole(
        "unbalanced_max",
        "-",
        "largest out-of-balance force / largest contact force",
        |r| r.assembly().unbalanced_max,
    )
    .usual(),
];
