//! The contact that is followed: its loops, its path between the friction limits, the traction
//! inside it, and its numbers.

mod path;
mod profile;

use ratatui::buffer::Buffer;
use ratatui::layout::{Constraint, Layout, Rect};

use super::{Pane, PaneId};
use crate::engine::contact::inner::{Inner, Value};
use crate::session::inspect::Inspection;
use crate::tui::app::App;
use crate::tui::look::Role;
use crate::tui::scale::short;
use crate::tui::write::{self, Lines};

/// The pane.
pub const PANE: Pane = Pane {
    name: "contact",
    summary: "a contact's loops, friction limits, traction and memory; i chooses it, or inspect",
    title,
    draw,
    ..Pane::PLAIN
};

/// What is drawn of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Drawing {
    Loop,
    Limits,
    Normal,
    Profile,
}

fn inspection(app: &App) -> Option<&Inspection> {
    app.frame.as_ref()?.contact.as_ref()
}

fn title(app: &App, _: PaneId) -> String {
    match inspection(app) {
        Some(contact) => format!(
            "contact {} {}  {}",
            contact.name, contact.state, contact.law
        ),
        None => "contact".into(),
    }
}

fn draw(app: &App, _: PaneId, area: Rect, buffer: &mut Buffer) {
    let Some(contact) = inspection(app) else {
        let mut lines = Lines::new(&app.look, area, buffer);
        let text = "no contact is followed: i follows one, of the disc that n selects if there is \
                    one; `inspect contact I-J` does, too";
        return lines.text(text, Role::Label);
    };
    let column = match area.width {
        100.. => 34,
        72.. => 30,
        _ => 0,
    };
    let [plots, numbers] =
        Layout::horizontal([Constraint::Min(0), Constraint::Length(column)]).areas(area);
    if column > 0 {
        write_numbers(app, contact, numbers, buffer);
        return draw_plots(app, contact, plots, buffer);
    }
    let head = summary(contact);
    let head = write::fitting(&head, usize::from(area.width));
    let line = u16::from(area.height > 1);
    Lines::new(&app.look, area, buffer).line(head, Role::Value);
    let below = Rect {
        y: area.y + line,
        height: area.height - line,
        ..area
    };
    if line > 0 {
        draw_plots(app, contact, below, buffer);
    }
}

fn draw_plots(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let columns = if area.width >= 40 { 2 } else { 1 };
    let rows = if area.height >= 12 { 2 } else { 1 };
    // As the exported picture has them; where not all have room, the most telling ones.
    let order = if columns * rows < 4 && contact.traction.is_some() {
        [
            Drawing::Loop,
            Drawing::Profile,
            Drawing::Limits,
            Drawing::Normal,
        ]
    } else {
        [
            Drawing::Loop,
            Drawing::Limits,
            Drawing::Normal,
            Drawing::Profile,
        ]
    };
    let bands = Layout::vertical(vec![Constraint::Fill(1); rows]).split(area);
    let places = bands.iter().flat_map(|band| {
        let parts = Layout::horizontal(vec![Constraint::Fill(1); columns]).spacing(1);
        parts.split(*band).to_vec()
    });
    for (drawing, place) in order.into_iter().zip(places) {
        match drawing {
            Drawing::Loop => path::draw_loop(app, contact, place, buffer),
            Drawing::Limits => path::draw_limits(app, contact, place, buffer),
            Drawing::Normal => path::draw_normal(app, contact, place, buffer),
            Drawing::Profile => profile::draw(app, contact, place, buffer),
        }
    }
}

fn value(inner: &Inner) -> (String, &'static str) {
    match inner.value {
        Value::Number(value, "-") => (short(value), ""),
        Value::Number(value, unit) => (short(value), unit),
        Value::Word(word) => (word.to_owned(), ""),
    }
}

/// Force, obliquity and what sticks in one line.
fn summary(contact: &Inspection) -> String {
    let wanted = ["N", "T", "|T|/(mu N)", "c/a"];
    let found = wanted.iter().filter_map(|name| {
        let inner = contact.numbers.iter().find(|inner| inner.name == *name)?;
        let (number, unit) = value(inner);
        Some(format!("{name} {number} {unit}").trim_end().to_owned())
    });
    let parts: Vec<String> = found.collect();
    if parts.is_empty() {
        contact.state.to_owned()
    } else {
        parts.join("  ")
    }
}

fn write_numbers(app: &App, contact: &Inspection, area: Rect, buffer: &mut Buffer) {
    let mut lines = Lines::new(&app.look, area, buffer);
    let names = if area.width >= 34 { 18 } else { 14 };
    for inner in &contact.numbers {
        let (text, unit) = value(inner);
        let name: String = inner.name.chars().take(names).collect();
        let role = if unit.starts_with('>') {
            Role::Warning
        } else {
            Role::Value
        };
        let label = format!(" {name:names$} ");
        if let Value::Word(word) = inner.value {
            lines.parts(&[(&label, Role::Label), (word, Role::Value)]);
            continue;
        }
        let number = format!("{text:>9}");
        lines.parts(&[
            (&label, Role::Label),
            (&number, role),
            (" ", role),
            (unit, role),
        ]);
    }
    if contact.numbers.is_empty() {
        lines.text(" apart: nothing is carried", Role::Label);
    }
    let (since, stride) = contact.since;
    let every = if stride > 1 {
        format!(", every {stride}")
    } else {
        String::new()
    };
    let since = super::status::grouped(since);
    lines.line(&format!(" since cycle {since}{every}"), Role::Label);
}
