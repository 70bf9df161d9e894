//! PRINT COORDINATION: contacts per particle, all in all and by type.

use super::{Place, figures};
use crate::measure::class::{Class, Sizes, by_material, by_size};
use crate::session::figure::{figure, per_cent};
use crate::session::print::layout::{Table, listed, name, number, words};

/// The tables.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let (assembly, world) = (place.region.assembly(), place.region.world());
    let inside = place.region.members();
    let mut lines = vec![place.heading("coordination")];
    lines.extend(listed(&[
        ("contacts", figures([assembly.contacts], "-")),
        (
            "coordination 2C/N, a wall counts half",
            figures([assembly.coordination], "-"),
        ),
        (
            "without rattlers",
            figures([assembly.coordination_mechanical], "-"),
        ),
        (
            "rattlers",
            format!(
                "{}, {}",
                figure(assembly.rattlers),
                per_cent(assembly.rattler_fraction)
            ),
        ),
        ("sliding", per_cent(assembly.sliding_fraction)),
    ]));
    let materials = world.model().materials.iter().map(|m| name(&m.name));
    let by_material = materials.zip(by_material(world, inside));
    let sizes = by_size(world, inside);
    let by_size = sizes.iter().map(|(sizes, class)| (radii(*sizes), *class));
    for (head, rows) in [
        ("type", by_material.collect::<Vec<_>>()),
        ("radius [m]", by_size.collect()),
    ] {
        lines.push(String::new());
        lines.extend(table(head, rows));
    }
    lines
}

/// Classes without particles are left out.
fn table(head: &'static str, rows: Vec<(String, Class)>) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            words(head),
            number("particles", ""),
            number("coordination", ""),
            number("share of contacts", ""),
            number("rattlers", ""),
            number("of them", ""),
        ],
    );
    for (name, class) in rows.into_iter().filter(|(_, class)| class.particles > 0.0) {
        table.row(vec![
            name,
            figure(class.particles),
            figure(class.coordination()),
            per_cent(class.share()),
            figure(class.rattlers),
            per_cent(class.rattler_fraction()),
        ]);
    }
    table.lines()
}

/// `0.5`, or `0.5 - 0.6` for a range.
pub(super) fn radii([from, to]: Sizes) -> String {
    if from == to {
        figure(from)
    } else {
        format!("{} - {}", figure(from), figure(to))
    }
}
