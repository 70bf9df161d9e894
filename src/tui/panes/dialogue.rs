//! What was said, and the prompt.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::{Pane, PaneId};
use crate::language::COMMANDS;
use crate::tui::app::{App, Said};
use crate::tui::look::Role;

/// The pane.
pub const PANE: Pane = Pane {
    name: "dialogue",
    summary: "commands and their answers; j and k scroll",
    title: |app, _| {
        if app.scrolled > 0 {
            format!("dialogue, {} lines back", app.scrolled)
        } else {
            "dialogue".into()
        }
    },
    draw,
};

fn styled(app: &App, said: &Said) -> (String, Style) {
    match said {
        Said::Line(text) => (format!("> {text}"), app.look.style(Role::Value)),
        Said::Answer(text) => (text.clone(), app.look.style(Role::Label)),
        Said::Error(text) => (format!("! {text}"), app.look.style(Role::Failure)),
        Said::Notice(text) => (format!("* {text}"), app.look.style(Role::Warning)),
    }
}

/// A text in lines of so many columns.
pub(super) fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    let mut column = 0;
    for c in text.chars().filter(|c| !c.is_control()) {
        if column == width.max(1) {
            lines.push(String::new());
            column = 0;
        }
        lines.last_mut().expect("there is a first line").push(c);
        column += 1;
    }
    lines
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let mut y = area.bottom();
    let end = app.dialogue.len().saturating_sub(app.scrolled);
    for said in app.dialogue[..end].iter().rev() {
        let (text, style) = styled(app, said);
        for line in wrapped(&text, width).iter().rev() {
            if y == area.y {
                return;
            }
            y -= 1;
            buffer.set_stringn(area.x, y, line, width, style);
        }
    }
}

/// Draws the last thing said in one line.
pub fn last(app: &App, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    let (text, style) = match app.dialogue.last() {
        Some(said) => styled(app, said),
        None => match &app.frame {
            Some(frame) => (frame.title.clone(), app.look.style(Role::Label)),
            None => return,
        },
    };
    buffer.set_stringn(area.x, area.y, text, usize::from(area.width), style);
}

/// Draws the prompt; answers where the cursor stands.
pub fn prompt(app: &App, area: Rect, buffer: &mut Buffer) -> Option<(u16, u16)> {
    if area.is_empty() {
        return None;
    }
    let width = usize::from(area.width);
    if !app.prompt.open {
        let text = match &app.frame {
            Some(frame) => format!("> press : and type a command ({})", frame.title),
            None => "> ".into(),
        };
        buffer.set_stringn(area.x, area.y, text, width, app.look.style(Role::Label));
        return None;
    }
    let text = app.prompt.text();
    let shift = (app.prompt.cursor() + 3).saturating_sub(width);
    let visible: String = text.chars().skip(shift).collect();
    buffer.set_stringn(
        area.x,
        area.y,
        format!("> {visible}"),
        width,
        app.look.style(Role::Value),
    );
    let used = 2 + visible.chars().count() + 2;
    if used < width {
        let hint = if app.prompt.candidates.is_empty() {
            usage(text)
        } else {
            app.prompt.candidates.join("  ")
        };
        let style = app.look.style(Role::Frame);
        buffer.set_stringn(area.x + used as u16, area.y, hint, width - used, style);
    }
    let x = area.x + (2 + app.prompt.cursor() - shift) as u16;
    Some((x.min(area.right() - 1), area.y))
}

/// Usage of the command being typed.
fn usage(text: &str) -> String {
    let Some(verb) = text.split_whitespace().next() else {
        return String::new();
    };
    let verb = verb.to_lowercase();
    let mut fitting = COMMANDS.iter().filter(|card| card.name.starts_with(&verb));
    match (fitting.next(), fitting.next()) {
        (Some(card), None) => card.usage.lines().next().unwrap_or_default().to_owned(),
        (Some(first), Some(_)) if first.name == verb => first.usage.to_owned(),
        _ => String::new(),
    }
}
