//! What the pictures have in common: colours, fonts, charts.

use std::error::Error;
use std::ops::Range;

use plotters::coord::Shift;
use plotters::prelude::*;

use crate::session::figure::figure;

pub(crate) const FONT: &str = "sans-serif";
pub(crate) const SMALL: i32 = 13;

/// Colours of several series, in turn, that stay apart for the colour-blind and in grey (Okabe & Ito).
pub(crate) const COLOURS: [RGBColor; 7] = [
    PATH,
    LIMIT,
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    BLACK,
];

/// Blue and vermilion, the first of them.
pub(crate) const PATH: RGBColor = RGBColor(0, 114, 178);
pub(crate) const LIMIT: RGBColor = RGBColor(213, 94, 0);
pub(crate) const FAINT: RGBColor = RGBColor(225, 225, 225);

pub(crate) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Plane =
    Cartesian2d<plotters::coord::types::RangedCoordf64, plotters::coord::types::RangedCoordf64>;
pub(crate) type Chart<'a, 'b> = ChartContext<'a, SVGBackend<'b>, Plane>;
pub(crate) type Drawn = Result<(), Box<dyn Error>>;

/// A range that holds the numbers and zero, with some room around.
pub(crate) fn around(numbers: impl Iterator<Item = f64>) -> Range<f64> {
    let (low, high) = numbers
        .filter(|x| x.is_finite())
        .fold((0.0f64, 0.0f64), |(low, high), x| (low.min(x), high.max(x)));
    let room = 0.06 * (high - low);
    if room > 0.0 {
        let below = if low < 0.0 { low - room } else { 0.0 };
        below..high + room
    } else {
        -1.0..1.0
    }
}

/// A range that holds the numbers with some room around, and zero too unless they all lie far from it
/// for how much they vary.
pub(crate) fn close(numbers: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    /// Zero is this many times their width away.
    const FAR: f64 = 2.0;
    let finite = numbers.clone().filter(|x| x.is_finite());
    let low = finite.clone().fold(f64::INFINITY, f64::min);
    let high = finite.fold(f64::NEG_INFINITY, f64::max);
    let width = high - low;
    if width > 0.0 && low.abs().min(high.abs()) > FAR * width && low * high > 0.0 {
        return low - 0.1 * width..high + 0.1 * width;
    }
    around(numbers)
}

/// Axes with their names; the title may be empty.
pub(crate) fn chart<'a, 'b>(
    area: &'a Area<'b>,
    title: &str,
    (x, y): (Range<f64>, Range<f64>),
    (x_name, y_name): (&str, &str),
) -> Result<Chart<'a, 'b>, Box<dyn Error>> {
    // Ticks count from an end: rounding must not show where they come to zero.
    let (across, up) = (x.end - x.start, y.end - y.start);
    let mut builder = ChartBuilder::on(area);
    if !title.is_empty() {
        builder.caption(title, (FONT, 16));
    }
    let mut chart = builder
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(74)
        .build_cartesian_2d(x, y)?;
    chart
        .configure_mesh()
        .light_line_style(TRANSPARENT)
        .bold_line_style(FAINT)
        .x_labels(6)
        .y_labels(7)
        .x_desc(x_name)
        .y_desc(y_name)
        .x_label_formatter(&|x| tick(*x, across))
        .y_label_formatter(&|y| tick(*y, up))
        .label_style((FONT, SMALL))
        .axis_desc_style((FONT, SMALL + 1))
        .draw()?;
    Ok(chart)
}

/// A tick of an axis of this length, without the digits that its step does not have.
pub(crate) fn tick(x: f64, length: f64) -> String {
    if x.abs() < 1e-9 * length {
        return "0".into();
    }
    // Four digits, and more where the axis is short for how far it is from zero.
    let more = libm::log10(x.abs() / length).clamp(0.0, 9.0) as usize;
    let rounded: f64 = format!("{x:.*e}", 3 + more).parse().unwrap_or(x);
    figure(rounded)
}

/// A whole picture of this size [pixels] under a title.
pub(crate) fn plate(
    size: (u32, u32),
    title: &str,
    draw: impl FnOnce(&Area<'_>) -> Drawn,
) -> Result<String, Box<dyn Error>> {
    let mut text = String::new();
    {
        let root = SVGBackend::with_string(&mut text, size).into_drawing_area();
        root.fill(&WHITE)?;
        let inside = root.titled(title, (FONT, 20))?;
        draw(&inside)?;
        root.present()?;
    }
    Ok(text)
}

/// Ranges in which a unit is as long up as across, around a window that is wanted, for a chart of
/// this area with the margins of [`chart`] and a caption.
pub(crate) fn equal(area: &Area<'_>, [x, y]: [Range<f64>; 2]) -> (Range<f64>, Range<f64>) {
    let (width, height) = area.dim_in_pixel();
    let inner = [
        f64::from(width) - 24.0 - 74.0,
        f64::from(height) - 24.0 - 42.0 - 26.0,
    ];
    let spans = [x.end - x.start, y.end - y.start];
    let unit = (spans[0] / inner[0]).max(spans[1] / inner[1]);
    let widened = |range: Range<f64>, pixels: f64| {
        let middle = 0.5 * (range.start + range.end);
        middle - 0.5 * unit * pixels..middle + 0.5 * unit * pixels
    };
    (widened(x, inner[0]), widened(y, inner[1]))
}
