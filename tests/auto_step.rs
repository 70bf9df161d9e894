//! `frac auto`: the step follows the stability bound, and the physics does not notice.

mod common;

use ballast::engine::World;
use ballast::engine::contact::dashpot::{hertz_restitution_for_fraction, restitution_for_fraction};
use ballast::engine::edit::Motion;
use ballast::engine::setup::{Body, LawChoice, Material, Setup, TimeStepChoice};
use ballast::record::checkpoint;
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
        // What comes until the next look is foreseen.
        assert!(most < 1.01 * share, "{share}: {most}");
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
    // Whose step is a tenth of the largest that is used below.
    let fine = fly(shot(None, 0.02)).velocity(0);
    // Energy is known to (ω dt)²/4, the square of the share, and the step changes by a few hundredths of
    // itself. Velocities are of second order, too: energy gives the normal one, 20 m/s, by half of that;
    // the others come out of the integral of friction and differ by 0.008 and 0.02 of the square.
    for share in [0.1, 0.05, 0.025] {
        let world = fly(shot(Some(share), 0.1));
        let square = share * share;
        let b = world.bookings().expect("booked");
        let energy = b.energy_error.abs();
        assert!(energy < 0.04 * square, "{share}: {energy}");
        let (v, spin) = world.velocity(0);
        let missed = [v[0] - fine.0[0], v[1] - fine.0[1], (spin - fine.1) * 1e-3];
        for (missed, most) in missed.into_iter().zip([0.012, 0.02 * 20.0, 0.03]) {
            assert!(missed.abs() < most * square, "{share}: {missed} {most}");
        }
    }
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

/// Energy at its most, and at the end, over that at the start, of a scene that nobody does work on.
fn gains(setup: Setup, cycles: u64) -> [f64; 2] {
    let mut world = world(setup);
    let energy = |world: &mut World| {
        world.settle();
        let e = world.energies();
        e.kinetic + e.rotational + e.elastic_normal + e.elastic_tangential
    };
    let start = energy(&mut world);
    let mut most = 0.0f64;
    for _ in 0..cycles {
        run(&mut world, 1);
        most = most.max(energy(&mut world));
    }
    [most, energy(&mut world)].map(|energy| energy / start)
}

/// Contacts that begin between two looks, with dashpots up to twenty times critical, against each other
/// and a wall.
#[test]
fn dashpots_of_contacts_to_come_are_seen() {
    for (law, body) in [
        (LawChoice::linear(), Body::Disc),
        (LawChoice::linear(), Body::Sphere),
        (law("hertz-mindlin"), Body::Sphere),
        (LawChoice::exact(), Body::Sphere),
    ] {
        for fraction in [0.1, 0.5, 1.0, 2.0, 5.0, 20.0] {
            for at_wall in [false, true] {
                let mut setup = shot(Some(0.5), 0.1);
                (setup.law, setup.body) = (law, body);
                setup.materials = vec![Material {
                    young: Some(5e9),
                    poisson: Some(0.25),
                    density: 2500.0,
                    ..material(1e7, 8e6, 0.3)
                }];
                setup.damping = contact_damping(fraction);
                if law == LawChoice::linear() {
                    setup.time_step = TimeStepChoice::Critical;
                }
                setup.particles = vec![moving(0.0, 0.0, 0.01, [1.0, 0.2], 0.0)];
                setup.walls.clear();
                if at_wall {
                    setup.walls = vec![wall("right", [0.0103, -1.0], [0.0103, 1.0])];
                } else {
                    let other = moving(0.0203, 0.0, 0.01, [-1.0, -0.2], 0.0);
                    setup.particles.push(other);
                }
                let [most, end] = gains(setup, 400);
                let case = format!("{} {body:?} {fraction} {at_wall}", law.card().name);
                // The slide has 4 % of the energy, the approach keeps e². Contacts of some ten steps know
                // that to a tenth of the whole, and to a third while they last.
                let damped = fraction.min(0.9);
                let e = if law == LawChoice::linear() {
                    restitution_for_fraction(damped, false)
                } else {
                    hertz_restitution_for_fraction(damped, false)
                };
                assert!(
                    most < 1.35 && end < e * e + 0.04 + 0.1,
                    "{case}: {most} {end} {e}"
                );
            }
        }
    }
}

/// A small sphere between a wall and one up to fifty times as large that comes.
#[test]
fn what_is_pinched_stays_stable() {
    for (young, speed, large) in [
        (5e8, 0.1, 0.01),
        (5e8, 3.4, 0.01),
        (5e9, 1.0, 0.01),
        (7e10, 0.1, 0.03),
        (7e10, 0.1, 0.1),
    ] {
        let small = 0.002;
        let mut setup = shot(Some(0.5), 0.1);
        setup.law = law("hertz-mindlin");
        setup.materials = vec![Material {
            young: Some(young),
            poisson: Some(0.25),
            density: 2500.0,
            ..material(1.0, 1.0, 0.0)
        }];
        setup.particles = vec![
            moving(0.0, 2.0 * small + large + 1e-5, large, [0.0, -speed], 0.0),
            particle(0.0, small + 1e-6, small),
        ];
        let [most, end] = gains(setup, 1500);
        assert!(
            most < 1.1 && (end - 1.0).abs() < 2e-3,
            "{young:e} {speed} {large}: {most} {end}"
        );
    }
}

/// When the bound is looked at next goes into a checkpoint: looks are seldom where nothing changes.
#[test]
fn a_checkpoint_does_not_change_when_it_is_looked_at() {
    let mut straight = world(press(0.9));
    run(&mut straight, 1000);
    let stored = checkpoint::encode(&straight).expect("it is stored");
    let mut resumed: World = checkpoint::decode(&stored).expect("it is what was stored");
    assert!(resumed.unpack(1));
    let before = straight.step_changes().count;
    for _ in 0..40 {
        run(&mut straight, 33);
        run(&mut resumed, 33);
        assert_eq!(straight.state_hash(), resumed.state_hash());
    }
    assert!(straight.step_changes().count > before);
}
