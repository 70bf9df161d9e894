//! From buffer to bytes: only what has changed, in as few bytes as it takes.
//!
//! One write per frame, bracketed as a synchronized update (terminals that do not know it ignore
//! it); short colour codes, no colour for blanks, relative moves within a row.

use std::fmt::Write;

use ratatui::buffer::{Buffer, Cell};
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier};

/// What the terminal shows, and how to get it to show something else.
#[derive(Debug)]
pub struct Painter {
    shown: Buffer,
    /// Whether what the terminal shows is unknown.
    unknown: bool,
    cursor: Option<(u16, u16)>,
    style: (Color, Color, Modifier),
    text: String,
}

const PLAIN: (Color, Color, Modifier) = (Color::Reset, Color::Reset, Modifier::empty());

impl Default for Painter {
    fn default() -> Self {
        Self {
            shown: Buffer::empty(Rect::default()),
            unknown: true,
            cursor: None,
            style: PLAIN,
            text: String::new(),
        }
    }
}

impl Painter {
    /// The next frame is painted whole.
    pub fn forget(&mut self) {
        self.unknown = true;
    }

    /// What the painted screen measures.
    pub fn area(&self) -> Rect {
        self.shown.area
    }

    /// Bytes that turn the screen into `next` with the cursor at this place, or hidden; empty when
    /// it looks like that already.
    pub fn paint(&mut self, next: &Buffer, cursor: Option<(u16, u16)>) -> &str {
        self.text.clear();
        let whole = self.unknown || self.shown.area != next.area;
        if whole {
            // Clear, and everything is as after a reset.
            self.text.push_str("\x1b[0m\x1b[2J\x1b[?25l");
            self.style = PLAIN;
            self.cursor = None;
            self.shown = Buffer::empty(next.area);
            self.unknown = false;
        }
        let mut at: Option<(u16, u16)> = None;
        let shown = std::mem::replace(&mut self.shown, Buffer::empty(Rect::default()));
        for (x, y, cell) in shown.diff(next) {
            self.go(at, (x, y));
            self.restyle(cell);
            self.text.push_str(cell.symbol());
            let width = ratatui::text::Span::raw(cell.symbol()).width().max(1) as u16;
            at = Some((x + width, y));
        }
        self.shown = shown;
        self.shown.clone_from(next);
        let moved = at.is_some();
        if cursor != self.cursor || (moved && cursor.is_some()) {
            match cursor {
                Some((x, y)) => {
                    let show = if self.cursor.is_none() {
                        "\x1b[?25h"
                    } else {
                        ""
                    };
                    let _ = write!(self.text, "\x1b[{};{}H{show}", y + 1, x + 1);
                }
                None => self.text.push_str("\x1b[?25l"),
            }
            self.cursor = cursor;
        }
        if !self.text.is_empty() {
            self.text.insert_str(0, "\x1b[?2026h");
            self.text.push_str("\x1b[?2026l");
        }
        &self.text
    }

    fn go(&mut self, from: Option<(u16, u16)>, (x, y): (u16, u16)) {
        let _ = match from {
            Some(at) if at == (x, y) => Ok(()),
            Some((fx, fy)) if fy == y && x > fx => write!(self.text, "\x1b[{}C", x - fx),
            _ => write!(self.text, "\x1b[{};{}H", y + 1, x + 1),
        };
    }

    fn restyle(&mut self, cell: &Cell) {
        let lined = cell
            .modifier
            .intersects(Modifier::REVERSED | Modifier::UNDERLINED);
        // A blank shows no foreground.
        let fg = if cell.symbol() == " " && !lined {
            self.style.0
        } else {
            cell.fg
        };
        let wanted = (fg, cell.bg, cell.modifier);
        if wanted == self.style {
            return;
        }
        let mut codes: Vec<String> = Vec::new();
        let lost = self.style.2 - wanted.2;
        let mut now = self.style;
        if !lost.is_empty() {
            codes.push("0".into());
            now = PLAIN;
        }
        let gained = wanted.2 - now.2;
        for (modifier, code) in [
            (Modifier::BOLD, "1"),
            (Modifier::DIM, "2"),
            (Modifier::ITALIC, "3"),
            (Modifier::UNDERLINED, "4"),
            (Modifier::REVERSED, "7"),
        ] {
            if gained.contains(modifier) {
                codes.push(code.into());
            }
        }
        if wanted.0 != now.0 {
            codes.push(code(wanted.0, 30));
        }
        if wanted.1 != now.1 {
            codes.push(code(wanted.1, 40));
        }
        if !codes.is_empty() {
            let _ = write!(self.text, "\x1b[{}m", codes.join(";"));
        }
        self.style = wanted;
    }
}

