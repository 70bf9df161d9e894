//! Status line and line of hints.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

use crate::session::frames::Frame;
use crate::tui::app::App;
use crate::tui::keys::KEYS;
use crate::tui::link::Link;
use crate::tui::look::Role;
use crate::tui::write;

/// A count with thin groups of three digits.
pub fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let mut text = String::new();
    for (k, c) in digits.chars().enumerate() {
        if k > 0 && (digits.len() - k).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(c);
    }
    text
}

/// A rate with a short unit.
fn rate(value: f64, unit: &str) -> String {
    match value {
        v if v >= 1e6 => format!("{:.1} M{unit}", v / 1e6),
        v if v >= 1e3 => format!("{:.1} k{unit}", v / 1e3),
        v => format!("{v:.0} {unit}"),
    }
}

/// Time to go, coarser the longer it is, so that it does not change with every frame.
fn time_left(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "unknown".into(),
        s if s < 60.0 => format!("{s:.0} s"),
        s if s < 3600.0 => format!("{:.0} min", s / 60.0),
        s if s < 1e6 => format!("{:.1} h", s / 3600.0),
        s => format!("{:.0} days", s / 86400.0),
    }
}

/// Parts of the status line, most important first; those that do not fit are left out.
fn parts(app: &App) -> Vec<(String, Role)> {
    let plain = Role::Label;
    let Some(frame) = &app.frame else {
        return vec![("starting ...".into(), plain)];
    };
    let (word, role) = match (&app.failure, frame.running, frame.finished) {
        (Some(_), ..) => ("FAILED", Role::Failure),
        (None, true, _) => ("RUN", Role::Running),
        (None, false, true) if frame.stages.1 > 0 => ("DONE", Role::Paused),
        (None, false, _) => ("PAUSED", Role::Paused),
    };
    let mut parts = vec![(word.to_owned(), role)];
    parts.push((format!("cycle {}", grouped(frame.cycle)), Role::Value));
    if let Some(failure) = &app.failure {
        // The cycle stands there already.
        let cycle = format!("cycle {}: ", frame.cycle);
        let reason = failure.strip_prefix(&cycle).unwrap_or(failure);
        parts.push((reason.to_owned(), Role::Failure));
    } else if frame.finished && !frame.running && frame.stages.1 == 0 {
        parts.push(("no stages: space runs".into(), plain));
    } else if frame.finished && !frame.running {
        parts.push(("e exports, : goes on by hand, b presets".into(), plain));
    }
    parts.extend(progress(frame).map(|text| (text, plain)));
    match app.unseen {
        0 => {}
        1 => parts.push(("1 warning".into(), Role::Warning)),
        n => parts.push((format!("{n} warnings"), Role::Warning)),
    }
    let (stage, stages) = frame.stages;
    if stages > 0 {
        parts.push((format!("{} {stage}/{stages}", frame.stage), plain));
    }
    if frame.running {
        let pace = if app.pace.is_some() { " paced" } else { "" };
        parts.push((format!("{}{pace}", rate(frame.rate, "cyc/s")), plain));
    } else if !frame.finished && app.failure.is_none() {
        parts.push(("space runs".into(), plain));
    }
    if frame.assembly.unbalanced.is_finite() {
        let mut text = format!("unbalanced {:.1e}", frame.assembly.unbalanced);
        if frame.measures_of != frame.cycle {
            text.push_str(&format!(" at {}", grouped(frame.measures_of)));
        }
        parts.push((text, plain));
    }
    // A line that nothing goes over is no news.
    let sends = app.link.budget.is_some() || app.link.measured.1 > 0.0;
    parts.extend(sends.then(|| (line(&app.link), plain)));
    parts.push((frame.preset.clone(), plain));
    parts
}

/// Frames and bytes per second to the terminal, the latter with the budget if there is one.
fn line(link: &Link) -> String {
    let (bytes, fps) = link.measured;
    match link.budget {
        Some(budget) => {
            format!("{fps:.0} fps {:.1}/{} kB/s", bytes / 1e3, budget / 1e3)
        }
        None => format!("{fps:.0} fps {}", rate(bytes, "B/s")),
    }
}

/// How much of the stage is done, and how long the rest takes.
fn progress(frame: &Frame) -> Option<String> {
    let (done, length) = (frame.stage_cycles.0, frame.stage_cycles.1?);
    if length == 0 || frame.finished {
        return None;
    }
    let share = format!("{:.0} %", 100.0 * done as f64 / length as f64);
    let seconds = length.saturating_sub(done) as f64 / frame.rate;
    if frame.running && frame.rate > 0.0 && seconds >= 1.0 {
        Some(format!("{share} eta {}", time_left(seconds)))
    } else {
        Some(share)
    }
}

/// Draws the status line.
pub fn draw(app: &App, area: Rect, buffer: &mut Buffer) {
    let mut column = 0;
    for (text, role) in parts(app) {
        let width = text.chars().count();
        // What matters most is cut rather than left out; what is short enough fills what is left.
        let must = column == 0 || role == Role::Failure;
        if !must && usize::from(column) + width > usize::from(area.width) {
            continue;
        }
        let on = (area, &mut *buffer);
        column = write::at(&app.look, on, (column, 0), &text, role).saturating_add(2);
    }
}

/// Hints while a line is typed.
const TYPING: [(&str, &str); 5] = [
    ("Enter", "execute"),
    ("Tab", "complete"),
    ("Up", "line before"),
    ("Esc", "leave"),
    ("Ctrl-C", "clear"),
];

/// Draws the line of hints.
pub fn hints(app: &App, area: Rect, buffer: &mut Buffer) {
    let back = app.zoomed.map(|_| ("Esc", "all panes"));
    let usual = KEYS
        .iter()
        .filter_map(|key| key.hint.map(|hint| (key.label, hint)));
    let hints: Vec<(&str, &str)> = if app.prompt.open {
        TYPING.to_vec()
    } else {
        back.into_iter().chain(usual).collect()
    };
    let mut column = 0;
    for (label, hint) in hints {
        let width = label.len() + 1 + hint.len();
        if usize::from(column) + width > usize::from(area.width) {
            break;
        }
        let bold = Style::new().add_modifier(Modifier::BOLD);
        let on = (area, &mut *buffer);
        let end = write::styled(&app.look, on, (column, 0), label, bold);
        let on = (area, &mut *buffer);
        column = write::at(&app.look, on, (end + 1, 0), hint, Role::Label) + 2;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_line_says_what_it_may_use() {
        let mut link = Link::new(crate::tui::link::Line {
            budget: Some(5e3),
            fps: 10.0,
        });
        link.measured = (6310.0, 9.6);
        assert_eq!(line(&link), "10 fps 6.3/5 kB/s");
        link.budget = None;
        assert_eq!(line(&link), "10 fps 6.3 kB/s");
    }

    #[test]
    fn digits_stand_in_threes() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_482_000), "1 482 000");
    }
}
