//! The picture of a study: error against wall time, both logarithmic, a line for each series.

use std::error::Error;

use plotters::coord::Shift;
use plotters::coord::combinators::{BindKeyPoints, LogCoord, WithKeyPoints};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::outcome::Outcome;
use crate::session::figure::{figure, rough};
use crate::session::pictures::plate::{COLOURS, FONT, SMALL};

/// Width and height [pixels].
const SIZE: (u32, u32) = (860, 560);

/// A variant in the picture.
struct Point {
    series: usize,
    /// Wall time [s] and error.
    at: (f64, f64),
    frac: f64,
    on_front: bool,
    fastest: bool,
}

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Axis = WithKeyPoints<LogCoord<f64>>;
type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Cartesian2d<Axis, Axis>>;

/// The picture as SVG, and how many variants are left out because they have no time or no error
/// above zero.
pub fn svg(outcome: &Outcome) -> Result<(String, usize), Box<dyn Error>> {
    let points = points(outcome);
    let left_out = outcome.runs.len() - points.len();
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, SIZE).into_drawing_area();
        root.fill(&WHITE)?;
        draw(&root, outcome, &points)?;
        root.present()?;
    }
    Ok((text, left_out))
}

fn points(outcome: &Outcome) -> Vec<Point> {
    let variants = outcome.plan.variants.iter().zip(&outcome.runs).enumerate();
    variants
        .filter(|(_, (_, run))| run.error > 0.0 && run.timing.median() > 0.0)
        .map(|(k, (variant, run))| Point {
            series: variant.series,
            at: (run.timing.median(), run.error),
            frac: variant.asked,
            on_front: run.on_front,
            fastest: outcome.fastest == Some(k),
        })
        .collect()
}

/// A logarithmic axis over whole decades.
struct Decades {
    low: i32,
    high: i32,
}

impl Decades {
    /// Around some numbers, at least one decade.
    fn around(numbers: impl Iterator<Item = f64>) -> Self {
        let (mut low, mut high) = (i32::MAX, i32::MIN);
        for number in numbers.filter(|number| number.is_normal()) {
            // Room for the labels of points at the edge.
            low = low.min((0.8 * number).log10().floor() as i32);
            high = high.max((1.25 * number).log10().ceil() as i32);
        }
        if low > high {
            (low, high) = (-1, 0);
        }
        Self { low, high }
    }

    fn range(&self) -> std::ops::Range<f64> {
        power(self.low)..power(self.high)
    }

    /// Lines at every decade, fainter ones in between where there is room.
    fn axis(&self) -> Axis {
        let decades: Vec<f64> = (self.low..=self.high).map(power).collect();
        let between = (self.low..self.high).flat_map(|k| (2..10).map(move |n| (k, n)));
        let few = self.high - self.low <= 8;
        let faint = between
            .filter(|_| few)
            .map(|(k, n)| f64::from(n) * power(k));
        self.range()
            .log_scale()
            .with_key_points(decades)
            .with_light_points(faint.collect::<Vec<f64>>())
    }
}

/// The number that reads 1eK: as a product it would be off by a rounding.
fn power(k: i32) -> f64 {
    format!("1e{k}").parse().unwrap_or(f64::NAN)
}

/// 0.001 as 1e-3: decades are read by their exponents.
fn decade(x: f64) -> String {
    format!("{x:e}")
}

