//! Which pane stands where, has the focus, and how much of it can be read.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use ballast::language::Observable;
use ballast::measure::columns::Column;
use ballast::tui::app::{App, Overlay};
use ballast::tui::keys::KEYS;
use ballast::tui::panes::PaneId;

use crate::example::{LOOK, app, contact};
use crate::{drawn, text};

fn press(app: &mut App, key: char, (width, height): (u16, u16)) {
    let code = if key == '\t' {
        KeyCode::Tab
    } else {
        KeyCode::Char(key)
    };
    app.key(KeyEvent::new(code, KeyModifiers::NONE));
    drawn(app, width, height);
}

#[test]
fn the_contact_that_is_followed_gets_the_focus() {
    for size in [(80, 24), (120, 40), (200, 60)] {
        let mut app = app(LOOK);
        drawn(&mut app, size.0, size.1);
        press(&mut app, 'i', size);
        // It comes with the next frame.
        let mut frame = crate::example::frame();
        (frame.contact, frame.restarted) = (Some(contact()), false);
        app.take_frame(Box::new(frame));
        drawn(&mut app, size.0, size.1);
        assert_eq!(app.focused(), Some(PaneId::Contact));
        press(&mut app, 'z', size);
        assert_eq!(app.zoomed, Some(PaneId::Contact));
    }
}

#[test]
fn keys_choose_the_only_pane_of_a_small_screen() {
    for size in [(40, 12), (20, 5)] {
        let mut app = app(LOOK);
        drawn(&mut app, size.0, size.1);
        assert_eq!(app.focused(), Some(PaneId::Numbers));
        for (key, shown) in [
            ('1', PaneId::Assembly),
            ('\t', PaneId::Chart(0)),
            ('p', PaneId::Contact),
            ('P', PaneId::Chart(0)),
            ('z', PaneId::Numbers),
            ('z', PaneId::Assembly),
            ('4', PaneId::Rose(0)),
            ('i', PaneId::Contact),
        ] {
            press(&mut app, key, size);
            assert_eq!(app.focused(), Some(shown), "{key} at {size:?}");
        }
        app.prompt.open_with("pane assembly");
        app.key(KeyEvent::new(KeyCode::Enter, KeyModifiers::NONE));
        drawn(&mut app, size.0, size.1);
        assert_eq!(app.focused(), Some(PaneId::Assembly));
    }
}

/// Help in all its pages, without frames and breaks.
fn help(size: (u16, u16)) -> String {
    let mut app = app(LOOK);
    app.overlay = Some(Overlay::Help(0));
    let (mut pages, mut at) = (String::new(), None);
    loop {
        let page = text(&drawn(&mut app, size.0, size.1));
        if app.overlay == at {
            break;
        }
        at = app.overlay;
        pages += &page;
        app.key(KeyEvent::new(KeyCode::PageDown, KeyModifiers::NONE));
    }
    pages
}

#[test]
fn help_is_neither_cut_nor_run_together() {
    for size in [(20, 5), (40, 12), (80, 24), (120, 40)] {
        let pages = help(size);
        let plain = pages.replace(['│', '─', '┌', '┐', '└', '┘'], " ");
        let words: Vec<&str> = plain.split_whitespace().collect();
        for key in KEYS {
            for word in key.help.split_whitespace().filter(|word| word.len() < 17) {
                let found =
                    words.contains(&word) || key.label.starts_with(|c: char| c.is_numeric());
                assert!(found, "{word} of {} at {size:?}: {pages}", key.label);
            }
        }
    }
}

#[test]
fn numbers_stand_only_where_a_key_leads() {
    let lines = text(&drawn(&mut app(LOOK), 200, 60));
    assert!(lines.contains(" 9 dialogue "), "{lines}");
    assert!(
        !lines.contains(" 10 ") && lines.contains("─ newest row") || lines.contains("┌ newest row")
    );
}

#[test]
fn a_preset_without_stages_waits_instead_of_being_done() {
    let mut app = app(LOOK);
    let frame = app.frame.as_mut().expect("it has one");
    (frame.running, frame.finished, frame.stages) = (false, true, (0, 0));
    let lines = text(&drawn(&mut app, 80, 24));
    assert!(lines.starts_with("PAUSED"), "{lines}");
    assert!(lines.contains("no stages: space runs"), "{lines}");
}

#[test]
fn the_step_monitor_does_not_contradict_its_warnings() {
    let mut app = app(LOOK);
    let frame = app.frame.as_mut().expect("it has one");
    frame.fracc.largest = None;
    app.series = ballast::tui::series::Series::default();
    let lines = text(&drawn(&mut app, 120, 40));
    assert!(lines.contains("none since the last row"), "{lines}");
    assert!(lines.contains("disc 5, 14 311"), "{lines}");
}

#[test]
fn a_selected_disc_is_described_to_the_end() {
    let mut app = app(LOOK);
    app.selected = Some(2);
    let lines = text(&drawn(&mut app, 80, 24));
    assert!(lines.contains("contacts"), "{lines}");
}

#[test]
fn names_of_columns_are_whole_where_there_is_room() {
    let name = "wall:a_rather_long_name:eccentricity";
    let mut app = app(LOOK);
    let mut frame = crate::example::frame();
    let column = Column::parse(name).expect("it is one");
    frame.columns = vec![Observable::Column(column)].into();
    for row in &mut frame.rows {
        row.values.truncate(1);
    }
    app.take_frame(Box::new(frame));
    app.zoomed = Some(PaneId::Numbers);
    let lines = text(&drawn(&mut app, 80, 24));
    assert!(lines.contains(name), "{lines}");
}
