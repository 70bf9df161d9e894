//! PRINT ROSE: contacts by direction.

use super::Place;
use crate::session::figure::{figure, per_cent};
use crate::session::print::layout::{Table, number};

/// The table.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let rose = place.region.rose();
    let total: f64 = rose.contacts.iter().sum();
    let mut lines = vec![place.heading("directions of the contacts")];
    if total == 0.0 {
        lines.push("nothing touches".into());
        return lines;
    }
    let mut table = Table::new(
        1,
        &[
            number("direction", "deg"),
            number("contacts", ""),
            number("share", ""),
            number("normal force", "N"),
            number("|tangential|", "N"),
            number("sliding", ""),
        ],
    );
    for k in 0..rose.contacts.len() {
        table.row(vec![
            figure(rose.direction(k)),
            figure(rose.contacts[k]),
            per_cent(rose.contacts[k] / total),
            figure(rose.force[k]),
            figure(rose.shear[k]),
            figure(rose.sliding[k]),
        ]);
    }
    lines.extend(table.lines());
    lines
}
