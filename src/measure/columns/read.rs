//! Where a column of the assembly is measured, and the shorthands its family declares it with.

use super::card::Row;
use crate::measure::regional::Regional;
use crate::measure::sample::Sample;

/// How a column of the assembly is read.
#[derive(Debug, Clone, Copy)]
pub enum Read {
    /// Of the run as a whole: no region has one of its own.
    World(fn(&Sample<'_>) -> f64),
    /// Of the first region of the scene, of everything where it has none, or of `region:NAME:`.
    Region(fn(&Regional<'_>) -> f64),
    /// Of everything, or of `region:NAME:`.
    Whole(fn(&Regional<'_>) -> f64),
    /// Of the run as a whole one thing, of `region:NAME:` another.
    Either(fn(&Sample<'_>) -> f64, fn(&Regional<'_>) -> f64),
}

impl Row<Read> {
    /// Whether a region can have it.
    pub fn is_regional(&self) -> bool {
        !matches!(self.read, Read::World(_))
    }
}

/// A column of the run as a whole.
pub(super) const fn world(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    read: fn(&Sample<'_>) -> f64,
) -> Row<Read> {
    Row::new(name, unit, summary, Read::World(read))
}

/// A column of the default region or of a named one.
pub(super) const fn regional(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    read: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    Row::new(name, unit, summary, Read::Region(read))
}

/// A column that is one thing for the run as a whole and another for a named region.
pub(super) const fn either(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    world: fn(&Sample<'_>) -> f64,
    region: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    Row::new(name, unit, summary, Read::Either(world, region))
}

/// A column of everything or of a named region.
pub(super) const fn whole(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    read: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    Row::new(name, unit, summary, Read::Whole(read))
}
