//! PRINT CHANGES: contacts and rotations against the reference.

use super::{Place, figures};
use crate::measure::sample::Sample;
use crate::session::figure::{figure, per_cent};
use crate::session::print::layout::listed;

/// The table.
pub(super) fn lines(place: &Place<'_, '_>, sample: &Sample<'_>) -> Vec<String> {
    let mut lines = vec![place.heading("changes")];
    let (Some(changes), Some(reference)) = (place.region.changes(), sample.reference()) else {
        lines.push("there is no reference: `reference` takes one".into());
        return lines;
    };
    let broken = format!(
        "{}, {}",
        figure(changes.broken),
        per_cent(changes.broken_fraction())
    );
    lines.extend(listed(&[
        ("since", format!("cycle {}", reference.cycle)),
        (
            "contacts then",
            figures([changes.broken + changes.kept], "-"),
        ),
        ("of them broken", broken),
        ("new contacts", figures([changes.made], "-")),
        ("mean rotation", figures([changes.rotation], "rad")),
        ("largest rotation", figures([changes.rotation_max], "rad")),
    ]));
    if place.region.world().ledger().is_some() {
        lines.extend(listed(&[
            ("mean sliding way", figures([changes.slid], "m")),
            ("longest sliding way", figures([changes.slid_max], "m")),
        ]));
    }
    lines
}
