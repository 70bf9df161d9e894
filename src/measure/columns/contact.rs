//! Columns of one contact, written `contact:I-J:n` or `contact:I-WALL:n`.

use super::card::Row;
use crate::engine::World;
use crate::measure::changes::slid;
use crate::measure::contact_area::{ContactArea, obliquity, peak_pressure, stick_ratio};

/// How a column of a contact is read, from its place in the list of contacts.
pub type ReadContact = fn(&World, usize) -> f64;

const fn row(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    read: ReadContact,
) -> Row<ReadContact> {
    Row::new(name, unit, summary, read)
}

fn stress(world: &World, k: usize) -> [f64; 2] {
    let reaction = world.reaction(k);
    ContactArea::of(world, k).stress(reaction.normal, reaction.tangential)
}

/// Losses since first touch: sliding, slip within, dashpots, a bond that broke [J].
fn lost(world: &World, k: usize) -> [f64; 4] {
    if world.ledger().is_none() {
        return [f64::NAN; 4];
    }
    let [sliding, within, dashpots] = world.pass().book(k).lost;
    if world.model().law.has_bonds() {
        [sliding, 0.0, dashpots, within]
    } else {
        [sliding, within, dashpots, 0.0]
    }
}

/// All of them. An absent contact carries nothing: 0. What a law does not know is NaN.
pub const CONTACT: &[Row<ReadContact>] = &[
    row(
        "n",
        "N",
        "normal force, compression positive",
        |world, k| world.reaction(k).normal,
    ),
    row("t", "N", "tangential force", |world, k| {
        world.reaction(k).tangential
    }),
    row("alpha", "m", "overlap", |world, k| {
        world.geometry(k).overlap
    }),
    row(
        "delta",
        "m",
        "tangential displacement since first touch",
        |world: &World, k| world.pass().book(k).delta,
    )
    .booked(),
    row("a", "m", "radius of the contact area", |world, k| {
        ContactArea::of(world, k).radius
    }),
    row(
        "sigma_n",
        "Pa",
        "mean normal stress on the contact area",
        |world, k| stress(world, k)[0],
    ),
    row(
        "sigma_t",
        "Pa",
        "mean tangential stress on the contact area",
        |world, k| stress(world, k)[1],
    ),
    row("p0", "Pa", "largest pressure of Hertz", peak_pressure),
    row(
        "obliquity",
        "-",
        "|tangential force| / (friction coefficient x normal force)",
        obliquity,
    ),
    row(
        "c_over_a",
        "-",
        "radius of the part that sticks / radius of the contact area, with partial slip",
        stick_ratio,
    ),
    row(
        "slid",
        "m",
        "tangential way, without sign, while the whole contact slid, since the reference or first touch",
        |world, k| slid(world, k).unwrap_or(f64::NAN),
    )
    .booked(),
    row(
        "friction_loss",
        "J",
        "energy lost by sliding and by slip within since first touch",
        |world, k| {
            let [sliding, slip, ..] = lost(world, k);
            sliding + slip
        },
    )
    .booked(),
    row(
        "slip_loss",
        "J",
        "the part of it that was lost by slip within the contact",
        |world, k| lost(world, k)[1],
    )
    .booked(),
    row(
        "damping_loss",
        "J",
        "energy lost in the dashpots since first touch",
        |world, k| lost(world, k)[2],
    )
    .booked(),
    row(
        "bond_loss",
        "J",
        "energy lost with a bond that broke since first touch",
        |world, k| lost(world, k)[3],
    )
    .booked(),
    row(
        "bonded",
        "-",
        "1 where a bond holds, 0 elsewhere",
        |world, k| f64::from(world.is_bonded(k)),
    )
    .counted(),
];
