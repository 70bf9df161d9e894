//! Where discs rain on a bed, halos are wide where they land and narrow elsewhere. That changes no bit.

mod common;

use ballast::engine::World;
use ballast::engine::setup::{Gravity, Material, Setup};
use ballast::record::checkpoint;
use common::*;

const RADIUS: f64 = 0.45;
const COLUMNS: usize = 84;

/// Discs that lie in rows, others that fall on them, with gaps between all, and a heavy one that is shot
/// through either.
fn rain(tol: Option<f64>) -> Setup {
    let mut setup = scene(Material {
        density: 1.0 / std::f64::consts::PI,
        ..material(1e5, 1e5, 0.3)
    });
    setup.tol = tol;
    setup.gravity = Some(Gravity::Uniform([0.0, -10.0]));
    setup.damping = contact_damping(0.2);
    for k in 0..COLUMNS * 50 {
        let (column, row) = ((k % COLUMNS) as f64, (k / COLUMNS) as f64);
        // In no lattice, so that whoever lands is thrown aside.
        let aside = 0.1 * (2.4 * row + 1.7 * column).sin();
        let falls = row >= 20.0;
        let y = RADIUS + 1.02 * row + if falls { 1.5 } else { 0.0 };
        let mut disc = particle(0.6 + 1.1 * column + aside, y, RADIUS);
        disc.velocity = [0.0, if falls { -15.0 } else { 0.0 }];
        setup.particles.push(disc);
    }
    let mut shot = particle(-5.0, 11.0, 3.0 * RADIUS);
    shot.velocity = [60.0, 3.0];
    setup.particles.push(shot);
    let width = 1.1 * COLUMNS as f64 + 0.2;
    setup.walls = vec![
        wall("floor", [-9.0, 0.0], [width, 0.0]),
        wall("right", [width, 0.0], [width, 99.0]),
    ];
    // It comes towards them.
    setup.walls[1].velocity = [-1.0, 0.0];
    setup
}

/// State hashes after every so many cycles.
fn hashes(world: &mut World, every: u64, samples: usize) -> Vec<u64> {
    (0..samples)
        .map(|_| {
            run(world, every);
            world.state_hash()
        })
        .collect()
}

/// The widest gap between listed particles over the halo, one with another.
fn widest(world: &World) -> f64 {
    let rows = &world.particles().row;
    let gap = |&[i, j]: &[u32; 2]| {
        let [a, b] = [i, j].map(|p| &rows[p as usize]);
        (a.x[0] - b.x[0]).hypot(a.x[1] - b.x[1]) - a.radius - b.radius
    };
    let gaps = world.contacts().pairs.iter().map(gap);
    gaps.fold(0.0, f64::max) / world.tol()
}

#[test]
fn halos_that_differ_change_no_bit() {
    let [mut same, mut differ] = [Some(0.6 * RADIUS), None].map(|tol| world(rain(tol)));
    assert_eq!(hashes(&mut same, 20, 10), hashes(&mut differ, 20, 10));
    // They did differ, and not in vain: fewer lists of fewer pairs.
    let [one, other] = [&same, &differ].map(widest);
    assert!(one < 1.5 && other > 2.2, "{one} {other}");
    let lists = [&same, &differ].map(|world| (world.contacts().rebuilds, world.contacts().len()));
    assert!(
        lists[0].0 > lists[1].0 && lists[0].1 > 2 * lists[1].1,
        "{lists:?}"
    );
    // Until most have landed.
    assert_eq!(hashes(&mut same, 100, 15), hashes(&mut differ, 100, 15));
}

#[test]
fn nor_do_threads() {
    let one = hashes(&mut world(rain(None)), 50, 6);
    for threads in [2, 3, 8] {
        let mut team = World::build(rain(None), threads).expect("the scene builds");
        assert_eq!(hashes(&mut team, 50, 6), one, "{threads} threads");
    }
}

#[test]
fn a_checkpoint_goes_on_as_if_nothing_had_been() {
    let mut world = world(rain(None));
    run(&mut world, 133);
    let stored = checkpoint::encode(&world).expect("it is stored");
    let mut read: World = checkpoint::decode(&stored).expect("it is what was stored");
    assert!(read.unpack(1));
    assert_eq!(world.contacts().pairs, read.contacts().pairs);
    assert!(widest(&read) > 2.2, "{}", widest(&read));
    for _ in 0..300 {
        run(&mut world, 1);
        run(&mut read, 1);
        assert_eq!(world.particles().row, read.particles().row);
    }
}

/// What is asked for may make the list again at any time, also when only a wall has spent its halo since
/// somebody looked at the tiles.
#[test]
fn a_list_that_is_asked_for_does_not_depend_on_a_checkpoint() {
    let resting = || {
        let mut setup = rain(None);
        setup.gravity = None;
        // Away from them, and so fast that its halo is spent before anything else is due.
        setup.walls[1].velocity = [60.0, 0.0];
        for disc in &mut setup.particles {
            disc.velocity = [0.0; 2];
        }
        setup
    };
    let read = |world: &World| {
        let stored = checkpoint::encode(world).expect("it is stored");
        let mut read: World = checkpoint::decode(&stored).expect("it is what was stored");
        assert!(read.unpack(1));
        read
    };
    let list = |world: &mut World| {
        world.set_wall_friction("floor", 0.25);
        (world.tol(), world.contacts().pairs.clone())
    };
    let mut still = world(resting());
    let lists = still.contacts().rebuilds;
    for _ in 0..300 {
        run(&mut still, 1);
        list(&mut read(&still));
    }
    assert!(still.contacts().rebuilds > lists + 2);
    let mut world = world(rain(None));
    for _ in 0..40 {
        run(&mut world, 13);
        let mut read = read(&world);
        assert_eq!(list(&mut world), list(&mut read));
    }
}

#[test]
fn a_flow_that_sets_in_makes_halos_the_same() {
    let with = |tol: Option<f64>| {
        let mut world = world(rain(tol));
        let mut seen = hashes(&mut world, 100, 1);
        let before = widest(&world);
        world.set_continuum(Some([[0.0, 0.4], [0.0, -0.2]]), 0);
        seen.extend(hashes(&mut world, 50, 3));
        let under = widest(&world);
        world.set_continuum(None, 0);
        seen.extend(hashes(&mut world, 50, 3));
        (seen, [before, under, widest(&world)])
    };
    let (same, _) = with(Some(0.6 * RADIUS));
    let (differ, [before, under, after]) = with(None);
    assert_eq!(same, differ);
    assert!(
        before > 2.2 && under < 1.5 && after > 1.5,
        "{before} {under} {after}"
    );
}
