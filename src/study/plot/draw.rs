//! The chart itself.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::course::Course;
use super::mark::{At, Mark};
use crate::session::pictures::plate::{
    COLOURS, Chart, Drawn, FAINT, FONT, SMALL, chart, close, plate,
};

/// Width and height [pixels].
const SIZE: (u32, u32) = (860, 560);

/// Half a cross of a mark [pixels].
const ARM: i32 = 6;

/// Width of a letter on the average over the size of its font.
const WIDTH: f64 = 0.39;

/// What a chart is made of.
pub(super) struct Content<'a> {
    pub(super) title: &'a str,
    pub(super) caption: &'a str,
    /// Names of the axes.
    pub(super) axes: [&'a str; 2],
    pub(super) courses: &'a [Course],
    pub(super) marks: &'a [Mark],
}

/// The chart as SVG.
pub(super) fn svg(content: &Content<'_>) -> Result<String, Box<dyn std::error::Error>> {
    let (courses, marks) = (content.courses, content.marks);
    let across = courses.iter().flat_map(|course| &course.points);
    let across = across.map(|point| point.x);
    let x = close(across.chain(marks.iter().filter_map(Mark::x)));
    let up = courses.iter().flat_map(Course::heights);
    let y = close(up.chain(marks.iter().filter_map(Mark::y)));
    let middle = 0.5 * (x.start + x.end);
    plate(SIZE, content.title, |area| {
        let names = (content.axes[0], content.axes[1]);
        let mut chart = chart(area, content.caption, (x.clone(), y.clone()), names)?;
        for (k, course) in courses.iter().enumerate() {
            spread(&mut chart, course, COLOURS[k % COLOURS.len()])?;
        }
        for (k, course) in courses.iter().enumerate() {
            line(&mut chart, course, COLOURS[k % COLOURS.len()])?;
        }
        for mark in marks {
            let ends = match mark.at {
                At::Point(x, y) => [(x, y); 2],
                At::Level(y) => [(x.start, y), (x.end, y)],
                At::Upright(x) => [(x, y.start), (x, y.end)],
            };
            draw_mark(&mut chart, mark, ends, middle)?;
        }
        if courses.len() > 1 {
            chart
                .configure_series_labels()
                .position(emptiest(courses, [x, y]))
                .background_style(WHITE.mix(0.85))
                .border_style(FAINT)
                .label_font((FONT, SMALL))
                .draw()?;
        }
        Ok(())
    })
}

/// A band of a standard deviation on both sides, and thin lines along the extremes.
fn spread(chart: &mut Chart<'_, '_>, course: &Course, colour: RGBColor) -> Drawn {
    for part in course.parts() {
        let known = part.iter().filter(|point| point.within[0].is_finite());
        let lower = known.clone().map(|point| (point.x, point.within[0]));
        let upper = known.rev().map(|point| (point.x, point.within[1]));
        let outline: Vec<(f64, f64)> = lower.chain(upper).collect();
        if !outline.is_empty() {
            let band = Polygon::new(outline, colour.mix(0.22).filled());
            chart.draw_series(std::iter::once(band))?;
        }
        for side in [0, 1] {
            let known = part.iter().filter(|point| point.extremes[side].is_finite());
            let ends: Vec<_> = known.map(|point| (point.x, point.extremes[side])).collect();
            if ends.len() > 1 {
                let thin = colour.mix(0.6).stroke_width(1);
                chart.draw_series(LineSeries::new(ends, thin))?;
            }
        }
    }
    Ok(())
}

/// The line; a dot where a row stands alone.
fn line(chart: &mut Chart<'_, '_>, course: &Course, colour: RGBColor) -> Drawn {
    let style = colour.stroke_width(2);
    for (k, part) in course.parts().enumerate() {
        let points: Vec<(f64, f64)> = part.iter().map(|point| (point.x, point.y)).collect();
        if let [alone] = points.as_slice() {
            let dot = Circle::new(*alone, 3, colour.filled());
            chart.draw_series(std::iter::once(dot))?;
        }
        let drawn = chart.draw_series(LineSeries::new(points, style))?;
        if k == 0 {
            drawn
                .label(&course.name)
                .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
        }
    }
    Ok(())
}

/// A cross with its label, or a dashed line with it.
fn draw_mark(chart: &mut Chart<'_, '_>, mark: &Mark, ends: [(f64, f64); 2], middle: f64) -> Drawn {
    let style = BLACK.stroke_width(1);
    let place = match mark.at {
        At::Point(..) => {
            let cross = BLACK.stroke_width(2);
            chart.draw_series(std::iter::once(
                EmptyElement::at(ends[0])
                    + PathElement::new([(-ARM, -ARM), (ARM, ARM)], cross)
                    + PathElement::new([(-ARM, ARM), (ARM, -ARM)], cross),
            ))?;
            ends[0]
        }
        At::Level(_) | At::Upright(_) => {
            chart.draw_series(DashedLineSeries::new(ends, 6, 4, style))?;
            ends[1]
        }
    };
    // Towards the middle, where there is room for it.
    let rightwards = place.0 < middle;
    let (side, away) = if rightwards {
        (HPos::Left, ARM + 3)
    } else {
        (HPos::Right, -ARM - 3)
    };
    let (above, lift) = match mark.at {
        At::Upright(_) => (VPos::Top, 4),
        At::Point(..) | At::Level(_) => (VPos::Bottom, -3),
    };
    let font = (FONT, SMALL).into_font().color(&BLACK);
    let text = Text::new(
        mark.label.clone(),
        (away, lift),
        font.pos(Pos::new(side, above)),
    );
    // Curves shine through the paper that it is written on.
    let width = (WIDTH * f64::from(SMALL) * mark.label.chars().count() as f64) as i32;
    let far = if rightwards {
        away + width
    } else {
        away - width
    };
    let top = match mark.at {
        At::Upright(_) => lift,
        At::Point(..) | At::Level(_) => lift - SMALL,
    };
    let paper = Rectangle::new(
        [(away.min(far), top), (away.max(far), top + SMALL)],
        WHITE.mix(0.6).filled(),
    );
    chart.draw_series(std::iter::once(EmptyElement::at(place) + paper + text))?;
    Ok(())
}

/// The corner with the fewest points.
fn emptiest(courses: &[Course], [x, y]: [std::ops::Range<f64>; 2]) -> SeriesLabelPosition {
    let mut counts = [0u32; 4];
    for point in courses.iter().flat_map(|course| &course.points) {
        let across = (point.x - x.start) / (x.end - x.start);
        let up = (point.y - y.start) / (y.end - y.start);
        if !(0.35..=0.65).contains(&up) {
            let corner = 2 * usize::from(up < 0.35) + usize::from(across > 0.5);
            counts[corner] += 1;
        }
    }
    let corners = [
        SeriesLabelPosition::UpperLeft,
        SeriesLabelPosition::UpperRight,
        SeriesLabelPosition::LowerLeft,
        SeriesLabelPosition::LowerRight,
    ];
    let fewest = counts.iter().zip(corners).min_by_key(|(count, _)| **count);
    fewest.map_or(SeriesLabelPosition::UpperRight, |(_, corner)| corner)
}
