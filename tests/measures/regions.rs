//! Regions: their areas, what belongs to them, and that it does not matter where they lie.

use ballast::engine::World;
use ballast::language::Term;
use ballast::measure::columns::Column;
use ballast::measure::region::{Enclosure, Shape};
use ballast::measure::rose::{PETALS, Rose};
use ballast::measure::sample::Sample;
use ballast::scene::Scene;
use ballast::session::{Budget, Options, Session};
use std::f64::consts::PI;

use crate::packing::{K, box_of, built, close, compressed, lattice, measured, run, setup, wall};

fn area(world: &World) -> f64 {
    measured(world, Shape::All).content.area
}

fn is_closed(world: &World) -> bool {
    matches!(Enclosure::of(world), Enclosure::Walls(_))
}

#[test]
fn walls_enclose_the_polygon_of_their_lines() {
    let discs = [([1.0, 1.0], 1.0), ([3.0, 1.0], 1.0), ([2.0, 2.5], 0.7)];
    // A box; the same with walls that end short of the corners and one that goes beyond; one
    // side of two pieces; two walls without end.
    let plain = box_of([0.0, 0.0], [4.0, 5.0]);
    let mut short = box_of([0.0, 0.0], [4.0, 5.0]);
    for wall in &mut short {
        wall.h1 += 0.1;
        wall.h2 -= 0.2;
    }
    short[0].h2 += 9.0;
    let mut pieces = plain.clone();
    pieces[2] = wall("one", [0.0, 0.0], [1.5, 0.0]);
    pieces.push(wall("two", [4.0, 0.0], [1.5, 0.0]));
    let mut endless = plain.clone();
    for wall in &mut endless[..2] {
        (wall.h1, wall.h2) = (f64::NEG_INFINITY, f64::INFINITY);
    }
    for walls in [plain, short, pieces, endless] {
        let mut setup = setup(&discs);
        setup.walls = walls;
        let world = built(setup);
        assert!(is_closed(&world));
        assert!(close(area(&world), 20.0, 1e-14, 20.0), "{}", area(&world));
        let covered = PI * (1.0 + 1.0 + 0.49) / 20.0;
        let porosity = measured(&world, Shape::All).content.porosity();
        assert!(close(porosity, 1.0 - covered, 1e-14, 1.0));
    }
    // A triangle with its direction reversed on one side: 3-4-5 about its incircle of radius 1.
    let mut triangle = setup(&[([1.0, 1.0], 1.0)]);
    triangle.walls = vec![
        wall("bottom", [4.0, 0.0], [0.0, 0.0]),
        wall("left", [0.0, 3.0], [0.0, 0.0]),
        wall("slope", [4.0, 0.0], [0.0, 3.0]),
    ];
    assert!(close(area(&built(triangle)), 6.0, 1e-14, 6.0));
}

#[test]
fn walls_that_move_and_turn_take_the_area_along() {
    let mut moved = setup(&lattice([2.1, 0.0], [0.0, 2.1], 3.1));
    moved.walls = box_of([-5.0, -5.0], [5.0, 5.0]);
    moved.walls[0].velocity = [-1.0, 0.0];
    moved.walls[3].velocity = [0.0, 0.5];
    // Both sides turn about their lower ends: a parallelogram of the same width and height.
    moved.walls[0].angular_velocity = -0.2;
    moved.walls[1].angular_velocity = -0.2;
    let mut world = built(moved);
    run(&mut world, 30);
    let t = world.time();
    assert!(t > 0.1);
    assert!(is_closed(&world));
    let exact = (10.0 + t) * (10.0 + 0.5 * t);
    assert!(
        close(area(&world), exact, 1e-12, exact),
        "{exact} {}",
        area(&world)
    );
    assert!(exact > 101.0);
}

#[test]
fn without_a_lid_it_is_the_hull_of_the_discs() {
    let discs = [([1.0, 1.0], 1.0), ([4.0, 1.0], 1.0)];
    let mut open = setup(&discs);
    open.walls = box_of([0.0, 0.0], [5.0, 5.0]);
    open.walls.pop();
    let world = built(open);
    assert!(!is_closed(&world));
    assert!(close(area(&world), PI + 6.0, 1e-14, 10.0));
    // A lid that covers less than half of the opening does not close it.
    let mut ajar = setup(&discs);
    ajar.walls = box_of([0.0, 0.0], [5.0, 5.0]);
    ajar.walls[3].h2 = 2.4;
    assert!(!is_closed(&built(ajar.clone())));
    ajar.walls[3].h2 = 2.6;
    assert!(is_closed(&built(ajar)));
    assert!(area(&built(setup(&[([7.0, 7.0], 2.0)]))) - 4.0 * PI < 1e-14);
}

#[test]
fn regions_side_by_side_share_everything_and_count_nothing_twice() {
    let mut world = built(compressed(6, 6));
    while measured(&world, Shape::All).stress.isotropic() < 2e3 {
        run(&mut world, 20);
    }
    let all = measured(&world, Shape::All);
    let (mut particles, mut discs, mut contacts) = (0, 0.0, 0.0);
    let mut sum = nalgebra::Matrix2::zeros();
    for i in 0..3 {
        for j in 0..4 {
            let min = [f64::from(i) * 4.0, f64::from(j) * 3.0];
            let max = [min[0] + 4.0, min[1] + 3.0];
            let part = measured(&world, Shape::Rectangle { min, max });
            particles += part.content.particles();
            discs += part.content.disc_area;
            contacts += part.fabric.contacts;
            if part.content.particles() > 0 {
                sum += part.stress.total / part.content.per_volume();
            }
        }
    }
    assert_eq!(particles, 36);
    // Wall contacts count whole, others half at each end: exact in binary.
    assert_eq!(contacts, all.fabric.contacts);
    let sample = Sample::of(&mut world);
    assert_eq!(contacts, sample.assembly().contacts);
    // 36 discs, up to four cuts each; sums in another order.
    assert!(close(discs, all.content.disc_area, 1e-13, discs));
    let whole = all.stress.total / all.content.per_volume();
    assert!((sum - whole).norm() < 1e-13 * whole.norm());
    assert!(whole.norm() > 0.0);
}

