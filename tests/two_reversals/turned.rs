//! Spheres that are pressed together in any direction, as every quasi-static test begins: rounding then
//! leaves a tangential displacement of some 1e-18 m, which is none.

use ballast::engine::World;
use ballast::engine::edit::Motion;
use ballast::engine::setup::{Material, TimeStepChoice};

use crate::common::{driven, material, run, spheres, world};

/// Radius of both [m].
const RADIUS: f64 = 0.01;

/// Approach of the second, and the speed of its surface later [m/s].
const SPEED: f64 = 4e-3;

/// Two steel spheres that touch in this direction [rad] after a long way, the second on its way to the
/// first.
fn pressing(name: &str, angle: f64, far: f64) -> World {
    let steel = Material {
        density: 7800.0,
        young: Some(210e9),
        ..material(1.0, 1.0, 0.3)
    };
    let mut setup = spheres(name, steel);
    setup.time_step = TimeStepChoice::Seconds(1e-6);
    setup.frac = 1.0;
    let (s, c) = angle.sin_cos();
    let at = |d: f64| [far + d * c, -0.7 * far + d * s];
    let ([x, y], [u, v]) = (at(0.0), at(2.0 * RADIUS));
    setup.particles = vec![
        driven(x, y, RADIUS, [0.0; 2], 0.0),
        driven(u, v, RADIUS, [-SPEED * c, -SPEED * s], 0.0),
    ];
    world(setup)
}

/// T/(μN) after pressing, and again after shear at constant N to about half of μN.
fn obliquity(name: &str, angle: f64, far: f64) -> [f64; 2] {
    let mut world = pressing(name, angle, far);
    let share = |world: &mut World| {
        world.settle();
        let r = world.reaction(0);
        r.tangential / (0.3 * r.normal)
    };
    run(&mut world, 1000);
    let pressed = share(&mut world);
    world.set_motion(1, Motion::Velocity([0.0; 2]));
    world.set_motion(1, Motion::Spin(-5.43e-2));
    run(&mut world, 1000);
    [pressed, share(&mut world)]
}

#[test]
fn the_force_after_pressing_does_not_depend_on_the_direction() {
    // With one curve only, load at constant N, both laws are exact.
    let [_, exact] = obliquity("mindlin-deresiewicz-exact", 0.0, 0.0);
    assert!(exact > 0.4 && exact < 0.6, "{exact}");
    for k in 0..24 {
        let angle = 0.43 * f64::from(k);
        for far in [0.0, 3.0] {
            let [pressed, sheared] = obliquity("mindlin-deresiewicz", angle, far);
            // Places are rounded to 2e-16 of their distance from the origin, over 2e-6 m of overlap.
            assert!(pressed.abs() < 1e-9, "{angle} {far}: {pressed}");
            let error = sheared - exact;
            assert!(error.abs() < 1e-8, "{angle} {far}: {error:e}");
        }
    }
}

/// What counts as nothing is far less than a first step of shear: however slow, it is summed up.
#[test]
fn slow_shear_is_not_taken_for_rounding() {
    let force = |cycles: u64, spin: f64| {
        let mut world = pressing("mindlin-deresiewicz", 0.3, 0.0);
        run(&mut world, 1000);
        world.set_motion(1, Motion::Velocity([0.0; 2]));
        world.set_motion(1, Motion::Spin(spin));
        run(&mut world, cycles);
        world.settle();
        world.reaction(0).tangential
    };
    // A step of 2e-17 m: 1e-11 of the way to sliding.
    let [slow, fast] = [force(20_000, -2e-9), force(2, -2e-5)];
    assert!((slow / fast - 1.0).abs() < 1e-3, "{slow} {fast}");
}
