//! The prompt: one line with history and completion.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tui_input::{Input, InputRequest};

use crate::language::Known;
use crate::tui::completion::complete;

/// What a key at the prompt led to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Typed {
    /// Editing goes on.
    Editing,
    /// A line to execute.
    Line(String),
    /// The prompt was left.
    Left,
}

/// The line being typed.
#[derive(Debug, Default)]
pub struct Prompt {
    /// Whether keys go here.
    pub open: bool,
    input: Input,
    history: Vec<String>,
    /// Place in the history while walking through it.
    recalled: Option<usize>,
    /// What could stand here, after Tab.
    pub candidates: Vec<String>,
}

impl Prompt {
    /// The text.
    pub fn text(&self) -> &str {
        self.input.value()
    }

    /// Column of the cursor.
    pub fn cursor(&self) -> usize {
        self.input.visual_cursor()
    }

    /// Opens the prompt with a text.
    pub fn open_with(&mut self, text: &str) {
        self.open = true;
        self.recalled = None;
        self.candidates.clear();
        self.input = Input::new(text.to_owned());
    }

    /// Adds pasted text.
    pub fn paste(&mut self, text: &str) {
        for c in text.chars().filter(|c| !c.is_control()) {
            self.input.handle(InputRequest::InsertChar(c));
        }
    }

    /// Takes a key.
    pub fn key(&mut self, key: KeyEvent, known: &Known) -> Typed {
        let control = key.modifiers.contains(KeyModifiers::CONTROL);
        if key.code != KeyCode::Tab {
            self.candidates.clear();
        }
        let edit = match (key.code, control) {
            (KeyCode::Enter, _) => return self.enter(),
            (KeyCode::Esc, _) => {
                self.open = false;
                return Typed::Left;
            }
            (KeyCode::Char('c'), true) => {
                let empty = self.text().is_empty();
                self.input = Input::default();
                self.open = !empty;
                return if empty { Typed::Left } else { Typed::Editing };
            }
            (KeyCode::Tab, _) => {
                self.complete(known);
                return Typed::Editing;
            }
            (KeyCode::Up, _) | (KeyCode::Char('p'), true) => {
                self.recall(true);
                return Typed::Editing;
            }
            (KeyCode::Down, _) | (KeyCode::Char('n'), true) => {
                self.recall(false);
                return Typed::Editing;
            }
            (KeyCode::Char('a'), true) | (KeyCode::Home, _) => InputRequest::GoToStart,
            (KeyCode::Char('e'), true) | (KeyCode::End, _) => InputRequest::GoToEnd,
            (KeyCode::Char('u'), true) => InputRequest::DeleteLine,
            (KeyCode::Char('k'), true) => InputRequest::DeleteTillEnd,
            (KeyCode::Char('w'), true) => InputRequest::DeletePrevWord,
            (KeyCode::Char('h'), true) | (KeyCode::Backspace, _) => InputRequest::DeletePrevChar,
            (KeyCode::Delete, _) => InputRequest::DeleteNextChar,
            (KeyCode::Left, true) => InputRequest::GoToPrevWord,
            (KeyCode::Right, true) => InputRequest::GoToNextWord,
            (KeyCode::Left, false) => InputRequest::GoToPrevChar,
            (KeyCode::Right, false) => InputRequest::GoToNextChar,
            (KeyCode::Char(c), false) => InputRequest::InsertChar(c),
            _ => return Typed::Editing,
        };
        self.input.handle(edit);
        Typed::Editing
    }

    /// What Enter does.
    pub(super) fn enter(&mut self) -> Typed {
        let line = self.text().trim().to_owned();
        self.input = Input::default();
        self.recalled = None;
        if line.is_empty() {
            self.open = false;
            return Typed::Left;
        }
        if self.history.last() != Some(&line) {
            self.history.push(line.clone());
        }
        Typed::Line(line)
    }

    fn recall(&mut self, older: bool) {
        let last = self.history.len();
        let place = match (self.recalled, older) {
            (None, true) => last.checked_sub(1),
            (Some(place), true) => Some(place.saturating_sub(1)),
            (Some(place), false) if place + 1 < last => Some(place + 1),
            (_, false) => None,
        };
        self.recalled = place;
        let text = place.map_or_else(String::new, |place| self.history[place].clone());
        self.input = Input::new(text);
    }

    /// Completes as far as all candidates agree, and lists them.
    fn complete(&mut self, known: &Known) {
        let line = self.text().to_owned();
        let completion = complete(&line, known);
        let Some(first) = completion.candidates.first() else {
            return;
        };
        let common = completion
            .candidates
            .iter()
            .fold(first.clone(), |common, candidate| {
                let same = common
                    .chars()
                    .zip(candidate.chars())
                    .take_while(|(a, b)| a == b)
                    .count();
                common.chars().take(same).collect()
            });
        let mut text = line[..completion.start].to_owned();
        let typed = &line[completion.start..];
        text.push_str(if common.len() >= typed.len() {
            &common
        } else {
            typed
        });
        if completion.candidates.len() == 1 {
            text.push(' ');
        } else {
            self.candidates.clone_from(&completion.candidates);
        }
        self.input = Input::new(text);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(prompt: &mut Prompt, code: KeyCode) -> Typed {
        prompt.key(KeyEvent::new(code, KeyModifiers::NONE), &Known::default())
    }

    fn write(prompt: &mut Prompt, text: &str) {
        text.chars().for_each(|c| {
            press(prompt, KeyCode::Char(c));
        });
    }

    #[test]
    fn lines_are_completed_executed_and_recalled() {
        let mut prompt = Prompt::default();
        prompt.open_with("");
        write(&mut prompt, "fric");
        press(&mut prompt, KeyCode::Tab);
        assert_eq!(prompt.text(), "friction ");
        write(&mut prompt, "0.3");
        assert_eq!(
            press(&mut prompt, KeyCode::Enter),
            Typed::Line("friction 0.3".into())
        );
        assert_eq!(prompt.text(), "");
        press(&mut prompt, KeyCode::Up);
        assert_eq!(prompt.text(), "friction 0.3");
        press(&mut prompt, KeyCode::Down);
        assert_eq!(prompt.text(), "");
        assert_eq!(press(&mut prompt, KeyCode::Esc), Typed::Left);
    }
}
