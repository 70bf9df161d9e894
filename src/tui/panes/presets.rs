//! Browser of presets.

use std::sync::LazyLock;

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::widgets::{Block, Widget};

use super::help;
use crate::scene::About;
use crate::scene::catalogue::PRESETS;
use crate::tui::app::App;
use crate::tui::look::Role;
use crate::tui::write::{self, Lines};

/// What the presets say about themselves. They are part of the program and never change.
static ABOUT: LazyLock<Vec<About>> = LazyLock::new(|| {
    let texts = PRESETS.iter().map(|preset| preset.text);
    texts.map(About::of).collect()
});

/// Draws the list with one under the cursor.
pub fn draw(app: &App, at: usize, area: Rect, buffer: &mut Buffer) {
    let area = area.intersection(buffer.area);
    let at = at.min(PRESETS.len() - 1);
    let title = format!(
        " presets  {} of {}; j k choose, Enter starts it, Esc closes ",
        at + 1,
        PRESETS.len()
    );
    help::frame(app, &title, area, buffer);
    let inner = Block::bordered().inner(area);
    let names = PRESETS.iter().map(|preset| preset.name.len()).max();
    let names = names.unwrap_or(0);
    let wide = inner.width >= 100;
    let longest = ABOUT.iter().map(|about| about.title.chars().count()).max();
    let list_width = (names + 4 + longest.unwrap_or(0) + 2) as u16;
    let [list, details] = if wide {
        Layout::horizontal([Constraint::Length(list_width), Constraint::Min(0)]).areas(inner)
    } else {
        let rows = (PRESETS.len() as u16 + 1).min(inner.height.div_ceil(2));
        Layout::vertical([Constraint::Length(rows), Constraint::Min(0)]).areas(inner)
    };
    draw_list(app, at, names, list, buffer);
    if wide {
        let block = Block::new()
            .borders(ratatui::widgets::Borders::LEFT)
            .border_set(app.border());
        let beside = block.inner(details);
        block.render(details, buffer);
        let padded = Rect {
            x: beside.x + 1,
            width: beside.width.saturating_sub(1),
            ..beside
        };
        draw_details(app, at, padded, buffer);
    } else {
        draw_details(app, at, details, buffer);
    }
}

fn draw_list(app: &App, at: usize, names: usize, area: Rect, buffer: &mut Buffer) {
    let height = usize::from(area.height);
    // The one under the cursor stays in sight.
    let first = (at + 1).saturating_sub(height);
    let running = app.frame.as_ref().map(|frame| frame.preset.as_str());
    let rows = PRESETS.iter().zip(ABOUT.iter()).enumerate();
    let mut lines = Lines::new(&app.look, area, buffer);
    for (k, (preset, about)) in rows.skip(first).take(height) {
        let (cursor, role) = if k == at {
            (">", Role::Selected)
        } else {
            (" ", Role::Label)
        };
        let here = if running == Some(preset.name) {
            '*'
        } else {
            ' '
        };
        let text = format!("{cursor}{here}{:names$}  {}", preset.name, about.title);
        lines.line(&text, role);
    }
}

fn draw_details(app: &App, at: usize, area: Rect, buffer: &mut Buffer) {
    let Some(about) = ABOUT.get(at) else { return };
    let mut lines = Lines::new(&app.look, area, buffer);
    lines.line(&about.title, Role::Value);
    for (name, text) in [
        ("shows", about.shows.as_str()),
        ("look at", &about.look),
        ("source", &about.source),
    ] {
        if !text.is_empty() {
            labelled(name, text, area.width, &mut lines);
        }
    }
    for (k, command) in about.try_.iter().enumerate() {
        let name = if k == 0 { "try" } else { "" };
        labelled(name, &format!(":{command}"), area.width, &mut lines);
    }
}

fn labelled(name: &str, text: &str, width: u16, lines: &mut Lines<'_>) {
    let room = usize::from(width).saturating_sub(9);
    for (k, part) in write::wrapped(text, room).iter().enumerate() {
        let name = if k == 0 { name } else { "" };
        lines.parts(&[(&format!("{name:8} "), Role::Label), (part, Role::Value)]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_preset_says_what_it_shows() {
        for (preset, about) in PRESETS.iter().zip(ABOUT.iter()) {
            assert!(!about.title.is_empty(), "{}", preset.name);
            assert!(!about.shows.is_empty(), "{}", preset.name);
            assert_ne!(about.title, "cannot be read", "{}", preset.name);
        }
    }
}
