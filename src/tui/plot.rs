//! A small plot of one quantity over another: axes with round ends, curves, marks.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::dots::{Dots, Ink};
use super::look::{Look, Points, Role};
use super::scale::Scale;
use super::write;

/// What stands around a plot.
pub struct Axes<'a> {
    /// What is drawn over what. What follows two blanks is left out where there is no room.
    pub title: &'a str,
    /// Smallest and largest value along and up.
    pub ranges: [(f64, f64); 2],
    /// Whether the line below holds the numbers of the axis.
    pub foot: bool,
}

/// A plot being drawn.
pub struct Plot {
    body: Rect,
    dots: Dots,
    scales: [Scale; 2],
}

impl Plot {
    /// Writes title and axes into an area; `None` where there is no room for a curve.
    pub fn new(look: &Look, axes: &Axes<'_>, area: Rect, buffer: &mut Buffer) -> Option<Self> {
        let title = write::fitting(axes.title, usize::from(area.width));
        write::at(look, (area, &mut *buffer), (0, 0), title, Role::Label);
        if area.height < 3 || area.width < 8 {
            return None;
        }
        let [along, up] = axes.ranges;
        // With one step only, an axis from -1 to 1 would reach from -2 to 2.
        let steps = |room: u16| usize::from(room).clamp(2, 6);
        let y = Scale::over(up.0, up.1, steps(area.height / 3));
        let x = Scale::over(along.0, along.1, steps(area.width / 12));
        let labels = y.ticks();
        let widest = labels.iter().map(|(_, label)| label.len()).max();
        let widest = widest.unwrap_or(0) as u16;
        // The curve has priority over its numbers.
        let gutter = if area.width >= 3 * (widest + 1) {
            widest + 1
        } else {
            0
        };
        let foot = u16::from(axes.foot && area.height >= 5);
        let body = Rect {
            x: area.x + gutter,
            y: area.y + 1,
            width: area.width - gutter,
            height: area.height - 1 - foot,
        };
        let rows = f64::from(body.height.max(1) - 1);
        for (value, label) in labels.iter().filter(|_| gutter > 0) {
            let row = 1.0 + (1.0 - y.place(*value)) * rows;
            let column = (gutter - 1).saturating_sub(label.len() as u16);
            let place = (column, row.round() as u16);
            write::at(look, (area, &mut *buffer), place, label, Role::Label);
        }
        let bar = if look.points == Points::Ascii {
            "|"
        } else {
            "│"
        };
        for row in 0..if gutter > 0 { body.height } else { 0 } {
            let place = (gutter - 1, row + 1);
            write::at(look, (area, &mut *buffer), place, bar, Role::Frame);
        }
        let dots = Dots::new(look.points, body.width, body.height);
        let mut plot = Self {
            body,
            dots,
            scales: [x, y],
        };
        if foot > 0 {
            plot.write_ends(*look, buffer);
        }
        plot.draw_zeros();
        Some(plot)
    }

    /// Where curves are.
    pub fn body(&self) -> Rect {
        self.body
    }

    /// The value along that a column of the body stands for.
    pub fn along(&self, column: u16) -> f64 {
        let scale = &self.scales[0];
        let share = (f64::from(column) + 0.5) / f64::from(self.body.width.max(1));
        scale.low + share * (scale.high - scale.low)
    }

    fn at(&self, point: (f64, f64)) -> [f64; 2] {
        let [across, down] = self.dots.size().map(|n| n.max(1) as f64 - 1.0);
        let [x, y] = &self.scales;
        [
            x.place(point.0) * across + 0.5,
            (1.0 - y.place(point.1)) * down + 0.5,
        ]
    }

    /// Both ends of the axis below.
    fn write_ends(&self, look: Look, buffer: &mut Buffer) {
        let line = Rect {
            y: self.body.bottom(),
            height: 1,
            ..self.body
        };
        let ticks = self.scales[0].ticks();
        let (Some((_, first)), Some((_, last))) = (ticks.first(), ticks.last()) else {
            return;
        };
        let end = usize::from(line.width).saturating_sub(last.len());
        write::at(
            &look,
            (line, &mut *buffer),
            (end as u16, 0),
            last,
            Role::Label,
        );
        if first.len() < end {
            write::at(&look, (line, buffer), (0, 0), first, Role::Label);
        }
    }

    /// Dotted lines where either quantity is zero.
    fn draw_zeros(&mut self) {
        let size = self.dots.size();
        let [x, y] = self.at((0.0, 0.0)).map(|place| place.floor() as i64);
        for step in (0..size[0] as i64).step_by(3) {
            self.dots.dot(step, y, Ink::Guide);
        }
        for step in (0..size[1] as i64).step_by(3) {
            self.dots.dot(x, step, Ink::Guide);
        }
    }

    /// A curve through points; those without a place interrupt it.
    pub fn curve(&mut self, points: impl Iterator<Item = (f64, f64)>, ink: Ink) {
        let mut before: Option<[f64; 2]> = None;
        for point in points {
            let here = self.at(point);
            if !here.iter().all(|place| place.is_finite()) {
                before = None;
                continue;
            }
            self.dots.line(before.unwrap_or(here), here, ink);
            before = Some(here);
        }
    }

    /// A dotted line between two points.
    pub fn dotted(&mut self, from: (f64, f64), to: (f64, f64)) {
        self.dots.dotted(self.at(from), self.at(to), Ink::Guide);
    }

    /// A filled column from zero up, a dot apart from its neighbours where they are wide enough.
    pub fn column(&mut self, (from, to): (f64, f64), height: f64, ink: Ink) {
        let (low, high) = (self.at((from, 0.0)), self.at((to, height)));
        if !low.iter().chain(&high).all(|place| place.is_finite()) || height <= 0.0 {
            return;
        }
        let [left, right] = [low[0], high[0]].map(|x| x.round() as i64);
        let gap = i64::from(right - left >= 3);
        let [top, foot] = [high[1], low[1]].map(|y| y.floor() as i64);
        for x in left..(right - gap).max(left + 1) {
            for y in top..=foot {
                self.dots.dot(x, y, ink);
            }
        }
    }

    /// A point that stands out.
    pub fn mark(&mut self, point: (f64, f64)) {
        let [x, y] = self.at(point);
        if x.is_finite() && y.is_finite() {
            self.dots
                .dot(x.floor() as i64, y.floor() as i64, Ink::Selected);
        }
    }

    /// Writes the curves.
    pub fn paint(self, look: &Look, buffer: &mut Buffer) {
        self.dots.paint(look, self.body, buffer);
    }
}
