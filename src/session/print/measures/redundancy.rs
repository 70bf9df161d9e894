//! PRINT REDUNDANCY: unknown contact forces against equations of equilibrium, and which sizes bear
//! nothing.

use super::coordination::radii;
use super::{Place, figures};
use crate::measure::class::by_size;
use crate::session::figure::{figure, per_cent};
use crate::session::print::layout::{Table, listed, number, words};

/// The tables.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let redundancy = place.region.redundancy();
    let mut lines = vec![place.heading("redundancy")];
    lines.extend(listed(&[
        ("unknown forces", figures([redundancy.unknowns], "-")),
        ("equations", figures([redundancy.equations], "-")),
        ("unknowns / equations", figures([redundancy.ratio()], "-")),
    ]));
    let mut table = Table::new(
        1,
        &[
            words("radius [m]"),
            number("particles", ""),
            number("bear nothing", ""),
            number("of them", ""),
            number("of all that do", ""),
        ],
    );
    let sizes = by_size(place.region.world(), place.region.members());
    let all: f64 = sizes.iter().map(|(_, class)| class.rattlers).sum();
    for (sizes, class) in sizes.iter().filter(|(_, class)| class.particles > 0.0) {
        let share = if all > 0.0 {
            per_cent(class.rattlers / all)
        } else {
            "-".into()
        };
        table.row(vec![
            radii(*sizes),
            figure(class.particles),
            figure(class.rattlers),
            per_cent(class.rattler_fraction()),
            share,
        ]);
    }
    lines.push(String::new());
    lines.extend(table.lines());
    lines
}
