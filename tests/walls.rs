//! Walls: faces, ends, joints, sides, motion, forces.

mod common;

use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Damping, Gravity, Material, Setup, TimeStepChoice, WallSetup};
use ballast::measure::wall_force::WallForce;
use common::*;

fn discs(friction: f64) -> Setup {
    scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e4, 0.8e4, friction)
    })
}

/// Force on the only particle at the start.
fn force_at(walls: Vec<WallSetup>, x: f64, y: f64) -> [f64; 2] {
    let mut setup = discs(0.5);
    setup.particles = vec![particle(x, y, 1.0)];
    setup.walls = walls;
    let mut world = world(setup);
    world.settle();
    world.particles().force[0].f
}

fn close(a: [f64; 2], b: [f64; 2], within: f64) -> bool {
    (a[0] - b[0]).abs() <= within && (a[1] - b[1]).abs() <= within
}

#[test]
fn both_sides_push_away() {
    for (from, to) in [(-3.0, 3.0), (3.0, -3.0)] {
        let bar = || vec![wall("bar", [from, 0.0], [to, 0.0])];
        // Overlap .01 times stiffness 1e4; last bits of coordinates of size 1 times 1e4.
        assert!(close(force_at(bar(), 0.5, 0.99), [0.0, 100.0], 1e-10));
        assert!(close(force_at(bar(), 0.5, -0.99), [0.0, -100.0], 1e-10));
        assert_eq!(force_at(bar(), 0.5, 1.01), [0.0, 0.0]);
    }
}

#[test]
fn ends_are_points() {
    let bar = || vec![wall("bar", [-3.0, 0.0], [0.0, 0.0])];
    // The centre lies .99 from the end, in any direction beyond it.
    for angle in [-1.5, -0.7, 0.0, 0.4, 1.2, 1.57f64] {
        let (s, c) = angle.sin_cos();
        let force = force_at(bar(), 0.99 * c, 0.99 * s);
        assert!(
            close(force, [100.0 * c, 100.0 * s], 1e-10),
            "{angle}: {force:?}"
        );
    }
    // Beyond the reach of the end nothing pushes, though the line goes on.
    assert_eq!(force_at(bar(), 0.9, 0.9), [0.0, 0.0]);
    // The other end, and a wall without ends.
    assert!(close(force_at(bar(), -3.99, 0.0), [-100.0, 0.0], 1e-10));
    assert!(close(
        force_at(vec![floor()], 1e3, 0.99),
        [0.0, 100.0],
        1e-10
    ));
}

#[test]
fn a_joint_counts_once() {
    // Two walls in line, joined over the origin, in every order and direction.
    let (a, b, c) = ([-3.0, 0.0], [0.0, 0.0], [3.0, 0.0]);
    let joined = [
        vec![wall("one", a, b), wall("two", b, c)],
        vec![wall("one", b, a), wall("two", c, b)],
        vec![wall("one", b, c), wall("two", a, b)],
        vec![wall("one", a, b), wall("two", c, b)],
        vec![wall("one", b, a), wall("two", b, c)],
    ];
    for walls in joined {
        for x in [-0.5, -1e-9, 0.0, 1e-9, 0.5] {
            let force = force_at(walls.clone(), x, 0.99);
            assert!(close(force, [0.0, 100.0], 1e-10), "{x}: {force:?}");
        }
    }
    // A ridge: within the fan over the corner both walls are met at their ends, which count once.
    let ridge = vec![wall("one", [-3.0, -1.0], b), wall("two", b, [3.0, -1.0])];
    for angle in [-0.2, 0.0, 0.2f64] {
        let (s, c) = angle.sin_cos();
        let force = force_at(ridge.clone(), 0.99 * s, 0.99 * c);
        assert!(
            close(force, [100.0 * s, 100.0 * c], 1e-10),
            "{angle}: {force:?}"
        );
    }
    // Negative control: the same without a joint pushes twice.
    let apart = vec![wall("one", a, b), wall("two", [0.0, 1e-4], [3.0, 1e-4])];
    assert!(force_at(apart, -1e-9, 0.99)[1] > 190.0);
    // An inner corner has two faces, and both push.
    let corner = vec![wall("one", [-3.0, 0.0], b), wall("two", b, [0.0, 3.0])];
    assert!(close(force_at(corner, -0.99, 0.98), [-100.0, 200.0], 1e-10));
}

