//! Directions of contact normals, plain and weighted by normal force.

use std::f64::consts::{PI, TAU};

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::Pane;
use crate::measure::fabric::Fabric;
use crate::measure::rose;
use crate::measure::tensor::Principal;
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

/// A distribution of directions, ready to be drawn.
#[derive(Debug, Clone, PartialEq)]
struct Rose {
    /// Weight of each petal; they are centred on multiples of their width, from 0 to 180 degrees.
    petals: Vec<f64>,
    /// Contacts counted.
    count: f64,
    /// Difference of the principal values of the mean of n n, 0 to 1.
    anisotropy: f64,
    /// Direction of the larger one [degrees].
    direction: f64,
}

impl Rose {
    fn of((rose, fabric): &(rose::Rose, Fabric), weighted: bool) -> Self {
        let (petals, tensor) = if weighted {
            (&rose.force, &fabric.weighted)
        } else {
            (&rose.contacts, &fabric.plain)
        };
        let principal = Principal::of(tensor);
        Self {
            petals: petals.clone(),
            count: fabric.contacts,
            anisotropy: principal.major - principal.minor,
            direction: principal.angle,
        }
    }

    fn mean(&self) -> f64 {
        self.petals.iter().sum::<f64>() / self.petals.len() as f64
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

fn draw(app: &App, weighted: bool, area: Rect, buffer: &mut Buffer) {
    let Some(frame) = &app.frame else {
        return;
    };
    let rose = frame
        .directions
        .as_ref()
        .map(|directions| Rose::of(directions, weighted));
    let Some(rose) = rose.filter(|rose| rose.count > 0.0 && rose.mean() > 0.0) else {
        write::at(
            &app.look,
            (area, buffer),
            (0, 0),
            "no contacts",
            Role::Label,
        );
        return;
    };
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
    let short = format!("anisotropy {:.3}", rose.anisotropy);
    let middle = format!("{short} at {:.0} deg", rose.direction);
    let long = format!("{} contacts, {middle}", rose.count);
    [long, middle, short]
        .into_iter()
        .find(|text| text.len() <= width)
        .unwrap_or_else(|| format!("{:.3}", rose.anisotropy))
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

fn write_table(app: &App, rose: &Rose, weighted: bool, area: Rect, buffer: &mut Buffer) {
    let mut lines = write::Lines::new(&app.look, area, buffer);
    let what = if weighted { "N" } else { "contacts" };
    lines.line(&format!("degrees   {what:>10}   share"), Role::Label);
    let total = rose.mean() * rose.petals.len() as f64;
    for (k, value) in rose.petals.iter().enumerate() {
        let number = if weighted {
            short(*value)
        } else {
            format!("{value:.0}")
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
        let one = Rose::of(&directions(&[(3, 1.0), (3, 5.0)]), false);
        // Rounding of sines only.
        assert!((one.anisotropy - 1.0).abs() < 1e-12 && (one.direction - 30.0).abs() < 1e-9);
        assert_eq!((one.petals[3], one.count), (2.0, 2.0));
        let three = Rose::of(&directions(&[(0, 1.0), (6, 1.0), (12, 1.0)]), true);
        assert!(three.anisotropy < 1e-12);
        let heavy = Rose::of(&directions(&[(0, 3.0), (9, 1.0)]), true);
        assert!((heavy.anisotropy - 0.5).abs() < 1e-12);
        assert_eq!((heavy.petals[0], heavy.petals[9]), (3.0, 1.0));
    }
}
