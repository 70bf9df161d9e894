//! `frac auto`: the step follows the stability bound, and the physics does not notice.

mod common;

use ballast::engine::World;
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

/// Through the impact and out again; answers the world and the largest dt over the bound.
fn fly(setup: Setup) -> (World, f64) {
    let mut world = world(setup);
    let mut most = 0f64;
    let mut touched = false;
    for _ in 0..200_000 {
        run(&mut world, 1);
        let bound = world.stable_step();
        if bound.is_finite() {
            touched = true;
            most = most.max(world.dt() / bound);
        } else if touched {
            break;
        }
    }
    world.settle();
    (world, most)
}

#[test]
fn the_step_keeps_to_its_share_of_the_bound() {
    // At 20 m/s the bound at full load is below the Rayleigh step, so that it has to be cut.
    let (world, most) = fly(shot(Some(0.9), 0.1));
    let changes = world.step_changes();
    assert!(changes.count > 0, "the step never changed");
    // Between two looks, twenty cycles apart, the bound falls on.
    assert!(most < 1.3 * 0.9, "{most}");
    let (finer, most) = fly(shot(Some(0.05), 0.1));
    assert!(most < 1.05 * 0.05, "{most}");
    let [v, fine] = [&world, &finer].map(|world| world.velocity(0).0[1]);
    assert!((fine / 20.0 - 1.0).abs() < 1e-4, "{fine}");
    assert!((v / 20.0 - 1.0).abs() < 0.05, "{v}");
    assert!(finer.cycle_number() > 5 * world.cycle_number());
}

#[test]
fn changes_of_the_step_are_no_work() {
    let (mut world, _) = fly(shot(Some(0.05), 0.1));
    let b = world.bookings().expect("booked");
    assert!(b.energy_error.abs() < 1e-5, "{}", b.energy_error);
    // A fixed step comes to the same end.
    let (mut fixed, _) = fly(shot(None, 0.02));
    world.settle();
    fixed.settle();
    let [a, b] = [&world, &fixed].map(|world| world.velocity(0));
    assert!(
        (a.0[0] - b.0[0]).abs() < 1e-5 && (a.0[1] - b.0[1]).abs() < 2e-3,
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
