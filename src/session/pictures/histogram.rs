//! Histograms of contacts as a picture, with the scatter of obliquity over normal force.

use plotters::prelude::*;

use super::Failure;
use super::plate::{Area, Drawn, FONT, PATH, around, chart, plate};
use crate::measure::histogram::Histogram;
use crate::measure::survey::Survey;
use crate::session::figure::rough;

/// The picture as SVG.
pub(super) fn svg(survey: &Survey, cycle: u64) -> Result<String, Failure> {
    plate((1000, 820), &format!("contacts at cycle {cycle}"), |area| {
        let parts = area.split_evenly((2, 2));
        if let Some(obliquity) = &survey.obliquity {
            let title = format!("mean of |T|/(μN): {}", rough(obliquity.mean()));
            bars(&parts[0], &obliquity.histogram(), &title, "T/(μN)")?;
            scatter(&parts[1], &obliquity.contacts)?;
        }
        if let Some(force) = &survey.normal_force {
            let title = format!("mean normal force: {} N", rough(force.mean));
            bars(&parts[2], force, &title, "N [N]")?;
        }
        if let Some(stress) = &survey.contact_stress {
            let title = format!("mean contact stress: {} Pa", rough(stress.mean));
            bars(&parts[3], stress, &title, "N over contact area [Pa]")?;
        }
        Ok(())
    })
}

fn bars(area: &Area<'_>, histogram: &Histogram, title: &str, name: &str) -> Drawn {
    let total = histogram.count();
    if total == 0.0 {
        let style = (FONT, 16).into_font();
        area.draw(&Text::new("no contact has friction", (90, 120), style))?;
        return Ok(());
    }
    let shares: Vec<f64> = histogram
        .bars
        .iter()
        .map(|bar| 100.0 * bar / total)
        .collect();
    let x = if histogram.low < 0.0 {
        histogram.low..histogram.high
    } else {
        around([histogram.high].into_iter())
    };
    let y = around(shares.iter().copied());
    let mut chart = chart(area, title, (x, y), (name, "% of the contacts"))?;
    let boxes = shares.iter().enumerate().map(|(bar, share)| {
        let [from, to] = histogram.edges(bar);
        let mut column = Rectangle::new([(from, 0.0), (to, *share)], PATH.mix(0.7).filled());
        column.set_margin(0, 0, 1, 1);
        column
    });
    chart.draw_series(boxes)?;
    Ok(())
}

fn scatter(area: &Area<'_>, contacts: &[[f64; 3]]) -> Drawn {
    let x = around(contacts.iter().map(|contact| contact[0]));
    let names = ("N/<N>", "T/(μN)");
    let mut chart = chart(area, "a dot per contact", (x, -1.05..1.05), names)?;
    let dots = contacts.iter();
    let dots = dots.map(|[force, used, _]| Circle::new((*force, *used), 2, PATH.filled()));
    chart.draw_series(dots)?;
    Ok(())
}
