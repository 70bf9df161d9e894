//! PRINT MOHR: circles of Mohr of the tensors of a region.

use nalgebra::Matrix2;

use super::Place;
use crate::measure::tensor::Principal;
use crate::session::figure::figure;
use crate::session::print::layout::{Table, number, words};

/// The table.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            words("circle"),
            words("unit"),
            number("centre", ""),
            number("radius", ""),
            number("major", ""),
            number("minor", ""),
            number("direction", "deg"),
        ],
    );
    let mut row = |name: &str, unit: &str, tensor: &Matrix2<f64>| {
        let circle = Principal::of(tensor);
        let mut cells = vec![name.to_owned(), unit.to_owned()];
        cells.extend([circle.centre(), circle.radius()].map(figure));
        cells.extend([circle.major, circle.minor, circle.angle].map(figure));
        table.row(cells);
    };
    let (region, fabric) = (place.region, place.region.fabric());
    row("stress", "Pa", &region.stress().total);
    row("fabric", "-", &fabric.plain);
    row("fabric by N", "-", &fabric.weighted);
    row("fabric by |T|", "-", &fabric.by_tangential);
    if let Some(strain) = region.strain() {
        row("strain", "-", &strain.tensor);
    }
    let mut lines = vec![place.heading("circles of Mohr")];
    lines.extend(table.lines());
    lines.push("direction is that of the major value; round the circle twice as far".into());
    lines
}
