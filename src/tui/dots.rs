//! A grid of dots on character cells: what pictures are drawn on.
//!
//! Braille has two by four dots in a cell, half blocks one by two, ASCII one. A cell has one ink:
//! the strongest that was put into it, whatever the order, so that pictures do not flicker. Shapes
//! are clipped first; their cost grows with what is seen of them.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::look::{Look, Points, Role};

/// What dots are drawn with, weakest first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Ink {
    /// Help lines.
    Guide,
    /// Outlines of discs.
    Disc,
    /// Walls and driven discs.
    Wall,
    /// A second curve.
    SecondCurve,
    /// Curves.
    Curve,
    /// Force bars of class 1 (weakest) to 4.
    Force(u8),
    /// Velocities.
    Velocity,
    /// What is selected.
    Selected,
}

impl Ink {
    fn role(self) -> Role {
        match self {
            Self::Guide => Role::Frame,
            Self::Disc => Role::Disc,
            Self::Wall => Role::Wall,
            Self::SecondCurve => Role::SecondCurve,
            Self::Curve => Role::Curve,
            Self::Force(class) => Role::Force(class),
            Self::Velocity => Role::Velocity,
            Self::Selected => Role::Selected,
        }
    }

    /// What stands for it where characters are the only dots.
    pub fn character(self) -> char {
        match self {
            Self::Guide => '.',
            Self::Disc => 'o',
            Self::Wall => '#',
            Self::SecondCurve => '+',
            Self::Curve => '*',
            Self::Force(1) => '-',
            Self::Force(2) => '=',
            Self::Force(3) => '%',
            Self::Force(_) => '@',
            Self::Velocity => '~',
            Self::Selected => '$',
        }
    }
}

/// The grid. Dot (0, 0) is at the upper left.
#[derive(Debug)]
pub struct Dots {
    points: Points,
    /// Cells across and down.
    cells: [usize; 2],
    /// Dots across and down.
    size: [usize; 2],
    /// Bits of each cell and its ink.
    grid: Vec<(u8, Ink)>,
}

impl Dots {
    /// An empty grid on so many cells.
    pub fn new(points: Points, width: u16, height: u16) -> Self {
        let cells = [usize::from(width), usize::from(height)];
        let [across, down] = per_cell(points);
        Self {
            points,
            cells,
            size: [cells[0] * across, cells[1] * down],
            grid: vec![(0, Ink::Guide); cells[0] * cells[1]],
        }
    }

    /// Dots across and down.
    pub fn size(&self) -> [usize; 2] {
        self.size
    }

    /// Height of a dot over its width, in cells twice as high as wide.
    pub fn aspect(&self) -> f64 {
        if self.points == Points::Ascii {
            2.0
        } else {
            1.0
        }
    }

    /// Puts a dot, if it is on the grid.
    pub fn dot(&mut self, x: i64, y: i64, ink: Ink) {
        let (Ok(x), Ok(y)) = (usize::try_from(x), usize::try_from(y)) else {
            return;
        };
        if x >= self.size[0] || y >= self.size[1] {
            return;
        }
        let [across, down] = per_cell(self.points);
        let cell = &mut self.grid[y / down * self.cells[0] + x / across];
        cell.0 |= bit(self.points, x % across, y % down);
        cell.1 = cell.1.max(ink);
    }

