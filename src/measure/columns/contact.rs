//! Columns of one contact, written `contact:I-J:n` or `contact:I-WALL:n`.

use super::card::Row;
use crate::engine::World;
use crate::measure::contact_area::ContactArea;

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

/// All of them. An absent contact carries nothing: 0.
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
];
