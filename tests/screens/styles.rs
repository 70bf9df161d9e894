//! What is meant is not said by colour alone, and colours are where they belong.

use ratatui::buffer::{Buffer, Cell};
use ratatui::style::{Color, Modifier};

use ballast::tui::app::App;
use ballast::tui::look::{Points, Theme};
use ballast::tui::panes::PaneId;

use crate::example::{LOOK, app};
use crate::{drawn, text};

/// First cell of a text on the screen.
fn cell_of<'a>(buffer: &'a Buffer, what: &str) -> &'a Cell {
    let lines = text(buffer);
    for (y, line) in lines.lines().enumerate() {
        if let Some(at) = line.find(what) {
            let x = line[..at].chars().count();
            return &buffer[(x as u16, y as u16)];
        }
    }
    panic!("`{what}` is not on the screen:\n{lines}");
}

fn enlarged(id: PaneId) -> App {
    let mut app = app(LOOK);
    app.zoomed = Some(id);
    app
}

#[test]
fn states_have_their_colours() {
    let mut app = app(LOOK);
    assert_eq!(cell_of(&drawn(&mut app, 120, 40), "RUN").fg, Color::Green);
    assert_eq!(
        cell_of(&drawn(&mut app, 120, 40), "1 warning").fg,
        Color::Yellow
    );
    app.failure = Some("broken".into());
    assert_eq!(cell_of(&drawn(&mut app, 120, 40), "FAILED").fg, Color::Red);
}

#[test]
fn new_warnings_have_a_mark_until_seen() {
    let mut app = enlarged(PaneId::Monitor);
    let warning = drawn(&mut app, 80, 24);
    assert_eq!(cell_of(&warning, "! disc 5, 14 311").fg, Color::Yellow);
    app.unseen = 0;
    let seen = text(&drawn(&mut app, 80, 24));
    assert!(
        seen.contains("  disc 5, 14 311") && !seen.contains("! disc"),
        "{seen}"
    );
}

#[test]
fn the_largest_force_is_red_and_widest() {
    let mut app = enlarged(PaneId::Assembly);
    let buffer = drawn(&mut app, 120, 40);
    // Disc 2 presses on the floor with 48 N, nearly four times the mean.
    let red = buffer.content().iter().filter(|cell| cell.fg == Color::Red);
    let dots = |cell: &Cell| {
        cell.symbol()
            .chars()
            .map(|c| (c as u32 & 0xff).count_ones())
            .sum()
    };
    let fullest: u32 = red.map(dots).max().unwrap();
    assert_eq!(fullest, 8);
}

#[test]
fn mono_uses_no_colour_and_keeps_the_selection_visible() {
    let mut app = enlarged(PaneId::Assembly);
    app.look.theme = Theme::Mono;
    app.selected = Some(7);
    for (width, height) in [(80, 24), (200, 60)] {
        let buffer = drawn(&mut app, width, height);
        for cell in buffer.content() {
            assert_eq!((cell.fg, cell.bg), (Color::Reset, Color::Reset));
        }
        let reversed = |cell: &&Cell| cell.modifier.contains(Modifier::REVERSED);
        assert!(buffer.content().iter().filter(reversed).count() > 8);
    }
}

#[test]
fn forces_differ_without_colour() {
    let mut app = enlarged(PaneId::Assembly);
    app.look.theme = Theme::Mono;
    app.look.points = Points::Ascii;
    let screen = text(&drawn(&mut app, 120, 40));
    for mark in ['-', '=', '%', '@', 'o', '#'] {
        assert!(screen.contains(mark), "{mark}\n{screen}");
    }
}

#[test]
fn a_creeping_assembly_changes_few_cells() {
    let mut app = app(LOOK);
    let before = drawn(&mut app, 120, 40);
    let mut frame = app.frame.clone().unwrap();
    frame.restarted = false;
    frame.cycle += 100;
    (frame.measures_of, frame.frac_limit_of) = (frame.cycle, frame.cycle);
    frame.stage_cycles.0 += 100;
    let mut row = app.series.rows().last().unwrap().clone();
    row.cycle += 100;
    frame.rows = vec![row];
    for touch in &mut frame.picture.touches {
        touch.n *= 1.003;
    }
    for disc in &mut frame.picture.discs {
        disc.at[1] -= 1e-6;
    }
    app.take_frame(frame);
    let after = drawn(&mut app, 120, 40);
    let changed = before.diff(&after).len();
    // The cycle, and little else.
    assert!((1..30).contains(&changed), "{changed} cells");
}
