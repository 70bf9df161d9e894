//! Time step and its limits.

use super::card::Row;
use super::read::{Read, world};

pub(super) const ROWS: &[Row<Read>] = &[
    world("dt", "s", "time step", |s| s.world().dt()).usual(),
    world(
        "fracc",
        "-",
        "largest FRACC of any particle since the last row",
        |s| s.world().fracc_monitor().largest.unwrap_or(f64::NAN),
    )
    .usual(),
    world(
        "frac_limit",
        "-",
        "largest stable FRAC by the stiffness bound of the present contacts",
        |s| s.world().frac_limit(),
    )
    .usual(),
];
