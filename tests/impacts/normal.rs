//! Normal impacts: Hertz's closed form, restitution asked and measured.

use ballast::engine::contact::dashpot::hertz_restitution_for_fraction;
use ballast::engine::setup::{Damping, Dashpot, TimeStepChoice};

use ballast::measure::columns::Column;
use ballast::measure::sample::Sample;

use crate::common::{law, moving, particle, world};
use crate::shots::Shot;

/// Hertz: (5.9), (5.12) of Randall 1989 with the exact constant 2.9432.
#[test]
fn hertz_impacts_have_their_closed_form() {
    for twin in [false, true] {
        let shot = Shot {
            twin,
            steps: 2000.0,
            ..Shot::thesis(law("hertz"), 0.0)
        };
        let [depth, force, time] = shot.hertz();
        let flight = shot.fire();
        if !twin {
            // Values of Randall's case to all digits the reference gives.
            assert!((time / 8.321_889_27e-6 - 1.0).abs() < 1e-8, "{time}");
            assert!((force / 5.777_795_33 - 1.0).abs() < 1e-8, "{force}");
        }
        // The largest value is between two boundaries: off by less than (π/2/2000)²/2 of itself.
        assert!((flight.deepest / depth - 1.0).abs() < 2e-6, "{flight:?}");
        assert!((flight.largest[0] / force - 1.0).abs() < 2e-6);
        // A step at either end.
        assert!((flight.steps as f64 * flight.dt / time - 1.0).abs() < 2.0 / 2000.0);
        assert!(
            (flight.v[0] / shot.velocity[0] - 1.0).abs() < 1e-8,
            "{:?}",
            flight.v
        );
    }
}

fn measured(e: f64, steps: f64, phase: f64, radius: f64, speed: f64, centred: bool) -> f64 {
    let shot = Shot {
        radius,
        velocity: [speed, 0.0],
        damping: Damping {
            contact: Dashpot::Restitution(e),
            centred,
            ..Damping::default()
        },
        steps,
        phase,
        ..Shot::thesis(law("hertz"), 0.0)
    };
    shot.fire().v[0] / speed
}

/// 0.7e-3 off at most with velocities half a step old, 5e-5 with centred ones.
#[test]
fn restitution_asked_is_restitution_measured() {
    for e in [0.2, 0.4, 0.6, 0.8, 0.95, 1.0] {
        for radius in [1e-5, 1e-3, 1.0] {
            for speed in [1e-3, 0.1, 10.0] {
                for (centred, within) in [(false, 1e-3), (true, 1e-4)] {
                    let off = measured(e, 350.0, 0.5, radius, speed, centred) - e;
                    assert!(off.abs() < within, "{e} {radius} {speed} {centred}: {off}");
                }
            }
        }
    }
}

/// The dashpot sees the velocity of half a step before: it acts late, first order in the step.
/// Mean over phases of the first touch, 80 steps in a contact (FRAC 0.1 of the thesis' case).
#[test]
fn the_lag_of_the_dashpot_is_of_first_order_and_mends() {
    let mean = |e: f64, steps: f64, centred: bool| {
        let phases = (0..16).map(|k| f64::from(k) / 16.0);
        let sum: f64 = phases
            .map(|phase| measured(e, steps, phase, 1e-3, 1.0, centred))
            .sum();
        sum / 16.0 - e
    };
    for e in [0.2, 0.5, 0.7, 0.9] {
        assert!(mean(e, 80.0, false).abs() < 5e-3);
        assert!(mean(e, 80.0, true).abs() < 1e-4);
    }
    let order = (mean(0.3, 35.0, false) / mean(0.3, 140.0, false)).log2() / 2.0;
    assert!((order - 1.0).abs() < 0.1, "{order}");
    assert!(mean(0.3, 35.0, true).abs() < 0.05 * mean(0.3, 35.0, false).abs());
}

/// Above the threshold a contact is damped critically, c = 2 √(M* k): e = 0.120 of a Hertz impact
/// that may not pull. Below it nothing changes.
#[test]
fn large_overlaps_are_damped_critically_and_counted() {
    let shot = |share: f64| Shot {
        damping: Damping {
            overlap_critical: Some(share),
            ..Damping::default()
        },
        ..Shot::thesis(law("hertz"), 0.0)
    };
    // The impact goes 0.056 % of the diameter deep.
    let below = shot(1e-3).fire().v[0] / 0.4;
    assert!((below - 1.0).abs() < 1e-6, "{below}");
    let above = shot(1e-9).fire().v[0] / 0.4;
    let critical = hertz_restitution_for_fraction(1.0, false);
    assert!((critical - 0.120).abs() < 5e-4, "{critical}");
    assert!((above - critical).abs() < 1e-3, "{above}");

    let warnings = Column::parse("overlap_warnings").expect("it is in the list");
    let mut counts = [1e-4, 1e-3].map(|share| {
        let mut world = shot(share).world();
        for _ in 0..150 {
            world.cycle().expect("no fault");
        }
        Sample::of(&mut world).value(&warnings)
    });
    counts.sort_by(f64::total_cmp);
    assert_eq!(counts, [0.0, 1.0]);
}

