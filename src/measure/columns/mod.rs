//! The columns of a history: names, units, what each needs and how it is read. Help, checks, CSV
//! headers, completions and the README table derive from these lists.
//!
//! Adding a column: a row in the file of its family, with the function that reads it. Adding a
//! family: a file, and a line in [`ASSEMBLY`].

mod card;
mod changes;
mod column;
mod contact;
mod counts;
mod energy;
mod fabric;
mod flow;
mod forces;
mod fourier;
mod fourth;
mod identity;
mod material;
mod names;
mod particle;
mod partition;
mod read;
mod space;
mod step;
mod strain;
mod stress;
mod wall;

pub use card::{Card, Kind, MARKS, Row};
pub use column::{Column, Partner};
pub use contact::{CONTACT, ReadContact};
pub use material::{MATERIAL, ReadMaterial};
pub use names::{Names, UnknownColumn, near, nearest};
pub use particle::{PARTICLE, ReadParticle};
pub use read::Read;
pub use wall::{ReadWall, WALL};

/// Columns of the assembly, family by family, in the order a history without a list shows them.
pub const ASSEMBLY: &[&[Row<Read>]] = &[
    step::ROWS,
    counts::ROWS,
    space::ROWS,
    stress::ROWS,
    partition::ROWS,
    strain::ROWS,
    flow::ROWS,
    fabric::ROWS,
    fourth::ROWS,
    fourier::ROWS,
    forces::ROWS,
    changes::ROWS,
    energy::ROWS,
    identity::ROWS,
];

/// The rows of [`ASSEMBLY`] in one line.
pub fn assembly() -> impl Iterator<Item = &'static Row<Read>> {
    ASSEMBLY.iter().flat_map(|family| family.iter())
}

/// Every column once: what stands before its name, and its card.
pub fn listing() -> Vec<(&'static str, &'static Card)> {
    fn of<R: 'static>(
        prefix: &'static str,
        rows: impl Iterator<Item = &'static Row<R>>,
    ) -> impl Iterator<Item = (&'static str, &'static Card)> {
        rows.map(move |row| (prefix, &row.card))
    }
    of("", assembly())
        .chain(of("wall:NAME:", WALL.iter()))
        .chain(of("contact:I-J:", CONTACT.iter()))
        .chain(of("particle:I:", PARTICLE.iter()))
        .chain(of("material:NAME:", MATERIAL.iter()))
        .collect()
}
