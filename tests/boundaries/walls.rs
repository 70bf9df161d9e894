//! Walls as the boundary: lines of the strained plane.

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Setup};

use crate::common::{closing_walls, material, particle, scene};

fn boxed() -> Setup {
    Setup {
        particles: vec![particle(5.0, 5.0, 0.5)],
        walls: closing_walls([0.0; 2], [10.0; 2], 0.0),
        boundary: Some(BoundarySetup::Walls { centre: [5.0; 2] }),
        ..scene(material(1e6, 1e6, 0.0))
    }
}

#[test]
fn walls_close_and_lean_with_the_strain() {
    let mut world = World::build(boxed(), 1).unwrap();
    world.set_strain_rate([[0.2, 0.3], [0.0, -0.1]], 0);
    let before: Vec<[[f64; 2]; 2]> = (world.walls().iter())
        .map(|w| [w.end(0), w.end(1)])
        .collect();
    let mut cycles = 0;
    while world.time() < 0.05 {
        world.cycle().expect("the scene is sound");
        cycles += 1;
    }
    let dt = world.dt();
    let step = nalgebra::Matrix2::identity() - dt * nalgebra::Matrix2::new(0.2, 0.3, 0.0, -0.1);
    let whole = step.pow(cycles);
    let centre = nalgebra::Vector2::new(5.0, 5.0);
    for (wall, ends) in world.walls().iter().zip(before) {
        // Points of the line stay on it, though not at their distance from each other.
        for end in ends {
            let exact = whole * (nalgebra::Vector2::from(end) - centre) + centre;
            let d = [exact[0] - wall.point[0], exact[1] - wall.point[1]];
            let off = d[1] * wall.direction[0] - d[0] * wall.direction[1];
            // A turn is exact for the angle of the step, the strain for its tangent: third order in
            // a turn of 0.015 over all steps together.
            assert!(off.abs() < 1e-4, "{} {off}", wall.name);
        }
    }
    assert!((world.imposed_strain().unwrap()[0][1] - 0.3 * world.time()).abs() < 1e-12);
}
