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
    regional(
        "mean_obliquity",
        "-",
        "mean of |T|/(mu N): share of friction in use",
        |r| r.obliquity().mean(),
    ),
    regional(
        "mean_contact_stress",
        "Pa",
        "mean over contacts of the mean normal stress on each",
        |r| r.contact_stress()[0],
    ),
    regional(
        "max_contact_stress",
        "Pa",
        "largest mean normal stress on a contact",
        |r| r.contact_stress()[1],
    ),
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
