//! Browser of presets.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use crate::tui::app::App;

/// Draws the list with one under the cursor.
pub fn draw(_: &App, _: usize, _: Rect, _: &mut Buffer) {}
