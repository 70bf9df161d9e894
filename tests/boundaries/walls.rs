//! Walls as the boundary: lines of the strained plane.

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Setup};
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};

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

/// The columns of a wall that moves and turns, far from zero: of the point that it turns about.
#[test]
fn columns_of_a_wall_are_those_of_its_turning_point() {
    let preset = r#"
        [model]
        law = "linear"
        body = "disc"
        frac = 0.1
        [material.disc]
        density = 1000
        normal_stiffness = 1e6
        [[particle]]
        at = [100, 200]
        radius = 0.5
        material = "disc"
        [[wall]]
        name = "bar"
        material = "disc"
        from = [101, 200]
        to = [101, 203]
        about = [102, 201]
        velocity = [0.1, -0.2]
        angular_velocity = -0.5
        [history]
        every = 1000
        columns = ["wall:bar:x", "wall:bar:y", "wall:bar:angle", "wall:bar:vx", "wall:bar:vy", "wall:bar:spin"]
        [[stage]]
        name = "turn"
        max_cycles = 1000
    "#;
    let scene = Scene::parse("bar", preset, &[]).expect("the scene is sound");
    let mut session = Session::open(scene, Options::default()).expect("the scene is sound");
    session
        .advance(Budget::default(), false)
        .expect("nothing breaks");
    let recording = session.recording();
    let last = recording.rows().len() - 1;
    let t = session.world().time();
    let due = [102.0 + 0.1 * t, 201.0 - 0.2 * t, -0.5 * t, 0.1, -0.2, -0.5];
    for (column, due) in due.into_iter().enumerate() {
        let is = recording.value(last, column);
        // A thousand additions to numbers of 1, the distance from where the world has its zero, and 200.
        assert!((is - due).abs() < 1e-12, "column {column}: {is} {due}");
    }
    assert!(t > 0.1, "it hardly moved: {t}");
}
