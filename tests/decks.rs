//! What LAMMPS makes of decks, as far as their text tells: models that it has, fixes in an order that
//! keeps what is held where it is, dashpots that are there before anything touches.

use std::collections::BTreeMap;

use ballast::scene::{Scene, catalogue};
use ballast::session::{Options, Session};

/// Presets whose decks are not looked at here: too large, or begun from a sample that takes long to
/// prepare. Their laws and dampings are those of others.
fn is_slow(scene: &Scene) -> bool {
    scene.start.is_some() || ["pluvial-million", "large-compression"].contains(&scene.name.as_str())
}

/// Files by their names.
type Files = BTreeMap<String, String>;

fn open(scene: Scene) -> Session {
    let options = Options {
        threads: 1,
        no_cache: true,
        ..Options::default()
    };
    Session::open(scene, options).expect("it opens")
}

/// The files of a deck, or why there is none.
fn written(session: &mut Session, nearest: bool) -> Result<Files, String> {
    let deck = session.lammps(nearest);
    deck.map(|deck| deck.files.into_iter().collect())
        .map_err(|refusal| refusal.to_string())
}

fn deck(text: &str) -> Files {
    let scene = Scene::parse("scene", text, &[]).expect("it is accepted");
    written(&mut open(scene), true).expect("it is written")
}

/// What LAMMPS would refuse, or take for something else than is meant.
fn complaints(deck: &Files) -> Vec<String> {
    let mut complaints = Vec::new();
    for (name, text) in deck {
        for line in text.lines() {
            let contact = line.starts_with("pair_coeff") && !line.contains("* *")
                || line.contains("wall/gran/region");
            let damped = [
                "velocity",
                "mass_velocity",
                "viscoelastic",
                "coeff_restitution",
            ]
            .iter()
            .any(|model| line.contains(&format!(" damping {model}")));
            let numbers = name != "README.md";
            let no_number =
                numbers && (line.split(' ')).any(|word| ["NaN", "inf", "-inf"].contains(&word));
            if contact && !damped || no_number {
                complaints.push(format!("{name}: {line}"));
            }
        }
        if name.starts_with("in.") {
            complaints.extend(late(text));
        }
    }
    complaints
}

/// Fixes that add forces after one that takes them away: LAMMPS runs them in this order.
fn late(script: &str) -> Vec<String> {
    let fixes = script.lines().filter(|line| line.starts_with("fix "));
    let styles = fixes.filter_map(|line| Some((line, line.split(' ').nth(3)?)));
    let rest = styles.skip_while(|(_, style)| !["setforce", "freeze"].contains(style));
    rest.filter(|(_, style)| ["gravity", "addforce", "damping/cundall", "viscous"].contains(style))
        .map(|(line, _)| line.to_owned())
        .collect()
}

#[test]
fn decks_of_all_presets_are_such_as_lammps_takes() {
    let (mut whole, mut near) = (0, 0);
    for preset in catalogue::PRESETS {
        let scene = Scene::load(preset.name, &[]).expect("embedded presets are accepted");
        if is_slow(&scene) {
            continue;
        }
        let mut session = open(scene);
        if session.world().model().law.has_bonds() {
            let refusal = written(&mut session, true).expect_err("LAMMPS has no such law");
            assert!(refusal.contains("knows no bonds"), "{refusal}");
            continue;
        }
        for nearest in [false, true] {
            match written(&mut session, nearest) {
                Ok(deck) => {
                    *if nearest { &mut near } else { &mut whole } += 1;
                    let complaints = complaints(&deck);
                    assert!(complaints.is_empty(), "{}: {complaints:#?}", preset.name);
                }
                Err(refusal) => assert!(!nearest, "{}: {refusal}", preset.name),
            }
        }
    }
    assert!(whole >= 8 && near >= 32, "{whole} {near}");
}

/// Two spheres with a gap between them that fly at each other, a floor that nothing touches.
const APART: &str = r#"
[model]
law = "linear"
time_step = "critical"
gravity = [1.0, -9.81]
[damping]
contact = 0.1
local = 0.2
global = 3.0
[material.glass]
density = 2650.0
normal_stiffness = 1e5
shear_stiffness = 1e5
friction = 0.3
[[particle]]
at = [0.0, 2e-3]
radius = 1e-3
material = "glass"
velocity = [0.1, 0.0]
fixed = ["y"]
force = [1e-3, 1e-3]
[[particle]]
at = [2.0001e-3, 2e-3]
radius = 1e-3
material = "glass"
fixed = ["x", "y"]
[[particle]]
at = [9e-3, 2e-3]
radius = 1e-3
material = "glass"
fixed = ["x", "y", "spin"]
[[wall]]
name = "floor"
from = [-1, 0]
to = [1, 0]
material = "glass"
"#;

