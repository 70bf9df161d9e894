//! Pictures, as text. They change only when what is drawn is meant to change.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};

use ballast::language::Observable;
use ballast::measure::columns::Column;
use ballast::measure::frame::Picture;
use ballast::measure::polygon::{ForcePolygon, Side};
use ballast::measure::survey::Part;
use ballast::session::frames::Frame;
use ballast::tui::app::{App, Overlay, Said};
use ballast::tui::look::{Chains, Compared, Points, Theme};
use ballast::tui::panes::{PANES, PaneId};
use ballast::tui::series::Series;
use ballast::tui::trail::Trail;

use crate::example::{LOOK, app, contact, empty, frame, survey_of_nothing};
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
    let variants: [Variant; 14] = [
        ("ascii", |app| app.look.points = Points::Ascii),
        ("changed", |app| app.look.compared = Compared::Contacts),
        ("turned", |app| app.look.compared = Compared::Rotations),
        ("moved", |app| app.look.compared = Compared::Displacements),
        ("slid", |app| app.look.compared = Compared::Sliding),
        ("slid_unbooked", |app| {
            app.look.compared = Compared::Sliding;
            set(app, |frame| {
                let against = frame.survey.against.as_mut().expect("it has one");
                against.slid = None;
            });
        }),
        ("changed_ascii", |app| {
            (app.look.compared, app.look.points) = (Compared::Contacts, Points::Ascii);
        }),
        ("turned_ascii", |app| {
            (app.look.compared, app.look.points) = (Compared::Rotations, Points::Ascii);
        }),
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
fn drawings_that_panes_turn_to() {
    for (id, pane) in PANES {
        for face in 1..pane.faces.len() {
            let mut turned = app(LOOK);
            turned.zoomed = Some(*id);
            turned.turned = vec![(*id, face)];
            compare(
                &format!("{}_{face}", pane.name.replace(' ', "_")),
                turned,
                (80, 24),
            );
        }
    }
}

/// With both columns in the history: the path of a shear test at constant volume, after an isotropic
/// stage.
#[test]
fn a_recorded_stress_path() {
    let column = |name| Observable::Column(Column::parse(name).expect("it is in the list"));
    let mut recorded = frame();
    recorded.columns = ["isotropic_stress", "sin_phi"].map(column).to_vec().into();
    for row in &mut recorded.rows {
        let t = row.cycle as f64 / 14_800.0;
        let sheared = (t - 0.5).max(0.0);
        let sine = 0.4 * (1.0 - (-12.0 * sheared).exp());
        row.values = vec![1e5 * (2.0 * t).min(1.0) + 6e4 * sheared, sine];
        row.stage = u32::from(t > 0.5);
    }
    for size in SIZES {
        let mut path = empty(LOOK);
        path.take_frame(Box::new(recorded.clone()));
        path.zoomed = Some(PaneId::StressPath);
        compare("stress_path_recorded", path, size);
    }
}

#[test]
fn a_force_polygon() {
    let side = |by: &str, direction: f64, force| Side {
        by: by.into(),
        direction,
        force,
    };
    let polygon = ForcePolygon {
        particle: 2,
        sides: vec![
            side("5", 31.0, [-6.1, -3.4]),
            side("3", 118.0, [2.2, -5.0]),
            side("floor", 270.0, [0.3, 8.6]),
            side("left", 180.0, [3.5, 0.6]),
        ],
        body: [0.0, -1.0],
    };
    for size in SIZES {
        let mut app = empty(LOOK);
        app.take_frame(Box::new(Frame {
            polygon: Some(polygon.clone()),
            ..frame()
        }));
        (app.zoomed, app.selected) = (Some(PaneId::ForcePolygon), Some(2));
        drawn(&mut app, size.0, size.1);
        assert_eq!(app.wants().polygon, Some(2));
        compare("force_polygon_selected", app, size);
    }
}

#[test]
fn panes_without_anything_to_draw() {
    for (id, pane) in PANES {
        let mut bare = app(LOOK);
        let nothing = Frame {
            picture: Picture::default(),
            survey: survey_of_nothing(),
            ..bare.frame.as_deref().expect("it has one").clone()
        };
        bare.frame = Some(Box::new(nothing));
        bare.series = Series::default();
        bare.trail = Trail::default();
        bare.zoomed = Some(*id);
        compare(
            &format!("empty_{}", pane.name.replace(' ', "_")),
            bare,
            (80, 24),
        );
    }
}

#[test]
fn measures_of_an_earlier_cycle_say_so_wherever_they_are_shown() {
    let screens = |measures_of, frac_limit_of| {
        let mut app = empty(LOOK);
        app.take_frame(Box::new(Frame {
            measures_of,
            frac_limit_of,
            ..frame()
        }));
        let all = text(&drawn(&mut app, 120, 40));
        let enlarged = PANES.iter().map(|(id, _)| {
            app.zoomed = Some(*id);
            (*id, text(&drawn(&mut app, 80, 24)))
        });
        (all, enlarged.collect::<Vec<_>>())
    };
    let (all, enlarged) = screens(14_000, 14_100);
    for says in ["at 14 000  ", "at cycle 14 000", "limit at cycle 14 100"] {
        assert!(all.contains(says), "{says}: {all}");
    }
    for (id, screen) in enlarged {
        let measured = matches!(
            id,
            PaneId::Rose(_)
                | PaneId::Histogram
                | PaneId::MohrCircle
                | PaneId::StressPath
                | PaneId::Profile
                | PaneId::Energy
        );
        assert_eq!(
            screen.contains("at cycle 14 000"),
            measured,
            "{id:?}: {screen}"
        );
    }
    let (all, enlarged) = screens(14_820, 14_820);
    let enlarged = enlarged.into_iter().map(|(_, screen)| screen);
    for screen in enlarged.chain([all]) {
        assert!(
            !screen.contains("at cycle") && !screen.contains("at 14"),
            "{screen}"
        );
    }
}

#[test]
fn frames_have_to_carry_the_selected_disc_whatever_pane_is_shown() {
    let mut app = app(LOOK);
    for (id, _) in PANES {
        app.zoomed = Some(*id);
        for selected in [None, Some(3)] {
            app.selected = selected;
            drawn(&mut app, 80, 24);
            assert_eq!(app.wants().selected, selected, "{id:?}");
        }
    }
}

#[test]
fn other_panes_in_the_places() {
    let mut swapped = app(LOOK);
    drawn(&mut swapped, 80, 24);
    press(&mut swapped, "p", (80, 24));
    press(&mut swapped, ":pane histo\n", (80, 24));
    compare("placed", swapped, (80, 24));
    let mut swapped = app(LOOK);
    drawn(&mut swapped, 120, 40);
    let first = swapped.wants();
    press(&mut swapped, ":pane mohr\n", (120, 40));
    // A frame carries what is seen.
    assert!(!first.survey.has(Part::Tensors) && swapped.wants().survey.has(Part::Tensors));
    assert!(!swapped.wants().survey.has(Part::Obliquity));
    press(
        &mut swapped,
        "\t\t]p:pane rose\n:pane nonsense\n",
        (120, 40),
    );
    compare("placed", swapped, (120, 40));
}

/// Presses keys one after the other; the screen is drawn between them.
fn press(app: &mut App, keys: &str, (width, height): (u16, u16)) {
    for key in keys.chars() {
        let code = match key {
            '\n' => KeyCode::Enter,
            '\t' => KeyCode::Tab,
            key => KeyCode::Char(key),
        };
        app.key(KeyEvent::new(code, KeyModifiers::NONE));
        if key == '\n' {
            app.key(KeyEvent::new(KeyCode::Esc, KeyModifiers::NONE));
        }
        drawn(app, width, height);
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
