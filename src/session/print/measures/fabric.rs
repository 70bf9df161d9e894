//! PRINT FABRIC: tensors of second and fourth order, plain and weighted.

use super::Place;
use crate::measure::tensor::Principal;
use crate::session::figure::figure;
use crate::session::print::layout::{Table, number, words};

/// The tables.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let (fabric, fourth) = (place.region.fabric(), place.region.fourth());
    let mut second = Table::new(
        1,
        &[
            words("mean of n n"),
            number("11", ""),
            number("12", ""),
            number("22", ""),
            number("major", ""),
            number("minor", ""),
            number("difference", ""),
            number("direction", "deg"),
        ],
    );
    let mut higher = Table::new(
        1,
        &[
            words("mean of n n n n"),
            number("1111", ""),
            number("1112", ""),
            number("1122", ""),
            number("1222", ""),
            number("2222", ""),
        ],
    );
    for (name, tensor, of) in [
        ("plain", &fabric.plain, &fourth.plain),
        ("by N", &fabric.weighted, &fourth.weighted),
        ("by |T|", &fabric.by_tangential, &fourth.by_tangential),
    ] {
        let p = Principal::of(tensor);
        let mut cells = vec![name.to_owned()];
        cells.extend([(0, 0), (0, 1), (1, 1)].map(|at| figure(tensor[at])));
        cells.extend([p.major, p.minor, 2.0 * p.radius(), p.angle].map(figure));
        second.row(cells);
        let mut cells = vec![name.to_owned()];
        cells.extend(of.0.map(figure));
        higher.row(cells);
    }
    let mut lines = vec![place.heading("fabric")];
    lines.extend(second.lines());
    lines.push(String::new());
    lines.extend(higher.lines());
    lines.push(format!(
        "{} contacts, trace of the fabric tensor 2 M R/V = {} 1/m2",
        figure(fabric.contacts),
        figure(fabric.trace(place.region.world(), place.region.content()))
    ));
    lines
}