/// Code of a colour; `base` is 30 for foregrounds, 40 for backgrounds.
fn code(colour: Color, base: u8) -> String {
    let basic = |n: u8| (base + n).to_string();
    let bright = |n: u8| (base + 60 + n).to_string();
    match colour {
        Color::Reset => basic(9),
        Color::Black => basic(0),
        Color::Red => basic(1),
        Color::Green => basic(2),
        Color::Yellow => basic(3),
        Color::Blue => basic(4),
        Color::Magenta => basic(5),
        Color::Cyan => basic(6),
        Color::Gray => basic(7),
        Color::DarkGray => bright(0),
        Color::LightRed => bright(1),
        Color::LightGreen => bright(2),
        Color::LightYellow => bright(3),
        Color::LightBlue => bright(4),
        Color::LightMagenta => bright(5),
        Color::LightCyan => bright(6),
        Color::White => bright(7),
        Color::Indexed(n) => format!("{};5;{n}", base + 8),
        Color::Rgb(r, g, b) => format!("{};2;{r};{g};{b}", base + 8),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use ratatui::style::Style;

    fn screen(text: &[(u16, u16, char, u8)]) -> Buffer {
        let mut buffer = Buffer::empty(Rect::new(0, 0, 20, 6));
        for &(x, y, c, style) in text {
            let modifier = [Modifier::empty(), Modifier::BOLD, Modifier::REVERSED];
            let colour = [Color::Reset, Color::Red, Color::Cyan, Color::LightBlue];
            let style = Style::new()
                .fg(colour[usize::from(style) % 4])
                .add_modifier(modifier[usize::from(style) % 3]);
            buffer.set_string(x % 20, y % 6, c.to_string(), style);
        }
        buffer
    }

    proptest! {
        /// A terminal that gets the bytes shows the buffer, whatever it showed before.
        #[test]
        fn a_terminal_shows_what_was_painted(
            frames in prop::collection::vec(
                prop::collection::vec((0u16..20, 0u16..6, "[a-z █⣿]", 0u8..12), 0..40), 1..6),
        ) {
            let mut parser = vt100::Parser::new(6.try_into().unwrap(), 20.try_into().unwrap(), 0);
            let mut painter = Painter::default();
            for frame in frames {
                let cells: Vec<(u16, u16, char, u8)> = frame
                    .into_iter()
                    .map(|(x, y, c, s)| (x, y, c.chars().next().unwrap(), s))
                    .collect();
                let next = screen(&cells);
                parser.process(painter.paint(&next, None).as_bytes());
                for y in 0..6 {
                    for x in 0..20 {
                        let cell = parser.screen().cell(y, x).unwrap();
                        let wanted = next[(x, y)].clone();
                        let symbol = if cell.contents().is_empty() { " " } else { cell.contents() };
                        prop_assert_eq!(symbol, wanted.symbol());
                        prop_assert_eq!(cell.inverse(), wanted.modifier.contains(Modifier::REVERSED));
                        if symbol != " " {
                            prop_assert_eq!(cell.bold(), wanted.modifier.contains(Modifier::BOLD));
                            let colour = match wanted.fg {
                                Color::Red => vt100::Color::Idx(1),
                                Color::Cyan => vt100::Color::Idx(6),
                                Color::LightBlue => vt100::Color::Idx(12),
                                _ => vt100::Color::Default,
                            };
                            prop_assert_eq!(cell.fgcolor(), colour);
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn nothing_new_costs_nothing() {
        let mut painter = Painter::default();
        let buffer = screen(&[(3, 2, 'x', 1)]);
        assert!(!painter.paint(&buffer, None).is_empty());
        assert_eq!(painter.paint(&buffer, None), "");
    }
}
