//! PRINT PROFILE: porosity by distance from the middle of a region.

use super::Place;
use crate::measure::profile::{Profile, RINGS};
use crate::session::figure::{figure, vector};
use crate::session::print::layout::{Table, number};

/// The table.
pub(in crate::session::print) fn lines(place: &Place<'_, '_>, rings: Option<u64>) -> Vec<String> {
    let count = rings.map_or(RINGS, |rings| rings as usize);
    let profile = Profile::of(place.region.world(), place.region.shape(), count);
    let mut table = Table::new(
        2,
        &[
            number("from", "m"),
            number("to", "m"),
            number("porosity", "-"),
            number("discs", "m2"),
            number("centres", ""),
        ],
    );
    for ring in &profile.rings {
        let mut cells: Vec<String> = [ring.inner, ring.outer].map(figure).into();
        cells.extend([ring.porosity(), ring.disc_area].map(figure));
        cells.push(ring.particles.to_string());
        table.row(cells);
    }
    let mut lines = vec![format!(
        "porosity of {} by distance from {} m",
        place.name,
        vector(profile.centre)
    )];
    lines.extend(table.lines());
    lines
}