/// A wall that stands on the face of another is not felt through it.
#[test]
fn an_end_on_a_face_counts_with_the_face() {
    let base = || wall("base", [-3.0, 0.0], [3.0, 0.0]);
    let stem = |foot: [f64; 2], top| [wall("stem", foot, top), wall("stem", top, foot)];
    for top in [[0.0, 3.0], [2.0, 3.0], [-3.0, 1.0]] {
        for stem in stem([0.0; 2], top) {
            for walls in [vec![base(), stem.clone()], vec![stem.clone(), base()]] {
                for x in [-0.5, -1e-9, 0.0, 1e-9, 0.1, 0.5] {
                    let force = force_at(walls.clone(), x, -0.99);
                    assert!(close(force, [0.0, -100.0], 1e-10), "{top:?} {x}: {force:?}");
                }
                // On its own side, away from the corner, the base is met as ever.
                assert!(close(force_at(walls, 2.5, 0.99), [0.0, 100.0], 1e-10));
            }
        }
    }
    // In the corner both faces push.
    let [upright, _] = stem([0.0; 2], [0.0, 3.0]);
    let force = force_at(vec![base(), upright.clone()], -0.99, 0.98);
    assert!(close(force, [-100.0, 200.0], 1e-10), "{force:?}");

    // It may slide along the face: where it stands is looked for in every cycle.
    let below = |velocity: [f64; 2]| {
        let mut setup = discs(0.0);
        setup.particles = vec![driven(0.0, -0.99, 1.0, [0.0; 2], 0.0)];
        let upright = WallSetup {
            velocity,
            ..upright.clone()
        };
        setup.walls = vec![base(), upright];
        setup.time_step = TimeStepChoice::Seconds(1e-3);
        setup.frac = 1.0;
        let mut world = world(setup);
        run(&mut world, 50);
        world.settle();
        world.particles().force[0].f
    };
    assert!(close(below([0.1, 0.0]), [0.0, -100.0], 1e-10));
    // Negative control: drawn 5e-6 off the face it is an end again, and pushes too.
    let apart = below([0.0, 1e-4]);
    assert!(apart[1] < -190.0, "{apart:?}");
}

/// A disc that is dragged along a floor in two pieces: shear force per cycle, and whether the
/// contact changed hands.
fn dragged(pieces: Vec<WallSetup>) -> (Vec<f64>, bool) {
    let mut setup = discs(1e3);
    // Moves to the right without turning: the spring just stretches.
    setup.particles = vec![driven(-0.01, 0.99, 1.0, [0.01, 0.0], 0.0)];
    setup.walls = pieces;
    setup.time_step = TimeStepChoice::Seconds(1e-3);
    setup.frac = 1.0;
    let mut world = world(setup);
    let mut shear = Vec::new();
    let mut walls = Vec::new();
    while world.position(0)[0] < 0.01 {
        run(&mut world, 1);
        let mut sum = 0.0;
        for k in 0..world.contacts().len() {
            if world.contacts().status[k] != Status::Apart {
                // Along the floor below, t points to the left.
                sum -= world.reaction(k).tangential;
                walls.push(world.contacts().walls[k].wall);
            }
        }
        shear.push(sum);
    }
    assert_eq!(walls.len(), shear.len(), "one contact at a time");
    (shear, walls.contains(&0) && walls.contains(&1))
}

