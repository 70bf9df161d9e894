//! What tells two runs apart.

use super::card::Row;
use super::read::{Read, world};

pub(super) const ROWS: &[Row<Read>] = &[world(
    "state_hash",
    "-",
    "hash of positions, velocities and contact memory",
    |s| f64::from_bits(s.hash()),
)
.hashed()];
