//! PRINT STRESS.

use super::{Place, figures};
use crate::session::print::layout::listed;

/// The table.
pub(super) fn lines(place: &Place<'_, '_>) -> Vec<String> {
    let (stress, content) = (place.region.stress(), place.region.content());
    let (s, principal) = (&stress.total, stress.principal());
    let mut lines = vec![place.heading("stress, compression positive,")];
    lines.extend(listed(&[
        ("s11 s12", figures([s[(0, 0)], s[(0, 1)]], "Pa")),
        ("s21 s22", figures([s[(1, 0)], s[(1, 1)]], "Pa")),
        ("s1 s2", figures([principal.major, principal.minor], "Pa")),
        ("direction of s1", figures([principal.angle], "deg")),
        ("isotropic", figures([stress.isotropic()], "Pa")),
        ("deviator s1 - s2", figures([stress.deviator()], "Pa")),
        ("sin phi", figures([stress.sin_phi()], "-")),
        ("porosity", figures([content.porosity()], "-")),
        ("area", figures([content.area], "m2")),
        ("thickness", figures([content.thickness], "m")),
    ]));
    lines
}
