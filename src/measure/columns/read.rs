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
    /// Of `region:NAME:` alone.
    Named(fn(&Regional<'_>) -> f64),
}

impl Row<Read> {
    /// Whether a region can have it.
    pub fn is_regional(&self) -> bool {
        !matches!(self.read, Read::World(_))
    }

    /// Whether it has a value without the name of a region.
    pub fn is_global(&self) -> bool {
        !matches!(self.read, Read::Named(_))
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

/// A column of a named region alone.
pub(super) const fn named(
    name: &'static str,
    unit: &'static str,
    summary: &'static str,
    read: fn(&Regional<'_>) -> f64,
) -> Row<Read> {
    Row::new(name, unit, summary, Read::Named(read))
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
