//! PRINT FOURIER: contacts and forces as waves over directions.

use super::Place;
use crate::session::figure::figure;
use crate::session::print::layout::{Table, number, words};

/// The table.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let fourier = place.region.fourier();
    let mut table = Table::new(
        1,
        &[
            words("wave"),
            words("of"),
            number("amplitude", ""),
            number("direction", "deg"),
        ],
    );
    for (name, of, wave) in [
        ("a", "contacts", fourier.contacts),
        ("b", "contacts, fourth order", fourier.fourfold),
        ("a_n", "normal forces", fourier.normal),
        ("a_t", "tangential forces", fourier.tangential),
    ] {
        table.row(vec![
            name.to_owned(),
            of.to_owned(),
            figure(wave.amplitude()),
            figure(wave.angle()),
        ]);
    }
    let mut lines = vec![place.heading("Fourier coefficients")];
    lines.extend(table.lines());
    lines.push(format!(
        "mean normal force over directions {} N",
        figure(fourier.mean_normal)
    ));
    lines.push(format!(
        "sin phi of the waves {}, of the stress {}",
        figure(fourier.sin_phi()),
        figure(place.region.stress().sin_phi())
    ));
    lines
}
