//! Roses of contact normals as a picture: all, weighted by normal and tangential force, sliding ones.

use std::f64::consts::{PI, TAU};

use plotters::prelude::*;

use super::Failure;
use super::plate::{Area, Drawn, FONT, LIMIT, PATH, chart, equal, plate};
use crate::measure::rose::Rose;
use crate::measure::survey::Survey;

/// The picture as SVG.
pub(super) fn svg(survey: &Survey, cycle: u64) -> Result<String, Failure> {
    let title = format!("directions of contacts at cycle {cycle}; circle: equal shares");
    plate((1000, 960), &title, |area| {
        let parts = area.split_evenly((2, 2));
        if let Some((rose, _)) = &survey.directions {
            petals(&parts[0], &rose.contacts, "contacts", "")?;
            petals(&parts[1], &rose.force, "normal force", " [N]")?;
            petals(&parts[2], &rose.shear, "tangential force", " [N]")?;
            petals(&parts[3], &rose.sliding, "sliding contacts", "")?;
        }
        Ok(())
    })
}

fn petals(area: &Area<'_>, petals: &[f64], title: &str, unit: &str) -> Drawn {
    let total: f64 = petals.iter().sum();
    if total == 0.0 {
        let style = (FONT, 16).into_font();
        area.draw(&Text::new(format!("{title}: none"), (90, 120), style))?;
        return Ok(());
    }
    let most = 1.05 * petals.iter().fold(0.0, |most: f64, petal| most.max(*petal));
    let name = format!("{title}{unit}");
    let ranges = equal(area, [-most..most, -most..most]);
    let mut chart = chart(area, title, ranges, (&name, &name))?;
    let at = |radius: f64, angle: f64| {
        let (s, c) = libm::sincos(angle);
        (radius * c, radius * s)
    };
    let width = PI / petals.len() as f64;
    let sectors = Rose::mirrored(petals).into_iter().zip(0_u32..);
    let sectors = sectors.map(|(petal, k)| {
        let middle = f64::from(k) * width;
        let arc = (0..=6).map(|step| at(petal, middle + (f64::from(step) / 6.0 - 0.5) * width));
        let mut corners = vec![(0.0, 0.0)];
        corners.extend(arc);
        Polygon::new(corners, PATH.mix(0.7).filled())
    });
    chart.draw_series(sectors)?;
    let mean = total / petals.len() as f64;
    let circle = (0..=180).map(|k| at(mean, TAU * f64::from(k) / 180.0));
    chart.draw_series(LineSeries::new(circle, LIMIT.stroke_width(1)))?;
    Ok(())
}