#[test]
fn shear_force_rolls_over_a_joint() {
    let (a, b, c) = ([-3.0, 0.0], [0.0, 0.0], [3.0, 0.0]);
    let (whole, _) = dragged(vec![wall("floor", a, c)]);
    let last = whole[whole.len() - 1];
    assert!((last / (0.8e4 * 0.02) - 1.0).abs() < 1e-2, "{last}");
    for pieces in [
        vec![wall("one", a, b), wall("two", b, c)],
        vec![wall("two", b, c), wall("one", a, b)],
        vec![wall("one", b, a), wall("two", b, c)],
    ] {
        let (joined, handed) = dragged(pieces);
        assert!(handed);
        for (x, y) in whole.iter().zip(&joined) {
            assert!((x - y).abs() < 1e-9 * last, "{x} {y}");
        }
    }
    // Negative control: over a gap that is too wide to touch both its ends, the force starts anew.
    let mut setup = discs(1e3);
    setup.particles = vec![driven(-0.3, 0.99, 1.0, [0.01, 0.0], 0.0)];
    setup.walls = vec![wall("one", a, [-0.2, 0.0]), wall("two", [0.2, 0.0], c)];
    setup.time_step = TimeStepChoice::Seconds(1e-2);
    setup.frac = 1.0;
    let mut world = world(setup);
    while world.position(0)[0] < 0.3 {
        run(&mut world, 1);
    }
    world.settle();
    let force = -world.particles().force[0].f[0];
    assert!(force > 0.0 && force < 0.5 * 0.8e4 * 0.6, "{force}");
}

#[test]
fn shear_force_rolls_over_a_ridge_and_round_an_end() {
    // A driven disc that goes round the corner of a ridge at constant distance: face, point, face.
    let b = [0.0, 0.0];
    for walls in [
        vec![wall("one", [-3.0, -3.0], b), wall("two", b, [3.0, -3.0])],
        vec![wall("two", b, [3.0, -3.0]), wall("one", [-3.0, -3.0], b)],
    ] {
        let mut setup = discs(1e3);
        let angle = -0.9f64;
        let at = [0.99 * angle.sin(), 0.99 * angle.cos()];
        setup.particles = vec![driven(at[0], at[1], 1.0, [0.0; 2], 0.0)];
        setup.walls = walls;
        setup.time_step = TimeStepChoice::Seconds(1e-4);
        setup.frac = 1.0;
        let mut world = world(setup);
        let mut angle = angle;
        let mut shear = Vec::new();
        while angle < 0.9 {
            let next = angle + 1e-4;
            // The chord from here to there.
            let v = [
                0.99 * (next.sin() - angle.sin()) / 1e-4,
                0.99 * (next.cos() - angle.cos()) / 1e-4,
            ];
            world.set_motion(0, ballast::engine::edit::Motion::Velocity(v));
            angle = next;
            run(&mut world, 1);
            let touching: Vec<usize> = (0..world.contacts().len())
                .filter(|&k| world.contacts().status[k] != Status::Apart)
                .collect();
            assert_eq!(touching.len(), 1, "at {angle}");
            shear.push(-world.reaction(touching[0]).tangential);
        }
        // The force only ever grows, by the path of the centre: 0.99 rad.
        let path = 0.99 * 1.8 * 0.8e4;
        let last = shear[shear.len() - 1];
        assert!((last / path - 1.0).abs() < 1e-3, "{last} {path}");
        assert!(shear.windows(2).all(|pair| pair[1] > pair[0]));
    }
}

#[test]
fn a_particle_rolls_off_an_end_and_stays_outside() {
    // Falls off the end of a table, past its edge and below it, without being caught by the line.
    let mut setup = discs(0.5);
    setup.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    setup.particles = vec![moving(-0.5, 0.999, 1.0, [1.0, 0.0], -1.0)];
    setup.walls = vec![wall("table", [-5.0, 0.0], [0.0, 0.0])];
    let mut world = world(setup);
    while world.position(0)[1] > -3.0 {
        run(&mut world, 1);
    }
    assert!(world.position(0)[0] > 0.5);
    let b = world.bookings().expect("booked");
    assert!(b.energy_error.abs() < 1e-3, "{}", b.energy_error);
}

