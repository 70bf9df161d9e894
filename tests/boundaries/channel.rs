//! A cell with walls along it: periodic in one direction only.

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Gravity, Setup, WallSetup};

use crate::common::{material, moving, scene, wall};

/// A disc that slides along an endless floor goes on for ever, and pushes the same as in a wide scene.
#[test]
fn a_disc_slides_through_the_images_of_a_floor() {
    let floor = WallSetup {
        h1: f64::NEG_INFINITY,
        h2: f64::INFINITY,
        ..wall("floor", [0.0, 0.0], [1.0, 0.0])
    };
    let mut setup = Setup {
        particles: vec![moving(1.0, 1.0, 1.0, [3.0, 0.0], 0.0)],
        walls: vec![floor],
        gravity: Some(Gravity::Uniform([0.0, -9.81])),
        boundary: Some(BoundarySetup::Cell {
            corner: [0.0, -1.0],
            edges: [[2.5, 0.0], [0.0, 8.0]],
        }),
        ..scene(material(1e6, 1e6, 0.0))
    };
    setup.damping.contact = ballast::engine::setup::Dashpot::Fraction(0.5);
    let open = Setup {
        boundary: None,
        ..setup.clone()
    };
    let [mut cell, mut open] =
        [setup, open].map(|s| World::build(s, 1).expect("the scene is sound"));
    for _ in 0..2000 {
        cell.cycle().expect("the scene is sound");
        open.cycle().expect("the scene is sound");
    }
    assert!(cell.position(0)[0] > 20.0);
    assert_eq!(cell.position(0), open.position(0));
}