/// The threshold is a share of the smaller body of each contact: a speck that is nowhere near changes nothing, and
/// beside a sphere of half the size it lies at half the depth (Randall 1989, 6.4.3).
#[test]
fn what_is_a_large_overlap_depends_on_the_two_that_touch() {
    let rebound = |share: f64, partner: f64, speck: bool| {
        let shot = Shot {
            twin: true,
            ..Shot::thesis(law("hertz"), 0.0)
        };
        let mut setup = shot.world().model().clone();
        setup.damping.overlap_critical = Some(share);
        let (r, v) = (shot.radius, shot.velocity[0]);
        setup.particles = vec![
            moving(-r, 0.0, r, [v, 0.0], 0.0),
            moving(partner * r, 0.0, partner * r, [-v, 0.0], 0.0),
        ];
        if speck {
            setup.particles.push(particle(0.0, 30.0 * r, 0.01 * r));
        }
        let mut world = world(setup);
        let mut deepest = 0f64;
        for _ in 0..2000 {
            world.cycle().expect("no fault");
            deepest = deepest.max(world.geometry(0).overlap);
        }
        let apart = world.velocity(1).0[0] - world.velocity(0).0[0];
        (apart / (2.0 * v), deepest / (2.0 * r * partner.min(1.0)))
    };
    for partner in [1.0, 0.5] {
        let (elastic, depth) = rebound(1.0, partner, false);
        assert!((elastic - 1.0).abs() < 1e-5, "{elastic}");
        for speck in [false, true] {
            let above = rebound(1.01 * depth, partner, speck).0;
            assert!((above - 1.0).abs() < 1e-5, "{partner} {speck}: {above}");
            let below = rebound(0.9 * depth, partner, speck).0;
            assert!(below < 0.95, "{partner} {speck}: {below}");
        }
    }
}

/// Rebound over approach speed of two spheres whose radii are 1 : `ratio`, less what was asked for.
fn uneven(ratio: f64, e: f64, steps: f64, centred: bool) -> f64 {
    let shot = Shot::thesis(law("hertz"), 0.0);
    let mut setup = shot.world().model().clone();
    let (small, large) = (shot.radius, ratio * shot.radius);
    let (m, r) = (
        shot.mass().0 * ratio.powi(3) / (1.0 + ratio.powi(3)),
        small * large / (small + large),
    );
    let v = 0.4;
    let depth = (15.0 * m * v * v / (16.0 * shot.young_eff() * r.sqrt())).powf(0.4);
    let dt = 2.943_275_179_6 * depth / v / steps;
    setup.time_step = TimeStepChoice::Seconds(dt);
    setup.damping = Damping {
        contact: Dashpot::Restitution(e),
        centred,
        ..Damping::default()
    };
    setup.tol = Some(0.5 * small);
    setup.particles = vec![
        moving(-small - 0.5 * v * dt, 0.0, small, [v, 0.0], 0.0),
        moving(large, 0.0, large, [0.0, 0.0], 0.0),
    ];
    let mut world = world(setup);
    for _ in 0..(4.0 * steps) as usize {
        world.cycle().expect("no fault");
    }
    world.settle();
    (world.velocity(1).0[0] - world.velocity(0).0[0]) / v - e
}

/// The lag of the dashpot is that of the effective mass: it does not grow with the ratio of sizes.
#[test]
fn unequal_sizes_lag_no_more() {
    for ratio in [1.0, 3.0, 10.0, 30.0] {
        for e in [0.3, 0.7] {
            let lagged = uneven(ratio, e, 80.0, false);
            let equal = uneven(1.0, e, 80.0, false);
            assert!(
                (lagged - equal).abs() < 2e-4,
                "{ratio} {e}: {lagged} {equal}"
            );
            let centred = uneven(ratio, e, 80.0, true);
            // One phase of the first touch only.
            assert!(centred.abs() < 5e-4, "{ratio} {e}: {centred}");
        }
    }
}
