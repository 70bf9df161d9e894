//! Columns of one contact, written `contact:I-J:n` or `contact:I-WALL:n`.

use super::card::Row;
use crate::engine::World;

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
];
