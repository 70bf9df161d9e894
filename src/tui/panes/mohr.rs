//! The circle of Mohr: normal and shear part of a tensor on planes of every direction.

use nalgebra::Matrix2;
use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::survey::{Part, Tensors};
use crate::measure::tensor::Principal;
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::Role;
use crate::tui::scale::{Scale, short};
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "mohr circle",
    summary: "shear over normal part on planes of every direction; marked is the plane across direction \
              1, the ray touches at the mobilised friction; ] chooses stress, fabric, strain",
    title: |app, id| FACES[app.face(id)].into(),
    draw,
    wants: |_, _, wants| wants.survey = wants.survey.with(Part::Tensors),
    faces: &FACES,
};

const FACES: [&str; 5] = [
    "Mohr circle of stress [Pa]",
    "Mohr circle of fabric [-]",
    "Mohr circle of fabric by N [-]",
    "Mohr circle of fabric by |T| [-]",
    "Mohr circle of strain [-]  since the reference",
];

/// A tensor and how its circle is shown.
struct Shown {
    tensor: Matrix2<f64>,
    /// Letter of its components.
    letter: char,
    /// Whether zero is seen: friction is read against it.
    from_zero: bool,
    /// Said when there is no circle.
    none: &'static str,
}

fn shown(tensors: &Tensors, face: usize) -> Shown {
    let fabric = |tensor: Matrix2<f64>, none| Shown {
        tensor,
        letter: 'F',
        from_zero: false,
        none,
    };
    match face {
        0 => Shown {
            tensor: tensors.stress.total,
            letter: 's',
            from_zero: true,
            none: "no stress yet",
        },
        1 => fabric(tensors.fabric.plain, "no contacts yet"),
        2 => fabric(tensors.fabric.weighted, "no contacts yet"),
        3 => fabric(
            tensors.fabric.by_tangential,
            "no contact carries a tangential force",
        ),
        _ => Shown {
            tensor: tensors
                .strain
                .map_or(Matrix2::from_element(f64::NAN), |strain| strain.tensor),
            letter: 'e',
            from_zero: true,
            none: "no strain yet: it takes three particles that were there at the reference",
        },
    }
}

fn draw(app: &App, id: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(tensors) = app.frame.as_ref().and_then(|frame| frame.survey.tensors) else {
        return;
    };
    let shown = shown(&tensors, app.face(id));
    let circle = Principal::of(&shown.tensor);
    let is_there = circle.major.is_finite() && circle.minor.is_finite();
    if !is_there || shown.tensor.iter().all(|part| *part == 0.0) {
        return Lines::new(&app.look, area, buffer).text(shown.none, Role::Label);
    }
    let is_stress = app.face(id) == 0;
    let table = area.width >= 70 && area.height >= 9;
    let foot = u16::from(area.height >= 5 && !table);
    let body = Rect {
        width: area.width - if table { 30 } else { 0 },
        height: area.height - foot,
        ..area
    };
    draw_circle(app, &shown, &circle, is_stress, body, buffer);
    if foot > 0 {
        let text = foot_text(&shown, &circle, is_stress);
        let text = write::fitting(&text, usize::from(area.width));
        let place = (0, area.height - 1);
        write::at(&app.look, (area, &mut *buffer), place, text, Role::Label);
    }
    if table {
        let place = Rect {
            x: body.right() + 1,
            width: 29,
            ..area
        };
        write_table(app, &shown, &circle, is_stress, place, buffer);
    }
}

/// Values to dots, as many across as down.
struct Map {
    scale: Scale,
    /// Dots per unit along.
    unit: f64,
    /// Dot of the lower end, and of no shear.
    start: [f64; 2],
    aspect: f64,
}

impl Map {
    fn new(shown: &Shown, circle: &Principal, dots: &Dots) -> Self {
        let [across, down] = dots.size().map(|n| n.max(1) as f64);
        let aspect = dots.aspect();
        let (low, high) = if shown.from_zero {
            (circle.minor.min(0.0), circle.major.max(0.0))
        } else {
            // A few widths only, so that the picture stands while the circle breathes.
            let half = [0.05, 0.1, 0.2, 0.5]
                .into_iter()
                .find(|half| *half >= circle.radius());
            let half = half.unwrap_or(1.0);
            (circle.centre() - half, circle.centre() + half)
        };
        let scale = Scale::over(low, high, 4);
        let span = scale.high - scale.low;
        let by_height = (down - 1.0) * aspect / (2.0 * circle.radius());
        let unit = ((across - 1.0) / span).min(by_height);
        Self {
            scale,
            unit,
            start: [0.5 * (across - span * unit), 0.5 * down],
            aspect,
        }
    }

    fn at(&self, normal: f64, shear: f64) -> [f64; 2] {
        [
            self.start[0] + (normal - self.scale.low) * self.unit,
            self.start[1] - shear * self.unit / self.aspect,
        ]
    }
}

