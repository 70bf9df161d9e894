//! Directions of contact normals, plain and weighted by normal force.

use std::f64::consts::{PI, TAU};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::Pane;
use crate::measure::frame::Touch;
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::Role;
use crate::tui::scale::short;
use crate::tui::write;

/// The pane.
pub const PANE: Pane = Pane {
    name: "rose",
    summary: "contact normals in 18 directions; the circle is what equal numbers would give",
    title: |_, _| "contact normals".into(),
    draw: |app, _, area, buffer| draw(app, false, area, buffer),
};

/// The same, weighted.
pub const WEIGHTED: Pane = Pane {
    name: "weighted rose",
    summary: "the same, each contact weighted by its normal force",
    title: |_, _| "normals x normal force".into(),
    draw: |app, _, area, buffer| draw(app, true, area, buffer),
};

/// Sectors of 10 degrees over half a turn; a normal has no sense.
const BINS: usize = 18;

/// Distribution of directions.
#[derive(Debug, Clone, PartialEq)]
struct Rose {
    /// Weight of each sector, from 0 to 180 degrees.
    bins: [f64; BINS],
    /// Contacts counted.
    count: usize,
    /// Difference of the principal values of the mean of n n, 0 to 1.
    anisotropy: f64,
    /// Direction of the larger one [degrees].
    direction: f64,
}

impl Rose {
    fn of(touches: &[Touch], weighted: bool) -> Self {
        let mut bins = [0.0; BINS];
        let (mut count, mut total, mut difference, mut product) = (0, 0.0, 0.0, 0.0);
        for touch in touches {
            let [x, y] = touch.normal;
            let weight = if weighted { touch.n } else { 1.0 };
            if !(touch.n > 0.0 && weight.is_finite() && x.is_finite() && y.is_finite()) {
                continue;
            }
            let angle = y.atan2(x).rem_euclid(PI);
            let bin = (angle / PI * BINS as f64) as usize;
            bins[bin.min(BINS - 1)] += weight;
            count += 1;
            total += weight;
            difference += weight * (x * x - y * y);
            product += weight * 2.0 * x * y;
        }
        let size = (difference * difference + product * product).sqrt();
        Self {
            bins,
            count,
            anisotropy: if total > 0.0 { size / total } else { f64::NAN },
            direction: (0.5 * product.atan2(difference))
                .to_degrees()
                .rem_euclid(180.0),
        }
    }

    fn mean(&self) -> f64 {
        self.bins.iter().sum::<f64>() / BINS as f64
    }
}

/// How many times the mean the outer rim stands for: one of few numbers, so that the picture keeps
/// its size while counts vary.
fn rim(rose: &Rose) -> f64 {
    let most = rose.bins.iter().fold(0.0, |a: f64, b| a.max(*b)) / rose.mean();
    let steps = [1.5, 2.0, 3.0, 4.5, 6.0, 9.0];
    steps.into_iter().find(|step| most <= *step).unwrap_or(18.0)
}

fn draw(app: &App, weighted: bool, area: Rect, buffer: &mut Buffer) {
    let Some(frame) = &app.frame else {
        return;
    };
    let rose = Rose::of(&frame.picture.touches, weighted);
    if rose.count == 0 {
        write::at(
            &app.look,
            (area, buffer),
            (0, 0),
            "no contacts",
            Role::Label,
        );
        return;
    }
    let table = area.width >= 70 && area.height >= 12;
    let foot = u16::from(area.height >= 4);
    let body = Rect {
        width: area.width - if table { 30 } else { 0 },
        height: area.height - foot,
        ..area
    };
    let mut dots = Dots::new(app.look.points, body.width, body.height);
    draw_outline(&rose, &mut dots);
    dots.paint(&app.look, body, buffer);
    if foot > 0 {
        let line = Rect {
            y: body.bottom(),
            height: 1,
            ..area
        };
        let text = foot_text(&rose, usize::from(area.width));
        write::at(&app.look, (line, &mut *buffer), (0, 0), &text, Role::Label);
    }
    if table {
        let place = Rect {
            x: body.right(),
            width: 30,
            ..area
        };
        write_table(app, &rose, weighted, place, buffer);
    }
}

