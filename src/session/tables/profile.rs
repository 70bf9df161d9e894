//! Porosity by distance from the middle of a region.

use crate::measure::profile::{Profile, RINGS};
use crate::measure::regional::Regional;
use crate::record::number::Cell;
use crate::record::table::CsvTable;

/// The innermost ring first. Units: m, m².
const COLUMNS: [&str; 6] = ["inner", "outer", "area", "disc_area", "porosity", "centres"];

/// The table; so many rings unless none are asked for.
pub(in crate::session) fn table(region: &Regional<'_>, rings: Option<u64>) -> CsvTable {
    let count = rings.map_or(RINGS, |rings| rings as usize);
    let profile = Profile::of(region.world(), region.shape(), count);
    let mut table = CsvTable::new(&COLUMNS);
    for ring in &profile.rings {
        table.row(&[
            Cell::Real(ring.inner),
            Cell::Real(ring.outer),
            Cell::Real(ring.area()),
            Cell::Real(ring.disc_area),
            Cell::Real(ring.porosity()),
            Cell::Count(ring.particles as u64),
        ]);
    }
    table
}
