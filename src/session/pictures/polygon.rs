//! The polygon of the forces on one particle as a picture.

use plotters::prelude::*;

use super::Failure;
use super::plate::{COLOURS, Drawn, FONT, LIMIT, SMALL, chart, equal, plate};
use crate::measure::polygon::ForcePolygon;
use crate::session::figure::rough;

/// The picture as SVG.
pub(super) fn svg(polygon: &ForcePolygon, cycle: u64) -> Result<String, Failure> {
    let title = format!(
        "forces on particle {} at cycle {cycle}, out of balance {} N",
        polygon.particle,
        rough(polygon.residual())
    );
    plate((700, 620), &title, |area| {
        let corners = polygon.corners();
        let [low, high] = polygon.bounds();
        let room = 0.1 * (high[0] - low[0]).max(high[1] - low[1]);
        let window = [0, 1].map(|k| low[k] - room..high[k] + room);
        let names = ("sum of forces, direction 1 [N]", "direction 2 [N]");
        let mut chart = chart(area, "", equal(area, window), names)?;
        let bodies = polygon.sides.iter().map(|side| side.by.clone());
        let named = bodies.chain(["weight, applied".to_owned()]);
        for (k, (by, ends)) in named.zip(corners.windows(2)).enumerate() {
            let colour = COLOURS[k % COLOURS.len()];
            let [from, to] = [ends[0], ends[1]].map(|[x, y]| (x, y));
            if from == to {
                continue;
            }
            chart.draw_series(LineSeries::new([from, to], colour.stroke_width(2)))?;
            let middle = (0.5 * (from.0 + to.0), 0.5 * (from.1 + to.1));
            let style = (FONT, SMALL).into_font().color(&colour);
            chart.draw_series(std::iter::once(Text::new(by, middle, style)))?;
        }
        closing(&mut chart, polygon.gap())
    })
}

/// What is missing to a closed polygon.
fn closing(chart: &mut super::plate::Chart<'_, '_>, gap: [f64; 2]) -> Drawn {
    let ends = [(0.0, 0.0), (gap[0], gap[1])];
    chart.draw_series(DashedLineSeries::new(ends, 4, 3, LIMIT.stroke_width(1)))?;
    chart.draw_series(std::iter::once(Circle::new(ends[0], 3, BLACK.filled())))?;
    Ok(())
}