fn draw(root: &Area<'_>, outcome: &Outcome, points: &[Point]) -> Result<(), Box<dyn Error>> {
    let scene = &outcome.plan.scene;
    let mut chart = ChartBuilder::on(root)
        .caption(format!("{}: speed against error", scene.name), (FONT, 20))
        .margin(14)
        .x_label_area_size(48)
        .y_label_area_size(72)
        .build_cartesian_2d(
            times(points).axis(),
            Decades::around(points.iter().map(|p| p.at.1).chain(scene.study.within)).axis(),
        )?;
    chart
        .configure_mesh()
        .light_line_style(RGBColor(235, 235, 235))
        .bold_line_style(RGBColor(200, 200, 200))
        .x_desc("wall time [s], median")
        .y_desc(axis(outcome))
        .x_label_formatter(&|x| decade(*x))
        .y_label_formatter(&|x| decade(*x))
        .label_style((FONT, SMALL))
        .axis_desc_style((FONT, SMALL + 2))
        .draw()?;
    within(&mut chart, scene.study.within, points)?;
    staircase(&mut chart, points)?;
    for (k, series) in outcome.plan.series.iter().enumerate() {
        line(&mut chart, k, &series.name(), points)?;
    }
    // Nothing is both fast and exact: that corner is free.
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerLeft)
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .label_font((FONT, SMALL))
        .draw()?;
    Ok(())
}

fn times(points: &[Point]) -> Decades {
    Decades::around(points.iter().map(|p| p.at.0))
}

fn axis(outcome: &Outcome) -> String {
    match outcome.plan.questions.as_slice() {
        [one] if one.is_absolute() => format!("error of {}", one.title()),
        [one] => format!("relative error of {} [-]", one.title()),
        many => format!("largest relative error of {} questions [-]", many.len()),
    }
}

/// A line at the error that is good enough.
fn within(
    chart: &mut Chart<'_, '_>,
    bound: Option<f64>,
    points: &[Point],
) -> Result<(), Box<dyn Error>> {
    let Some(bound) = bound else { return Ok(()) };
    let range = times(points).range();
    let ends = [(range.start, bound), (range.end, bound)];
    let style = RGBColor(90, 90, 90).stroke_width(1);
    chart
        .draw_series(LineSeries::new(ends, style))?
        .label(format!("within {}", figure(bound)))
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
    Ok(())
}

/// The Pareto front as the edge of what can be had: no variant lies below or left of it.
fn staircase(chart: &mut Chart<'_, '_>, points: &[Point]) -> Result<(), Box<dyn Error>> {
    let mut front: Vec<(f64, f64)> = points.iter().filter(|p| p.on_front).map(|p| p.at).collect();
    front.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut corners = Vec::new();
    for pair in front.windows(2) {
        corners.extend([pair[0], (pair[1].0, pair[0].1)]);
    }
    corners.extend(front.last());
    let style = RGBColor(170, 170, 170).stroke_width(3);
    chart
        .draw_series(LineSeries::new(corners, style))?
        .label("Pareto front")
        .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
    Ok(())
}

/// A series: a line, its points with their FRAC, filled on the front, ringed if the fastest within
/// the bound.
fn line<'a, 'b: 'a>(
    chart: &mut Chart<'a, 'b>,
    k: usize,
    name: &str,
    points: &[Point],
) -> Result<(), Box<dyn Error>> {
    let colour = COLOURS[k % COLOURS.len()];
    let own: Vec<&Point> = points.iter().filter(|p| p.series == k).collect();
    chart
        .draw_series(LineSeries::new(
            own.iter().map(|p| p.at),
            colour.stroke_width(1),
        ))?
        .label(name)
        .legend(move |(x, y)| {
            EmptyElement::at((x, y))
                + PathElement::new([(0, 0), (18, 0)], colour.stroke_width(1))
                + Circle::new((9, 0), 4, colour.filled())
        });
    let label = (FONT, SMALL)
        .into_font()
        .color(&colour)
        .pos(Pos::new(HPos::Left, VPos::Bottom));
    for point in own {
        let fill = if point.on_front { colour } else { WHITE };
        let ring = if point.fastest { 9 } else { 0 };
        chart.draw_series(std::iter::once(
            EmptyElement::at(point.at)
                + Circle::new((0, 0), 4, fill.filled())
                + Circle::new((0, 0), 4, colour.stroke_width(1))
                + Circle::new((0, 0), ring, colour.stroke_width(2))
                + Text::new(rough(point.frac), (8, -6), label.clone()),
        ))?;
    }
    Ok(())
}
