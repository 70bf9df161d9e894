//! The neighbour list changes no bit: neither its halo, nor threads, nor commands that change it.

mod common;

use ballast::engine::World;
use ballast::engine::edit::Motion;
use ballast::engine::neighbours::Status;
use ballast::engine::setup::{Gravity, Setup};
use ballast::measure::columns::Column;
use ballast::measure::columns::Partner;
use ballast::measure::sample::{Sample, find_contact};
use common::*;

/// Hashes on the way, and how often the list was made.
fn hashes(setup: Setup, threads: usize, cycles: u64, samples: u64) -> (Vec<u64>, World) {
    let mut world = World::build(setup, threads).expect("the scene builds");
    let hashes = (0..samples)
        .map(|_| {
            run(&mut world, cycles / samples);
            world.state_hash()
        })
        .collect();
    (hashes, world)
}

#[test]
fn the_halo_changes_no_bit() {
    let with = |tol: f64| {
        let setup = Setup {
            tol: Some(tol * 0.9),
            ..collapsing_pile(14, 0.1)
        };
        assert_eq!(setup.particles.len(), 105);
        hashes(setup, 1, 20_000, 40)
    };
    let (narrow, a) = with(0.02);
    let (middle, b) = with(0.1);
    let (wide, c) = with(0.5);
    assert_eq!(narrow, middle);
    assert_eq!(narrow, wide);
    // The lists were really different, and made anew on the way.
    let lists = [&a, &b, &c].map(|w| (w.contacts().rebuilds, w.contacts().len()));
    assert!(
        lists[0].0 > lists[1].0 && lists[1].0 > lists[2].0 && lists[2].0 > 2,
        "{lists:?}"
    );
    assert!(lists[0].1 < lists[2].1);
    // And the pile did collapse.
    let drop = a.particles().row[104].x[1] - collapsing_pile(14, 0.1).particles[104].at[1];
    assert!(drop < -1.0, "{drop}");
    // Negative control: the hash sees the last bit of one coordinate.
    let mut other = collapsing_pile(14, 0.1);
    other.particles[50].at[0] = other.particles[50].at[0].next_up();
    assert_ne!(
        hashes(other, 1, 500, 1).0,
        hashes(collapsing_pile(14, 0.1), 1, 500, 1).0
    );
}

#[test]
fn threads_change_no_bit() {
    // 2485 particles and as many contacts: eight shares of 256 each, and more.
    let setup = || collapsing_pile(70, 0.2);
    let (one, world) = hashes(setup(), 1, 300, 3);
    assert!(
        world.particles().len() >= 8 * 256 && world.contacts().len() >= 8 * 256,
        "{}",
        world.contacts().len()
    );
    assert!(world.contacts().rebuilds > 1);
    for threads in [2, 3, 8] {
        let (same, team) = hashes(setup(), threads, 300, 3);
        assert_eq!(team.threads(), threads);
        assert_eq!(one, same, "{threads} threads");
        assert_eq!(world.bookings(), team.bookings(), "{threads} threads");
        assert_eq!(
            world.fracc_monitor(),
            team.fracc_monitor(),
            "{threads} threads"
        );
    }
}

#[test]
fn sampling_changes_no_bit() {
    let plain = hashes(collapsing_pile(8, 0.2), 1, 2000, 1).0;
    let mut world = world(collapsing_pile(8, 0.2));
    for n in 0..2000 {
        run(&mut world, 1);
        if n % 7 == 0 {
            let sample = Sample::of(&mut world);
            let column = Column::parse("energy_error").expect("a column");
            assert!(sample.value(&column).is_finite());
        }
    }
    assert_eq!(plain[0], world.state_hash());
}

/// Shear force and slip path of contact I-J, by numbers.
fn memory(world: &World, i: u32, j: u32) -> [f64; 2] {
    let k = find_contact(world, i, &Partner::Particle(j)).expect("listed");
    [world.pass().reduced(k)[1], world.pass().book(k).delta]
}

#[test]
fn commands_keep_numbers_and_memory() {
    let mut world = world(collapsing_pile(6, 0.6));
    run(&mut world, 9_000);
    // Sticking pairs with a shear force, none with the particles that come and go. (What slides is
    // cut to its limit when forces around it change.)
    let pairs: Vec<[u32; 2]> = (0..world.contacts().pairs.len())
        .filter(|&k| {
            let sticks = world.contacts().status[k] == Status::Touching;
            sticks && world.pass().reduced(k)[1] != 0.0
        })
        .map(|k| world.contacts().pairs[k].map(|p| world.particles().id[p as usize]))
        .filter(|pair| !pair.contains(&4) && !pair.contains(&12))
        .collect();
    assert!(pairs.len() > 5, "{}", pairs.len());
    let before: Vec<[f64; 2]> = pairs.iter().map(|&[i, j]| memory(&world, i, j)).collect();
    let same = |world: &World, what: &str| {
        for (&[i, j], old) in pairs.iter().zip(&before) {
            assert_eq!(memory(world, i, j), *old, "{i}-{j} after {what}");
        }
    };

    assert_eq!(world.create(&particle(0.0, 40.0, 0.9)), 22);
    same(&world, "create");
    for number in [4, 12, 22] {
        let p = world.particles().index(number).expect("there");
        world.delete(p);
        assert_eq!(world.particles().index(number), None);
        same(&world, "delete");
    }
    let left: Vec<u32> = (1..=21).filter(|n| ![4, 12].contains(n)).collect();
    assert_eq!(world.particles().id, left);
    // Numbers are not given twice.
    assert_eq!(world.create(&particle(0.0, 40.0, 0.9)), 23);
    same(&world, "create again");
    world.create_wall(&wall("far", [-90.0, -5.0], [90.0, -5.0]));
    same(&world, "wall");
    world.delete_wall(3);
    same(&world, "wall gone");
    world.change_materials(|model| model.materials[0].friction = 0.7);
    same(&world, "friction");
    world.set_fixed(0, [true, false, true]);
    world.set_gravity(Some(Gravity::Uniform([1.0, -9.0])));
    world.set_frac(0.05);
    same(&world, "the rest");
    let step = world.base_step();
    world.create(&particle(0.0, 60.0, 0.5));
    assert!(world.base_step() < step);
    world.set_damping(contact_damping(0.1));
    same(&world, "a smaller step");
    // Friction off and on again: the springs are let go.
    world.change_materials(|model| model.materials[0].friction = 0.0);
    run(&mut world, 1);
    world.change_materials(|model| model.materials[0].friction = 0.3);
    for &[i, j] in &pairs {
        if find_contact(&world, i, &Partner::Particle(j)).is_some() {
            assert_eq!(memory(&world, i, j)[0], 0.0);
        }
    }
    run(&mut world, 2000);
    world.settle();
    assert!(world.bookings().expect("booked").energy_error.abs() < 0.05);
}

