//! `frac auto`: the step follows the stability bound, and the physics does not notice.

mod common;

use ballast::engine::World;
use ballast::engine::edit::Motion;
use ballast::engine::setup::{Body, LawChoice, Material, Setup, TimeStepChoice};
use common::*;

fn shot(auto: Option<f64>, frac: f64) -> Setup {
    let mut setup = scene(Material {
        name: "steel".into(),
        density: 7800.0,
        young: Some(210e9),
        poisson: Some(0.28),
        ..material(1.0, 1.0, 0.12)
    });
    setup.law = LawChoice::exact();
    setup.body = Body::Sphere;
    setup.time_step = TimeStepChoice::Rayleigh;
    setup.frac = frac;
    setup.frac_auto = auto;
    setup.walls = vec![floor()];
    setup.particles = vec![moving(0.0, 1.005e-3, 1e-3, [0.1, -20.0], 0.0)];
    setup
}

/// Through the impact and out again.
fn fly(setup: Setup) -> World {
    let mut world = world(setup);
    let mut touched = false;
    for _ in 0..200_000 {
        run(&mut world, 1);
        let touches = world.stable_step().is_finite();
        if touched && !touches {
            break;
        }
        touched |= touches;
    }
    world.settle();
    world
}

/// A sphere on the floor, pressed by a driven one from above to a tenth of its radius.
fn press(share: f64) -> Setup {
    let mut setup = shot(Some(share), 0.1);
    setup.particles = vec![
        particle(0.0, 1e-3, 1e-3),
        driven(0.0, 3e-3, 1e-3, [0.0, -0.5], 0.0),
    ];
    setup
}

#[test]
fn the_step_keeps_to_its_share_of_the_bound() {
    for share in [0.9, 0.3] {
        let mut world = world(press(share));
        let (first, mut most, mut least) = (world.dt(), 0f64, f64::INFINITY);
        while world.time() < 4e-4 {
            run(&mut world, 1);
            most = most.max(world.dt() / world.stable_step());
            least = least.min(world.dt());
        }
        // Between two looks, twenty cycles apart, the bound falls on.
        assert!(most < 1.1 * share, "{share}: {most}");
        assert!(most > 0.95 * share, "{share}: {most}");
        assert!(
            least < 0.8 * first,
            "the load cut the step: {least} {first}"
        );
        let changes = world.step_changes();
        assert!(changes.count > 3 && changes.count < 100, "{changes:?}");
        let [low, high] = changes.range.expect("it changed");
        assert!(low == least && high == first, "{changes:?}");
    }
}

#[test]
fn the_load_gone_the_step_grows_again() {
    let mut world = world(press(0.9));
    while world.time() < 4e-4 {
        run(&mut world, 1);
    }
    let loaded = world.dt();
    world.set_motion(1, Motion::Velocity([0.0, 0.5]));
    while world.time() < 12e-4 {
        run(&mut world, 1);
    }
    assert!(world.dt() > 1.1 * loaded);
    assert!(world.dt() <= 0.9 * world.base_step() * (1.0 + 1e-12));
}

#[test]
fn changes_of_the_step_are_no_work() {
    let mut world = fly(shot(Some(0.05), 0.1));
    let b = world.bookings().expect("booked");
    assert!(b.energy_error.abs() < 1e-5, "{}", b.energy_error);
    // A fixed step comes to the same end.
    let mut fixed = fly(shot(None, 0.02));
    world.settle();
    fixed.settle();
    let [a, b] = [&world, &fixed].map(|world| world.velocity(0));
    assert!(
        (a.0[0] - b.0[0]).abs() < 1e-4 && (a.0[1] - b.0[1]).abs() < 2e-3,
        "{a:?} {b:?}"
    );
    assert!((a.1 - b.1).abs() * 1e-3 < 1e-4, "{a:?} {b:?}");
}

#[test]
fn time_is_the_sum_of_all_steps() {
    let mut world = world(shot(Some(0.5), 0.1));
    let mut sum = 0.0;
    for _ in 0..3000 {
        sum += world.dt();
        run(&mut world, 1);
    }
    assert!((world.time() / sum - 1.0).abs() < 1e-12);
}

#[test]
fn a_fixed_step_can_be_had_back() {
    let mut world = world(shot(Some(0.5), 0.1));
    run(&mut world, 500);
    world.set_frac(0.1);
    let dt = world.dt();
    assert!((dt / world.base_step() - 0.1).abs() < 1e-15);
    run(&mut world, 500);
    assert_eq!(world.dt(), dt);
    world.set_frac_auto(Some(0.3));
    run(&mut world, 500);
    assert_ne!(world.dt(), dt);
}
