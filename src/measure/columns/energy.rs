//! Where the energy is and where it went. What needs energies booked in every cycle is recorded only where
//! it is named.

use super::card::Row;
use super::read::{Read, world};
use crate::measure::sample::Sample;

const fn stored(
    name: &'static str,
    summary: &'static str,
    read: fn(&Sample<'_>) -> f64,
) -> Row<Read> {
    world(name, "J", summary, read).usual()
}

const fn booked(
    name: &'static str,
    summary: &'static str,
    read: fn(&Sample<'_>) -> f64,
) -> Row<Read> {
    world(name, "J", summary, read).booked()
}

pub(super) const ROWS: &[Row<Read>] = &[
    stored("kinetic", "translational kinetic energy", |s| {
        s.energies().kinetic
    }),
    stored("rotational", "rotational kinetic energy", |s| {
        s.energies().rotational
    }),
    stored("elastic_normal", "energy of the normal springs", |s| {
        s.energies().elastic_normal
    }),
    stored(
        "elastic_tangential",
        "energy of the tangential springs",
        |s| s.energies().elastic_tangential,
    ),
    stored(
        "potential",
        "energy in the field of gravity, 0 at the start",
        |s| s.energies().potential,
    ),
    booked(
        "friction_loss",
        "energy lost by sliding, slip within contacts and rolling, cumulative",
        |s| s.bookings().friction_loss,
    ),
    booked(
        "slip_loss",
        "the part of friction_loss that was lost by slip within contacts",
        |s| s.bookings().slip_loss,
    ),
    booked(
        "bond_loss",
        "energy lost with bonds that broke, what their springs held, cumulative",
        |s| s.bookings().bond_loss,
    ),
    booked(
        "damping_loss",
        "energy lost in contact dashpots, cumulative",
        |s| s.bookings().damping_loss,
    ),
    booked(
        "global_loss",
        "energy lost by global, local and CON1 damping, cumulative",
        |s| s.bookings().global_loss,
    ),
    booked(
        "boundary_work",
        "work of walls, driven particles, applied forces and commands",
        |s| s.bookings().boundary_work,
    ),
    world(
        "energy_error",
        "-",
        "what the ledger fails to close by, relative",
        |s| s.bookings().energy_error,
    )
    .booked(),
];
