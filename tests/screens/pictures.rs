//! Pictures, as text. They change only when what is drawn is meant to change.

use ballast::tui::app::{App, Overlay, Said};
use ballast::tui::look::{Chains, Points, Theme};
use ballast::tui::panes::{PANES, PaneId};

use crate::example::{LOOK, app, contact, empty};
use crate::{drawn, text};

const SIZES: [(u16, u16); 3] = [(80, 24), (120, 40), (200, 60)];

/// A name, and what is different about it.
type Variant = (&'static str, fn(&mut App));

fn compare(name: &str, mut app: App, (width, height): (u16, u16)) {
    let name = format!("{name}_{width}x{height}");
    insta::assert_snapshot!(name, text(&drawn(&mut app, width, height)));
}

#[test]
fn whole_screens() {
    for size in SIZES {
        compare("all", app(LOOK), size);
    }
}

#[test]
fn each_pane_enlarged() {
    for size in SIZES {
        for (id, pane) in PANES {
            let mut app = app(LOOK);
            app.zoomed = Some(*id);
            compare(&pane.name.replace(' ', "_"), app, size);
        }
    }
}

#[test]
fn what_lies_over_panes() {
    for size in SIZES {
        for (name, overlay) in [
            ("help", Overlay::Help(0)),
            ("help_end", Overlay::Help(u16::MAX)),
            ("presets", Overlay::Presets(2)),
            ("quit", Overlay::Quit),
        ] {
            let mut app = app(LOOK);
            app.overlay = Some(overlay);
            compare(name, app, size);
        }
    }
}

#[test]
fn assembly_in_its_variants() {
    let enlarged = |app: &mut App| app.zoomed = Some(PaneId::Assembly);
    let variants: [Variant; 7] = [
        ("ascii", |app| app.look.points = Points::Ascii),
        ("half_blocks", |app| app.look.points = Points::HalfBlock),
        ("tangential", |app| app.look.chains = Chains::Tangential),
        ("velocities", |app| app.look.velocities = true),
        ("chains_only", |app| app.look.discs = false),
        ("selected", |app| app.selected = Some(2)),
        ("magnified", |app| {
            app.view.magnify(3.0);
            app.view.pan([[0.0, 0.0], [0.8, 0.7]], -0.1, -0.2);
        }),
    ];
    for (name, change) in variants {
        let mut app = app(LOOK);
        enlarged(&mut app);
        change(&mut app);
        compare(&format!("assembly_{name}"), app, (80, 24));
    }
}

#[test]
fn a_contact_that_is_followed() {
    let enlarged = |app: &mut App| {
        set(app, |frame| frame.contact = Some(contact()));
        app.zoomed = Some(PaneId::Contact);
    };
    for size in SIZES {
        let mut followed = app(LOOK);
        enlarged(&mut followed);
        compare("contact_followed", followed, size);
        let mut beside = app(LOOK);
        set(&mut beside, |frame| frame.contact = Some(contact()));
        compare("contact_beside", beside, size);
    }
    let variants: [Variant; 4] = [
        ("ascii", |app| app.look.points = Points::Ascii),
        ("apart", |app| {
            set_contact(app, |contact| {
                contact.state = "apart";
                contact.traction = None;
                contact.numbers.clear();
            });
        }),
        ("slides", |app| {
            set_contact(app, |contact| {
                contact.state = "slides";
                let traction = contact.traction.as_mut().expect("it has one");
                traction.steps = vec![(1e-6, 1.0)];
            });
        }),
        ("linear", |app| {
            set_contact(app, |contact| {
                (contact.law, contact.traction) = ("linear", None);
            });
        }),
    ];
    for (name, change) in variants {
        let mut app = app(LOOK);
        enlarged(&mut app);
        change(&mut app);
        compare(&format!("contact_{name}"), app, (80, 24));
    }
}

fn set_contact(app: &mut App, change: impl FnOnce(&mut ballast::session::inspect::Inspection)) {
    set(app, |frame| {
        change(frame.contact.as_mut().expect("it is followed"));
    });
}

#[test]
fn ascii_screens() {
    let mut look = LOOK;
    look.points = Points::Ascii;
    look.theme = Theme::Mono;
    for size in [(80, 24), (200, 60)] {
        compare("ascii", app(look), size);
    }
}

#[test]
fn small_screens() {
    for size in [
        (59, 14),
        (40, 12),
        (20, 5),
        (20, 4),
        (20, 3),
        (10, 2),
        (10, 1),
    ] {
        compare("small", app(LOOK), size);
    }
}

#[test]
fn states_of_a_run() {
    let states: [Variant; 5] = [
        ("paused", |app| set(app, |frame| frame.running = false)),
        ("done", |app| {
            set(app, |frame| {
                frame.running = false;
                frame.finished = true;
            });
        }),
        ("failed", |app| {
            set(app, |frame| frame.running = false);
            app.failure = Some("disc 5 went through wall floor at cycle 14 820".into());
        }),
        ("typing", |app| app.prompt.open_with("cre")),
        ("answered", |app| {
            app.say(Said::Answer("a long answer ".repeat(12)));
        }),
    ];
    for (name, change) in states {
        let mut app = app(LOOK);
        change(&mut app);
        compare(&format!("state_{name}"), app, (80, 24));
    }
    compare("state_starting", empty(LOOK), (80, 24));
}

fn set(app: &mut App, change: impl FnOnce(&mut ballast::session::frames::Frame)) {
    change(app.frame.as_mut().expect("the example has a frame"));
}