#[test]
fn friction_off_for_one_pair_of_materials() {
    // Other pairs still have friction, so the tangential part stays: the spring of this one is
    // dropped, not divided by.
    let mut setup = collapsing_pile(5, 0.3);
    setup.materials.push(setup.materials[0].clone());
    setup.walls[0].material = 1;
    let mut world = world(setup);
    run(&mut world, 1500);
    world.change_materials(|model| model.materials[1].friction = 0.0);
    run(&mut world, 500);
    world.settle();
    let floor = |k: usize| world.contacts().walls[k].wall == 0;
    let first = world.contacts().pairs.len();
    let mut count = 0;
    for k in 0..world.contacts().walls.len() {
        if floor(k) {
            assert_eq!(world.reaction(first + k).tangential, 0.0);
            count += 1;
        }
    }
    assert!(count > 2);
    let b = world.bookings().expect("booked");
    assert!(b.friction_loss.is_finite() && b.energy_error.abs() < 0.05);
}

#[test]
fn velocities_of_the_boundary_survive_a_change_of_step() {
    let mut world = world(collapsing_pile(6, 0.3));
    run(&mut world, 777);
    let state = |world: &mut World| {
        world.settle();
        (0..21).map(|p| world.velocity(p)).collect::<Vec<_>>()
    };
    let before = state(&mut world);
    world.set_frac(0.02);
    world.change_materials(|model| model.materials[0].density *= 2.0);
    world.set_gravity(None);
    let after = state(&mut world);
    let scale = before
        .iter()
        .fold(0.0, |most: f64, (v, _)| most.max(v[1].abs()));
    for ((v, spin), (u, turn)) in before.iter().zip(&after) {
        assert!(
            (v[0] - u[0]).abs() + (v[1] - u[1]).abs() < 1e-13 * scale,
            "{v:?} {u:?}"
        );
        assert!((spin - turn).abs() < 1e-12);
    }
    assert!(scale > 0.0);
    // A given velocity is the one that is shown.
    world.set_motion(3, Motion::Velocity([0.25, -0.5]));
    let (v, _) = state(&mut world)[3];
    assert!((v[0] - 0.25).abs() < 1e-14 && (v[1] + 0.5).abs() < 1e-14);
}

#[test]
fn a_resized_particle_weighs_touches_and_costs_what_its_size_says() {
    let mut setup = two_particles(material(1e6, 0.0, 0.0), 0.05);
    setup.ledger = true;
    let radius = setup.particles[0].radius;
    let mut world = world(setup);
    run(&mut world, 5);
    let before = world.particles().mass[0];
    // It grows over the gap by a tenth of that gap more.
    world.set_radius(0, radius + 0.055);
    let ratio = (radius + 0.055) / radius;
    let power = if world.model().body == ballast::engine::setup::Body::Disc {
        2
    } else {
        3
    };
    let wanted = (0..power).fold(before, |mass, _| mass * ratio);
    assert!((world.particles().mass[0] / wanted - 1.0).abs() < 1e-14);
    world.settle();
    // k α²/2 with α = 0.005 was put in by the command, and the contact pushes at once. Both stand at
    // this boundary, so their half steps before and after it are opposite: -(F dt/2)²/(2 m) each.
    let booked = world.bookings().unwrap().boundary_work;
    let half = 0.5 * 1e6 * 0.005 * world.dt();
    let masses = &world.particles().mass;
    let opposite: f64 = masses.iter().map(|m| 0.5 * half * half / m).sum();
    let wanted = 0.5 * 1e6 * 0.005 * 0.005 - opposite;
    assert!((booked / wanted - 1.0).abs() < 1e-9, "{booked} {wanted}");
    assert!(world.particles().force[0].f[0] < 0.0);
    run(&mut world, 400);
    // The contact is left inside a step, at most v dt before its end: an error of (ω dt)², with
    // ω² = 2 k/m and dt = 0.1 · 2 √(m/k).
    assert!(world.bookings().unwrap().energy_error.abs() < 0.08);
}
