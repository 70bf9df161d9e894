//! The stress path: deviator stress over mean stress, where it has been and where it is.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::survey::Part;
use crate::session::frames::{ChartRow, Wants};
use crate::tui::app::App;
use crate::tui::dots::Ink;
use crate::tui::look::Role;
use crate::tui::plot::{Axes, Plot};
use crate::tui::scale::short;
use crate::tui::trail::StressPoint;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "stress path",
    summary: "s1-s2 over mean stress, the present stage as a full curve; the dotted ray is equal \
              mobilised friction",
    title,
    draw,
    wants,
    ..Pane::PLAIN
};

/// How a row of the history tells mean and deviator stress.
#[derive(Debug, Clone, Copy)]
enum Recorded {
    /// Places of isotropic and deviator stress.
    Deviator(usize, usize),
    /// Places of isotropic stress and sin φ.
    Friction(usize, usize),
}

impl Recorded {
    fn of(app: &App) -> Option<Self> {
        let place = |name| app.series.position(name);
        let mean = place("isotropic_stress")?;
        let deviator = place("deviator_stress").map(|second| Self::Deviator(mean, second));
        deviator.or_else(|| Some(Self::Friction(mean, place("sin_phi")?)))
    }

    fn point(self, row: &ChartRow) -> StressPoint {
        let value = |place: usize| row.values.get(place).copied().unwrap_or(f64::NAN);
        let at = match self {
            Self::Deviator(mean, deviator) => (value(mean), value(deviator)),
            Self::Friction(mean, sine) => (value(mean), 2.0 * value(mean) * value(sine)),
        };
        StressPoint {
            cycle: row.cycle,
            stage: row.stage,
            at,
        }
    }
}

fn wants(app: &App, _: PaneId, wants: &mut Wants) {
    if Recorded::of(app).is_none() {
        wants.survey = wants.survey.with(Part::Tensors);
    }
}

/// All points that have a place.
fn points(app: &App) -> Vec<StressPoint> {
    let found: Vec<StressPoint> = match Recorded::of(app) {
        Some(recorded) => app
            .series
            .rows()
            .iter()
            .map(|row| recorded.point(row))
            .collect(),
        None => app.trail.points().to_vec(),
    };
    let has_place = |point: &StressPoint| point.at.0.is_finite() && point.at.1.is_finite();
    found.into_iter().filter(has_place).collect()
}

fn title(app: &App, _: PaneId) -> String {
    let now = points(app)
        .last()
        .map(|point| point.at.1 / (2.0 * point.at.0));
    match now.filter(|sine| sine.is_finite()) {
        Some(sine) => format!("stress path [Pa]  sin phi {sine:.3}"),
        None => "stress path [Pa]".into(),
    }
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let points = points(app);
    let Some(now) = points.last() else {
        let text = "no stress yet; it is drawn from the history if isotropic_stress and \
                    deviator_stress are recorded, else from frames";
        return Lines::new(&app.look, area, buffer).text(text, Role::Label);
    };
    if points.iter().all(|point| point.at == (0.0, 0.0)) {
        return Lines::new(&app.look, area, buffer).text("no stress yet", Role::Label);
    }
    let foot = u16::from(area.height >= 6);
    if foot > 0 {
        let text = foot_text(app, &points);
        let text = write::fitting(&text, usize::from(area.width));
        let place = (0, area.height - 1);
        write::at(&app.look, (area, &mut *buffer), place, text, Role::Label);
    }
    let body = Rect {
        height: area.height - foot,
        ..area
    };
    let extent = |of: fn(&StressPoint) -> f64| {
        let values = points.iter().map(of);
        values.fold((0.0f64, 0.0f64), |(low, high), x| (low.min(x), high.max(x)))
    };
    let axes = Axes {
        title: "s1-s2 over mean stress (s1+s2)/2",
        ranges: [extent(|point| point.at.0), extent(|point| point.at.1)],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, body, buffer) else {
        return;
    };
    let most = points
        .iter()
        .fold(0.0f64, |most, point| most.max(point.at.0));
    let slope = now.at.1 / now.at.0;
    plot.dotted((0.0, 0.0), (most, slope * most));
    let stages = points.chunk_by(|a, b| a.stage == b.stage);
    let mut before: Option<&StressPoint> = None;
    for stage in stages {
        let ink = if stage[0].stage == now.stage {
            Ink::Curve
        } else {
            Ink::SecondCurve
        };
        let through = before.into_iter().chain(stage).map(|point| point.at);
        plot.curve(through, ink);
        before = stage.last();
    }
    plot.mark(now.at);
    plot.paint(&app.look, buffer);
}

/// Where it stands, and where the points come from.
fn foot_text(app: &App, points: &[StressPoint]) -> String {
    let (Some(first), Some(now)) = (points.first(), points.last()) else {
        return String::new();
    };
    let place = format!("mean {} Pa  s1-s2 {} Pa", short(now.at.0), short(now.at.1));
    if Recorded::of(app).is_some() {
        return place;
    }
    let since = super::status::grouped(first.cycle);
    format!("{place}  not recorded: from frames since cycle {since}")
}
