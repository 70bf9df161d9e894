//! Text on the screen: clipped to its place, and in ASCII where nothing else can be shown.

use std::borrow::Cow;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::look::{Look, Points, Role};

/// A text as this terminal can show it.
pub fn shown<'a>(look: &Look, text: &'a str) -> Cow<'a, str> {
    if look.points != Points::Ascii || text.is_ascii() {
        return Cow::Borrowed(text);
    }
    let plain = text.chars().map(|c| if c.is_ascii() { c } else { '?' });
    Cow::Owned(plain.collect())
}

/// Writes on line `row` of an area from column `column` on; answers the column behind the text.
pub fn styled(
    look: &Look,
    (area, buffer): (Rect, &mut Buffer),
    (column, row): (u16, u16),
    text: &str,
    style: Style,
) -> u16 {
    let area = area.intersection(buffer.area);
    if row >= area.height || column >= area.width {
        return column;
    }
    let width = usize::from(area.width - column);
    let (x, y) = (area.x + column, area.y + row);
    let (end, _) = buffer.set_stringn(x, y, shown(look, text), width, style);
    end - area.x
}

/// The same in the style of a role.
pub fn at(look: &Look, on: (Rect, &mut Buffer), place: (u16, u16), text: &str, role: Role) -> u16 {
    styled(look, on, place, text, look.style(role))
}

/// Lines that follow each other in an area; those that do not fit are left out.
pub struct Lines<'a> {
    look: &'a Look,
    area: Rect,
    buffer: &'a mut Buffer,
    row: u16,
}

impl<'a> Lines<'a> {
    /// From the top of an area on.
    pub fn new(look: &'a Look, area: Rect, buffer: &'a mut Buffer) -> Self {
        Self {
            look,
            area,
            buffer,
            row: 0,
        }
    }

    /// Lines that are left.
    pub fn left(&self) -> u16 {
        self.area.height.saturating_sub(self.row)
    }

    /// Adds a line of parts in different roles.
    pub fn parts(&mut self, parts: &[(&str, Role)]) {
        let mut column = 0;
        for (text, role) in parts {
            let on = (self.area, &mut *self.buffer);
            column = at(self.look, on, (column, self.row), text, *role);
        }
        self.row = self.row.saturating_add(1);
    }

    /// Adds a line.
    pub fn line(&mut self, text: &str, role: Role) {
        self.parts(&[(text, role)]);
    }

    /// Adds a text in as many lines as it needs.
    pub fn text(&mut self, text: &str, role: Role) {
        for line in wrapped(text, usize::from(self.area.width)) {
            self.line(&line, role);
        }
    }
}

/// As many parts of a title, set off by two blanks, as have room in so many columns.
pub fn fitting(title: &str, room: usize) -> &str {
    let mut text = title;
    while text.chars().count() > room {
        match text.rsplit_once("  ") {
            Some((shorter, _)) => text = shorter.trim_end(),
            None => break,
        }
    }
    text
}

/// A title in so many columns that says which cycle it is about, whatever else there is no room for.
pub fn dated(title: &str, cycle: &str, room: usize) -> String {
    let at = format!("at cycle {cycle}");
    let (name, more) = title.split_once("  ").unwrap_or((title, ""));
    let name = format!("{name} {at}");
    match (name.chars().count() <= room, more) {
        (false, _) => at,
        (true, "") => name,
        (true, more) => format!("{name}  {more}"),
    }
}

/// A text in lines of so many columns, broken at blanks where there are any.
pub fn wrapped(text: &str, width: usize) -> Vec<String> {
    let width = width.max(1);
    let mut rest: Vec<char> = text.chars().filter(|c| !c.is_control()).collect();
    let mut lines = Vec::new();
    while rest.len() > width {
        let blank = rest[..=width].iter().rposition(|&c| c == ' ');
        // A blank in the first third would leave a nearly empty line.
        let cut = blank.filter(|&k| 3 * k > width).unwrap_or(width);
        let line: String = rest[..cut].iter().collect();
        lines.push(line.trim_end().to_owned());
        rest.drain(..cut);
        if rest.first() == Some(&' ') {
            rest.remove(0);
        }
    }
    lines.push(rest.into_iter().collect());
    lines
}

/// A gauge so many columns wide, filled from the left.
pub fn gauge(look: &Look, share: f64, width: usize) -> String {
    let (full, empty) = if look.points == Points::Ascii {
        ('#', '.')
    } else {
        ('█', '░')
    };
    let share = if share.is_finite() {
        share.clamp(0.0, 1.0)
    } else {
        0.0
    };
    let filled = (share * width as f64).round() as usize;
    (0..width)
        .map(|k| if k < filled { full } else { empty })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tui::look::from_environment;

    #[test]
    fn lines_break_at_blanks() {
        assert_eq!(wrapped("", 5), [""]);
        assert_eq!(wrapped("one two", 7), ["one two"]);
        assert_eq!(wrapped("one two three", 8), ["one two", "three"]);
        assert_eq!(wrapped("abcdefghij", 4), ["abcd", "efgh", "ij"]);
        assert_eq!(wrapped("  indented", 40), ["  indented"]);
    }

    #[test]
    fn ascii_terminals_get_ascii() {
        let look = from_environment(|_| None);
        assert_eq!(shown(&look, "1.2 µm"), "1.2 ?m");
        assert_eq!(gauge(&look, 0.5, 4), "##..");
        assert_eq!(gauge(&look, f64::NAN, 2), "..");
    }

    #[test]
    fn titles_lose_their_last_parts() {
        let title = "kinetic [J] 0.1  translational  energy";
        assert_eq!(fitting(title, 74), title);
        assert_eq!(fitting(title, 34), "kinetic [J] 0.1  translational");
        assert_eq!(fitting(title, 16), "kinetic [J] 0.1");
        assert_eq!(fitting(title, 0), "kinetic [J] 0.1");
    }
}
