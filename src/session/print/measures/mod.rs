//! PRINT of measures: those of a region, the first one or everything unless another is named.

mod changes;
mod coordination;
mod fabric;
mod fourier;
mod histogram;
mod mohr;
mod partition;
mod polygon;
mod profile;
mod redundancy;
mod rose;
mod strain;
mod stress;

pub(super) use polygon::lines as polygon;
pub(super) use profile::lines as profile;

use crate::language::command::{Measure, Where};
use crate::measure::regional::Regional;
use crate::measure::sample::Sample;
use crate::session::figure::figure;
use crate::session::places::region_at;

/// A region and what to call it.
pub(super) struct Place<'a, 's> {
    /// Its measures.
    pub(super) region: &'a Regional<'s>,
    /// `region core`, `circle 0 0 0.1` or `everything`.
    pub(super) name: String,
}

impl<'a, 's> Place<'a, 's> {
    /// In a sample that was taken for it.
    pub(super) fn of(sample: &'a Sample<'s>, place: &Where) -> Self {
        let default = sample.region_names().next();
        Self {
            region: region_at(sample, place),
            name: match (place, default) {
                (Where::Region(name), _) => format!("region {name}"),
                (Where::Here(place), _) => place.to_string(),
                (Where::Default, Some(name)) => format!("region {name}"),
                (Where::Default, None) => "everything".to_owned(),
            },
        }
    }

    /// `stress of region core, 37 particles`.
    fn heading(&self, what: &str) -> String {
        let particles = self.region.members().iter().filter(|inside| **inside);
        format!("{what} of {}, {} particles", self.name, particles.count())
    }
}

/// The table of a measure.
pub(super) fn lines(sample: &Sample<'_>, measure: Measure, place: &Where) -> Vec<String> {
    let place = Place::of(sample, place);
    match measure {
        Measure::Stress => stress::lines(&place),
        Measure::Partition => partition::lines(&place),
        Measure::Mohr => mohr::lines(&place),
        Measure::Strain => strain::lines(&place, sample),
        Measure::Fabric => fabric::lines(&place),
        Measure::Fourier => fourier::lines(&place),
        Measure::Rose => rose::lines(&place),
        Measure::Coordination => coordination::lines(&place),
        Measure::Redundancy => redundancy::lines(&place),
        Measure::Changes => changes::lines(&place, sample),
        Measure::Obliquity => histogram::obliquity(&place),
        Measure::ContactStress => histogram::contact_stress(&place),
        Measure::Force => histogram::force(&place),
    }
}

/// Two figures of a pair with their unit, or one.
fn figures<const N: usize>(values: [f64; N], unit: &str) -> String {
    let texts = values.map(figure).join(" ");
    if unit == "-" {
        texts
    } else {
        format!("{texts} {unit}")
    }
}