fn draw_circle(
    app: &App,
    shown: &Shown,
    circle: &Principal,
    is_stress: bool,
    area: Rect,
    buffer: &mut Buffer,
) {
    let line = u16::from(area.height >= 3);
    let body = Rect {
        height: area.height - line,
        ..area
    };
    let mut dots = Dots::new(app.look.points, body.width, body.height);
    let map = Map::new(shown, circle, &dots);
    let ends = [map.scale.low, map.scale.high].map(|end| map.at(end, 0.0));
    dots.dotted(ends[0], ends[1], Ink::Guide);
    if map.scale.low <= 0.0 && map.scale.high >= 0.0 {
        let reach = circle.radius();
        dots.dotted(map.at(0.0, -reach), map.at(0.0, reach), Ink::Guide);
    }
    let sine = circle.radius() / circle.centre();
    if is_stress && (0.0..1.0).contains(&sine) {
        let cosine = (1.0 - sine * sine).sqrt();
        for side in [1.0, -1.0] {
            let touch = map.at(
                circle.centre() - circle.radius() * sine,
                side * circle.radius() * cosine,
            );
            dots.dotted(map.at(0.0, 0.0), touch, Ink::Guide);
        }
    }
    let size = circle.radius() * map.unit;
    dots.circle(
        map.at(circle.centre(), 0.0),
        [size, size / map.aspect],
        Ink::Curve,
    );
    let t = &shown.tensor;
    let shear = 0.5 * (t[(0, 1)] + t[(1, 0)]);
    let [one, two] = [map.at(t[(0, 0)], shear), map.at(t[(1, 1)], -shear)];
    dots.line(one, two, Ink::SecondCurve);
    dots.dot(one[0].floor() as i64, one[1].floor() as i64, Ink::Selected);
    dots.paint(&app.look, body, buffer);
    if line > 0 {
        write_ends(app, &map, &ends, (area, buffer));
    }
}

/// The ends of the axis below them.
fn write_ends(app: &App, map: &Map, ends: &[[f64; 2]; 2], (area, buffer): (Rect, &mut Buffer)) {
    let across = crate::tui::dots::per_cell(app.look.points)[0] as f64;
    let ticks = map.scale.ticks();
    let (Some((_, first)), Some((_, last))) = (ticks.first(), ticks.last()) else {
        return;
    };
    let [from, to] = ends.map(|end| (end[0] / across).clamp(0.0, f64::from(area.width)));
    let row = area.height - 1;
    let last_at = (to as u16).saturating_sub(last.len() as u16);
    write::at(
        &app.look,
        (area, &mut *buffer),
        (last_at, row),
        last,
        Role::Label,
    );
    if from as u16 + (first.len() as u16) < last_at {
        write::at(
            &app.look,
            (area, buffer),
            (from as u16, row),
            first,
            Role::Label,
        );
    }
}

/// Sine of the mobilised friction, where that means something.
fn sin_phi(circle: &Principal) -> f64 {
    circle.radius() / circle.centre()
}

fn foot_text(shown: &Shown, circle: &Principal, is_stress: bool) -> String {
    let letter = shown.letter;
    let [major, minor] = [circle.major, circle.minor].map(short);
    let values = format!("{letter}1 {major}  {letter}2 {minor}");
    let direction = if circle.angle.is_finite() {
        format!("1 at {:.0} deg", circle.angle)
    } else {
        "alike in all directions".to_owned()
    };
    if is_stress {
        format!("sin phi {:.3}  {values}  {direction}", sin_phi(circle))
    } else {
        format!("{values}  {direction}")
    }
}

fn write_table(
    app: &App,
    shown: &Shown,
    circle: &Principal,
    is_stress: bool,
    area: Rect,
    buffer: &mut Buffer,
) {
    let mut lines = Lines::new(&app.look, area, buffer);
    let letter = shown.letter;
    let mut row = |name: &str, value: &str| {
        lines.parts(&[
            (&format!("{name:14}"), Role::Label),
            (&format!("{value:>12}"), Role::Value),
        ]);
    };
    for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let name = format!("{letter}{}{}", i + 1, j + 1);
        row(&name, &short(shown.tensor[(i, j)]));
    }
    row("major", &short(circle.major));
    row("minor", &short(circle.minor));
    row("direction [deg]", &format!("{:>11.1}", circle.angle));
    row("centre", &short(circle.centre()));
    row("radius", &short(circle.radius()));
    if is_stress {
        row("sin phi", &format!("{:.4}", sin_phi(circle)));
    }
    if lines.left() >= 5 {
        lines.line("", Role::Label);
        let text = "marked: the plane across direction 1, opposite the one across 2; turned by an \
                    angle, a plane lies twice as far round";
        lines.text(text, Role::Label);
    }
}
