//! Directions of contact normals, plain and weighted by normal force.

use std::f64::consts::{PI, TAU};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::fabric::Fabric;
use crate::measure::rose;
use crate::measure::survey::Part;
use crate::measure::tensor::Principal;
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::Role;
use crate::tui::scale::short;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "rose",
    summary: "contact normals in 18 directions; the circle is what equal shares would give; ] weights \
              them by normal or tangential force, or takes sliding contacts only",
    title: |app, id| FACES[app.face(id)].into(),
    draw,
    wants: |_, _, wants| wants.survey = wants.survey.with(Part::Directions),
    faces: &FACES,
};

const FACES: [&str; 4] = [
    "contact normals",
    "normals x N  weighted by normal force",
    "normals x |T|  weighted by tangential force",
    "sliding contacts  their normals",
];

/// What the contacts of a rose are weighted by: the place in [`FACES`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Weight {
    One,
    Normal,
    Tangential,
    Sliding,
}

const WEIGHTS: [Weight; 4] = [
    Weight::One,
    Weight::Normal,
    Weight::Tangential,
    Weight::Sliding,
];

impl Weight {
    /// Heading of the column in the table.
    fn word(self) -> &'static str {
        match self {
            Self::One => "contacts",
            Self::Normal => "sum N [N]",
            Self::Tangential => "sum|T| [N]",
            Self::Sliding => "sliding",
        }
    }

    /// Why there is no rose.
    fn none(self) -> &'static str {
        match self {
            Self::One | Self::Normal => "no contacts yet",
            Self::Tangential => "no contact carries a tangential force",
            Self::Sliding => "no contact slides in this cycle",
        }
    }

    fn is_count(self) -> bool {
        matches!(self, Self::One | Self::Sliding)
    }
}

/// A distribution of directions, ready to be drawn.
#[derive(Debug, Clone, PartialEq)]
struct Rose {
    /// Weight of each petal; they are centred on multiples of their width, from 0 to 180 degrees.
    petals: Vec<f64>,
    /// Contacts counted.
    count: f64,
    /// Difference of the principal values of the mean of n n, 0 to 1, and direction of the larger one
    /// [degrees].
    fabric: Option<(f64, f64)>,
}

impl Rose {
    fn of((rose, fabric): &(rose::Rose, Fabric), weight: Weight) -> Self {
        let (petals, tensor) = match weight {
            Weight::One => (&rose.contacts, Some(&fabric.plain)),
            Weight::Normal => (&rose.force, Some(&fabric.weighted)),
            Weight::Tangential => (&rose.shear, Some(&fabric.by_tangential)),
            Weight::Sliding => (&rose.sliding, None),
        };
        let principal = tensor.map(Principal::of);
        Self {
            petals: petals.clone(),
            count: fabric.contacts,
            fabric: principal.map(|principal| (2.0 * principal.radius(), principal.angle)),
        }
    }

    fn is_there(&self) -> bool {
        self.count > 0.0 && self.sum() > 0.0
    }

    fn sum(&self) -> f64 {
        self.petals.iter().sum()
    }

    fn mean(&self) -> f64 {
        self.sum() / self.petals.len() as f64
    }

    /// Width of a petal [rad].
    fn width(&self) -> f64 {
        PI / self.petals.len() as f64
    }
}

/// How many times the mean the outer rim stands for: one of few numbers, so that the picture keeps
/// its size while counts vary.
fn rim(rose: &Rose) -> f64 {
    let most = rose.petals.iter().fold(0.0, |a: f64, b| a.max(*b)) / rose.mean();
    let steps = [1.5, 2.0, 3.0, 4.5, 6.0, 9.0];
    steps.into_iter().find(|step| most <= *step).unwrap_or(18.0)
}

fn draw(app: &App, id: PaneId, area: Rect, buffer: &mut Buffer) {
    let weight = WEIGHTS[app.face(id)];
    let Some(frame) = &app.frame else {
        return;
    };
    let Some(directions) = &frame.survey.directions else {
        return;
    };
    let rose = Rose::of(directions, weight);
    if !rose.is_there() {
        return Lines::new(&app.look, area, buffer).text(weight.none(), Role::Label);
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
        write_table(app, &rose, weight, place, buffer);
    }
}

