//! How much of the room is taken.

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[regional(
    "porosity",
    "-",
    "1 - area of discs / area of the region",
    |r| r.content().porosity(),
)
.usual()];
