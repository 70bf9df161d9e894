//! What was said, and the prompt.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::{Pane, PaneId};
use crate::tui::app::{App, Said};
use crate::tui::completion::usage;
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

/// Lines that the dialogue takes from an entry on, in so many columns.
pub fn height(app: &App, first: usize, width: usize) -> usize {
    let entries = app.dialogue.iter().skip(first);
    entries
        .map(|said| wrapped(&styled(app, said).0, width).len())
        .sum()
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let width = usize::from(area.width);
    if app.dialogue.is_empty() {
        let text = "nothing said yet; `:` opens the prompt, `help` lists the commands";
        Lines::new(&app.look, area, buffer).text(text, Role::Label);
    }
    // Lines below the pane and in it, from the newest upwards.
    let mut hidden = app.scrolled;
    let mut row = area.height;
    for said in app.dialogue.iter().rev() {
        let (text, style) = styled(app, said);
        for line in wrapped(&text, width).iter().rev() {
            if hidden > 0 {
                hidden -= 1;
                continue;
            }
            if row == 0 {
                return;
            }
            row -= 1;
            write::styled(&app.look, (area, &mut *buffer), (0, row), line, style);
        }
    }
}

/// Draws the last thing said, in as many lines as there are.
pub fn last(app: &App, area: Rect, buffer: &mut Buffer) {
    let (text, style) = match app.dialogue.last() {
        Some(said) => styled(app, said),
        None => match &app.frame {
            Some(frame) => (frame.title.clone(), app.look.style(Role::Label)),
            None => return,
        },
    };
    let lines = wrapped(&text, usize::from(area.width));
    for (line, row) in lines.iter().zip(0..area.height) {
        write::styled(&app.look, (area, &mut *buffer), (0, row), line, style);
    }
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
    // Said in words what it is: where there are no colours it would seem to be typed.
    let hint = match (app.prompt.candidates.as_slice(), usage(text)) {
        ([], "") => String::new(),
        ([], usage) => format!("usage: {usage}"),
        (candidates, _) => format!("one of: {}", candidates.join("  ")),
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