    /// A line between two points, in dots.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], ink: Ink) {
        self.bar(from, to, 1, ink);
    }

    /// A dotted line: one dot in three, or in two where dots are large.
    pub fn dotted(&mut self, from: [f64; 2], to: [f64; 2], ink: Ink) {
        let limits = self.size.map(|n| n as f64);
        let Some([a, b]) = clipped(from, to, 0.0, limits) else {
            return;
        };
        let d = [b[0] - a[0], b[1] - a[1]];
        let period = if self.points == Points::Braille {
            3.0
        } else {
            2.0
        };
        let steps = (d[0].abs().max(d[1].abs()) / period).floor().max(1.0) as i64;
        for step in 0..=steps {
            let s = step as f64 / steps as f64;
            let [x, y] = [0, 1].map(|k| (a[k] + s * d[k]).floor() as i64);
            self.dot(x, y, ink);
        }
    }

    /// A line so many dots wide.
    pub fn bar(&mut self, from: [f64; 2], to: [f64; 2], width: u8, ink: Ink) {
        let margin = 8.0;
        let limits = self.size.map(|n| n as f64 + margin);
        let Some([a, b]) = clipped(from, to, -margin, limits) else {
            return;
        };
        let d = [b[0] - a[0], b[1] - a[1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let major = usize::from(d[1].abs() > d[0].abs());
        let span = d[major].abs();
        // Copies side by side along the other axis; a sloping bar needs more of them.
        let copies = if span > 0.0 {
            (f64::from(width) * length / span).round() as i64
        } else {
            i64::from(width)
        };
        let steps = span.ceil().max(1.0) as i64;
        for step in 0..=steps {
            let s = step as f64 / steps as f64;
            let p = [a[0] + s * d[0], a[1] + s * d[1]];
            let first = p[1 - major] - 0.5 * (copies - 1) as f64;
            for copy in 0..copies {
                let across = first + copy as f64;
                let [x, y] = if major == 0 {
                    [p[0], across]
                } else {
                    [across, p[1]]
                };
                self.dot(x.floor() as i64, y.floor() as i64, ink);
            }
        }
    }

    /// The outline of a disc; radii along and across, in dots. Walks over the columns where the
    /// outline is flat and over the rows where it is steep, as far as they are on the grid.
    pub fn circle(&mut self, centre: [f64; 2], radii: [f64; 2], ink: Ink) {
        if !centre.iter().chain(&radii).all(|v| v.is_finite()) || !self.sees(centre, radii) {
            return;
        }
        if radii[0] < 0.75 {
            self.dot(centre[0].floor() as i64, centre[1].floor() as i64, ink);
            return;
        }
        let diagonal = (radii[0] * radii[0] + radii[1] * radii[1]).sqrt();
        for walk in 0..2 {
            let other = 1 - walk;
            let reach = radii[walk] * radii[walk] / diagonal;
            let last = self.size[walk] as f64 - 1.0;
            let from = (centre[walk] - reach).floor().max(0.0) as i64;
            let to = (centre[walk] + reach).floor().min(last) as i64;
            for at in from..=to {
                let d = ((at as f64 + 0.5 - centre[walk]) / radii[walk]).clamp(-1.0, 1.0);
                let h = radii[other] * (1.0 - d * d).sqrt();
                for side in [centre[other] - h, centre[other] + h] {
                    let side = side.floor() as i64;
                    let [x, y] = if walk == 0 { [at, side] } else { [side, at] };
                    self.dot(x, y, ink);
                }
            }
        }
    }

    /// Whether any of a disc is on the grid.
    pub fn sees(&self, centre: [f64; 2], radii: [f64; 2]) -> bool {
        (0..2).all(|k| centre[k] + radii[k] >= 0.0 && centre[k] - radii[k] <= self.size[k] as f64)
    }

    /// Writes the cells that have dots; the others are left as they are.
    pub fn paint(&self, look: &Look, area: Rect, buffer: &mut Buffer) {
        for (k, &(bits, ink)) in self.grid.iter().enumerate().filter(|(_, cell)| cell.0 != 0) {
            let x = area.x + (k % self.cells[0]) as u16;
            let y = area.y + (k / self.cells[0]) as u16;
            let character = match self.points {
                Points::Braille => char::from_u32(0x2800 + u32::from(bits)).unwrap_or(' '),
                Points::HalfBlock => [' ', '▀', '▄', '█'][usize::from(bits & 3)],
                Points::Ascii => ink.character(),
            };
            if let Some(cell) = buffer.cell_mut((x, y)) {
                cell.set_char(character).set_style(look.style(ink.role()));
            }
        }
    }
}

/// Dots across and down in a cell.
pub fn per_cell(points: Points) -> [usize; 2] {
    match points {
        Points::Braille => [2, 4],
        Points::HalfBlock => [1, 2],
        Points::Ascii => [1, 1],
    }
}

/// Bit of a dot within its cell.
fn bit(points: Points, x: usize, y: usize) -> u8 {
    match points {
        // Unicode numbers the lowest row last.
        Points::Braille if y == 3 => 0x40 << x,
        Points::Braille => 1 << (y + 3 * x),
        Points::HalfBlock => 1 << y,
        Points::Ascii => 1,
    }
}

/// The part of a line inside a box, by Liang and Barsky; `None` if there is none.
fn clipped(from: [f64; 2], to: [f64; 2], low: f64, high: [f64; 2]) -> Option<[[f64; 2]; 2]> {
    let d = [to[0] - from[0], to[1] - from[1]];
    if !from.iter().chain(&d).all(|v| v.is_finite()) {
        return None;
    }
    let (mut enter, mut leave) = (0.0f64, 1.0f64);
    for k in 0..2 {
        if d[k] == 0.0 {
            if from[k] < low || from[k] > high[k] {
                return None;
            }
            continue;
        }
        let (s, t) = ((low - from[k]) / d[k], (high[k] - from[k]) / d[k]);
        enter = enter.max(s.min(t));
        leave = leave.min(s.max(t));
    }
    let at = |s: f64| [0, 1].map(|k| (from[k] + s * d[k]).clamp(low, high[k]));
    (enter <= leave).then(|| [at(enter), at(leave)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::look::{Chains, Compared, Theme};
    use proptest::prelude::*;

    fn text(dots: &Dots) -> Vec<String> {
        let look = Look {
            theme: Theme::Mono,
            points: dots.points,
            chains: Chains::Off,
            discs: true,
            velocities: false,
            compared: Compared::Off,
        };
        let area = Rect::new(0, 0, dots.cells[0] as u16, dots.cells[1] as u16);
        let mut buffer = Buffer::empty(area);
        dots.paint(&look, area, &mut buffer);
        let rows = buffer.content().chunks(dots.cells[0]);
        rows.map(|row| row.iter().map(ratatui::buffer::Cell::symbol).collect())
            .collect()
    }

    #[test]
    fn dots_fill_their_cells() {
        for (points, full) in [
            (Points::Braille, "⣿⣿"),
            (Points::HalfBlock, "██"),
            (Points::Ascii, "oo"),
        ] {
            let mut dots = Dots::new(points, 2, 1);
            let [across, down] = dots.size().map(|n| n as u32);
            for y in 0..i64::from(down) {
                for x in 0..i64::from(across) {
                    dots.dot(x, y, Ink::Disc);
                }
            }
            assert_eq!(text(&dots), [full]);
        }
    }

    #[test]
    fn a_circle_is_round_and_closed() {
        let mut dots = Dots::new(Points::Braille, 6, 3);
        dots.circle([6.0, 6.0], [5.0, 5.0], Ink::Disc);
        assert_eq!(text(&dots), ["⢀⠔⠒⠒⠢⡀", "⢸    ⡇", "⠈⠢⠤⠤⠔⠁"]);
    }

    #[test]
    fn bars_are_as_wide_as_asked() {
        for width in 1..=4u8 {
            let mut dots = Dots::new(Points::Braille, 8, 4);
            dots.bar([8.0, 2.0], [8.0, 14.0], width, Ink::Force(width));
            let set: u32 = dots.grid.iter().map(|(bits, _)| bits.count_ones()).sum();
            // Thirteen rows, both ends included.
            assert_eq!(set, 13 * u32::from(width));
        }
    }

    #[test]
    fn the_strongest_ink_stays() {
        let mut dots = Dots::new(Points::Ascii, 1, 1);
        dots.dot(0, 0, Ink::Force(4));
        dots.dot(0, 0, Ink::Force(2));
        dots.dot(0, 0, Ink::Disc);
        assert_eq!(text(&dots), ["@"]);
    }

    proptest! {
        #[test]
        fn nothing_is_too_large_or_undefined(
            a in prop::array::uniform2(any::<f64>()),
            b in prop::array::uniform2(any::<f64>()),
            width in 0u8..5,
            cells in (0u16..9, 0u16..9),
        ) {
            for points in [Points::Braille, Points::HalfBlock, Points::Ascii] {
                let mut dots = Dots::new(points, cells.0, cells.1);
                dots.bar(a, b, width, Ink::Disc);
                dots.circle(a, b, Ink::Disc);
                dots.circle(a, b.map(f64::abs), Ink::Disc);
            }
        }
    }
}