fn foot_text(rose: &Rose, width: usize) -> String {
    let Some((anisotropy, direction)) = rose.fabric else {
        let short = format!("{} slide", rose.sum());
        let long = format!("{} of {} contacts slide", rose.sum(), rose.count);
        return if long.len() <= width { long } else { short };
    };
    let short = format!("anisotropy {anisotropy:.3}");
    let middle = format!("{short} at {direction:.0} deg");
    let long = format!("{} contacts, {middle}", rose.count);
    [long, middle, short]
        .into_iter()
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("{anisotropy:.3}"))
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
    let (width, petals) = (rose.width(), rose.petals.len());
    for k in 0..2 * petals {
        let r = |k: usize| unit * rose.petals[k % petals];
        let (from, to) = ((k as f64 - 0.5) * width, (k as f64 + 0.5) * width);
        let steps = (r(k) * width).ceil().max(1.0) as usize;
        let arc = |s: usize| at(r(k), from + (to - from) * s as f64 / steps as f64);
        for s in 0..steps {
            dots.line(arc(s), arc(s + 1), Ink::Curve);
        }
        dots.line(at(r(k), to), at(r(k + 1), to), Ink::Curve);
    }
}

fn write_table(app: &App, rose: &Rose, weight: Weight, area: Rect, buffer: &mut Buffer) {
    let mut lines = Lines::new(&app.look, area, buffer);
    let what = weight.word();
    lines.line(&format!("degrees   {what:>10}   share"), Role::Label);
    let total = rose.sum();
    for (k, value) in rose.petals.iter().enumerate() {
        let number = if weight.is_count() {
            value.to_string()
        } else {
            short(*value)
        };
        let share = 100.0 * value / total;
        let middle = k as f64 * rose.width().to_degrees();
        let text = format!("{middle:>7.0}   {number:>10}   {share:4.1} %");
        lines.line(&text, Role::Value);
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Matrix2, Vector2};

    use super::*;

    fn directions(normals: &[(usize, f64)]) -> (rose::Rose, Fabric) {
        let mut rose = rose::Rose {
            contacts: vec![0.0; 18],
            force: vec![0.0; 18],
            shear: vec![0.0; 18],
            sliding: vec![0.0; 18],
        };
        let (mut plain, mut weighted) = (Matrix2::zeros(), Matrix2::zeros());
        let force: f64 = normals.iter().map(|(_, n)| n).sum();
        for &(petal, n) in normals {
            rose.contacts[petal] += 1.0;
            rose.force[petal] += n;
            let angle = (10.0 * petal as f64).to_radians();
            let e = Vector2::new(angle.cos(), angle.sin());
            plain += e * e.transpose() / normals.len() as f64;
            weighted += e * e.transpose() * n / force;
        }
        let contacts = normals.len() as f64;
        (
            rose,
            Fabric {
                plain,
                weighted,
                by_tangential: Matrix2::zeros(),
                contacts,
            },
        )
    }

    #[test]
    fn one_direction_is_wholly_anisotropic_three_are_not() {
        let one = Rose::of(&directions(&[(3, 1.0), (3, 5.0)]), Weight::One);
        // Rounding of sines only.
        let (anisotropy, direction) = one.fabric.unwrap();
        assert!((anisotropy - 1.0).abs() < 1e-12 && (direction - 30.0).abs() < 1e-9);
        assert_eq!((one.petals[3], one.count), (2.0, 2.0));
        let three = Rose::of(
            &directions(&[(0, 1.0), (6, 1.0), (12, 1.0)]),
            Weight::Normal,
        );
        assert!(three.fabric.unwrap().0 < 1e-12);
        let heavy = Rose::of(&directions(&[(0, 3.0), (9, 1.0)]), Weight::Normal);
        assert!((heavy.fabric.unwrap().0 - 0.5).abs() < 1e-12);
        assert_eq!((heavy.petals[0], heavy.petals[9]), (3.0, 1.0));
    }
}
