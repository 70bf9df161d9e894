//! PRINT STRAIN: what the particles of a region have in common.

use super::{Place, figures};
use crate::measure::sample::Sample;
use crate::session::print::layout::listed;

/// The table.
pub(super) fn lines(place: &Place<'_, '_>, sample: &Sample<'_>) -> Vec<String> {
    let (region, flow) = (place.region, place.region.flow());
    let mut lines = vec![place.heading("strain of best fit, compression positive,")];
    let mut rows = Vec::new();
    if let (Some(strain), Some(reference)) = (region.strain(), sample.reference()) {
        let e = &strain.tensor;
        let since = format!(
            "cycle {}, {} particles were inside then",
            reference.cycle, strain.particles
        );
        rows.extend([
            ("since", since),
            ("e11 e12", figures([e[(0, 0)], e[(0, 1)]], "-")),
            ("e21 e22", figures([e[(1, 0)], e[(1, 1)]], "-")),
            ("deviator e1 - e2", figures([strain.deviator()], "-")),
            ("volumetric e1 + e2", figures([strain.volumetric()], "-")),
        ]);
    }
    let r = &flow.rate;
    let pressure = region.stress().isotropic();
    rows.extend([
        ("rate 11 12", figures([r[(0, 0)], r[(0, 1)]], "1/s")),
        ("rate 21 22", figures([r[(1, 0)], r[(1, 1)]], "1/s")),
        (
            "inertial number",
            figures([flow.inertial_number(pressure)], "-"),
        ),
        ("granular temperature", figures([flow.temperature], "m2/s2")),
    ]);
    lines.extend(listed(&rows));
    lines
}