fn foot_text(rose: &Rose, width: usize) -> String {
    let anisotropy = format!("a {:.3} at {:.0} deg", rose.anisotropy, rose.direction);
    let long = format!("{} contacts, anisotropy {}", rose.count, &anisotropy[2..]);
    let middle = format!("n {}  {anisotropy}", rose.count);
    [long, middle, anisotropy]
        .into_iter()
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("n {}", rose.count))
}

/// Sectors as steps, and the dotted circle of equal numbers.
fn draw_outline(rose: &Rose, dots: &mut Dots) {
    let [across, down] = dots.size().map(|n| n as f64);
    let aspect = dots.aspect();
    let radius = 0.5 * (across - 1.0).min((down - 1.0) * aspect);
    let unit = radius / (rim(rose) * rose.mean());
    let at = |r: f64, angle: f64| {
        [
            0.5 * across + r * angle.cos(),
            0.5 * down - r * angle.sin() / aspect,
        ]
    };
    let dotted = (TAU * unit * rose.mean() / 3.0).max(8.0) as usize;
    for k in 0..dotted {
        let [x, y] = at(unit * rose.mean(), k as f64 / dotted as f64 * TAU);
        dots.dot(x.floor() as i64, y.floor() as i64, Ink::Guide);
    }
    let width = PI / BINS as f64;
    for k in 0..2 * BINS {
        let r = |k: usize| unit * rose.bins[k % BINS];
        let (from, to) = (k as f64 * width, (k + 1) as f64 * width);
        let steps = (r(k) * width).ceil().max(1.0) as usize;
        let arc = |s: usize| at(r(k), from + (to - from) * s as f64 / steps as f64);
        for s in 0..steps {
            dots.line(arc(s), arc(s + 1), Ink::Curve);
        }
        dots.line(at(r(k), to), at(r(k + 1), to), Ink::Curve);
    }
}

fn write_table(app: &App, rose: &Rose, weighted: bool, area: Rect, buffer: &mut Buffer) {
    let mut lines = write::Lines::new(&app.look, area, buffer);
    let what = if weighted { "N" } else { "contacts" };
    lines.line(&format!("degrees   {what:>10}   share"), Role::Label);
    let total = rose.mean() * BINS as f64;
    for (k, value) in rose.bins.iter().enumerate() {
        let number = if weighted {
            short(*value)
        } else {
            format!("{value:.0}")
        };
        let share = 100.0 * value / total;
        let text = format!(
            "{:>3}-{:<3}   {number:>10}   {share:4.1} %",
            10 * k,
            10 * k + 10
        );
        lines.line(&text, Role::Value);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(degrees: f64, n: f64) -> Touch {
        let angle = degrees.to_radians();
        Touch {
            ends: [[0.0; 2]; 2],
            length: 1.0,
            normal: [angle.cos(), angle.sin()],
            n,
            t: 0.0,
            sliding: false,
            first: 1,
            second: Some(2),
        }
    }

    #[test]
    fn normals_have_no_sense() {
        let there = Rose::of(&[touch(25.0, 1.0), touch(95.0, 2.0)], false);
        let back = Rose::of(&[touch(205.0, 1.0), touch(-85.0, 2.0)], false);
        assert_eq!(there.bins, back.bins);
        assert_eq!((there.bins[2], there.bins[9]), (1.0, 1.0));
    }

    #[test]
    fn one_direction_is_wholly_anisotropic_three_are_not() {
        let one = Rose::of(&[touch(30.0, 1.0), touch(30.0, 5.0)], false);
        // Rounding of sines only.
        assert!((one.anisotropy - 1.0).abs() < 1e-12 && (one.direction - 30.0).abs() < 1e-9);
        let three = Rose::of(
            &[touch(0.0, 1.0), touch(60.0, 1.0), touch(120.0, 1.0)],
            true,
        );
        assert!(three.anisotropy < 1e-12);
        let heavy = Rose::of(&[touch(0.0, 3.0), touch(90.0, 1.0)], true);
        assert!((heavy.anisotropy - 0.5).abs() < 1e-12);
    }

    #[test]
    fn open_contacts_do_not_count() {
        let rose = Rose::of(&[touch(10.0, 0.0), touch(10.0, f64::NAN)], true);
        assert_eq!(rose.count, 0);
        assert!(rose.anisotropy.is_nan());
    }
}
