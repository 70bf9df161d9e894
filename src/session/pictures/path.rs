//! The stress path as a picture.

use plotters::prelude::*;

use super::Failure;
use super::plate::{LIMIT, PATH, around, chart, plate};
use crate::language::Observable;
use crate::session::figure::rough;
use crate::session::{Refusal, Session};

/// Mean and deviator stress [Pa] of every row of the history that has both.
pub(super) fn recorded(session: &Session) -> Result<Vec<(f64, f64)>, Refusal> {
    let recording = session.recording();
    let place = |name: &str| {
        let named = recording.shown().find(|column| column.name() == name)?;
        recording.position(named as &Observable)
    };
    let (Some(mean), deviator, sine) = (
        place("isotropic_stress"),
        place("deviator_stress"),
        place("sin_phi"),
    ) else {
        return Err(not_recorded());
    };
    if deviator.is_none() && sine.is_none() {
        return Err(not_recorded());
    }
    let rows = 0..recording.rows().len();
    let points = rows.map(|row| {
        let value = |place: usize| recording.value(row, place);
        let across = match (deviator, sine) {
            (Some(deviator), _) => value(deviator),
            (None, Some(sine)) => 2.0 * value(mean) * value(sine),
            (None, None) => f64::NAN,
        };
        (value(mean), across)
    });
    let points: Vec<(f64, f64)> = points
        .filter(|(mean, deviator)| mean.is_finite() && deviator.is_finite())
        .collect();
    if points.is_empty() {
        return Err(Refusal::new(
            "the history has no row with a stress yet",
            "run until there is one",
        ));
    }
    Ok(points)
}

fn not_recorded() -> Refusal {
    Refusal::new(
        "the stress path is not recorded",
        "`history columns isotropic_stress, deviator_stress` records it from now on",
    )
}

/// The picture as SVG.
pub(super) fn svg(points: &[(f64, f64)]) -> Result<String, Failure> {
    let sine = |(mean, deviator): (f64, f64)| deviator / (2.0 * mean);
    let most = points.iter().map(|point| sine(*point));
    let most = most.filter(|sine| sine.is_finite()).fold(0.0, f64::max);
    let title = format!("stress path, largest sin φ = {}", rough(most));
    plate((760, 560), &title, |area| {
        let x = around(points.iter().map(|point| point.0));
        let y = around(points.iter().map(|point| point.1));
        let names = ("(σ1 + σ2)/2 [Pa]", "σ1 - σ2 [Pa]");
        let end = x.end.min(y.end / (2.0 * most).max(1e-300));
        let mut chart = chart(area, "dotted: the largest sin φ", (x, y), names)?;
        if most > 0.0 {
            let steps = (0..=120).map(|k| end * f64::from(k) / 120.0);
            let dots = steps.map(|mean| Circle::new((mean, 2.0 * most * mean), 1, LIMIT.filled()));
            chart.draw_series(dots)?;
        }
        chart.draw_series(LineSeries::new(
            points.iter().copied(),
            PATH.stroke_width(2),
        ))?;
        if let Some(now) = points.last() {
            chart.draw_series(std::iter::once(Circle::new(*now, 4, PATH.filled())))?;
        }
        Ok(())
    })
}
