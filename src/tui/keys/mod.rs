//! What each key does: the dispatcher, the help page and the README read the same table.

mod action;

pub use action::Action;

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

/// A row of the table.
#[derive(Debug, Clone, Copy)]
pub struct Key {
    /// The keys.
    pub press: &'static [(KeyCode, KeyModifiers)],
    /// How they are written.
    pub label: &'static str,
    /// What they do.
    pub help: &'static str,
    /// What they do.
    pub action: Action,
    /// Short word in the line of hints, for the most useful.
    pub hint: Option<&'static str>,
}

const NONE: KeyModifiers = KeyModifiers::NONE;
const CONTROL: KeyModifiers = KeyModifiers::CONTROL;

const fn key(
    press: &'static [(KeyCode, KeyModifiers)],
    label: &'static str,
    help: &'static str,
    action: Action,
) -> Key {
    Key {
        press,
        label,
        help,
        action,
        hint: None,
    }
}

const fn hinted(hint: &'static str, key: Key) -> Key {
    Key {
        hint: Some(hint),
        ..key
    }
}

macro_rules! press {
    ($($code:expr),+) => { &[$(($code, NONE)),+] };
}

/// All keys, in the order help shows them.
pub const KEYS: &[Key] = &[
    hinted(
        "run/pause",
        key(
            press!(KeyCode::Char(' ')),
            "space",
            "run or pause",
            Action::Toggle,
        ),
    ),
    hinted(
        "cycle",
        key(press!(KeyCode::Char('.')), ".", "one cycle", Action::Cycle),
    ),
    key(
        press!(KeyCode::Char(',')),
        ",",
        "up to the next row of the history",
        Action::Row,
    ),
    hinted(
        "command",
        key(
            press!(KeyCode::Char(':')),
            ":",
            "type a command",
            Action::Prompt,
        ),
    ),
    hinted(
        "help",
        key(
            press!(KeyCode::Char('?'), KeyCode::F(1)),
            "?",
            "help",
            Action::Help,
        ),
    ),
    hinted(
        "presets",
        key(
            press!(KeyCode::Char('b')),
            "b",
            "browse presets",
            Action::Presets,
        ),
    ),
    hinted(
        "pane",
        key(press!(KeyCode::Tab), "Tab", "next pane", Action::Focus(1)),
    ),
    key(
        &[
            (KeyCode::BackTab, KeyModifiers::SHIFT),
            (KeyCode::BackTab, NONE),
        ],
        "S-Tab",
        "pane before",
        Action::Focus(-1),
    ),
    key(press!(KeyCode::Char('1')), "1", "assembly", Action::Pane(0)),
    key(
        press!(KeyCode::Char('2')),
        "2",
        "second pane",
        Action::Pane(1),
    ),
    key(
        press!(KeyCode::Char('3')),
        "3",
        "third pane",
        Action::Pane(2),
    ),
    key(
        press!(KeyCode::Char('4')),
        "4",
        "fourth pane",
        Action::Pane(3),
    ),
    key(
        press!(KeyCode::Char('5')),
        "5",
        "fifth pane",
        Action::Pane(4),
    ),
    key(
        press!(KeyCode::Char('6')),
        "6",
        "sixth pane",
        Action::Pane(5),
    ),
    key(
        press!(KeyCode::Char('7')),
        "7",
        "seventh pane",
        Action::Pane(6),
    ),
    key(
        press!(KeyCode::Char('8')),
        "8",
        "eighth pane",
        Action::Pane(7),
    ),
    key(
        press!(KeyCode::Char('9')),
        "9",
        "ninth pane",
        Action::Pane(8),
    ),
    hinted(
        "zoom",
        key(
            press!(KeyCode::Char('z'), KeyCode::Enter),
            "z",
            "enlarge the pane, or back",
            Action::Zoom,
        ),
    ),
    hinted(
        "swap",
        key(
            press!(KeyCode::Char('p')),
            "p",
            "another pane in the place in focus; `pane NAME` puts one there",
            Action::Place(1),
        ),
    ),
    key(
        press!(KeyCode::Char('P')),
        "P",
        "the pane before in the list of panes",
        Action::Place(-1),
    ),
    key(press!(KeyCode::Esc), "Esc", "back", Action::Back),
    key(
        press!(KeyCode::Char('h'), KeyCode::Left),
        "h left",
        "view to the left",
        Action::Pan(-0.1, 0.0),
    ),
    key(
        press!(KeyCode::Char('l'), KeyCode::Right),
        "l right",
        "view to the right",
        Action::Pan(0.1, 0.0),
    ),
    key(
        press!(KeyCode::Char('k'), KeyCode::Up),
        "k up",
        "view up, or scroll up",
        Action::Pan(0.0, 0.1),
    ),
    key(
        press!(KeyCode::Char('j'), KeyCode::Down),
        "j down",
        "view down, or scroll down",
        Action::Pan(0.0, -0.1),
    ),
    key(
        press!(KeyCode::PageUp),
        "PgUp",
        "scroll up by a page",
        Action::Scroll(-1),
    ),
    key(
        press!(KeyCode::PageDown),
        "PgDn",
        "scroll down by a page",
        Action::Scroll(1),
    ),
    key(
        press!(KeyCode::Char('+'), KeyCode::Char('=')),
        "+",
        "magnify",
        Action::Magnify(1.25),
    ),
    key(
        press!(KeyCode::Char('-')),
        "-",
        "show more",
        Action::Magnify(0.8),
    ),
    key(press!(KeyCode::Char('0')), "0", "show all", Action::Fit),
    key(
        press!(KeyCode::Char(']')),
        "]",
        "next drawing of the pane in focus: column of a chart, weights of a rose ...",
        Action::Turn(1),
    ),
    key(
        press!(KeyCode::Char('[')),
        "[",
        "drawing before",
        Action::Turn(-1),
    ),
    key(
        press!(KeyCode::Char('n')),
        "n",
        "select the next disc",
        Action::Select(1),
    ),
    key(
        press!(KeyCode::Char('N')),
        "N",
        "select the disc before",
        Action::Select(-1),
    ),
    key(
        press!(KeyCode::Char('i')),
        "i",
        "follow the next contact, of the selected disc if there is one",
        Action::Contact(1),
    ),
    key(
        press!(KeyCode::Char('I')),
        "I",
        "follow the contact before",
        Action::Contact(-1),
    ),
    key(
        press!(KeyCode::Char('f')),
        "f",
        "force bars: none, force, tangential",
        Action::Chains,
    ),
    key(
        press!(KeyCode::Char('d')),
        "d",
        "outlines of discs",
        Action::Discs,
    ),
    key(
        press!(KeyCode::Char('v')),
        "v",
        "velocities",
        Action::Velocities,
    ),
    key(
        press!(KeyCode::Char('c')),
        "c",
        "changes since the `reference`: contacts, rotations, displacements, sliding, none",
        Action::Compare,
    ),
    key(
        press!(KeyCode::Char('m')),
        "m",
        "points: braille, half blocks, ASCII",
        Action::Points,
    ),
    key(
        press!(KeyCode::Char('t')),
        "t",
        "colours or none",
        Action::Theme,
    ),
    key(
        press!(KeyCode::Char('{')),
        "{",
        "half the cycles per second",
        Action::Pace(false),
    ),
    key(
        press!(KeyCode::Char('}')),
        "}",
        "twice the cycles per second",
        Action::Pace(true),
    ),
    key(
        press!(KeyCode::Char('|')),
        "|",
        "as many cycles per second as possible",
        Action::Flat,
    ),
    key(
        press!(KeyCode::Char('<')),
        "<",
        "fewer frames per second",
        Action::Fps(false),
    ),
    key(
        press!(KeyCode::Char('>')),
        ">",
        "more frames per second",
        Action::Fps(true),
    ),
    key(
        press!(KeyCode::Char('w')),
        "w",
        "warnings have been seen",
        Action::Acknowledge,
    ),
    hinted(
        "export",
        key(
            press!(KeyCode::Char('e')),
            "e",
            "export the history as CSV",
            Action::PromptWith("export csv "),
        ),
    ),
    key(
        press!(KeyCode::Char('/')),
        "/",
        "inspect a contact",
        Action::PromptWith("inspect contact "),
    ),
    hinted(
        "quit",
        key(
            press!(KeyCode::Char('q')),
            "q",
            "quit; asks if cycles are unsaved",
            Action::Quit,
        ),
    ),
    key(
        &[(KeyCode::Char('l'), CONTROL)],
        "Ctrl-L",
        "repaint the screen",
        Action::Repaint,
    ),
    key(
        &[(KeyCode::Char('z'), CONTROL)],
        "Ctrl-Z",
        "suspend; the run stands still too, fg goes on",
        Action::Suspend,
    ),
    key(
        &[(KeyCode::Char('c'), CONTROL)],
        "Ctrl-C",
        "running: pause; paused: quit",
        Action::Interrupt,
    ),
];

