//! Help, and the question before quitting.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Paragraph, Widget};

use crate::tui::app::App;
use crate::tui::keys::KEYS;

/// Draws help from a line on.
pub fn draw(app: &App, from: u16, area: Rect, buffer: &mut Buffer) {
    let mut text = String::new();
    for key in KEYS {
        text.push_str(&format!("{:8} {}\n", key.label, key.help));
    }
    Clear.render(area, buffer);
    let block = Block::bordered()
        .border_set(app.border())
        .title(" help, Esc closes ");
    Paragraph::new(text)
        .scroll((from, 0))
        .block(block)
        .render(area, buffer);
}

/// Asks before unsaved cycles are left.
pub fn ask(app: &App, area: Rect, buffer: &mut Buffer) {
    let text = "cycles are not exported; q quits all the same, Esc stays";
    let width = (text.len() as u16 + 4).min(area.width);
    let height = 3.min(area.height);
    let x = area.x + (area.width - width) / 2;
    let y = area.y + (area.height - height) / 2;
    let place = Rect {
        x,
        y,
        width,
        height,
    };
    Clear.render(place, buffer);
    let block = Block::bordered().border_set(app.border()).title(" quit? ");
    Paragraph::new(text).block(block).render(place, buffer);
}
