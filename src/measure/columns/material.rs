//! Columns of the particles of one material, written `material:NAME:coordination`.

use super::card::Row;
use crate::measure::class::Class;

/// How a column of a material is read.
pub type ReadMaterial = fn(&Class) -> f64;

/// All of them, of the default region.
pub const MATERIAL: &[Row<ReadMaterial>] = &[
    Row::new("particles", "-", "particles of the material", |class| {
        class.particles
    }),
    Row::new(
        "coordination",
        "-",
        "coordination number of its particles",
        Class::coordination,
    ),
    Row::new(
        "contact_share",
        "-",
        "its share of the contacts, ends counted",
        Class::share,
    ),
    Row::new(
        "rattler_fraction",
        "-",
        "rattlers among its particles / its particles",
        Class::rattler_fraction,
    ),
];
