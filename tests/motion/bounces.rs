//! A disc that bounces: what comes back of its speed, with and without dashpots.

use ballast::engine::contact::dashpot::restitution_for_fraction;
use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Body, Damping, Dashpot, TimeStepChoice};

use crate::common::*;
use crate::of_mass;

/// Two equal discs that meet head-on: speed after over speed before, and what it may depend on.
fn bounce(steps: f64, phase: f64, damping: Damping) -> f64 {
    let k = 1e4;
    let mut setup = two_particles(of_mass(Body::Disc, 1.0, material(k, k, 0.0)), 0.0);
    // Half a period of two masses 1 on a spring k.
    let contact = std::f64::consts::PI * (0.5 / k).sqrt();
    let dt = contact / steps;
    setup.time_step = TimeStepChoice::Seconds(dt);
    setup.frac = 1.0;
    setup.damping = damping;
    let v = 0.01;
    // The first touch falls this fraction of a step after a boundary.
    let gap = 2.0 * v * dt * (3.0 + phase);
    setup.particles[0].at[0] -= 0.5 * gap;
    setup.particles[1].at[0] += 0.5 * gap;
    setup.particles[0].velocity = [v, 0.0];
    setup.particles[1].velocity = [-v, 0.0];
    let mut world = world(setup);
    run(&mut world, (6.0 * steps) as u64 + 10);
    let apart = |status: &Status| *status == Status::Apart;
    assert!(world.contacts().status.iter().all(apart));
    let after = world.particles().row[1].v[0];
    assert!(after > 0.0, "they met");
    after / v
}

/// Largest error over sixteen phases.
fn worst(steps: f64, damping: Damping, expected: f64) -> f64 {
    let errors: Vec<f64> = (0..16)
        .map(|k| (bounce(steps, f64::from(k) / 16.0, damping) - expected).abs())
        .collect();
    range(&errors)[1]
}

#[test]
fn an_undamped_bounce_restores_the_speed() {
    let fine = worst(1000.0, Damping::default(), 1.0);
    assert!(fine < 1e-8, "{fine:e}");
    let errors = [50.0, 100.0, 200.0, 400.0, 800.0]
        .map(|steps| [1.0 / steps, worst(steps, Damping::default(), 1.0)]);
    let order = order(&errors);
    assert!((order - 3.0).abs() < 0.2, "{order}: {errors:?}");
}

#[test]
fn restitution_comes_out_as_asked() {
    for pull in [false, true] {
        for e in [0.1, 0.3, 0.5, 0.8, 0.95] {
            let damping = Damping {
                contact: Dashpot::Restitution(e),
                pull,
                ..Damping::default()
            };
            let coarse = worst(1000.0, damping, e);
            let fine = worst(4000.0, damping, e);
            // The dashpot lags half a step: first order.
            assert!(fine < 2e-3, "{e} {pull}: {fine}");
            assert!(fine < 0.4 * coarse, "{e} {pull}: {fine} {coarse}");
        }
        for fraction in [0.05, 0.2, 0.7] {
            let damping = Damping {
                pull,
                ..contact_damping(fraction)
            };
            let e = restitution_for_fraction(fraction, pull);
            assert!(
                (bounce(4000.0, 0.3, damping) - e).abs() < 2e-3,
                "{fraction} {pull}"
            );
        }
    }
    // Negative control: the two rules of separation differ by far more than the tolerance.
    let gap = restitution_for_fraction(0.2, false) - restitution_for_fraction(0.2, true);
    assert!(gap > 0.02);
}

#[test]
fn restitution_holds_against_what_cannot_move_but_may_turn() {
    for fixed in [[true; 3], [true, true, false]] {
        let mut setup = scene(of_mass(Body::Disc, 1.0, material(1e4, 1e4, 0.0)));
        setup.damping.contact = Dashpot::Restitution(0.5);
        setup.frac = 1e-3;
        setup.particles = vec![
            moving(0.0, 0.0, 1.0, [0.01, 0.0], 0.0),
            particle(2.0 + 1e-6, 0.0, 1.0),
        ];
        setup.particles[1].fixed = fixed;
        let mut world = world(setup);
        while world.particles().row[0].v[0] > 0.0 || world.contacts().status[0] != Status::Apart {
            run(&mut world, 1);
        }
        // As if it could give way, .60 came out.
        let ratio = -world.particles().row[0].v[0] / 0.01;
        assert!((ratio - 0.5).abs() < 2e-3, "{fixed:?}: {ratio}");
    }
}

#[test]
fn a_wall_dashpot_of_its_own() {
    let e = 0.4;
    let mut setup = on_floor(of_mass(Body::Disc, 1.0, material(1e4, 1e4, 0.0)), 1e-4);
    setup.damping.contact = Dashpot::Restitution(0.9);
    setup.damping.wall = Some(Dashpot::Restitution(e));
    setup.frac = 1e-3;
    setup.particles[0].velocity = [0.0, -0.01];
    let mut world = world(setup);
    while world.particles().row[0].v[1] < 0.0 || world.contacts().status[0] != Status::Apart {
        run(&mut world, 1);
    }
    let ratio = world.particles().row[0].v[1] / 0.01;
    // Half a step of lag in a contact of some 1500 steps.
    assert!((ratio - e).abs() < 2e-3, "{ratio}");
}
