//! A contact that is inspected: its numbers against the closed forms of Hertz, Cattaneo and Mindlin,
//! the files that are written, and that looking changes nothing.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use std::fs;

use ballast::engine::contact::inner::Value;
use ballast::scene::Scene;
use ballast::session::inspect::Inspection;
use ballast::session::{Budget, Options, Session};

/// Two glass spheres, both driven: pressed by 1 µm in a thousand cycles, then sheared by the spin of
/// the second, which leaves the overlap as it is.
const SPHERES: &str = r#"
[model]
law = "mindlin-deresiewicz-exact"
time_step = 1e-8

[material.glass]
density = 2500.0
young = 70e9
poisson = 0.3
friction = 0.3

[[particle]]
at = [0.0, 0.0]
radius = 0.001
material = "glass"
driven = true

[[particle]]
at = [0.0, 0.002]
radius = 0.001
material = "glass"
driven = true

[history]
every = 100
columns = ["contact:1-2:n", "contact:1-2:a", "contact:1-2:c_over_a", "contact:1-2:p0", "state_hash"]
"#;

fn session(text: &str) -> Session {
    let scene = Scene::parse("spheres", text, &[]).expect("the preset is sound");
    Session::open(scene, Options::default()).unwrap()
}

fn tell(session: &mut Session, line: &str) -> Vec<String> {
    let reply = session.type_line(line).expect("the line is right");
    if reply.request.is_some() {
        session.advance(Budget::default(), false).unwrap();
    }
    reply.lines
}

fn refusal(session: &mut Session, line: &str) -> String {
    session.type_line(line).unwrap_err().to_string()
}

/// Pressed by 1 µm and sheared by so many cycles of 0.2 nm.
fn sheared(text: &str, cycles: u32) -> Session {
    let mut session = session(text);
    for line in [
        "inspect contact 1-2",
        "particle 2 velocity 0 -0.1",
        "cycle 1000",
        "particle 2 velocity 0 0",
        "particle 2 spin -20",
    ] {
        tell(&mut session, line);
    }
    tell(&mut session, &format!("cycle {cycles}"));
    session
}

fn inspected(session: &Session) -> Inspection {
    session.inspection().expect("it is followed")
}

/// Of two spheres of radius 1 mm.
const R_EFF: f64 = 0.5e-3;
const YOUNG_EFF: f64 = 70e9 / (2.0 * (1.0 - 0.09));

/// E*/(4 G*) of two like bodies.
const KAPPA: f64 = (2.0 - 0.3) / (2.0 * (1.0 - 0.3));

#[test]
fn hertz_cattaneo_and_mindlin() {
    let session = sheared(SPHERES, 1000);
    let contact = inspected(&session);
    let now = contact.trace.last().unwrap();
    // Rounding of coordinates of 2 mm, 2e-16 of them, is 4e-13 of an overlap of 1 µm; it enters
    // every step of a thousand.
    let near = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
    assert!(near(now.alpha, 1e-6), "{}", now.alpha);
    let radius = (R_EFF * now.alpha).sqrt();
    let peak = 2.0 * YOUNG_EFF * radius / (std::f64::consts::PI * R_EFF);
    assert!(near(contact.radius, radius) && near(contact.peak, peak));
    let number = |name: &str| {
        let found = contact.numbers.iter().find(|inner| inner.name == name);
        match found.unwrap().value {
            Value::Number(value, _) => value,
            Value::Word(word) => panic!("{name} is {word}"),
        }
    };
    assert!(near(number("a/R_min"), radius / 1e-3));
    assert!(near(number("sigma_n"), 2.0 / 3.0 * peak));
    let n = 4.0 / 3.0 * YOUNG_EFF * R_EFF.sqrt() * now.alpha.powf(1.5);
    assert!(near(now.n, n));
    // The spin acts at the lever of the touching point, D/2.
    let delta = 1000.0 * 20.0 * 1e-8 * 0.5 * (2e-3 - now.alpha);
    assert!(near(now.delta.abs(), delta), "{} {delta}", now.delta);
    // Mindlin 1949: (c/a)² = 1 - δ/δ_s, T = μN (1 - (c/a)³).
    let c = (1.0 - delta / (0.3 * KAPPA * now.alpha)).sqrt();
    let t = 0.3 * n * (1.0 - c * c * c);
    assert!(near(now.t.abs(), t), "{} {t}", now.t);
    assert!((0.5..0.8).contains(&c), "the case is no corner: {c}");
    let stress = 0.3 * (1.0 - c * c * c) * 2.0 / 3.0 * peak;
    assert!(near(number("sigma_t").abs(), stress));
    assert!(near(number("c/a"), c));
    let traction = contact.traction.as_ref().unwrap();
    assert!(near(traction.stick_ratio(), c));

    // The file says the same, and the columns of the history.
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("q.csv");
    let mut session = session;
    tell(&mut session, &format!("export traction {}", file.display()));
    let mut rows = csv::Reader::from_path(&file).unwrap();
    let mut zones = Vec::new();
    for row in rows.records() {
        let row = row.unwrap();
        let number = |k: usize| row[k].parse::<f64>().unwrap();
        let (r, q) = (number(0), number(2).abs());
        let stuck = (c * c - r * r).max(0.0).sqrt();
        let right = 0.3 * peak * ((1.0 - r * r).sqrt() - stuck);
        assert!((q - right).abs() < 1e-9 * peak, "{r}: {q} {right}");
        if r < 1.0 {
            assert_eq!(&row[4] == "stick", r < c, "{r}");
        }
        zones.push(row[4].to_owned());
    }
    assert_eq!(zones.len(), 201);
    session.finish().unwrap();
    let (last, recording) = (session.recording().rows().len() - 1, session.recording());
    assert!(near(recording.value(last, 1), radius));
    assert!(near(recording.value(last, 2), c));
    assert!(near(recording.value(last, 3), peak));
}

