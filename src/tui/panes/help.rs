//! Help, and the question before quitting.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::widgets::{Block, Clear, Widget};

use super::PANES;
use crate::language::COMMANDS;
use crate::tui::app::App;
use crate::tui::app::words::WORDS;
use crate::tui::keys::{Action, KEYS};
use crate::tui::look::Role;
use crate::tui::write::{self, Lines};

/// Below this width keys stand in one column.
const TWO_COLUMNS: u16 = 92;

/// A line of help.
type Line = (String, Role);

/// Everything there is to say, for a page so many columns wide.
fn page(app: &App, width: u16) -> Vec<Line> {
    let mut page = Vec::new();
    let heading = |page: &mut Vec<Line>, text: &str| {
        if !page.is_empty() {
            page.push((String::new(), Role::Label));
        }
        let lines = write::wrapped(text, usize::from(width));
        page.extend(lines.into_iter().map(|line| (line, Role::Value)));
    };
    heading(&mut page, "KEYS");
    page.extend(keys(width));
    heading(
        &mut page,
        "COMMANDS, after `:`; `help NAME` explains one; Tab completes; words may be shortened",
    );
    let cards = COMMANDS.iter().map(|card| (card.name, card.summary));
    page.extend(table(cards, 10, width));
    heading(&mut page, "WORDS OF THE SCREEN, after `:` as well");
    let words = WORDS.iter().map(|word| (word.usage, word.summary));
    page.extend(table(words, 16, width));
    heading(
        &mut page,
        "PANES; p changes what stands in the place in focus, ] turns it to another drawing, z enlarges it",
    );
    page.extend(table(
        PANES.iter().map(|(_, pane)| (pane.name, pane.summary)),
        14,
        width,
    ));
    heading(&mut page, "GOOD TO KNOW");
    let folder = if app.folder.is_empty() {
        "The run keeps no files of its own.".to_owned()
    } else {
        format!(
            "The journal and the last state of the run are kept in {}",
            app.folder
        )
    };
    let notes = [
        folder.as_str(),
        "Every command is in the journal with its cycle; `ballast run` on it repeats the run bit \
         for bit.",
        "Ctrl-Z stops the program and the run with it; `fg` in the shell goes on.",
        "Over a slow line: `set kbps 20`, or fewer frames with <. What the line cannot carry is \
         left out, never queued.",
    ];
    for note in notes {
        let lines = write::wrapped(note, usize::from(width));
        page.extend(lines.into_iter().map(|line| (line, Role::Label)));
    }
    page
}

/// Keys with what they do, in two columns if there is room.
fn keys(width: u16) -> Vec<Line> {
    let mut rows: Vec<(&str, &str)> = Vec::new();
    for key in KEYS {
        match key.action {
            Action::Pane(0) => rows.push(("1 to 9", "pane of this number")),
            Action::Pane(_) => {}
            _ => rows.push((key.label, key.help)),
        }
    }
    if width < TWO_COLUMNS {
        return table(rows.into_iter(), 8, width);
    }
    let column = usize::from(width / 2);
    let texts = table(rows.into_iter(), 8, width / 2 - 2);
    // A key and all of its meaning stand in one of them.
    let mut half = texts.len().div_ceil(2);
    while texts
        .get(half)
        .is_some_and(|(text, _)| text.starts_with(' '))
    {
        half += 1;
    }
    let lines = (0..half).map(|k| {
        let right = texts.get(half + k).map_or("", |(text, _)| text.as_str());
        (format!("{:column$}{right}", texts[k].0), Role::Label)
    });
    lines.collect()
}

/// Fewer columns than this are no room for meanings beside names.
const BESIDE: usize = 16;

/// Names and what they mean; long meanings go on in the next line, and where there is no room beside
/// the names all of them begin there.
fn table<'a>(
    rows: impl Iterator<Item = (&'a str, &'a str)>,
    names: usize,
    width: u16,
) -> Vec<Line> {
    let width = usize::from(width);
    let room = width.saturating_sub(names + 1);
    let mut lines = Vec::new();
    for (name, meaning) in rows {
        if room < BESIDE {
            let below = write::wrapped(meaning, width.saturating_sub(2));
            lines.push((name.to_owned(), Role::Label));
            lines.extend(below.iter().map(|part| (format!("  {part}"), Role::Label)));
            continue;
        }
        for (k, part) in write::wrapped(meaning, room).iter().enumerate() {
            let name = if k == 0 { name } else { "" };
            lines.push((format!("{name:names$} {part}"), Role::Label));
        }
    }
    lines
}

/// Draws help from a line on; answers the line it really began with, the last page's at most.
pub fn draw(app: &App, from: u16, area: Rect, buffer: &mut Buffer) -> u16 {
    let area = area.intersection(buffer.area);
    let inner = Block::bordered().inner(area);
    let page = page(app, inner.width);
    let most = page.len().saturating_sub(usize::from(inner.height));
    let from = usize::from(from).min(most);
    let last = (from + usize::from(inner.height)).min(page.len());
    let position = if most == 0 {
        "Esc closes".to_owned()
    } else {
        format!(
            "lines {} to {last} of {}; j k PgDn PgUp, Esc closes",
            from + 1,
            page.len()
        )
    };
    frame(app, &format!(" help  {position} "), area, buffer);
    let mut lines = Lines::new(&app.look, inner, buffer);
    for (text, role) in &page[from..last] {
        lines.line(text, *role);
    }
    from as u16
}

/// An empty box with a title.
pub(super) fn frame(app: &App, title: &str, area: Rect, buffer: &mut Buffer) {
    Clear.render(area, buffer);
    Block::bordered()
        .border_set(app.border())
        .border_style(app.look.style(Role::Focus))
        .title(write::shown(&app.look, title))
        .render(area, buffer);
}

/// Asks before unsaved cycles are left.
pub fn ask(app: &App, area: Rect, buffer: &mut Buffer) {
    let area = area.intersection(buffer.area);
    let cycles = app.frame.as_ref().map_or(0, |frame| frame.cycle);
    let text = format!(
        "{} cycles are not exported. q quits all the same; Esc stays, then e exports.",
        super::status::grouped(cycles.saturating_sub(app.kept_cycle))
    );
    let width = area.width.min(56);
    let room = usize::from(width.saturating_sub(2));
    let height = (write::wrapped(&text, room).len() as u16 + 2).min(area.height);
    let place = Rect {
        x: area.x + (area.width - width) / 2,
        y: area.y + (area.height - height) / 2,
        width,
        height,
    };
    frame(app, " quit? ", place, buffer);
    let inner = Block::bordered().inner(place);
    // A box too small for its border and the question shows the question.
    let inner = if inner.is_empty() { place } else { inner };
    Lines::new(&app.look, inner, buffer).text(&text, Role::Warning);
}
