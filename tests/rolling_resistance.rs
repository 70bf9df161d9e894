//! Rolling resistance against rigid-body mechanics: a sphere that rolls to rest, one on an incline.

mod common;

use ballast::engine::World;
use ballast::engine::setup::{
    Body, Damping, Dashpot, Gravity, LawChoice, Material, Setup, TimeStepChoice,
};
use common::*;

const G: f64 = 9.81;
const RADIUS: f64 = 0.01;

/// A sphere set down on a floor that is inclined by turning gravity.
fn on_a_floor(law: LawChoice, rolling: f64, incline: f64, v: f64) -> Setup {
    let mut setup = scene(Material {
        name: "soft".into(),
        density: 1000.0,
        young: Some(1e7),
        poisson: Some(0.3),
        rolling_friction: rolling,
        ..material(2e4, 1.6e4, 0.8)
    });
    setup.law = law;
    setup.body = Body::Sphere;
    setup.time_step = TimeStepChoice::Seconds(2e-5);
    setup.frac = 1.0;
    setup.gravity = Some(Gravity::Uniform([G * incline.sin(), -G * incline.cos()]));
    // Tangential too: the spring and the ball would ring for long.
    setup.damping = Damping {
        contact: Dashpot::Fraction(0.3),
        tangential: Some(0.3),
        ..Damping::default()
    };
    setup.walls = vec![floor()];
    let weight = 4.0 / 3.0 * std::f64::consts::PI * RADIUS.powi(3) * 1000.0 * G * incline.cos();
    let depth = if law.has_constant_springs() {
        weight / 2e4
    } else {
        let young = 1e7 / (2.0 * (1.0 - 0.09));
        (0.75 * weight / (young * RADIUS.sqrt())).powf(2.0 / 3.0)
    };
    // Rolling without slip: the lowest point rests.
    setup.particles = vec![moving(0.0, RADIUS - depth, RADIUS, [v, 0.0], -v / RADIUS)];
    setup
}

fn speed(world: &mut World) -> f64 {
    world.settle();
    world.velocity(0).0[0]
}

/// Speed of a ball that has the energy of a fully bent rolling spring [m/s].
fn swing(world: &World) -> f64 {
    let [normal, _] = world.springs(0);
    let overlap = world.geometry(0).overlap;
    let stiffness = world.pass().stiffness(0, overlap).k[0];
    let energy = normal * normal / (2.0 * 2.25 * stiffness);
    (2.0 * energy / (1.4 * world.particles().mass[0])).sqrt()
}

/// Way that a ball rolls until its spring stands at the limit, N/(c k_n μ_r) [m].
fn reach(world: &World, rolling: f64) -> f64 {
    let [normal, _] = world.springs(0);
    let overlap = world.geometry(0).overlap;
    normal / (2.25 * world.pass().stiffness(0, overlap).k[0] * rolling)
}

fn laws() -> [LawChoice; 3] {
    [
        LawChoice::linear(),
        law("hertz-mindlin"),
        LawChoice::exact(),
    ]
}

/// Once the moment stands at μ_r R N the deceleration is (5/7) μ_r g; then the spring stops the
/// ball, which comes to rest.
#[test]
fn a_rolling_sphere_comes_to_rest() {
    for law in laws() {
        let (rolling, v) = (0.05, 0.2);
        let mut world = world(on_a_floor(law, rolling, 0.0, v));
        // The moment needs θ = 1/(c k_n μ_r R/N) to build up: far less than a hundredth of a turn.
        run(&mut world, 5000);
        let start = speed(&mut world);
        run(&mut world, 10_000);
        let lost = start - speed(&mut world);
        let expected = 5.0 / 7.0 * rolling * G * 0.2;
        assert!(
            (lost / expected - 1.0).abs() < 1e-3,
            "{law:?}: {lost} {expected}"
        );
        run(&mut world, 60_000);
        let (at, rest) = (world.position(0)[0], speed(&mut world).abs());
        // Nothing damps the spring: it swings with what it holds at most, N²/(2 c k_n).
        let swing = swing(&world);
        assert!(
            rest <= 1.05 * swing && swing < 0.05 * v,
            "{law:?}: {rest} {swing}"
        );
        run(&mut world, 60_000);
        let moved = (world.position(0)[0] - at).abs();
        assert!(moved < 2.1 * reach(&world, rolling), "{law:?}: {moved}");
        let b = world.bookings().expect("booked");
        assert!(b.energy_error.abs() < 1e-4, "{law:?}: {}", b.energy_error);
        assert!(b.friction_loss > 0.5 * 0.7 * world.particles().mass[0] * v * v * 0.9);
    }
}

/// Below tan θ = μ_r it stays, above it rolls with (5/7) g (sin θ - μ_r cos θ).
#[test]
fn an_incline_holds_it_or_not() {
    for law in laws() {
        let rolling: f64 = 0.1;
        let mut held = world(on_a_floor(law, rolling, (0.8 * rolling).atan(), 0.0));
        run(&mut held, 100_000);
        let moved = held.position(0)[0].abs();
        // Free it would have gone 5/14 g sin θ t² = 1.1 m.
        assert!(speed(&mut held).abs() <= swing(&held), "{law:?}");
        assert!(moved < 3.0 * reach(&held, rolling), "{law:?}: {moved}");
        let incline = (2.0 * rolling).atan();
        let mut free = world(on_a_floor(law, rolling, incline, 0.0));
        run(&mut free, 10_000);
        let start = speed(&mut free);
        run(&mut free, 10_000);
        let gained = (speed(&mut free) - start) / 0.2;
        let expected = 5.0 / 7.0 * G * (incline.sin() - rolling * incline.cos());
        assert!(
            (gained / expected - 1.0).abs() < 1e-3,
            "{law:?}: {gained} {expected}"
        );
        // The negative control: without resistance it is faster.
        let mut bare = world(on_a_floor(law, 0.0, incline, 0.0));
        run(&mut bare, 20_000);
        assert!(speed(&mut bare) > 1.5 * speed(&mut free));
    }
}

/// Two spheres in contact, one spinning: the couple is equal and opposite, the sum of spins stays.
#[test]
fn the_couple_is_equal_and_opposite() {
    let mut setup = on_a_floor(LawChoice::exact(), 0.2, 0.0, 0.0);
    setup.gravity = None;
    setup.walls.clear();
    setup.damping = Damping::default();
    // No friction to speak of beside the couple: opposite spins roll without slip.
    setup.particles = vec![
        moving(-0.9999 * RADIUS, 0.0, RADIUS, [0.01, 0.0], 5.0),
        moving(0.9999 * RADIUS, 0.0, RADIUS, [-0.01, 0.0], -5.0),
    ];
    let mut world = world(setup);
    run(&mut world, 100);
    world.settle();
    let [a, b] = [0, 1].map(|p| world.velocity(p).1);
    assert!((a + b).abs() < 1e-9 && a < 4.999, "{a} {b}");
}
