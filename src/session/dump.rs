//! Dumps: tables of all particles or contacts at cycle 0, every so many cycles and at the end of each
//! stage, one file each.
//!
//! A file depends on its cycle alone and is written whole under a name that holds it: a run that is
//! resumed or replayed writes the same files again with the same bytes, and a killed one leaves none
//! half written.

use std::path::{Path, PathBuf};

use super::{RunError, Session, tables};
use crate::language::command::DumpOf;
use crate::measure::sample::Sample;
use crate::record::whole_file;
use crate::scene::DumpFormat as Format;

/// Digits of a cycle in a name: names sort as cycles do.
const DIGITS: usize = 10;

impl Session {
    /// Dumps of the preset go beside this path from now on: its ending is replaced by theirs.
    pub fn write_dumps(&mut self, beside: &Path) {
        self.dump_stem = Some(beside.with_extension(""));
    }

    /// Writes the dumps of this boundary if they are due, once. `ending`: a stage ends here.
    pub(super) fn dump(&mut self, ending: bool) -> Result<(), RunError> {
        let cycle = self.world.cycle_number();
        let Some(dump) = &self.scene.dump else {
            return Ok(());
        };
        let due = ending || cycle.is_multiple_of(dump.every);
        if !due || self.dumped == Some(cycle) {
            return Ok(());
        }
        let Some(stem) = &self.dump_stem else {
            return Ok(());
        };
        let regions = &self.scene.regions;
        let sample = Sample::over(&mut self.world, regions, Some(&self.reference));
        for of in &dump.what {
            let path = path(stem, *of, cycle, dump.format);
            match dump.format {
                Format::Csv => whole_file::write(&path, tables::all(&sample, *of).bytes())?,
                Format::Vtk => whole_file::write(&path, &tables::polydata(&sample, *of).bytes())?,
            }
        }
        // Not before all are there: a run that is resumed makes good what failed.
        self.dumped = Some(cycle);
        Ok(())
    }
}

/// The file of a dump.
fn path(stem: &Path, of: DumpOf, cycle: u64, format: Format) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    let ending = format.ending();
    name.push(format!(".{of}.{cycle:0DIGITS$}.{ending}"));
    name.into()
}