#[test]
fn a_turning_wall_carries_and_tilts() {
    // A driven lever lifts a fixed-height particle's overlap by ω r t.
    let mut setup = discs(0.0);
    setup.particles = vec![driven(2.0, 1.0, 1.0, [0.0; 2], 0.0)];
    setup.walls = vec![wall("lever", [0.0, 0.0], [5.0, 0.0])];
    setup.walls[0].about = [-1.0, 0.0];
    setup.walls[0].angular_velocity = 0.01;
    setup.time_step = TimeStepChoice::Seconds(1e-3);
    setup.frac = 1.0;
    let mut world = world(setup);
    run(&mut world, 1000);
    world.settle();
    // The line through (-1, 0) at angle φ; the centre at (3, 1) from there.
    let phi = 0.01f64;
    let overlap = 1.0 - (phi.cos() - 3.0 * phi.sin());
    let force = world.particles().force[0].f;
    let expected = [-1e4 * overlap * phi.sin(), 1e4 * overlap * phi.cos()];
    assert!(close(force, expected, 1e-8 * 1e4), "{force:?} {expected:?}");
    // Its end went along the circle.
    let end = world.walls()[0].end(1);
    assert!(close(end, [6.0 * phi.cos() - 1.0, 6.0 * phi.sin()], 1e-12));
    assert!((world.walls()[0].angle - phi).abs() < 1e-15);
}

#[test]
fn a_long_lever_reaches_far_particles_in_time() {
    // Far outside the scene as it was at the start, a turning wall is fast: it must be seen coming.
    let mut setup = discs(0.0);
    setup.particles = vec![
        particle(0.0, 30.0, 1.0),
        particle(3.0, 30.0, 1.0),
        moving(6.0, 30.0, 1.0, [50.0, 0.0], 0.0),
    ];
    setup.walls = vec![WallSetup {
        h1: 0.0,
        h2: f64::INFINITY,
        angular_velocity: 0.0,
        ..wall("lever", [0.0, 0.0], [1.0, 0.0])
    }];
    setup.time_step = TimeStepChoice::Seconds(1e-4);
    setup.frac = 1.0;
    let mut world = world(setup);
    run(&mut world, 100_000);
    assert!(world.position(2)[0] > 500.0);
    world.zero_velocities();
    // 25 m/s out there, 1.5 m/s where the scene was.
    world.set_wall_spin(0, 0.05);
    let mut touched = false;
    for _ in 0..20_000 {
        run(&mut world, 1);
        touched |= world.contacts().status.contains(&Status::Touching);
        // The disc goes before the wall, never through it.
        let x = world.position(2);
        let angle = world.walls()[0].angle;
        assert!(x[1] * angle.cos() - x[0] * angle.sin() > 0.5);
        if touched {
            break;
        }
    }
    assert!(touched);
}

#[test]
fn wall_forces_balance_particle_forces() {
    let mut setup = discs(0.4);
    let mut random = Random(5);
    for row in 0..3 {
        for column in 0..4 {
            let x = 1.95 * f64::from(column) + random.between(-0.02, 0.02);
            let y = 1.95 * f64::from(row) + random.between(-0.02, 0.02);
            setup.particles.push(particle(x, y, 1.0));
        }
    }
    setup.walls = closing_walls([-0.97, -0.97], [6.82, 4.87], 0.1);
    setup.walls[0].angular_velocity = 0.1;
    setup.damping = contact_damping(0.2);
    let mut world = world(setup);
    for _ in 0..50 {
        run(&mut world, 10);
        world.settle();
        let inner = world.particles();
        let (mut on_particles, mut turn, mut scale) = ([0.0; 2], 0.0, 0.0);
        for (row, force) in inner.row.iter().zip(&inner.force) {
            on_particles = [on_particles[0] + force.f[0], on_particles[1] + force.f[1]];
            turn += row.x[0] * force.f[1] - row.x[1] * force.f[0] + row.radius * force.tau;
            scale += force.scale;
        }
        let (mut on_walls, mut turn_of_walls) = ([0.0; 2], 0.0);
        for w in 0..4 {
            let on = WallForce::of(&world, w);
            let about = world.walls()[w].about;
            on_walls = [on_walls[0] + on.force[0], on_walls[1] + on.force[1]];
            turn_of_walls += on.moment + about[0] * on.force[1] - about[1] * on.force[0];
        }
        assert!(close(on_walls, on_particles.map(|f| -f), 1e-14 * scale));
        // Walls are touched at the overlapped surface, particles turn about their full radius:
        // the moments differ by shear force times overlap.
        assert!(
            (turn + turn_of_walls).abs() < 0.05 * scale,
            "{turn} {turn_of_walls}"
        );
        assert!(scale > 1.0);
    }
}

