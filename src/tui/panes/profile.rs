//! Porosity by distance from the middle of the region.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::measure::profile::Ring;
use crate::measure::survey::Part;
use crate::tui::app::App;
use crate::tui::dots::Ink;
use crate::tui::look::Role;
use crate::tui::plot::{Axes, Plot};
use crate::tui::scale::short;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "porosity profile",
    summary: "porosity of rings about the middle of the first region, or of everything",
    title: |_, _| "porosity [-] by distance".into(),
    draw,
    wants: |_, _, wants| wants.survey = wants.survey.with(Part::Profile),
    ..Pane::PLAIN
};

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let profile = app
        .frame
        .as_ref()
        .and_then(|frame| frame.survey.profile.as_ref());
    let Some(profile) = profile else {
        return;
    };
    let reach = profile.rings.last().map_or(0.0, |ring| ring.outer);
    if reach.is_nan() || reach <= 0.0 {
        return Lines::new(&app.look, area, buffer).text("no particles", Role::Label);
    }
    let foot = u16::from(area.height >= 6);
    if foot > 0 {
        let [x, y] = profile.centre.map(short);
        let rings = profile.rings.len();
        let text = format!("{rings} rings about x {x} y {y} m  `print profile` lists them");
        let text = write::fitting(&text, usize::from(area.width));
        let place = (0, area.height - 1);
        write::at(&app.look, (area, &mut *buffer), place, text, Role::Label);
    }
    let body = Rect {
        height: area.height - foot,
        ..area
    };
    let values = profile.rings.iter().map(Ring::porosity);
    let most = values.filter(|n| n.is_finite()).fold(0.0, f64::max);
    let axes = Axes {
        title: "porosity over radius [m]",
        ranges: [(0.0, reach), (0.0, most)],
        foot: true,
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, body, buffer) else {
        return;
    };
    let steps = profile.rings.iter().flat_map(|ring| {
        let porosity = ring.porosity();
        [(ring.inner, porosity), (ring.outer, porosity)]
    });
    plot.curve(steps, Ink::Curve);
    plot.paint(&app.look, buffer);
}
