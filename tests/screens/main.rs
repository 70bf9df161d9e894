//! What the workbench draws: pictures of every pane at three sizes, styles of chosen cells, and
//! that nothing breaks at any size.

mod any_size;
mod example;
mod pictures;
mod places;
mod styles;
mod talk;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;

use ballast::tui::app::App;

/// Draws a screen.
fn drawn(app: &mut App, width: u16, height: u16) -> Buffer {
    let area = Rect::new(0, 0, width, height);
    let mut buffer = Buffer::empty(area);
    app.draw(area, &mut buffer);
    buffer
}

/// The characters of a screen, a line each.
fn text(buffer: &Buffer) -> String {
    let width = usize::from(buffer.area.width).max(1);
    let lines = buffer.content().chunks(width).map(|row| {
        let line: String = row.iter().map(ratatui::buffer::Cell::symbol).collect();
        line.trim_end().to_owned() + "\n"
    });
    lines.collect()
}
