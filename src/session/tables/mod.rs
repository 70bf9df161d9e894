//! Tables for other programs: what there is at one cycle boundary, in SI units and the coordinates of
//! the preset, compression positive. `export` writes one, `[dump]` many.

mod contacts;
mod particles;
mod profile;
mod vtk;

pub(super) use profile::table as profile;
pub(super) use vtk::polydata;

use crate::language::command::DumpOf;
use crate::measure::sample::Sample;
use crate::record::table::CsvTable;

/// All particles or all contacts.
pub(super) fn all(sample: &Sample<'_>, of: DumpOf) -> CsvTable {
    match of {
        DumpOf::Particles => particles::table(sample),
        DumpOf::Contacts => contacts::table(sample),
    }
}
