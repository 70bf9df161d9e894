//! How many contacts there are, and how they share out.

use super::card::Row;
use super::read::{Read, regional, whole, world};
use crate::engine::boundary::Boundary;
use crate::measure::overlap::large_overlaps;

pub(super) const ROWS: &[Row<Read>] = &[
    whole(
        "contacts",
        "-",
        "touching contacts, wall contacts included",
        |r| r.assembly().contacts,
    )
    .counted()
    .usual(),
    regional("coordination", "-", "coordination number 2C/N", |r| {
        r.assembly().coordination
    })
    .usual(),
    regional(
        "coordination_mechanical",
        "-",
        "coordination number without rattlers",
        |r| r.assembly().coordination_mechanical,
    )
    .usual(),
    regional(
        "rattlers",
        "-",
        "particles with no contact or with one",
        |r| r.assembly().rattlers,
    )
    .counted(),
    regional("rattler_fraction", "-", "rattlers / particles", |r| {
        r.assembly().rattler_fraction
    }),
    regional(
        "redundancy",
        "-",
        "unknown contact forces / equations of equilibrium",
        |r| r.redundancy().ratio(),
    ),
    regional(
        "sliding_fraction",
        "-",
        "sliding contacts / contacts with friction",
        |r| r.assembly().sliding_fraction,
    )
    .usual(),
    world("bonds", "-", "bonds that hold", |s| {
        s.world().bonds() as f64
    })
    .counted(),
    world("bonds_broken", "-", "bonds that broke", |s| {
        s.world().bonds_broken() as f64
    })
    .counted(),
    world(
        "boundary_particles",
        "-",
        "particles of the boundary ring",
        |s| {
            s.world()
                .boundary()
                .and_then(Boundary::ring)
                .map_or(0, |ring| ring.members.len()) as f64
        },
    )
    .counted(),
    world(
        "overlap_warnings",
        "-",
        "contacts with an overlap above damping.overlap_critical, or 0.07, of the smaller diameter",
        |s| large_overlaps(s.world()) as f64,
    )
    .counted(),
];