#[test]
fn nothing_moves_what_is_held() {
    let deck = deck(APART);
    let script = &deck["in.scene"];
    assert_eq!(complaints(&deck), Vec::<String>::new(), "{script}");
    let fixes = script.lines().filter(|line| line.starts_with("fix "));
    let last: Vec<&str> = fixes.collect::<Vec<_>>().split_off(6);
    let expected = [
        "fix drag free addforce v_dragx v_dragy 0.0",
        "fix held held freeze",
        "fix heldx heldx setforce 0.0 NULL NULL",
        "fix heldy heldy setforce NULL 0.0 NULL",
    ];
    assert_eq!(last, expected, "{script}");
    // The check itself sees what comes too late.
    let turned =
        "fix heldx heldx setforce 0.0 NULL NULL\nfix gravity free gravity 9.81 vector 0 -1 0\n";
    assert_eq!(late(turned).len(), 1);
}

#[test]
fn dashpots_are_written_before_anything_touches() {
    let deck = deck(APART);
    let word = |line: &str, k: usize| -> f64 {
        let word = line.split(' ').nth(k).expect("so many words");
        word.parse().expect("a number")
    };
    // c = 2 b sqrt(m k) over m: the effective mass is half of one's at a neighbour, all of it at a wall.
    let mass = 2650.0 * 4.0 / 3.0 * std::f64::consts::PI * 1e-9;
    let gamma = |effective: f64| 0.2 * (1e5 / effective).sqrt();
    let lines: Vec<&str> = deck["law.classic"].lines().collect();
    assert!(
        (word(lines[0], 4) / gamma(0.5 * mass) - 1.0).abs() < 1e-12,
        "{}",
        lines[0]
    );
    let wall = lines[2];
    assert!(
        wall.contains("wall/gran/region granular hooke 100000.0 "),
        "{wall}"
    );
    assert!((word(wall, 7) / gamma(mass) - 1.0).abs() < 1e-12, "{wall}");
    assert!(
        wall.contains(" tangential linear_history_classic 100000.0 1.0 0.3 damping mass_velocity")
    );
    let readme = &deck["README.md"];
    let differs = readme.find("## What differs").expect("it is there");
    for hint in [
        "no particles touch each other now",
        "some walls touch no particle now",
        "tangential dashpots where spring and dashpot together exceed friction",
        "LAMMPS takes R for the velocities",
    ] {
        let at = readme.find(hint);
        assert!(at > Some(differs), "no {hint} in {readme}");
    }
    // Of spheres of Hertz it takes an overlap, too.
    let hertz = APART.replace("\"linear\"\ntime_step = \"critical\"", "\"hertz-mindlin\"");
    let hertz = hertz.replace(
        "normal_stiffness = 1e5\nshear_stiffness = 1e5",
        "young = 70e9\npoisson = 0.25",
    );
    let deck = self::deck(&hertz);
    let (a, stiffness) = (
        0.5e-3 * 1e-3_f64.sqrt(),
        70e9 / 0.9375 * 0.5e-3 * 1e-3_f64.sqrt(),
    );
    let gamma = 0.2 * (stiffness / (0.5 * mass)).sqrt() / a;
    let line = deck["law.classic"].lines().next().expect("a line");
    assert!(
        (word(line, 4) / gamma - 1.0).abs() < 1e-12,
        "{line} {gamma}"
    );
    assert!(deck["README.md"].contains("a thousandth of the effective radius"));
}

#[test]
fn a_refusal_says_each_thing_once() {
    let critical = APART.replace("contact = 0.1", "contact = 1.0");
    let scene = Scene::parse("scene", &critical, &[]).expect("it is accepted");
    let refusal = written(&mut open(scene), false).expect_err("LAMMPS cannot do that");
    for once in [
        "damping of 1 of critical",
        "damping that gives a restitution",
    ] {
        assert_eq!(refusal.matches(once).count(), 1, "{once}: {refusal}");
    }
}
