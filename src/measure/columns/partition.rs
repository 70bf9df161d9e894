//! Where stress comes from (Cundall & Strack 1983).

use super::card::Row;
use super::read::{Read, regional};

pub(super) const ROWS: &[Row<Read>] = &[regional(
    "sin_phi_shear",
    "-",
    "part of sin_phi that tangential forces carry",
    |r| r.stress().sin_phi_shear(),
)
.usual()];
