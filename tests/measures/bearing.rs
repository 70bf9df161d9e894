//! What servos see, against the measures and against lattices.

use ballast::measure::bearing::Bearing;
use ballast::measure::region::{Content, Shape};
use ballast::measure::stress::Stress;

use crate::packing::{K, built, close, compressed, lattice, run, setup};

/// Unit discs whose overlap is 0.02.
const D: f64 = 1.98;

#[test]
fn a_servo_sees_the_stress_that_is_measured() {
    let mut world = built(compressed(8, 8));
    run(&mut world, 500);
    let circle = Shape::Circle {
        centre: [8.0, 8.0],
        radius: 5.0,
    };
    for shape in [Shape::All, circle] {
        let content = Content::of(&world, shape);
        let (seen, stress) = (Bearing::of(&world, &content), Stress::of(&world, &content));
        assert!(stress.isotropic() > 0.0 && stress.shear.norm() > 0.0);
        assert_eq!(seen.stress, stress.total, "{shape:?}");
    }
}

/// An isotropic strain shortens every branch by its share: n contacts per disc on an area A carry
/// k n D^2/(2 A) more, that is k in a square lattice and sqrt(3) k in a hexagonal one.
#[test]
fn moduli_of_lattices() {
    let row = D * 3f64.sqrt() / 2.0;
    for (step, size, modulus) in [
        ([0.0, D], [5.0 * D, 6.0 * D], K),
        ([0.5 * D, row], [5.0 * D, 6.0 * row], 3f64.sqrt() * K),
    ] {
        let world = built(setup(&lattice([D, 0.0], step, 20.0)));
        let corner = [-4.3, -5.7];
        let region = Shape::Rectangle {
            min: corner,
            max: [corner[0] + size[0], corner[1] + size[1]],
        };
        let seen = Bearing::of(&world, &Content::of(&world, region));
        assert!(close(seen.modulus, modulus, 1e-12, modulus), "{seen:?}");
    }
}