#[test]
fn roses_count_wall_contacts_once_and_sliding_ones_apart() {
    let mut boxed = setup(&[([1.0, 1.0], 1.01)]);
    boxed.walls = box_of([0.0, 0.0], [2.0, 2.0]);
    let world = built(boxed);
    let m = measured(&world, Shape::All);
    let rose = Rose::of(&world, &m.content, 4);
    assert_eq!(rose.contacts, [2.0, 0.0, 2.0, 0.0]);
    assert!(close(rose.force[0], 0.02 * K, 1e-12, K));
    let mut world = built(compressed(6, 6));
    let mut slid = 0.0;
    for _ in 0..40 {
        if slid > 10.0 {
            break;
        }
        run(&mut world, 20);
        let sample = Sample::of(&mut world);
        let rose = sample.regional().rose();
        let assembly = *sample.assembly();
        let sum = |petals: &[f64]| petals.iter().sum::<f64>();
        assert_eq!(sum(&rose.contacts), assembly.contacts);
        if assembly.contacts > 0.0 {
            let share = sum(&rose.sliding) / sum(&rose.contacts);
            assert!(close(share, assembly.sliding_fraction, 1e-14, 1.0));
        }
        slid += sum(&rose.sliding);
        assert_eq!(rose.contacts.len(), PETALS);
    }
    assert!(slid > 10.0, "something must have slid: {slid}");
}

#[test]
fn lying_elsewhere_changes_nothing() {
    let shapes = [
        Shape::All,
        Shape::Circle {
            centre: [0.5, 0.25],
            radius: 5.0,
        },
        Shape::Rectangle {
            min: [-3.5, -4.25],
            max: [4.0, 3.75],
        },
    ];
    // Far away by a power of two and with coordinates in 64ths nothing is rounded: not one bit
    // differs. By 1e6 with any overlap, coordinates are rounded to 1e-10, overlaps of 0.03 to 1e-8.
    for (d, shift, share) in [(2.0 - 1.0 / 32.0, 1_048_576.0, 0.0), (1.97, 1e6, 1e-7)] {
        let discs = lattice([d, 0.0], [0.5 * d, 1.75], 9.0);
        let far: Vec<_> = discs
            .iter()
            .map(|&([x, y], r)| ([x + shift, y - shift], r))
            .collect();
        let (near, far) = (built(setup(&discs)), built(setup(&far)));
        assert!(near.contacts().pairs.len() > 100);
        for shape in shapes {
            let elsewhere = match shape {
                Shape::All => Shape::All,
                Shape::Circle { centre, radius } => Shape::Circle {
                    centre: [centre[0] + shift, centre[1] - shift],
                    radius,
                },
                Shape::Rectangle { min, max } => Shape::Rectangle {
                    min: [min[0] + shift, min[1] - shift],
                    max: [max[0] + shift, max[1] - shift],
                },
            };
            let (a, b) = (measured(&near, shape), measured(&far, elsewhere));
            assert_eq!(a.content.inside, b.content.inside);
            let (p, q) = (a.content.porosity(), b.content.porosity());
            assert!((p - q).abs() <= share, "{shape:?} {p} {q}");
            let off = (a.stress.total - b.stress.total).norm();
            assert!(off <= share * a.stress.isotropic(), "{shape:?} {off}");
            assert!((a.fabric.weighted - b.fabric.weighted).norm() <= share);
        }
    }
}

#[test]
fn presets_name_regions_and_histories_read_them() {
    let preset = r#"
        [model]
        body = "disc"
        [material.m]
        density = 1e3
        normal_stiffness = 1e6
        [[particle]]
        at = [0, 0]
        radius = 1
        material = "m"
        [[particle]]
        at = [1.98, 0]
        radius = 1
        material = "m"
        [[measure]]
        name = "left"
        rectangle = { min = [-1, -1], max = [0.5, 1] }
        [[measure]]
        name = "whole"
        circle = { centre = [0.99, 0], radius = 2 }
        [history]
        columns = ["porosity", "region:whole:porosity", "region:left:stress_11", "stress_11"]
        [[stage]]
        name = "look"
        max_cycles = 1
    "#;
    let scene = Scene::parse("regions", preset, &[]).unwrap();
    let mut session = Session::open(scene, Options::default()).unwrap();
    session.advance(Budget::default(), false).unwrap();
    let value = |name: &str| {
        let column = Column::parse(name).unwrap();
        session.recording().term(0, &Term::Column(column))
    };
    // The default is the first, which a segment of the first disc sticks out of.
    let disc = PI - (PI / 3.0 - 3f64.sqrt() / 4.0);
    assert!((value("porosity") - (1.0 - disc / 3.0)).abs() < 1e-14);
    assert!((value("region:whole:porosity") - 0.5).abs() < 1e-14);
    // Its stress is that of the whole disc's volume, scaled to what of it is in.
    let stress = disc / 3.0 / PI * 0.99 * 0.02 * 1e6;
    assert!(close(value("region:left:stress_11"), stress, 1e-12, stress));
    assert_eq!(value("stress_11"), value("region:left:stress_11"));
}
