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

use crate::language::command::Measure;
use crate::measure::regional::Regional;
use crate::measure::sample::Sample;
use crate::session::figure::figure;

/// A region and what to call it.
pub(super) struct Place<'a, 's> {
    /// Its measures.
    pub(super) region: &'a Regional<'s>,
    /// `region core` or `everything`.
    pub(super) name: String,
}

impl<'a, 's> Place<'a, 's> {
    /// The region of this name, else the default one.
    pub(super) fn of(sample: &'a Sample<'s>, name: Option<&str>) -> Self {
        let default = sample.region_names().next();
        let region = name.and_then(|name| sample.region(name));
        Self {
            region: region.unwrap_or_else(|| sample.regional()),
            name: match name.or(default) {
                Some(name) => format!("region {name}"),
                None => "everything".to_owned(),
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
pub(super) fn lines(sample: &Sample<'_>, measure: Measure, region: Option<&str>) -> Vec<String> {
    let place = Place::of(sample, region);
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
