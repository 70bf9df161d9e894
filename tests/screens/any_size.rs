//! Whatever the size, the state and the frame: nothing breaks, and ASCII stays ASCII.

use crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use proptest::prelude::*;

use ballast::engine::contact::inner::Inner;
use ballast::measure::frame::Picture;
use ballast::measure::survey::Survey;
use ballast::session::frames::Frame;
use ballast::tui::app::{App, Overlay, Said, Warning};
use ballast::tui::look::{Chains, Compared, Look, Points, Theme};
use ballast::tui::panes::{PANES, PaneId};

use crate::drawn;
use crate::example::{contact, empty, frame};

/// Numbers that go wrong where anything can.
const ODD: [f64; 8] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -1.0,
    1e300,
    -1e300,
    5e-324,
];

/// A frame of one of several kinds.
fn frame_of(kind: u8, odd: f64) -> Frame {
    let mut frame = frame();
    match kind {
        0 => frame.contact = Some(contact()),
        1 => {
            frame.picture = Picture::default();
            frame.survey = Survey::default();
            frame.rows.clear();
            frame.energies = None;
            frame.bookings = None;
            frame.stages = (0, 0);
            frame.stage_cycles = (0, None);
        }
        2 => {
            frame.picture.discs.truncate(1);
            frame.picture.touches.clear();
            frame.picture.walls.clear();
            frame.rows.truncate(1);
            frame.bookings = None;
        }
        _ => spoil(&mut frame, odd),
    }
    frame
}

/// Puts an odd number everywhere.
fn spoil(frame: &mut Frame, odd: f64) {
    for disc in &mut frame.picture.discs {
        (disc.at, disc.radius, disc.velocity, disc.angle) = ([odd; 2], odd, [odd; 2], odd);
    }
    spoil_survey(&mut frame.survey, odd);
    let mut followed = contact();
    for moment in followed.trace.iter_mut().step_by(3) {
        (moment.alpha, moment.t) = (odd, odd);
    }
    if let Some(traction) = &mut followed.traction {
        traction.steps[1] = (odd, odd);
    }
    followed.friction = odd;
    followed.numbers.push(Inner::number("Größe", odd, "m"));
    frame.contact = Some(followed);
    for touch in frame.picture.touches.iter_mut().step_by(2) {
        (touch.ends, touch.length, touch.normal) = ([[odd; 2]; 2], odd, [odd; 2]);
        (touch.n, touch.t) = (odd, odd);
    }
    frame.picture.walls[0].ends = [[odd, 0.0], [0.0, odd]];
    frame.picture.bounds = [[odd; 2], [0.0, 1.0]];
    frame.picture.fastest = odd;
    for row in frame.rows.iter_mut().step_by(3) {
        row.values.fill(odd);
    }
    frame.rows[7].values.clear();
    frame.rows[9].cycle = u64::MAX;
    (frame.dt, frame.frac, frame.frac_limit, frame.rate) = (odd, odd, odd, odd);
    frame.fracc.largest = Some(odd);
    frame.stage_cycles = (u64::MAX, Some(1));
    frame.cycle = u64::MAX;
    if let Some(energies) = &mut frame.energies {
        (energies.kinetic, energies.potential) = (odd, odd);
    }
    if let Some(bookings) = &mut frame.bookings {
        bookings.energy_error = odd;
    }
    frame.title = "Größe 漢字 \u{301}".into();
    frame.stage = "Böschung".into();
}

fn spoil_survey(survey: &mut Survey, odd: f64) {
    if let Some((rose, fabric)) = &mut survey.directions {
        rose.contacts[3] = odd;
        rose.force[4] = odd;
        fabric.plain[(0, 1)] = odd;
        fabric.weighted[(0, 0)] = odd;
    }
    if let Some(tensors) = &mut survey.tensors {
        tensors.stress.total[(1, 1)] = odd;
        if let Some(strain) = &mut tensors.strain {
            strain.tensor.fill(odd);
        }
    }
    if let Some(against) = &mut survey.against {
        against.lattice[0].1 = [[odd; 2]; 2];
        if let Some(slid) = &mut against.slid {
            (slid[0].at, slid[1].along, slid[2].way) = ([odd; 2], [odd; 2], odd);
        }
        (against.displaced[1].u, against.displaced[2].rotation) = ([odd; 2], odd);
    }
    if let Some(obliquity) = &mut survey.obliquity {
        obliquity.contacts[2] = [odd, odd, 1.0];
    }
    if let Some(profile) = &mut survey.profile {
        profile.rings[1].disc_area = odd;
        profile.rings[4].outer = odd;
    }
    for histogram in [&mut survey.contact_stress, &mut survey.normal_force] {
        let Some(histogram) = histogram else { continue };
        histogram.bars[2] = odd;
        (histogram.high, histogram.mean) = (odd, odd);
    }
}

