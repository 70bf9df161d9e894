//! What is said, and how it gets the room to be read.

use super::{App, Said};
use crate::tui::layout::{self, Class};
use crate::tui::panes::{self, PaneId};

/// Entries of the dialogue kept.
const KEPT: usize = 2000;

impl App {
    /// Adds to the dialogue.
    pub fn say(&mut self, said: Said) {
        self.dialogue.push(said);
        if self.dialogue.len() > KEPT {
            self.dialogue.drain(..KEPT / 4);
        }
        self.scrolled = 0;
        self.unread = None;
        self.dirty = true;
    }

    /// Another run keeps its files in this folder; says where those of the run before stay.
    pub fn keep_in(&mut self, folder: String) {
        let before = std::mem::replace(&mut self.folder, folder);
        if !before.is_empty() {
            let text = format!("the run before is kept in {before}");
            self.say(Said::Notice(text));
        }
    }

    /// Says something that has to be readable to its end: what does not fit where it would stand
    /// gets the whole screen, from its beginning on. Esc gives it back.
    pub(super) fn answer(&mut self, all: Vec<Said>) {
        let count = all.len();
        for said in all {
            self.say(said);
        }
        let first = self.dialogue.len().saturating_sub(count);
        let fits = match self.dialogue_room() {
            Some((width, height)) => panes::dialogue::height(self, first, width) <= height,
            None => {
                let width = usize::from(self.arrangement.last.width);
                count <= 1 && panes::dialogue::height(self, first, width) <= self.most_at_bottom()
            }
        };
        if !fits {
            self.zoomed = Some(PaneId::Dialogue);
            self.unread = Some(first);
        }
    }

    /// Columns and lines of the dialogue, if it is on the screen.
    fn dialogue_room(&self) -> Option<(usize, usize)> {
        let area = self.place_of(PaneId::Dialogue)?;
        let border = match self.arrangement.class {
            Class::Numbers => 0,
            _ => 2,
        };
        let inside = |length: u16| usize::from(length.saturating_sub(border));
        Some((inside(area.width), inside(area.height)))
    }

    fn most_at_bottom(&self) -> usize {
        usize::from(layout::most_at_bottom(self.area))
    }

    /// Lines that the last thing said needs below the panes: none where the dialogue is in sight.
    pub(super) fn lines_at_bottom(&self) -> u16 {
        if self.place_of(PaneId::Dialogue).is_some() {
            return 0;
        }
        let width = usize::from(self.arrangement.last.width);
        let last = self.dialogue.len().saturating_sub(1);
        let needed = panes::dialogue::height(self, last, width).max(1);
        needed.min(self.most_at_bottom()) as u16
    }

    /// Lines of a page of the dialogue; the last of one page is the first of the next.
    fn page(&self) -> usize {
        let lines = self.dialogue_room().map_or(1, |(_, lines)| lines);
        lines.saturating_sub(1).max(1)
    }

    /// Lines of a page of what lies over the panes.
    pub(super) fn overlay_page(&self) -> usize {
        usize::from(self.area.height.saturating_sub(3)).max(1)
    }

    /// Scrolls the dialogue by lines.
    pub(super) fn scroll(&mut self, by: isize) {
        self.scrolled = self.scrolled.saturating_add_signed(-by);
        self.settle_dialogue();
    }

    /// Scrolls the dialogue by pages.
    pub(super) fn scroll_pages(&mut self, by: isize) {
        self.scroll(by * self.page() as isize);
    }

    /// Keeps the dialogue within its pane: its first line stays at the top at the latest.
    pub(super) fn settle_dialogue(&mut self) {
        let Some((width, height)) = self.dialogue_room() else {
            self.scrolled = 0;
            return;
        };
        if let Some(first) = self.unread.take() {
            let lines = panes::dialogue::height(self, first, width);
            self.scrolled = lines.saturating_sub(height);
        }
        if self.scrolled > 0 {
            let lines = panes::dialogue::height(self, 0, width);
            self.scrolled = self.scrolled.min(lines.saturating_sub(height));
        }
    }
}