#[test]
fn eccentricity_counts_from_mid_length() {
    // Load at 3 of 8 along the wall: 1 before the middle, over half the length 4. Compression on
    // either side gives the same sign.
    for (side, direction) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0)] {
        let mut setup = discs(0.0);
        setup.particles = vec![particle(3.0 * direction, 0.99 * side, 1.0)];
        setup.walls = vec![wall("beam", [0.0, 0.0], [8.0 * direction, 0.0])];
        let mut world = world(setup);
        world.settle();
        let on = WallForce::of(&world, 0);
        assert!(
            (on.eccentricity + 0.25).abs() < 1e-12,
            "{}",
            on.eccentricity
        );
        assert!(close(on.force, [0.0, -100.0 * side], 1e-9));
        assert!(
            (on.moment + 300.0 * side * direction).abs() < 1e-9,
            "{}",
            on.moment
        );
    }
    // Endless or unloaded: none.
    let mut setup = discs(0.0);
    setup.particles = vec![particle(3.0, 0.99, 1.0)];
    setup.walls = vec![floor(), wall("far", [0.0, -50.0], [1.0, -50.0])];
    let world = world(setup);
    assert!(WallForce::of(&world, 0).eccentricity.is_nan());
    assert!(WallForce::of(&world, 1).eccentricity.is_nan());
}

/// A disc that rolling resistance holds on a floor that tilts: the floor bears its weight where it is, and
/// what lifts or lowers it is the work of the floor.
#[test]
fn rolling_resistance_acts_on_walls_and_is_their_work() {
    let mut setup = discs(0.8);
    setup.materials[0].rolling_friction = 0.15;
    setup.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    setup.damping = Damping {
        global: 1.0,
        ..contact_damping(0.2)
    };
    setup.particles = vec![particle(0.0, 0.999, 1.0)];
    setup.walls = vec![wall("floor", [-5.0, 0.0], [5.0, 0.0])];
    setup.walls[0].about = [0.0, 0.0];
    setup.time_step = TimeStepChoice::Seconds(1e-3);
    setup.frac = 1.0;
    let mut world = world(setup);
    run(&mut world, 10_000);
    let before = world.bookings().expect("energies are booked").boundary_work;
    let height = world.position(0)[1];
    // To .1: it would roll at .15.
    world.set_wall_spin(0, -0.002);
    run(&mut world, 50_000);
    world.settle();
    let [x, y] = world.position(0);
    assert!(x > 0.09 && x < 0.11, "it rolled away: {x}");
    // A mass of 1, dragged by 1/s times .002 m/s.
    let on = WallForce::of(&world, 0);
    assert!((on.moment + 10.0 * x).abs() < 0.01 * 10.0 * x, "{on:?}");
    let booked = world.bookings().expect("energies are booked");
    let work = booked.boundary_work - before;
    // The height, what the rolling spring holds, M²/2k_r with k_r = 3 k (.15)², and α m v² for the drag.
    let held = (10.0 * x) * (10.0 * x) / (6e4 * 0.15 * 0.15);
    let due = 10.0 * (y - height) + held + 0.002 * 0.002 * 50.0;
    assert!((work - due).abs() < 0.005 * due.abs(), "{work} {due}");
    assert!(booked.energy_error.abs() < 1e-5, "{booked:?}");
}

/// Friction of a wall set again and again is what it was set to last, and leaves nothing behind.
#[test]
fn friction_of_a_wall_is_what_it_was_set_to_last() {
    let mut setup = discs(0.5);
    setup.particles = vec![particle(0.0, 0.999, 1.0), particle(3.0, 0.999, 1.0)];
    setup.walls = vec![floor()];
    let mut world = world(setup);
    for friction in [0.1, 0.7, 0.3] {
        world.set_wall_friction("floor", friction);
        let at_wall = (0..world.contacts().len()).map(|k| world.pair_of(k).friction);
        assert_eq!(at_wall.collect::<Vec<_>>(), [friction; 2]);
        assert_eq!(world.model().pairs.len(), 1);
        assert_eq!(world.model().materials.len(), 2);
    }
}
