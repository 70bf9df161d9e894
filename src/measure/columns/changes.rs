//! What has changed since the reference.

use super::card::Row;
use super::read::{Read, regional};
use crate::measure::changes::Changes;
use crate::measure::regional::Regional;

fn changes(region: &Regional<'_>, read: impl Fn(&Changes) -> f64) -> f64 {
    region.changes().map_or(f64::NAN, read)
}

pub(super) const ROWS: &[Row<Read>] = &[
    regional(
        "contacts_broken",
        "-",
        "contacts of the reference that are broken",
        |r| changes(r, |c| c.broken),
    ),
    regional(
        "contacts_new",
        "-",
        "contacts that the reference did not have",
        |r| changes(r, |c| c.made),
    ),
    regional(
        "broken_fraction",
        "-",
        "broken contacts / contacts of the reference",
        |r| changes(r, Changes::broken_fraction),
    ),
    regional(
        "mean_rotation",
        "rad",
        "mean size of the rotation since the reference",
        |r| changes(r, |c| c.rotation),
    ),
    regional(
        "max_rotation",
        "rad",
        "largest size of the rotation since the reference",
        |r| changes(r, |c| c.rotation_max),
    ),
    regional(
        "mean_slid",
        "m",
        "mean way that touching contacts slid since the reference or first touch",
        |r| changes(r, |c| c.slid),
    )
    .booked(),
    regional(
        "max_slid",
        "m",
        "longest way that a touching contact slid since the reference or first touch",
        |r| changes(r, |c| c.slid_max),
    )
    .booked(),
];
