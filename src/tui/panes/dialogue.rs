//! What was said, and the prompt.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::{Pane, PaneId};
use crate::language::COMMANDS;
use crate::tui::app::{App, Said};
use crate::tui::look::Role;
use crate::tui::write::{self, Lines, wrapped};

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
    ..Pane::PLAIN
};

fn styled(app: &App, said: &Said) -> (String, Style) {
    match said {
        Said::Line(text) => (format!("> {text}"), app.look.style(Role::Value)),
        Said::Answer(text) => (text.clone(), app.look.style(Role::Label)),
        Said::Error(text) => (format!("! {text}"), app.look.style(Role::Failure)),
        Said::Notice(text) => (format!("* {text}"), app.look.style(Role::Warning)),
    }
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    let mut row = area.height;
    if app.dialogue.is_empty() {
        let text = "nothing said yet; `:` opens the prompt, `help` lists the commands";
        Lines::new(&app.look, area, buffer).text(text, Role::Label);
    }
    let end = app.dialogue.len().saturating_sub(app.scrolled);
    for said in app.dialogue[..end].iter().rev() {
        let (text, style) = styled(app, said);
        for line in wrapped(&text, width).iter().rev() {
            if row == 0 {
                return;
            }
            row -= 1;
            write::styled(&app.look, (area, &mut *buffer), (0, row), line, style);
        }
    }
}

/// Draws the last thing said in one line.
pub fn last(app: &App, area: Rect, buffer: &mut Buffer) {
    let (text, style) = match app.dialogue.last() {
        Some(said) => styled(app, said),
        None => match &app.frame {
            Some(frame) => (frame.title.clone(), app.look.style(Role::Label)),
            None => return,
        },
    };
    write::styled(&app.look, (area, buffer), (0, 0), &text, style);
}

/// Draws the prompt; answers where the cursor stands.
pub fn prompt(app: &App, area: Rect, buffer: &mut Buffer) -> Option<(u16, u16)> {
    if area.is_empty() {
        return None;
    }
    if !app.prompt.open {
        write::at(
            &app.look,
            (area, buffer),
            (0, 0),
            invitation(app),
            Role::Label,
        );
        return None;
    }
    let width = usize::from(area.width);
    let text = app.prompt.text();
    // Long lines move to the left, so that the cursor stays in sight.
    let shift = (app.prompt.cursor() + 3).saturating_sub(width);
    let visible: String = text.chars().skip(shift).collect();
    let line = format!("> {visible}");
    let end = write::at(&app.look, (area, &mut *buffer), (0, 0), &line, Role::Value);
    let hint = if app.prompt.candidates.is_empty() {
        usage(text)
    } else {
        app.prompt.candidates.join("  ")
    };
    write::at(&app.look, (area, buffer), (end + 2, 0), &hint, Role::Frame);
    let x = area.x + (2 + app.prompt.cursor() - shift) as u16;
    Some((x.min(area.right() - 1), area.y))
}

/// What the closed prompt says.
fn invitation(app: &App) -> &'static str {
    match &app.frame {
        None => "> ",
        Some(frame) if app.failure.is_some() || frame.finished => {
            "press : to type a command, e to export the history, b for presets"
        }
        Some(_) => "press : to type a command, ? for help",
    }
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
