//! PRINT PARTITION: where stress comes from. Each row is a sum of its own, so that their sum can be
//! held against the total.

use nalgebra::Matrix2;

use super::Place;
use crate::session::figure::figure;
use crate::session::print::layout::{Table, number, words};

/// The table.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let stress = place.region.stress();
    let mut table = Table::new(
        1,
        &[
            words("part"),
            number("s11", "Pa"),
            number("s12", "Pa"),
            number("s21", "Pa"),
            number("s22", "Pa"),
            number("isotropic", "Pa"),
            number("sin phi", "-"),
        ],
    );
    let mut row = |name: &str, part: &Matrix2<f64>| {
        let components = [(0, 0), (0, 1), (1, 0), (1, 1)].map(|at| part[at]);
        let mut cells = vec![name.to_owned()];
        cells.extend(components.map(figure));
        cells.push(figure(0.5 * part.trace()));
        cells.push(figure(stress.sin_phi_of(part)));
        table.row(cells);
    };
    row("fabric", &stress.fabric);
    row("normal variation", &stress.normal_variation);
    row("shear", &stress.shear);
    row("sum of these", &stress.parts());
    row("total by itself", &stress.total);
    row("normal", &stress.normal);
    let mut lines = vec![place.heading("partition of the stress")];
    lines.extend(table.lines());
    let off = (stress.parts() - stress.total).norm() / stress.total.norm();
    lines.push(format!(
        "mean normal force {} N; sum and total differ by {} of the total",
        figure(stress.mean_normal),
        figure(off)
    ));
    lines
}