/// The same path with laws that do not know of annuli: the numbers above are not what any law gives.
#[test]
fn other_laws_know_less() {
    let text = SPHERES.replace("mindlin-deresiewicz-exact", "hertz-mindlin");
    let mut other = sheared(&text, 1000);
    let (contact, exact) = (inspected(&other), inspected(&sheared(SPHERES, 1000)));
    assert!(contact.traction.is_none() && contact.peak > 0.0);
    let [t, right] = [&contact, &exact].map(|c| c.trace.last().unwrap().t);
    assert!((t / right - 1.0).abs() > 0.1, "{t} {right}");
    let refused = refusal(&mut other, "export traction never.csv");
    assert!(
        refused.contains(
            "not known to law hertz-mindlin in this state; law mindlin-deresiewicz-exact"
        ),
        "{refused}"
    );

    // Two reversals give the traction of the closed form as long as there is no reversal.
    let text = SPHERES.replace("mindlin-deresiewicz-exact", "mindlin-deresiewicz");
    let randall = inspected(&sheared(&text, 1000)).traction.unwrap();
    let exact = exact.traction.unwrap();
    for r in [0.0, 0.3, 0.6, 0.9] {
        assert!((randall.at(r) - exact.at(r)).abs() < 1e-9, "{r}");
    }
}

#[test]
fn looking_changes_nothing() {
    let run = |look: bool| {
        let folder = tempfile::tempdir().unwrap();
        let mut session = session(SPHERES);
        for (k, line) in [
            "particle 2 velocity 0 -0.1",
            "cycle 700",
            "particle 2 velocity 0.02 0",
            "cycle 900",
            "particle 2 velocity -0.02 0.02",
            "cycle 900",
        ]
        .iter()
        .enumerate()
        {
            if look {
                tell(&mut session, "inspect contact 1-2");
                for what in ["path", "svg contact"] {
                    let file = folder.path().join(format!("{k}"));
                    tell(&mut session, &format!("export {what} {}", file.display()));
                }
                if k == 3 {
                    tell(&mut session, "inspect off");
                }
            }
            tell(&mut session, line);
        }
        session.finish().unwrap();
        session
    };
    let (blind, seeing) = (run(false), run(true));
    assert_eq!(blind.world().state_hash(), seeing.world().state_hash());
    assert_eq!(blind.recording().rows(), seeing.recording().rows());
    assert_eq!(blind.journal().to_string(), seeing.journal().to_string());
}

/// Without the books the follower adds the displacement up itself: to the same number.
#[test]
fn the_displacement_is_that_of_the_books() {
    let booked = SPHERES.replace("\"state_hash\"", "\"contact:1-2:delta\"");
    let (with, without) = (sheared(&booked, 500), sheared(SPHERES, 500));
    let last = |session: &Session| *inspected(session).trace.last().unwrap();
    assert_eq!(last(&with).delta, last(&without).delta);
    assert_eq!(last(&with).delta, with.world().pass().book(0).delta);
    assert!(with.world().ledger().is_some() && without.world().ledger().is_none());
}

#[test]
fn the_record_is_bounded_and_keeps_its_ends() {
    let session = sheared(SPHERES, 20_000);
    let contact = inspected(&session);
    assert!((2000..=4097).contains(&contact.trace.len()));
    assert!(contact.since.1.is_power_of_two() && contact.since.1 > 1);
    assert_eq!(contact.trace[0].cycle, 1);
    assert_eq!(contact.trace.last().unwrap().cycle, 21_000);
    assert!(contact.trace.is_sorted_by_key(|moment| moment.cycle));
}

/// Apart and together again: another touch, whose displacement begins anew.
#[test]
fn touches_are_told_apart() {
    let mut session = sheared(SPHERES, 500);
    for line in [
        "particle 2 spin 0",
        "particle 2 velocity 0 0.1",
        "cycle 1500",
    ] {
        tell(&mut session, line);
    }
    assert_eq!(inspected(&session).state, "apart");
    let refused = refusal(&mut session, "export traction never.csv");
    assert!(refused.contains("run until it touches"), "{refused}");
    tell(&mut session, "particle 2 velocity 0 -0.1");
    tell(&mut session, "cycle 1500");
    let contact = inspected(&session);
    let last = contact.trace.last().unwrap();
    assert_eq!((contact.trace[0].touch, last.touch), (1, 2));
    assert_eq!(last.delta, 0.0);
}

#[test]
fn files_are_whole_or_not_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut session = session(SPHERES);
    let file = folder.path().join("loop.svg");
    let line = format!("export svg contact {}", file.display());
    let refused = refusal(&mut session, &line);
    assert!(
        refused.contains("`inspect contact I-J` begins to"),
        "{refused}"
    );
    tell(&mut session, "inspect contact 1-2");
    // Apart, and nothing recorded: still a picture.
    tell(&mut session, &line);
    tell(&mut session, "particle 2 velocity 0 -0.1");
    tell(&mut session, "cycle 300");
    tell(&mut session, &line);
    let svg = fs::read_to_string(&file).unwrap();
    assert!(
        svg.starts_with("<svg") && svg.ends_with("</svg>\n") && !svg.ends_with("\n\n"),
        "{svg}"
    );
    for name in ["contact 1-2", "tangential displacement [m]", "N [N]", "r/a"] {
        assert!(svg.contains(name), "{name}");
    }
    let lost = refusal(&mut session, "export svg contact /no/such/place/loop.svg");
    assert!(lost.contains("there is no folder"), "{lost}");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}
