//! Changes in the middle of a run, and what they once broke.

use ballast::engine::World;
use ballast::engine::setup::{Gravity, Material, TimeStepChoice};
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

use crate::common::{driven, floor, material, moving, run, spheres, world};

fn light() -> Material {
    Material {
        density: 1.0,
        young: Some(1e6),
        ..material(1.0, 1.0, 0.5)
    }
}

/// Cycles of a fall and what comes after it.
const CYCLES: u64 = 1500;

/// A sphere that falls aslant on a floor, spinning; after some cycles a command that changes nothing.
fn fall(name: &str, at: Option<u64>) -> ([f64; 2], f64) {
    let mut setup = spheres(name, light());
    setup.gravity = Some(Gravity::Uniform([0.3, -5.0]));
    setup.particles = vec![moving(0.0, 1.4, 1.0, [0.0, -0.2], 0.3)];
    setup.walls = vec![floor()];
    let mut world = world(setup);
    if let Some(at) = at {
        run(&mut world, at);
        world.change_materials(|_| ());
    }
    run(&mut world, CYCLES - at.unwrap_or_default());
    world.settle();
    let (v, spin) = world.velocity(0);
    (v, spin)
}

/// A command lists neighbours anew: a wall that was not near enough before is then listed, and was taken
/// for touched a radius deep.
#[test]
fn a_command_that_changes_nothing_changes_nothing_at_a_wall() {
    for name in [
        "mindlin-deresiewicz",
        "mindlin-deresiewicz-exact",
        "hertz-mindlin",
    ] {
        let undisturbed = fall(name, None);
        assert!(
            undisturbed.0[1] > -0.5,
            "it has met the floor: {undisturbed:?}"
        );
        for at in (0..CYCLES).step_by(60) {
            assert_eq!(fall(name, Some(at)), undisturbed, "{name} at {at}");
        }
    }
}

/// Two spheres, one of which is pressed on the other and sheared for 100 steps of a hundredth of the overlap.
fn sheared(name: &str) -> World {
    let mut setup = spheres(name, light());
    setup.time_step = TimeStepChoice::Seconds(1e-3);
    setup.frac = 1.0;
    setup.particles = vec![
        driven(0.0, 1.995, 1.0, [0.01, -0.005], 0.0),
        driven(0.0, 0.0, 1.0, [0.0; 2], 0.0),
    ];
    let mut world = world(setup);
    run(&mut world, 100);
    world.settle();
    world
}

/// The force stays what it was when springs change; the work that this takes or gives is booked.
#[test]
fn other_elastic_constants_keep_forces_and_books() {
    let laws = [
        "mindlin-deresiewicz-exact",
        "mindlin-deresiewicz",
        "hertz-mindlin",
    ];
    let changes: [fn(&mut World); 4] = [
        |_| (),
        |world| world.change_materials(|model| model.materials[0].poisson = Some(0.0)),
        |world| world.change_materials(|model| model.materials[0].young = Some(8e5)),
        |world| world.set_radius(0, 1.0005),
    ];
    for name in laws {
        let ends = changes.map(|change| {
            let mut world = sheared(name);
            let spring = |world: &World| world.pass().springs(0, world.geometry(0).overlap)[1];
            let before = spring(&world);
            change(&mut world);
            run(&mut world, 1);
            let after = spring(&world) / before - 1.0;
            run(&mut world, 99);
            world.settle();
            (after, world.bookings().expect("they are kept").energy_error)
        });
        let (more, open) = ends[0];
        for (after, books) in ends {
            // The next step adds what it does without a change, in proportion to the stiffness; T of the exact
            // law lost .08.
            assert!(after > 0.0 && after < 1.2 * more, "{name}: {after} {more}");
            // As open as without a change; they were open by 3e-3.
            assert!(books.abs() < 2.0 * open.abs(), "{name}: {books:e} {open:e}");
        }
    }
}

fn session(text: &str, set: &[&str]) -> Session {
    let set: Vec<String> = set.iter().map(|&option| option.to_owned()).collect();
    let scene = Scene::parse("p.toml", text, &set).unwrap_or_else(|why| panic!("{why}"));
    let mut session = Session::open(scene, Options::default()).expect("it begins");
    session.advance(Budget::default(), false).expect("it runs");
    session
}

/// What a flow carries along it carries against the force that is applied to it, too.
#[test]
fn applied_forces_do_no_work_along_a_flow() {
    let text = |flow: &str| {
        format!(
            "[model]\nlaw = \"linear\"\nbody = \"disc\"\ntime_step = 1e-3\n\
             [material.a]\ndensity = 1.0\nnormal_stiffness = 1e4\n\
             [[particle]]\nat = [3.0, 0.0]\nradius = 1.0\nmaterial = \"a\"\nforce = [1.0, 0.5]\n\
             [history]\ncolumns = [\"energy_error\"]\n\
             [[stage]]\nname = \"s\"\ndo = [{flow}]\nmax_cycles = 1000\n"
        )
    };
    for flow in ["", "\"continuum -0.1 0 0 -0.1\"", "\"continuum 0 0.2 0 0\""] {
        let mut session = session(&text(flow), &[]);
        let world = session.world_mut();
        world.settle();
        let error = world.bookings().expect("they are kept").energy_error;
        assert!(error.abs() < 1e-9, "{flow}: {error:e}");
    }
}

/// A wall under a servo moves towards whatever is nearest, however wide the halo of the list.
#[test]
fn a_servo_does_not_depend_on_the_halo() {
    let text = "[model]\nlaw = \"linear\"\nbody = \"disc\"\n\
                [material.a]\ndensity = 1.0\nnormal_stiffness = 1e4\n\
                [[particle]]\nat = [0.0, -1.3]\nradius = 1.0\nmaterial = \"a\"\n\
                [[particle]]\nat = [0.0, 4.0]\nradius = 1.0\nmaterial = \"a\"\n\
                [[particle]]\nat = [3.0, 4.0]\nradius = 1.0\nmaterial = \"a\"\n\
                [[wall]]\nname = \"plate\"\nmaterial = \"a\"\nfrom = [-5.0, 0.0]\nto = [5.0, 0.0]\n\
                [[stage]]\nname = \"s\"\ndo = [\"wall plate servo 10\"]\nmax_cycles = 100\n";
    let at = |tol: &str| {
        let mut session = session(text, &[&format!("model.tol={tol}")]);
        session.world_mut().walls()[0].velocity
    };
    let down = at("0.5");
    assert!(down[1] < 0.0, "{down:?}");
    assert_eq!(at("0.1"), down);
}
