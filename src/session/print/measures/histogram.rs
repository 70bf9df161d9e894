//! PRINT HISTOGRAM: how contacts share out over what they carry.

use super::Place;
use crate::measure::contact_area::normal_stresses;
use crate::measure::histogram::Histogram;
use crate::measure::link::normal_forces;
use crate::session::figure::{figure, per_cent};
use crate::session::print::layout::{Table, number, words};

/// Bars of a histogram whose range its values decide.
const BARS: usize = 16;

/// Length of the longest bar [characters].
const LONGEST: f64 = 40.0;

/// T/(μ N), from full friction one way to full friction the other way.
pub(super) fn obliquity(place: &Place<'_, '_>) -> Vec<String> {
    let obliquity = place.region.obliquity();
    let mut lines = vec![place.heading("obliquity T/(mu N) of the contacts with friction")];
    lines.extend(bars(&obliquity.histogram(), "-"));
    if !obliquity.contacts.is_empty() {
        lines.push(format!("mean of |T|/(mu N) {}", figure(obliquity.mean())));
    }
    lines
}

/// Mean normal stress on the contact areas.
pub(super) fn contact_stress(place: &Place<'_, '_>) -> Vec<String> {
    let stresses = normal_stresses(place.region.world(), place.region.members());
    let mut lines = vec![place.heading("mean normal stress on the contact areas")];
    lines.extend(bars(&Histogram::from_zero(&stresses, BARS), "Pa"));
    lines
}

/// Normal forces over their mean.
pub(super) fn force(place: &Place<'_, '_>) -> Vec<String> {
    let forces = normal_forces(place.region.world(), place.region.members());
    let mut lines = vec![place.heading("normal forces")];
    lines.extend(bars(&Histogram::from_zero(&forces, BARS), "N"));
    lines
}

fn bars(histogram: &Histogram, unit: &'static str) -> Vec<String> {
    let count = histogram.count();
    if count == 0.0 {
        return vec!["no contact has one".into()];
    }
    let mut table = Table::new(
        2,
        &[
            number("from", unit),
            number("to", unit),
            number("contacts", ""),
            number("share", ""),
            words(""),
        ],
    );
    let most = histogram
        .bars
        .iter()
        .fold(0.0, |most: f64, bar| most.max(*bar));
    for (k, bar) in histogram.bars.iter().enumerate() {
        let [from, to] = histogram.edges(k);
        table.row(vec![
            figure(from),
            figure(to),
            figure(*bar),
            per_cent(bar / count),
            "#".repeat((LONGEST * bar / most).round() as usize),
        ]);
    }
    let mut lines = table.lines();
    let unit = if unit == "-" {
        String::new()
    } else {
        format!(" {unit}")
    };
    lines.push(format!(
        "mean {}{unit}, standard deviation {}{unit}",
        figure(histogram.mean),
        figure(histogram.deviation)
    ));
    lines
}
