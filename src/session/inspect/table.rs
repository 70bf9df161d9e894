//! A followed contact as tables for other programs, in SI units.

use super::Inspection;
use crate::engine::contact::traction::{Traction, Zone};
use crate::record::number::Cell;
use crate::record::table::CsvTable;

/// Steps from the middle of the contact to its edge.
const STEPS: u32 = 200;

/// Units: s, m, N. `touch` counts touches, `limit` is μN + c.
const PATH: [&str; 8] = [
    "cycle", "time", "touch", "alpha", "delta", "n", "t", "limit",
];

/// The path: a row for each moment that was kept.
pub(super) fn path(inspection: &Inspection) -> CsvTable {
    let mut table = CsvTable::new(&PATH);
    for moment in &inspection.trace {
        let limit = inspection.friction * moment.n + inspection.cohesion;
        table.row(&[
            Cell::Count(moment.cycle),
            Cell::Real(moment.time),
            Cell::Count(u64::from(moment.touch)),
            Cell::Real(moment.alpha),
            Cell::Real(moment.delta),
            Cell::Real(moment.n),
            Cell::Real(moment.t),
            Cell::Real(limit),
        ]);
    }
    table
}

/// Units: m, Pa. `mu_p` is what limits the traction `q`.
const TRACTION: [&str; 5] = ["r_over_a", "r", "q", "mu_p", "zone"];

/// The traction over the radius, from the middle outwards.
pub(super) fn traction(inspection: &Inspection, traction: &Traction) -> CsvTable {
    let limit = traction.friction * inspection.peak;
    let mut table = CsvTable::new(&TRACTION);
    for k in 0..=STEPS {
        let r = f64::from(k) / f64::from(STEPS);
        let zone = match traction.zone(r) {
            // The pressure ends there, and with it the question.
            _ if k == STEPS => "edge",
            Zone::Stick => "stick",
            Zone::SlipForward => "slip+",
            Zone::SlipBackward => "slip-",
        };
        table.row(&[
            Cell::Real(r),
            Cell::Real(r * inspection.radius),
            Cell::Real(limit * traction.at(r)),
            Cell::Real(limit * Traction::pressure(r)),
            Cell::name(zone),
        ]);
    }
    table
}
