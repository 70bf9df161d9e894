//! All particles or all contacts for programs that draw in space.

mod contacts;
mod particles;

use crate::language::command::DumpOf;
use crate::measure::sample::Sample;
use crate::record::vtk::Polydata;

/// Points, or lines between the bodies that touch.
pub(in crate::session) fn polydata(sample: &Sample<'_>, of: DumpOf) -> Polydata {
    let world = sample.world();
    let (cycle, time) = (world.cycle_number(), world.time());
    let title = format!("ballast {of}, cycle {cycle}, time {time:?} s, SI units");
    match of {
        DumpOf::Particles => particles::points(sample, &title),
        DumpOf::Contacts => contacts::lines(sample, &title),
    }
}
