//! The traction inside a followed contact against what limits it, and where it sticks and slips.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::engine::contact::traction::{Traction, Zone};
use crate::session::inspect::Inspection;
use crate::tui::app::App;
use crate::tui::dots::Ink;
use crate::tui::look::Role;
use crate::tui::plot::{Axes, Plot};
use crate::tui::write::{self, Lines};

/// Points from the middle to the edge.
const STEPS: i32 = 200;

pub(super) fn draw(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let Some(traction) = &contact.traction else {
        let text = match (contact.state, contact.shears()) {
            ("apart", _) => "traction: none while the contact is apart",
            (_, false) => "traction: none without friction",
            _ => "traction: not known to this law in this state",
        };
        return Lines::new(&app.look, area, buffer).text(text, Role::Label);
    };
    let axes = Axes {
        title: "q/(mu p0) over r/a  limit +-p/p0",
        ranges: [(-1.0, 1.0), (-1.0, 1.0)],
        foot: true,
    };
    let zones = u16::from(area.height >= 7);
    let above = Rect {
        height: area.height - zones,
        ..area
    };
    let Some(mut plot) = Plot::new(&app.look, &axes, above, buffer) else {
        return;
    };
    let over = |height: &dyn Fn(f64) -> f64| -> Vec<(f64, f64)> {
        (-STEPS..=STEPS)
            .map(|k| f64::from(k) / f64::from(STEPS))
            .map(|r| (r, height(r.abs())))
            .collect()
    };
    for sign in [1.0, -1.0] {
        let limit = over(&|r| sign * Traction::pressure(r));
        plot.curve(limit.into_iter(), Ink::SecondCurve);
    }
    plot.curve(over(&|r| traction.at(r)).into_iter(), Ink::Curve);
    if zones > 0 {
        let line = Rect {
            y: above.bottom(),
            height: 1,
            ..plot.body()
        };
        for column in 0..line.width {
            let r = plot.along(column).abs();
            let (text, role) = match traction.zone(r) {
                _ if r > 1.0 => continue,
                Zone::Stick => ("=", Role::Label),
                Zone::SlipForward => ("+", Role::Warning),
                Zone::SlipBackward => ("-", Role::Warning),
            };
            write::at(&app.look, (line, &mut *buffer), (column, 0), text, role);
        }
        write_legend(app, traction, plot.body(), buffer);
    }
    plot.paint(&app.look, buffer);
}

/// What the signs of the line below mean, between the ends of the axis.
fn write_legend(app: &App, traction: &Traction, body: Rect, buffer: &mut Buffer) {
    let slip = match (traction.stick_ratio(), traction.zone(0.999_999)) {
        (1.0, _) => "= sticks",
        (_, Zone::SlipBackward) => "= sticks - slips",
        _ => "= sticks + slips",
    };
    let room = usize::from(body.width);
    // The numbers at both ends stay.
    if room < slip.len() + 10 {
        return;
    }
    let line = Rect {
        y: body.bottom(),
        height: 1,
        ..body
    };
    let column = (room - slip.len()) / 2;
    write::at(
        &app.look,
        (line, buffer),
        (column as u16, 0),
        slip,
        Role::Label,
    );
}
