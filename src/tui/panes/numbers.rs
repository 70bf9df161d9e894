//! The newest values of the recorded columns.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::tui::app::App;
use crate::tui::look::Role;

/// The pane.
pub const PANE: Pane = Pane {
    name: "numbers",
    summary: "newest row of the history",
    title: |_, _| "now".into(),
    draw,
};

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(row) = app.series.rows().last() else {
        return;
    };
    for (k, column) in app
        .series
        .columns
        .iter()
        .enumerate()
        .take(usize::from(area.height))
    {
        let text = format!(
            "{:20} {:>12.5e} {}",
            column.name(),
            row.values[k],
            column.card().unit
        );
        let width = usize::from(area.width);
        buffer.set_stringn(
            area.x,
            area.y + k as u16,
            text,
            width,
            app.look.style(Role::Value),
        );
    }
}