/// A state of the screen.
#[derive(Debug, Clone)]
struct State {
    look: Look,
    overlay: Option<Overlay>,
    zoomed: usize,
    focus: usize,
    prompt: Option<String>,
    frame: Option<u8>,
    odd: usize,
    scrolled: usize,
    selected: Option<u32>,
    failed: bool,
    magnified: i32,
    turned: usize,
}

fn look() -> impl Strategy<Value = Look> {
    let points = prop_oneof![
        Just(Points::Braille),
        Just(Points::HalfBlock),
        Just(Points::Ascii)
    ];
    let chains = prop_oneof![
        Just(Chains::Off),
        Just(Chains::Force),
        Just(Chains::Tangential)
    ];
    let compared = prop_oneof![
        Just(Compared::Off),
        Just(Compared::Contacts),
        Just(Compared::Rotations),
        Just(Compared::Displacements),
        Just(Compared::Sliding)
    ];
    (points, chains, any::<[bool; 3]>(), compared).prop_map(
        |(points, chains, [mono, discs, velocities], compared)| Look {
            theme: if mono { Theme::Mono } else { Theme::Colour },
            points,
            chains,
            discs,
            velocities,
            compared,
        },
    )
}

fn state() -> impl Strategy<Value = State> {
    let overlay = prop_oneof![
        4 => Just(None),
        1 => any::<u16>().prop_map(|at| Some(Overlay::Help(at))),
        1 => (0usize..20).prop_map(|at| Some(Overlay::Presets(at))),
        1 => Just(Some(Overlay::Quit)),
    ];
    let screen = (look(), overlay, 0usize..2 * PANES.len(), 0usize..14);
    let prompt = prop_oneof![
        2 => Just(None),
        1 => prop_oneof![Just("cre"), Just("Böschung 漢字漢字漢字"), Just("")]
            .prop_map(|text| Some(text.repeat(3))),
    ];
    let run = (
        prompt,
        prop::option::of(0u8..5),
        0usize..ODD.len(),
        0usize..30,
    );
    let rest = (
        prop::option::of(0u32..9),
        any::<bool>(),
        -10i32..40,
        0usize..5,
    );
    (screen, run, rest).prop_map(|(screen, run, rest)| State {
        look: screen.0,
        overlay: screen.1,
        zoomed: screen.2,
        focus: screen.3,
        prompt: run.0,
        frame: run.1,
        odd: run.2,
        scrolled: run.3,
        selected: rest.0,
        failed: rest.1,
        magnified: rest.2,
        turned: rest.3,
    })
}

fn screen(state: &State) -> App {
    let mut app = empty(state.look);
    if let Some(kind) = state.frame {
        app.take_frame(Box::new(frame_of(kind, ODD[state.odd])));
    }
    for said in [
        Said::Answer("Größe 漢字 ".repeat(40)),
        Said::Error("tab\tand bell\u{7}".into()),
    ] {
        app.say(said);
    }
    for particle in [None, Some(3)] {
        app.warnings.push(Warning {
            cycle: 5,
            particle,
            text: "Überlappung".into(),
        });
    }
    app.unseen = 1;
    app.overlay = state.overlay;
    app.zoomed = PANES.get(state.zoomed).map(|(id, _)| *id);
    app.turned = PANES.iter().map(|(id, _)| (*id, state.turned)).collect();
    app.focus = state.focus;
    app.scrolled = state.scrolled;
    app.selected = state.selected;
    app.failure = state.failed.then(|| "Fehler: Größe".repeat(20));
    app.view.magnify(1.25f64.powi(state.magnified));
    if let Some(text) = &state.prompt {
        app.prompt.open_with("");
        app.paste(text);
        app.key(KeyEvent::new(KeyCode::Tab, KeyModifiers::NONE));
    }
    app
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn nothing_breaks(state in state(), width in 0u16..=200, height in 0u16..=60) {
        let mut app = screen(&state);
        let buffer = drawn(&mut app, width, height);
        if state.look.points == Points::Ascii {
            for cell in buffer.content() {
                prop_assert!(cell.symbol().is_ascii(), "{:?}", cell.symbol());
            }
        }
        if state.look.theme == Theme::Mono {
            use ratatui::style::Color;
            prop_assert!(buffer.content().iter().all(|cell| cell.fg == Color::Reset));
        }
    }
}

#[test]
fn every_small_size_is_drawn() {
    let mut app = crate::example::app(crate::example::LOOK);
    let mut following = crate::example::app(crate::example::LOOK);
    following.frame.as_mut().expect("it has one").contact = Some(contact());
    for height in 0..=30 {
        for width in 0..=90 {
            drawn(&mut app, width, height);
            following.zoomed = None;
            drawn(&mut following, width, height);
            following.zoomed = Some(PaneId::Contact);
            drawn(&mut following, width, height);
        }
    }
}
