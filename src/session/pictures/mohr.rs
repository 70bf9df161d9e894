//! Circles of Mohr as a picture: stress and fabric.

use std::f64::consts::TAU;

use nalgebra::Matrix2;
use plotters::prelude::*;

use super::Failure;
use super::plate::{Area, Drawn, LIMIT, PATH, chart, equal, plate};
use crate::measure::survey::Survey;
use crate::measure::tensor::Principal;
use crate::session::figure::rough;

/// Points of a circle.
const STEPS: u32 = 180;

/// The picture as SVG.
pub(super) fn svg(survey: &Survey, cycle: u64) -> Result<String, Failure> {
    let title = format!("circles of Mohr at cycle {cycle}");
    plate((1000, 520), &title, |area| {
        let parts = area.split_evenly((1, 2));
        if let Some(tensors) = &survey.tensors {
            circle(&parts[0], &tensors.stress.total, true)?;
            circle(&parts[1], &tensors.fabric.plain, false)?;
        }
        Ok(())
    })
}

fn circle(area: &Area<'_>, tensor: &Matrix2<f64>, is_stress: bool) -> Drawn {
    let p = Principal::of(tensor);
    let (centre, radius) = (p.centre(), p.radius());
    let sine = radius / centre;
    let (title, names) = if is_stress {
        let title = format!("stress: sin φ = {}", rough(sine));
        (title, ("normal stress [Pa]", "shear stress [Pa]"))
    } else {
        let title = format!("fabric: Φ1 - Φ2 = {}", rough(2.0 * radius));
        (title, ("normal part", "shear part"))
    };
    let room = 0.1 * radius.max(1e-6 * centre.abs());
    let reach = radius + room;
    let low = if is_stress { p.minor.min(0.0) } else { p.minor };
    let window = [low - room..p.major.max(low) + room, -reach..reach];
    let mut chart = chart(area, &title, equal(area, window), names)?;
    let around = (0..=STEPS).map(|k| {
        let (s, c) = libm::sincos(TAU * f64::from(k) / f64::from(STEPS));
        (centre + radius * c, radius * s)
    });
    chart.draw_series(LineSeries::new(around, PATH.stroke_width(2)))?;
    let shear = 0.5 * (tensor[(0, 1)] + tensor[(1, 0)]);
    let planes = [(tensor[(0, 0)], shear), (tensor[(1, 1)], -shear)];
    chart.draw_series(LineSeries::new(planes, PATH.stroke_width(1)))?;
    chart.draw_series(std::iter::once(Circle::new(planes[0], 4, PATH.filled())))?;
    if is_stress && (0.0..1.0).contains(&sine) {
        let cosine = (1.0 - sine * sine).sqrt();
        for side in [1.0, -1.0] {
            let touch = (centre - radius * sine, side * radius * cosine);
            chart.draw_series(LineSeries::new([(0.0, 0.0), touch], LIMIT.stroke_width(1)))?;
        }
    }
    Ok(())
}
