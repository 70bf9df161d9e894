//! Pane: energy.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use super::{Pane, PaneId};
use crate::tui::app::App;

/// The pane.
pub const PANE: Pane = Pane {
    name: "energy",
    summary: "energy",
    title: |_, _| "energy".into(),
    draw,
};

fn draw(_: &App, _: PaneId, _: Rect, _: &mut Buffer) {}
