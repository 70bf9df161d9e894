//! Pane: rose.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::tui::app::App;

/// The pane.
pub const PANE: Pane = Pane {
    name: "rose",
    summary: "rose",
    title: |_, _| "rose".into(),
    draw,
};

fn draw(_: &App, _: PaneId, _: Rect, _: &mut Buffer) {}

/// The same, weighted.
pub const WEIGHTED: Pane = Pane {
    name: "weighted rose",
    summary: "rose",
    title: |_, _| "rose".into(),
    draw,
};
