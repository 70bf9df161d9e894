//! The polygon of the forces on the selected disc.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::polygon::ForcePolygon;
use crate::tui::app::App;
use crate::tui::dots::{Dots, Ink};
use crate::tui::look::Role;
use crate::tui::scale::short;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "force polygon",
    summary: "forces on the selected disc, head to tail round it; dotted is what is missing to close it",
    title,
    draw,
    wants: |app, _, wants| wants.polygon = app.selected,
    ..Pane::PLAIN
};

fn polygon(app: &App) -> Option<&ForcePolygon> {
    let polygon = app.frame.as_ref()?.polygon.as_ref()?;
    (app.selected == Some(polygon.particle)).then_some(polygon)
}

fn title(app: &App, _: PaneId) -> String {
    match polygon(app) {
        Some(polygon) => format!(
            "forces on disc {} [N]  out of balance {}",
            polygon.particle,
            short(polygon.residual())
        ),
        None => "force polygon [N]".into(),
    }
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(polygon) = polygon(app) else {
        let text = "n and N select a disc";
        return Lines::new(&app.look, area, buffer).text(text, Role::Label);
    };
    if polygon.is_empty() {
        let text = format!("nothing acts on disc {}", polygon.particle);
        return Lines::new(&app.look, area, buffer).text(&text, Role::Label);
    }
    let table = area.width >= 60 && area.height >= 6;
    let body = Rect {
        width: area.width - if table { 34 } else { 0 },
        ..area
    };
    sides(app, polygon, body, buffer);
    if table {
        let place = Rect {
            x: body.right() + 1,
            width: 33,
            ..area
        };
        list(app, polygon, place, buffer);
    }
}

/// The sides, as long across as up.
fn sides(app: &App, polygon: &ForcePolygon, area: Rect, buffer: &mut Buffer) {
    let corners = polygon.corners();
    let mut dots = Dots::new(app.look.points, area.width, area.height);
    let aspect = dots.aspect();
    let [across, down] = dots.size().map(|n| n.max(1) as f64);
    let [low, high] = polygon.bounds();
    let [wide, tall] = [0, 1].map(|k| (high[k] - low[k]).max(f64::MIN_POSITIVE));
    // A dot is left free on every side.
    let unit = ((across - 3.0).max(1.0) / wide).min((down - 3.0).max(1.0) * aspect / tall);
    let middle = [0, 1].map(|k| 0.5 * (low[k] + high[k]));
    let at = |[x, y]: [f64; 2]| {
        [
            0.5 * across + (x - middle[0]) * unit,
            0.5 * down - (y - middle[1]) * unit / aspect,
        ]
    };
    let last = corners.len().saturating_sub(2);
    for (k, side) in corners.windows(2).enumerate() {
        let ink = if k == last {
            Ink::SecondCurve
        } else {
            Ink::Curve
        };
        dots.line(at(side[0]), at(side[1]), ink);
    }
    let [start, end] = [[0.0; 2], polygon.gap()].map(at);
    dots.dotted(start, end, Ink::Guide);
    dots.dot(
        start[0].floor() as i64,
        start[1].floor() as i64,
        Ink::Selected,
    );
    dots.paint(&app.look, area, buffer);
}

/// The sides as a table.
fn list(app: &App, polygon: &ForcePolygon, area: Rect, buffer: &mut Buffer) {
    let mut lines = Lines::new(&app.look, area, buffer);
    let row = |by: &str, at: &str, force: &str| {
        let by = write::fitting(by, 15).to_owned();
        format!("{by:15} {at:>7} {force:>9}")
    };
    lines.line(&row("by", "at deg", "N"), Role::Label);
    for side in &polygon.sides {
        let at = format!("{:.1}", side.direction);
        lines.line(&row(&side.by, &at, &short(side.size())), Role::Value);
    }
    if polygon.body != [0.0; 2] {
        let force = short(polygon.body_size());
        lines.line(&row("weight, applied", "", &force), Role::Value);
    }
}
