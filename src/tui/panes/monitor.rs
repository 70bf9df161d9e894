//! Whether the time step is small enough: FRACC, the stability bound, warnings.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::session::frames::Frame;
use crate::tui::app::App;
use crate::tui::look::Role;
use crate::tui::scale::short;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "step monitor",
    summary: "FRACC and FRAC against their limits, time step, warnings; w marks them as seen",
    title: |app, _| match app.unseen {
        0 => "step monitor".into(),
        1 => "step monitor  1 new warning".into(),
        new => format!("step monitor  {new} new warnings"),
    },
    draw,
    wants: |_, _, wants| wants.limit = true,
    ..Pane::PLAIN
};

/// FRACC above this is a warning.
const FRACC_LIMIT: f64 = 0.3;

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let mut lines = Lines::new(&app.look, area, buffer);
    if let Some(failure) = &app.failure {
        lines.text(&format!("FAILED: {failure}"), Role::Failure);
    }
    let Some(frame) = &app.frame else {
        return;
    };
    for gauge in gauges(app, frame) {
        gauge.write(app, area.width, &mut lines);
    }
    if frame.frac_limit_of != frame.cycle {
        let text = format!(
            "limit at cycle {}",
            super::status::grouped(frame.frac_limit_of)
        );
        lines.line(&text, Role::Label);
    }
    let step = format!("{} s", short(frame.dt));
    lines.parts(&[("time step  ", Role::Label), (&step, Role::Value)]);
    if app.warnings.is_empty() {
        lines.line("no warnings", Role::Label);
    }
    let newest_first = app.warnings.iter().rev().enumerate();
    for (k, warning) in newest_first.take(usize::from(lines.left())) {
        let (mark, role) = if k < app.unseen {
            ("! ", Role::Warning)
        } else {
            ("  ", Role::Label)
        };
        let cycle = super::status::grouped(warning.cycle);
        // Where there is no room for all of it the disc is what the keys lead to.
        let text = match warning.particle {
            Some(id) => format!("{mark}disc {id}, {cycle}: {}", warning.text),
            None => format!("{mark}{cycle}: {}", warning.text),
        };
        lines.line(&text, role);
    }
}

/// A value against its limit.
struct Gauge {
    name: &'static str,
    /// What is said where there is no value.
    missing: &'static str,
    value: f64,
    limit: f64,
}

fn gauges(app: &App, frame: &Frame) -> [Gauge; 2] {
    // Right after a row nothing has been seen yet; then the row says what was.
    let column = app.series.position("fracc");
    let row = column.and_then(|k| app.series.rows().last()?.values.get(k).copied());
    [
        Gauge {
            name: "FRACC",
            // Rows begin it anew; what was seen before is what warnings are about.
            missing: if app.warnings.is_empty() {
                "not evaluated yet"
            } else {
                "none since the last row"
            },
            value: frame.fracc.largest.or(row).unwrap_or(f64::NAN),
            limit: FRACC_LIMIT,
        },
        Gauge {
            name: "FRAC ",
            missing: "not known yet",
            value: frame.frac,
            limit: frame.frac_limit,
        },
    ]
}

impl Gauge {
    fn write(&self, app: &App, width: u16, lines: &mut Lines<'_>) {
        let over = self.value > self.limit;
        let number = if self.value.is_nan() {
            self.missing.to_owned()
        } else if self.limit.is_nan() {
            format!("{:.3}", self.value)
        } else if self.limit.is_finite() {
            format!("{:.3} of {}", self.value, short(self.limit))
        } else {
            format!("{:.3}, no limit without contacts", self.value)
        };
        let verdict = if over { " TOO LARGE" } else { "" };
        let role = if over { Role::Warning } else { Role::Value };
        let used = self.name.len() + number.len() + verdict.len() + 3;
        let room = usize::from(width).saturating_sub(used).min(24);
        let bar = if room >= 4 && self.value.is_finite() && self.limit.is_finite() {
            format!(
                "{} ",
                write::gauge(&app.look, self.value / self.limit, room)
            )
        } else {
            String::new()
        };
        lines.parts(&[
            (self.name, Role::Label),
            (" ", Role::Label),
            (&bar, role),
            (&number, role),
            (verdict, Role::Failure),
        ]);
    }
}
