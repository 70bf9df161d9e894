//! How fast an assembly flows, and what its particles do besides.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[
    regional(
        "inertial_number",
        "-",
        "strain rate times mean diameter x sqrt(density / mean stress)",
        |r| r.flow().inertial_number(r.stress().isotropic()),
    ),
    regional(
        "granular_temperature",
        "m^2/s^2",
        "mean square of the velocity beside the common flow / 2",
        |r| r.flow().temperature,
    ),
];
