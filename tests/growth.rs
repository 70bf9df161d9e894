//! `grow`: radii follow a line, masses follow the radii, energy is booked, samples reach what they are
//! prepared to.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

const PAIR: &str = r#"
[model]
law = "linear"
time_step = "critical"
body = "BODY"
overlap = "allow"
[material.m]
density = 2000.0
normal_stiffness = 1e6
shear_stiffness = 1e6
[[particle]]
at = [0.0, 0.0]
radius = 1.0
material = "m"
driven = true
[[particle]]
at = [1.99, 0.0]
radius = 1.0
material = "m"
driven = true
[[particle]]
at = [9.0, 0.0]
radius = 0.5
material = "m"
velocity = [0.0, 0.25]
[history]
every = 1
columns = ["elastic_normal", "kinetic", "boundary_work", "energy_error"]
[[stage]]
name = "grow"
do = ["grow 1.2 over 50"]
max_cycles = 60
"#;

/// Discs at random in a periodic cell that grow until they are as dense as wanted.
const CELL: &str = r#"
[model]
law = "linear"
body = "disc"
frac = STEP
[damping]
contact = 0.1
global = 2000.0
[material.m]
density = 2650.0
normal_stiffness = 2e7
shear_stiffness = 2e7
friction = FRICTION
[[generate]]
in = { rectangle = { min = [0, 0], max = [0.014, 0.014] } }
material = "m"
periodic = true
grading = [{ radius = 0.76e-3, count = 23 }, { radius = 0.61e-3, count = 28 }, { radius = 0.46e-3, count = 38 }]
[cell]
size = [0.014, 0.014]
[history]
every = 50
columns = ["porosity", "coordination", "energy_error"]
[[stage]]
name = "grow"
do = ["grow 1.4 over CYCLES"]
until = "UNTIL"
max_cycles = 200_000
"#;

fn open(text: &str) -> Session {
    let scene = Scene::parse("growth", text, &[]).unwrap();
    Session::open(scene, Options::default()).unwrap()
}

fn ended(text: &str) -> Session {
    let mut session = open(text);
    session.advance(Budget::default(), false).unwrap();
    session.finish().unwrap();
    session
}

fn last(session: &Session, column: &str) -> f64 {
    let recording = session.recording();
    let names = recording.names();
    let place = names.iter().position(|name| name == column).unwrap();
    recording.value(recording.rows().len() - 1, place)
}

fn prepared(frac: f64, friction: f64, until: &str) -> Session {
    let cycles = (4000.0 / frac) as u64;
    let text = CELL
        .replace("STEP", &frac.to_string())
        .replace("FRICTION", &friction.to_string())
        .replace("CYCLES", &cycles.to_string())
        .replace("UNTIL", until);
    ended(&text)
}

#[test]
fn radii_follow_a_line_and_masses_the_radii() {
    for (body, power) in [("disc", 2), ("sphere", 3)] {
        let mut session = open(&PAIR.replace("BODY", body));
        let mass = session.world().particles().mass[2];
        for cycle in 1..=60_u64 {
            let budget = Budget {
                until_cycle: Some(cycle),
                ..Budget::default()
            };
            session.advance(budget, false).unwrap();
            let factor = 1.0 + 0.2 * cycle.min(50) as f64 / 50.0;
            let particles = session.world().particles();
            assert!((particles.row[2].radius / (0.5 * factor) - 1.0).abs() < 1e-14);
            assert!((particles.mass[2] / (mass * factor.powi(power)) - 1.0).abs() < 1e-13);
            assert_eq!(session.world().velocity(2).0, [0.0, 0.25]);
        }
    }
}

#[test]
fn what_it_takes_is_work_of_the_command() {
    let session = ended(&PAIR.replace("BODY", "disc"));
    // Overlap 0.01 -> 2 * 1.2 - 1.99; the free disc keeps its velocity and gains 44 % of mass.
    let spring = |overlap: f64| 0.5 * 1e6 * overlap * overlap;
    let elastic = spring(0.41) - spring(0.01);
    let kinetic = 0.5 * 2000.0 * std::f64::consts::PI * 0.25 * 0.0625 * 0.44;
    let work = last(&session, "boundary_work");
    assert!((work / (elastic + kinetic) - 1.0).abs() < 1e-12, "{work}");
    assert!(last(&session, "energy_error").abs() < 1e-12);
}

#[test]
fn samples_reach_the_porosity_they_are_prepared_to() {
    for wanted in [0.25, 0.2] {
        let session = prepared(0.1, 0.0, &format!("porosity < {wanted}"));
        let reached = last(&session, "porosity");
        // 1 - porosity goes with the square of the radius: 50 cycles of 40000 add at most
        // 2 * 0.4 * 50/40000 of it.
        assert!(reached < wanted && wanted - reached < 1e-3, "{reached}");
    }
}

#[test]
fn friction_decides_how_dense_a_coordination_number_is() {
    let [smooth, rough] = [0.0, 0.5].map(|friction| {
        let session = prepared(0.1, friction, "coordination > 3");
        assert!(last(&session, "coordination") > 3.0);
        last(&session, "porosity")
    });
    assert!(rough > smooth, "{rough} {smooth}");
}

#[test]
fn the_ledger_closes_with_the_square_of_the_step() {
    let errors = [0.1, 0.05].map(|frac| {
        let session = prepared(frac, 0.0, "porosity < 0.25");
        last(&session, "energy_error").abs()
    });
    assert!(errors[0] < 0.02, "{errors:?}");
    assert!(errors[1] < 0.5 * errors[0], "{errors:?}");
}
