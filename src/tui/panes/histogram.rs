//! How contacts share out over what they carry: obliquity, normal force, stress on their areas.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::histogram::Histogram;
use crate::measure::obliquity::Obliquity;
use crate::measure::survey::{Part, Survey};
use crate::session::frames::Wants;
use crate::tui::app::App;
use crate::tui::dots::Ink;
use crate::tui::look::Role;
use crate::tui::plot::{Axes, Plot};
use crate::tui::scale::{count, short};
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "histogram",
    summary: "share of the contacts over T/(mu N), normal force or mean normal stress; ] chooses, also \
              the scatter of T/(mu N) over N",
    title: |app, id| FACES[app.face(id)].into(),
    draw,
    wants,
    faces: &FACES,
};

const FACES: [&str; 4] = [
    "obliquity T/(mu N) [-]",
    "normal force N/<N> [-]",
    "contact stress [Pa]  N over area of the contact",
    "T/(mu N) over N/<N> [-]  a dot per contact",
];

/// What is drawn: the place in [`FACES`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Drawing {
    Obliquity,
    Force,
    Stress,
    Scatter,
}

const DRAWINGS: [Drawing; 4] = [
    Drawing::Obliquity,
    Drawing::Force,
    Drawing::Stress,
    Drawing::Scatter,
];

fn wants(app: &App, id: PaneId, wants: &mut Wants) {
    let part = match DRAWINGS[app.face(id)] {
        Drawing::Obliquity | Drawing::Scatter => Part::Obliquity,
        Drawing::Force => Part::NormalForce,
        Drawing::Stress => Part::ContactStress,
    };
    wants.survey = wants.survey.with(part);
}

/// The histogram of a drawing, in its units.
fn histogram(survey: &Survey, drawing: Drawing) -> Option<Histogram> {
    match drawing {
        Drawing::Obliquity => survey.obliquity.as_ref().map(Obliquity::histogram),
        Drawing::Force => survey.normal_force.as_ref().map(over_mean),
        Drawing::Stress => survey.contact_stress.clone(),
        Drawing::Scatter => None,
    }
}

/// The same bars over values in multiples of their mean.
fn over_mean(histogram: &Histogram) -> Histogram {
    Histogram {
        low: histogram.low / histogram.mean,
        high: histogram.high / histogram.mean,
        bars: histogram.bars.clone(),
        mean: 1.0,
        deviation: histogram.deviation / histogram.mean,
    }
}

fn draw(app: &App, id: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(frame) = &app.frame else {
        return;
    };
    let drawing = DRAWINGS[app.face(id)];
    if drawing == Drawing::Scatter {
        if let Some(obliquity) = &frame.survey.obliquity {
            draw_scatter(app, obliquity, area, buffer);
        }
        return;
    }
    let Some(histogram) = histogram(&frame.survey, drawing) else {
        return;
    };
    let count = histogram.count();
    if count.is_nan() || count <= 0.0 {
        return say_none(app, drawing, area, buffer);
    }
    let foot = foot(&frame.survey, &histogram, drawing);
    let body = write_foot(app, &foot, area, buffer);
    draw_bars(app, &histogram, body, buffer);
}

/// Why nothing is drawn.
fn say_none(app: &App, drawing: Drawing, area: Rect, buffer: &mut Buffer) {
    let touches = app
        .frame
        .as_ref()
        .is_some_and(|frame| !frame.picture.touches.is_empty());
    let text = match drawing {
        Drawing::Obliquity | Drawing::Scatter if touches => {
            "no contact has friction: `friction 0.3` gives it to all"
        }
        _ => "no contacts yet",
    };
    Lines::new(&app.look, area, buffer).text(text, Role::Label);
}

/// Numbers that go with the bars; what follows two blanks can be left out.
fn foot(survey: &Survey, histogram: &Histogram, drawing: Drawing) -> String {
    let contacts = count(histogram.count());
    let mean = match (&survey.obliquity, &survey.normal_force, drawing) {
        (Some(obliquity), _, Drawing::Obliquity) => {
            return format!(
                "mean |T|/(mu N) {}  {contacts} contacts with friction",
                short(obliquity.mean())
            );
        }
        (_, Some(force), Drawing::Force) => {
            let (mean, spread) = (short(force.mean), short(force.deviation));
            format!("mean <N> {mean} N  standard deviation {spread} N")
        }
        _ => {
            let (mean, spread) = (short(histogram.mean), short(histogram.deviation));
            format!("mean {mean} Pa  standard deviation {spread} Pa")
        }
    };
    format!("{mean}  {contacts} contacts")
}

/// Writes a line below; answers what is left above.
fn write_foot(app: &App, text: &str, area: Rect, buffer: &mut Buffer) -> Rect {
    let foot = u16::from(area.height >= 5);
    if foot > 0 {
        let text = write::fitting(text, usize::from(area.width));
        let place = (0, area.height - 1);
        write::at(&app.look, (area, buffer), place, text, Role::Label);
    }
    Rect {
        height: area.height - foot,
        ..area
    }
}

fn draw_bars(app: &App, histogram: &Histogram, area: Rect, buffer: &mut Buffer) {
    let total = histogram.count();
    let shares: Vec<f64> = histogram
        .bars
        .iter()
        .map(|bar| 100.0 * bar / total)
        .collect();
    let most = shares.iter().fold(0.0, |most: f64, share| most.max(*share));
    let axes = Axes {
        title: "% of the contacts",
        ranges: [(histogram.low, histogram.high), (0.0, most)],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, area, buffer) else {
        return;
    };
    for (bar, share) in shares.iter().enumerate() {
        let [from, to] = histogram.edges(bar);
        plot.column((from, to), *share, Ink::Curve);
    }
    plot.paint(&app.look, buffer);
}

fn draw_scatter(app: &App, obliquity: &Obliquity, area: Rect, buffer: &mut Buffer) {
    if obliquity.contacts.is_empty() {
        return say_none(app, Drawing::Scatter, area, buffer);
    }
    let mean = short(obliquity.mean());
    let contacts = obliquity.contacts.len();
    let foot = format!("mean |T|/(mu N) {mean}  {contacts} contacts with friction");
    let body = write_foot(app, &foot, area, buffer);
    let forces = obliquity.contacts.iter().map(|[force, ..]| *force);
    let axes = Axes {
        title: "T/(mu N) over N/<N>",
        ranges: [(0.0, forces.fold(0.0, f64::max)), (-1.0, 1.0)],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, body, buffer) else {
        return;
    };
    for [force, share, _] in &obliquity.contacts {
        plot.curve([(*force, *share)].into_iter(), Ink::Curve);
    }
    plot.paint(&app.look, buffer);
}
