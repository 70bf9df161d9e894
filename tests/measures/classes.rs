//! Coordination by material and by size.

use ballast::measure::assembly::Assembly;
use ballast::measure::class::{Class, by_material, by_size};
use ballast::measure::redundancy::Redundancy;

use crate::packing::{box_of, built, close, compressed, run, setup};

/// A large disc in the middle of four small ones, a rattler beside them, of two materials.
#[test]
fn contacts_share_out_by_class() {
    let mut setup = setup(&[
        ([0.0, 0.0], 2.0),
        ([2.9, 0.0], 1.0),
        ([0.0, 2.9], 1.0),
        ([-2.9, 0.0], 1.0),
        ([0.0, -2.9], 1.0),
        ([6.0, 6.0], 1.0),
    ]);
    let mut hard = setup.materials[0].clone();
    hard.name = "hard".into();
    setup.materials.push(hard);
    setup.particles[0].material = 1;
    setup.particles[1].material = 1;
    let world = built(setup);
    let all = [true; 6];
    let class = |particles, ends, rattlers| Class {
        particles,
        ends,
        rattlers,
        all_ends: 8.0,
    };
    // The four small ones touch once each: they count as rattlers.
    let materials = by_material(&world, &all);
    assert_eq!(materials, [class(4.0, 3.0, 4.0), class(2.0, 5.0, 1.0)]);
    let sizes = by_size(&world, &all);
    assert_eq!(
        sizes,
        [
            ([1.0; 2], class(5.0, 4.0, 5.0)),
            ([2.0; 2], class(1.0, 4.0, 0.0))
        ]
    );
    assert_eq!(sizes[1].1.coordination(), 4.0);
    assert_eq!(sizes[1].1.share(), 0.5);
    assert_eq!(sizes[0].1.rattler_fraction(), 1.0);
    // What is not inside is not counted, its ends neither.
    let part = by_size(&world, &[true, false, false, false, false, true]);
    assert_eq!((part[0].1.particles, part[0].1.all_ends), (1.0, 4.0));
    // Nothing here bears anything but the large disc, and no contact it has ends at another bearing
    // one.
    let redundancy = Redundancy::of(&world, &all);
    assert_eq!((redundancy.unknowns, redundancy.equations), (0.0, 2.0));
}

#[test]
fn classes_add_up_to_the_assembly() {
    let mut world = built(compressed(8, 8));
    run(&mut world, 500);
    let inside: Vec<bool> = (0..64).map(|p| p % 5 != 0).collect();
    let assembly = Assembly::within(&world, &inside);
    let sizes = by_size(&world, &inside);
    assert_eq!(sizes.len(), 10);
    for (before, after) in sizes.iter().zip(&sizes[1..]) {
        assert_eq!(before.0[1], after.0[0]);
    }
    let sum = |of: fn(&Class) -> f64| sizes.iter().map(|(_, class)| of(class)).sum::<f64>();
    let particles = sum(|class| class.particles);
    assert_eq!(
        particles,
        inside.iter().filter(|inside| **inside).count() as f64
    );
    assert_eq!(sum(|class| class.rattlers), assembly.rattlers);
    assert!(close(
        sum(|class| class.ends) / particles,
        assembly.coordination,
        1e-14,
        1.0
    ));
    assert!(close(sum(Class::share), 1.0, 1e-14, 1.0));
    assert!(sizes.iter().all(|(_, class)| class.particles > 0.0));
}

#[test]
fn redundancy_counts_walls_driven_discs_and_slip() {
    // A disc pressed by all four walls: 4 contacts, two forces each with friction, 3 equations.
    for (friction, unknowns, equations) in [(0.0, 4.0, 2.0), (0.5, 8.0, 3.0)] {
        let mut boxed = setup(&[([1.0, 1.0], 1.01)]);
        boxed.walls = box_of([0.0; 2], [2.0; 2]);
        boxed.materials[0].friction = friction;
        let redundancy = Redundancy::of(&built(boxed), &[true]);
        assert_eq!(
            (redundancy.unknowns, redundancy.equations),
            (unknowns, equations)
        );
    }
    // Between two driven discs the same: they need no equations, and one contact does not make
    // them rattlers.
    let mut row = setup(&[([0.0, 0.0], 1.0), ([1.9, 0.0], 1.0), ([3.8, 0.0], 1.0)]);
    row.materials[0].friction = 0.5;
    row.particles[0].fixed = [true; 3];
    row.particles[2].fixed = [true; 3];
    let held = built(row.clone());
    let redundancy = Redundancy::of(&held, &[true; 3]);
    assert_eq!((redundancy.unknowns, redundancy.equations), (4.0, 3.0));
    // Only the middle one is inside: its contacts lead out.
    let redundancy = Redundancy::of(&held, &[false, true, false]);
    assert_eq!((redundancy.unknowns, redundancy.equations), (2.0, 3.0));
    // Let go, nothing is left that bears.
    row.particles[0].fixed = [false; 3];
    row.particles[2].fixed = [false; 3];
    assert!(
        Redundancy::of(&built(row), &[false, false, true])
            .ratio()
            .is_nan()
    );
    // A contact that slides has lost one force.
    let mut world = built(compressed(6, 6));
    let mut slid = false;
    for _ in 0..30 {
        run(&mut world, 20);
        let all = [true; 36];
        let assembly = Assembly::of(&world);
        let redundancy = Redundancy::of(&world, &all);
        if assembly.rattlers == 0.0 && assembly.contacts > 0.0 {
            let forces = assembly.contacts * (2.0 - assembly.sliding_fraction);
            assert!(close(redundancy.unknowns, forces, 1e-14, forces));
            assert_eq!(redundancy.equations, 3.0 * 36.0);
            slid |= assembly.sliding_fraction > 0.0;
        }
    }
    assert!(
        slid,
        "some contact must have slid in an assembly without rattlers"
    );
}
