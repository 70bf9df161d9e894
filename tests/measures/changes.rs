//! Contacts broken and made, and rotations, since the reference.

use ballast::engine::World;
use ballast::engine::setup::TimeStepChoice;
use ballast::measure::changes::{Bond, Changes, lattice};
use ballast::measure::reference::Reference;
use ballast::scene::Scene;
use ballast::session::{Options, Session};

use crate::packing::{box_of, built, compressed, run, setup};

/// Three driven discs over a floor: 1 on it, 2 beside, 3 apart. 2 moves from 1 to 3, all turn.
fn three() -> World {
    let mut setup = setup(&[([0.0, 0.99], 1.0), ([1.98, 1.2], 1.0), ([4.1, 1.2], 1.0)]);
    setup.walls = box_of([-1.5, 0.0], [9.0, 9.0]);
    (setup.time_step, setup.frac) = (TimeStepChoice::Seconds(0.01), 1.0);
    for particle in &mut setup.particles {
        particle.fixed = [true; 3];
        // Nothing can turn a frictionless disc, but its own spin does.
        particle.spin = 0.5;
    }
    setup.particles[1].velocity = [1.0, 0.0];
    setup.particles[2].spin = -1.5;
    built(setup)
}

fn changes(world: &World, reference: &Reference) -> Changes {
    Changes::of(world, &vec![true; world.particles().len()], reference)
}

#[test]
fn contacts_break_and_form() {
    let mut world = three();
    let reference = Reference::of(&world);
    let none = changes(&world, &reference);
    assert_eq!((none.kept, none.made, none.broken), (2.0, 0.0, 0.0));
    assert_eq!((none.rotation, none.rotation_max), (0.0, 0.0));
    assert_eq!(none.broken_fraction(), 0.0);
    run(&mut world, 20);
    let now = changes(&world, &reference);
    assert_eq!((now.kept, now.made, now.broken), (1.0, 1.0, 1.0));
    assert_eq!(now.broken_fraction(), 0.5);
    let turned = 0.2 * (0.5 + 0.5 + 1.5) / 3.0;
    assert!((now.rotation - turned).abs() < 1e-14 && (now.rotation_max - 0.3).abs() < 1e-14);
    // Across the edge of a region contacts count by half, at the floor whole.
    let part = |inside: [bool; 3]| Changes::of(&world, &inside, &reference);
    let first = part([true, false, false]);
    assert_eq!((first.kept, first.made, first.broken), (1.0, 0.0, 0.5));
    let second = part([false, true, false]);
    assert_eq!((second.kept, second.made, second.broken), (0.0, 0.5, 0.5));
    // The space lattice says where.
    let of = |bond: Bond| {
        let bonds = lattice(&world, &reference);
        let found: Vec<_> = bonds.iter().filter(|(of, _)| *of == bond).collect();
        assert_eq!(found.len(), 1, "{bonds:?}");
        found[0].1
    };
    assert_eq!(of(Bond::Broken)[0], [0.0, 0.99]);
    assert_eq!(of(Bond::Made)[1], [4.1, 1.2]);
    let [_, foot] = of(Bond::Kept);
    assert!(foot[0].abs() < 1e-15 && foot[1].abs() < 1e-15);
    // A new reference starts over.
    let later = changes(&world, &Reference::of(&world));
    assert_eq!((later.kept, later.made, later.broken), (2.0, 0.0, 0.0));
}

#[test]
fn particles_are_known_by_their_numbers_and_angles() {
    let mut world = three();
    run(&mut world, 20);
    // Numbers 1 and 3, turned: not what most references hold.
    world.delete(1);
    world.settle();
    let reference = Reference::of(&world);
    run(&mut world, 20);
    let turned = |id| reference.change(&world, id).map(|(_, turned)| turned);
    assert_eq!([turned(0), turned(2), turned(4)], [None; 3]);
    for (id, expected) in [(1, 0.5 * 0.2), (3, -1.5 * 0.2)] {
        let turned = turned(id).expect("it is there");
        assert!((turned - expected).abs() < 1e-14, "{id}: {turned}");
    }
}

#[test]
fn what_is_gone_has_broken_its_contacts() {
    let mut world = three();
    let reference = Reference::of(&world);
    world.delete(1);
    world.settle();
    let now = changes(&world, &reference);
    // The end that is left counts.
    assert_eq!((now.kept, now.made, now.broken), (1.0, 0.0, 0.5));
    let floor = world.walls().iter().position(|wall| wall.name == "bottom");
    world.delete_wall(floor.expect("the box has one"));
    world.settle();
    let now = changes(&world, &reference);
    assert_eq!((now.kept, now.made, now.broken), (0.0, 0.0, 1.5));
    assert_eq!(reference.change(&world, 2), None);
}

#[test]
fn regions_side_by_side_share_the_changes() {
    let mut world = built(compressed(8, 8));
    run(&mut world, 500);
    let reference = Reference::of(&world);
    // Sideways it gives way now.
    world.set_wall_velocity(0, [-0.6, 0.0]);
    world.set_wall_velocity(1, [0.6, 0.0]);
    run(&mut world, 150);
    let all = changes(&world, &reference);
    assert!(
        all.broken > 5.0 && all.made > 5.0 && all.kept > 20.0,
        "{all:?}"
    );
    let mut sum = [0.0; 3];
    for third in 0..3 {
        let inside: Vec<bool> = (0..64).map(|p| p % 3 == third).collect();
        let part = Changes::of(&world, &inside, &reference);
        for (sum, own) in sum.iter_mut().zip([part.kept, part.made, part.broken]) {
            *sum += own;
        }
    }
    assert_eq!(sum, [all.kept, all.made, all.broken]);
    let count = |of: Bond| {
        lattice(&world, &reference)
            .iter()
            .filter(|(bond, _)| *bond == of)
            .count()
    };
    assert_eq!(count(Bond::Kept) as f64, all.kept);
    assert_eq!(count(Bond::Made) as f64, all.made);
    // Broken contacts at walls are not drawn.
    assert!(count(Bond::Broken) as f64 <= all.broken);
}

/// Two discs that touch through the edge of a periodic cell and part: each bond is as long as the
/// shortest way between them, not across the cell.
#[test]
fn bonds_through_the_edge_of_a_cell_are_short() {
    let text = r#"
        [model]
        body = "disc"
        time_step = 1e-3
        [material.disc]
        density = 1000.0
        normal_stiffness = 1e4
        shear_stiffness = 1e4
        [cell]
        size = [1.0, 1.0]
        [[particle]]
        at = [-0.45, 0.0]
        radius = 0.051
        material = "disc"
        driven = true
        velocity = [1.0, 0.0]
        [[particle]]
        at = [0.45, 0.0]
        radius = 0.051
        material = "disc"
        driven = true
    "#;
    let scene = Scene::parse("edge", text, &[]).unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    let world = session.world_mut();
    let reference = Reference::of(world);
    let of = |world: &World, bond: Bond| {
        let bonds = lattice(world, &reference);
        assert!(bonds.len() == 1 && bonds[0].0 == bond, "{bonds:?}");
        let [from, to] = bonds[0].1;
        (to[0] - from[0]).abs()
    };
    assert!((of(world, Bond::Kept) - 0.1).abs() < 1e-15);
    // It moves away from the edge by 0.01 m.
    run(world, 10);
    assert!((of(world, Bond::Broken) - 0.11).abs() < 1e-12);
}
