//! Status line and line of hints.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

use crate::tui::app::App;
use crate::tui::keys::KEYS;
use crate::tui::look::Role;

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

/// Parts of the status line, most important first; those that do not fit are left out.
fn parts(app: &App) -> Vec<(String, Style)> {
    let plain = Style::new();
    let Some(frame) = &app.frame else {
        return vec![("starting ...".into(), plain)];
    };
    let (word, role) = match (&app.failure, frame.running, frame.finished) {
        (Some(_), ..) => ("FAILED", Role::Failure),
        (None, true, _) => ("RUN", Role::Running),
        (None, false, true) => ("DONE", Role::Paused),
        (None, false, false) => ("PAUSED", Role::Paused),
    };
    let mut parts = vec![(word.to_owned(), app.look.style(role))];
    let (stage, stages) = frame.stages;
    if stages > 0 {
        parts.push((format!("{} {stage}/{stages}", frame.stage), plain));
    }
    parts.push((format!("cycle {}", grouped(frame.cycle)), plain));
    if !frame.finished
        && let (done, Some(length)) = frame.stage_cycles
        && length > 0
    {
        let mut text = format!("{:.0} %", 100.0 * done as f64 / length as f64);
        if frame.running && frame.rate > 0.0 {
            let seconds = length.saturating_sub(done) as f64 / frame.rate;
            if seconds >= 1.0 {
                text.push_str(&format!(
                    " eta {:.0}m{:02.0}",
                    (seconds / 60.0).floor(),
                    seconds % 60.0
                ));
            }
        }
        parts.push((text, plain));
    }
    if frame.running {
        let pace = if app.pace.is_some() { " (paced)" } else { "" };
        parts.push((format!("{}{pace}", rate(frame.rate, "cyc/s")), plain));
    }
    if app.unseen > 0 {
        parts.push((format!("W:{}", app.unseen), app.look.style(Role::Warning)));
    }
    parts.push((format!("unb {:.1e}", frame.assembly.unbalanced), plain));
    let (bytes, fps) = app.link.measured;
    parts.push((format!("{fps:.0} fps {}", rate(bytes, "B/s")), plain));
    parts
}

/// Draws the status line.
pub fn draw(app: &App, area: Rect, buffer: &mut Buffer) {
    let mut x = area.x;
    for (text, style) in parts(app) {
        let width = text.chars().count() as u16;
        if area.height == 0 || x + width > area.right() {
            break;
        }
        buffer.set_string(x, area.y, &text, style);
        x += width + 2;
    }
}

/// Draws the line of hints.
pub fn hints(app: &App, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    let mut x = area.x;
    for key in KEYS {
        let Some(hint) = key.hint else { continue };
        let width = (key.label.len() + 1 + hint.len() + 2) as u16;
        if x + width > area.right() {
            break;
        }
        buffer.set_string(
            x,
            area.y,
            key.label,
            Style::new().add_modifier(Modifier::BOLD),
        );
        let label = app.look.style(Role::Label);
        buffer.set_string(x + key.label.len() as u16 + 1, area.y, hint, label);
        x += width;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_stand_in_threes() {
        assert_eq!(grouped(0), "0");
        assert_eq!(grouped(999), "999");
        assert_eq!(grouped(1_482_000), "1 482 000");
    }
}