/// The row of a key.
pub fn find(event: KeyEvent) -> Option<&'static Key> {
    // Terminals report capital letters with and without Shift.
    let modifiers = event.modifiers & (KeyModifiers::CONTROL | KeyModifiers::ALT);
    KEYS.iter().find(|key| {
        key.press.iter().any(|(code, wanted)| {
            *code == event.code && modifiers == (*wanted & !KeyModifiers::SHIFT)
        })
    })
}

/// Markdown table of the keys.
pub fn reference_table() -> String {
    let mut text = String::from("| key | what it does |\n|---|---|\n");
    for key in KEYS {
        text.push_str(&format!(
            "| `{}` | {} |\n",
            key.label.replace('|', "\\|"),
            key.help
        ));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_key_does_two_things() {
        let mut seen = Vec::new();
        for press in KEYS.iter().flat_map(|key| key.press) {
            assert!(!seen.contains(press), "{press:?}");
            seen.push(*press);
        }
    }

    #[test]
    fn keys_are_found_with_and_without_shift() {
        let plus = KeyEvent::new(KeyCode::Char('N'), KeyModifiers::SHIFT);
        assert_eq!(find(plus).unwrap().action, Action::Select(-1));
        let quit = KeyEvent::new(KeyCode::Char('c'), KeyModifiers::CONTROL);
        assert_eq!(find(quit).unwrap().action, Action::Interrupt);
        assert!(find(KeyEvent::new(KeyCode::Char('q'), KeyModifiers::CONTROL)).is_none());
    }
}
