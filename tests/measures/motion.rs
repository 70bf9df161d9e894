//! Strain and flow: driven discs that follow a given field.

use ballast::engine::World;
use ballast::engine::setup::{Body, TimeStepChoice};
use ballast::measure::flow::Flow;
use ballast::measure::reference::Reference;
use ballast::measure::region::Shape;
use ballast::measure::strain::Strain;
use ballast::measure::stress::Stress;
use ballast::measure::tensor::Principal;
use nalgebra::{Matrix2, Vector2};

use crate::packing::{Disc, built, close, lattice, measured, run, setup};

/// Step [s].
const DT: f64 = 1e-3;

/// Driven discs, each with its velocity.
fn driven(discs: &[Disc], velocity: impl Fn(usize, Vector2<f64>) -> Vector2<f64>) -> World {
    let mut setup = setup(discs);
    (setup.time_step, setup.frac) = (TimeStepChoice::Seconds(DT), 1.0);
    for (k, particle) in setup.particles.iter_mut().enumerate() {
        particle.fixed = [true; 3];
        particle.velocity = velocity(k, Vector2::from(particle.at)).into();
    }
    built(setup)
}

/// Velocity gradient: along direction 1 the field stretches, along 2 it compresses, and it shears.
fn gradient() -> Matrix2<f64> {
    Matrix2::new(0.3, -0.2, 0.5, -0.4)
}

#[test]
fn strain_is_the_displacement_gradient_of_what_was_in_the_region() {
    let discs = lattice([2.1, 0.0], [0.0, 2.1], 15.0);
    // Outside of the circle another field rules: whoever is in it belongs by where it was.
    let circle = Shape::Circle {
        centre: [0.0; 2],
        radius: 8.0,
    };
    let mut world = driven(&discs, |_, x| {
        if x.norm() < 8.0 {
            Vector2::new(5.0, -7.0) + gradient() * x
        } else {
            Vector2::new(-9.0, 3.0)
        }
    });
    let reference = Reference::of(&world);
    let still = Strain::of(&world, circle, &reference);
    assert_eq!(still.tensor, Matrix2::zeros());
    run(&mut world, 500);
    let strain = Strain::of(&world, circle, &reference);
    // Compression positive. A rounding of positions of 15 in each of 500 steps.
    let exact = -gradient() * (500.0 * DT);
    assert!((strain.tensor - exact).norm() < 1e-12, "{}", strain.tensor);
    let in_circle = discs.iter().filter(|(x, _)| Vector2::from(*x).norm() < 8.0);
    assert_eq!(strain.particles, in_circle.count());
    let principal = Principal::of(&exact);
    assert!(close(strain.volumetric(), exact.trace(), 1e-12, 1.0));
    assert!(close(
        strain.deviator(),
        principal.major - principal.minor,
        1e-12,
        1.0
    ));
    // All of them follow no common field.
    let all = Strain::of(&world, Shape::All, &reference);
    assert!((all.tensor - exact).norm() > 0.1);
    // A disc that is gone leaves the others' strain as it is.
    let middle = discs.iter().position(|(x, _)| *x == [0.0, 0.0]);
    world.delete(middle.expect("the lattice has one"));
    world.settle();
    let without = Strain::of(&world, circle, &reference);
    assert_eq!(without.particles + 1, strain.particles);
    assert!((without.tensor - exact).norm() < 1e-12);
}

#[test]
fn two_discs_have_no_strain() {
    let world = driven(&[([0.0, 0.0], 1.0), ([3.0, 0.0], 1.0)], |_, x| x);
    let reference = Reference::of(&world);
    let strain = Strain::of(&world, Shape::All, &reference);
    assert!(strain.tensor.iter().all(|x| x.is_nan()) && strain.particles == 2);
    let flow = Flow::of(&world, &[true, true]);
    assert!(flow.rate.iter().all(|x| x.is_nan()) && flow.temperature.is_nan());
    assert!(flow.inertial_number(1.0).is_nan());
}

#[test]
fn flow_is_the_common_field_and_temperature_the_rest() {
    // 8 x 8 discs; every other one is faster by 0.7 along direction 1, the others slower: that has
    // neither a mean nor a gradient.
    let discs: Vec<Disc> = (0..64_u32)
        .map(|k| ([2.2 * f64::from(k % 8), 2.2 * f64::from(k / 8)], 1.0))
        .collect();
    let checker = |k: usize| {
        if (k % 8 + k / 8).is_multiple_of(2) {
            0.7
        } else {
            -0.7
        }
    };
    for besides in [0.0, 1.0] {
        let world = driven(&discs, |k, x| {
            Vector2::new(besides * checker(k), 3.0) + gradient() * x
        });
        let flow = Flow::of(&world, &[true; 64]);
        assert!((flow.rate + gradient()).norm() < 1e-12, "{}", flow.rate);
        let temperature = 0.5 * besides * 0.7 * 0.7;
        assert!(
            close(flow.temperature, temperature, 1e-12, 1.0),
            "{}",
            flow.temperature
        );
    }
}

#[test]
fn the_inertial_number_has_no_units() {
    // A hexagonal packing, squeezed by 1 % and sheared: its pressure is known.
    let (d, k) = (1.98, crate::packing::K);
    let row = d * 3f64.sqrt() / 2.0;
    let discs = lattice([d, 0.0], [0.5 * d, row], 12.0);
    let period = Shape::Rectangle {
        min: [-4.3, -5.7],
        max: [-4.3 + 5.0 * d, -5.7 + 6.0 * row],
    };
    let shear = Matrix2::new(0.0, 0.0, 0.04, 0.0);
    for (body, thickness) in [(Body::Disc, 1.0), (Body::Sphere, 2.0)] {
        let mut setup = setup(&discs);
        setup.body = body;
        (setup.time_step, setup.frac) = (TimeStepChoice::Seconds(DT), 1.0);
        for particle in &mut setup.particles {
            particle.fixed = [true; 3];
            particle.velocity = (shear * Vector2::from(particle.at)).into();
        }
        let world = built(setup);
        let content = measured(&world, period).content;
        let pressure = Stress::of(&world, &content).isotropic();
        let exact = 3f64.sqrt() * 0.02 * k / (d * thickness);
        assert!(close(pressure, exact, 1e-12, exact));
        // Simple shear at 0.04 /s: that is the difference of the principal rates. Diameter 2,
        // density 1000, for either body.
        let number = Flow::of(&world, &content.inside).inertial_number(pressure);
        let exact = 0.04 * 2.0 * (1000.0 / exact).sqrt();
        assert!(close(number, exact, 1e-12, exact), "{number} {exact}");
        assert!(
            Flow::of(&world, &content.inside)
                .inertial_number(0.0)
                .is_nan()
        );
    }
}
