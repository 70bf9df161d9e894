//! Rings of boundary particles.

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Dashpot, Setup};
use ballast::measure::region::{Content, Shape};
use ballast::measure::stress::Stress;

use crate::common::{law, material, particle, scene};

const K: f64 = 1e6;

/// A round piece of a hexagonal packing of discs of radius 1, just touching, under a ring.
fn round_piece(radius: f64, overlap: f64) -> Setup {
    let d = 2.0 - overlap;
    let row = d * 3f64.sqrt() / 2.0;
    let mut particles = Vec::new();
    for j in -12..=12 {
        for i in -12..=12 {
            let x = [(f64::from(i) + 0.5 * f64::from(j)) * d, f64::from(j) * row];
            if x[0].hypot(x[1]) < radius + 1.9 {
                particles.push(particle(x[0], x[1], 1.0));
            }
        }
    }
    let mut setup = Setup {
        particles,
        boundary: Some(BoundarySetup::Ring {
            centre: [0.0; 2],
            radius,
            turning: false,
        }),
        law: law("linear"),
        ..scene(material(K, 0.8 * K, 0.3))
    };
    setup.damping.contact = Dashpot::Fraction(0.1);
    setup
}

fn members(world: &World) -> Vec<u32> {
    let ring = world
        .boundary()
        .and_then(ballast::engine::boundary::Boundary::ring);
    ring.map(|ring| ring.members.clone()).unwrap_or_default()
}

fn core(world: &World) -> Stress {
    let shape = Shape::Circle {
        centre: [0.0; 2],
        radius: 9.0,
    };
    Stress::of(world, &Content::of(world, shape))
}

/// Members go where the strain takes them, to rounding, and nothing they touch changes that.
#[test]
fn members_move_as_the_strain_says() {
    let mut world = World::build(round_piece(14.0, 0.0), 1).unwrap();
    let first: Vec<([f64; 2], u32)> = members(&world)
        .iter()
        .map(|&id| (world.position(world.particles().index(id).unwrap()), id))
        .collect();
    assert!(first.len() > 30);
    let rate = [[0.4, 0.1], [0.0, -0.2]];
    assert!(world.set_strain_rate(rate, 0));
    let n = 400;
    for _ in 0..n {
        world.cycle().expect("the scene is sound");
    }
    let dt = world.dt();
    let step = nalgebra::Matrix2::identity() - dt * nalgebra::Matrix2::new(0.4, 0.1, 0.0, -0.2);
    let whole = step.pow(n);
    for (at, id) in first {
        let exact = whole * nalgebra::Vector2::from(at);
        let now = world.position(world.particles().index(id).unwrap());
        assert!((now[0] - exact[0]).abs() < 1e-12 * 14.0, "{now:?} {exact}");
        assert!((now[1] - exact[1]).abs() < 1e-12 * 14.0, "{now:?} {exact}");
    }
    let strain = world.imposed_strain().unwrap();
    assert!((strain[0][0] - 0.4 * f64::from(n) * dt).abs() < 1e-12);
}

/// What the ring does is booked: the balance closes, and without the ring's work it would not.
#[test]
fn the_ledger_closes_while_the_ring_closes() {
    let mut world = World::build(round_piece(14.0, 0.0), 1).unwrap();
    world.set_strain_rate([[0.0005, 0.0], [0.0, 0.0005]], 100);
    for _ in 0..3000 {
        world.cycle().expect("the scene is sound");
    }
    world.set_strain_rate([[-0.0002, 0.0], [0.0, 0.0003]], 0);
    for _ in 0..1000 {
        world.cycle().expect("the scene is sound");
    }
    let b = world.bookings().unwrap();
    assert!(b.boundary_work > 0.0 && b.damping_loss > 0.0);
    assert!(b.energy_error.abs() < 1e-4, "{b:?}");
}

/// A particle that is pushed out by more than half joins, and stays.
#[test]
fn who_is_more_than_half_outside_joins() {
    let mut setup = round_piece(14.0, 0.0);
    setup.particles.retain(|p| p.at[0].hypot(p.at[1]) < 9.0);
    setup.particles[0].velocity = {
        let x = setup.particles[0].at;
        let r = x[0].hypot(x[1]);
        [50.0 * x[0] / r, 50.0 * x[1] / r]
    };
    let mut world = World::build(setup, 1).unwrap();
    assert!(members(&world).is_empty());
    for _ in 0..20_000 {
        world.cycle().expect("the scene is sound");
        if !members(&world).is_empty() {
            break;
        }
    }
    assert_eq!(members(&world), [1]);
    let x = world.position(0);
    // Found within fifty cycles.
    let late = 50.0 * 50.0 * world.dt();
    let r = x[0].hypot(x[1]);
    assert!((14.0..14.0 + late).contains(&r), "{r}");
    for _ in 0..100 {
        world.cycle().expect("the scene is sound");
    }
    assert_eq!(world.position(0), x);
    assert_eq!(world.velocity(0).0, [0.0; 2]);
}

/// A ring under stress presses the inside to the same stress, whatever its principal axes, and its
/// forces balance.
#[test]
fn a_loaded_ring_hands_its_stress_on() {
    for stress in [
        [[1e4, 0.0], [0.0, 1e4]],
        [[1.2e4, 0.0], [0.0, 0.9e4]],
        [[1e4, 1e3], [1e3, 1e4]],
    ] {
        let mut setup = round_piece(14.0, 0.01);
        setup.damping.global = 20.0;
        let mut world = World::build(setup, 1).unwrap();
        assert!(world.load_boundary(stress, 2000));
        for _ in 0..60_000 {
            world.cycle().expect("the scene is sound");
        }
        world.settle();
        let inside = core(&world).total;
        for (i, row) in stress.iter().enumerate() {
            for (j, s) in row.iter().enumerate() {
                let missed = (inside[(i, j)] - s).abs() / 1e4;
                assert!(missed < 0.03, "{i}{j} {inside} {stress:?}");
            }
        }
        let b = world.bookings().unwrap();
        assert!(b.energy_error.abs() < 1e-3, "{b:?}");
        // Held again, it keeps the stress it had.
        assert!(world.set_strain_rate([[0.0; 2]; 2], 0));
        for _ in 0..2000 {
            world.cycle().expect("the scene is sound");
        }
        world.settle();
        assert!((core(&world).total - inside).norm() < 0.02 * inside.norm());
    }
}

/// The load grows evenly over its cycles, whenever it is asked for, and from one that is still growing.
#[test]
fn a_load_is_reached_over_its_cycles() {
    for start in [0, 100] {
        let mut world = World::build(round_piece(14.0, 0.01), 1).unwrap();
        let advance = |world: &mut World, cycles: u64| {
            for _ in 0..cycles {
                world.cycle().expect("the scene is sound");
            }
            world.boundary().unwrap().ring().unwrap().stress()
        };
        let stress = |s: f64| Some([[s, 0.0], [0.0, 0.5 * s]]);
        advance(&mut world, start);
        assert!(world.load_boundary([[1e4, 0.0], [0.0, 5e3]], 200));
        assert_eq!(advance(&mut world, 0), stress(0.0));
        assert_eq!(advance(&mut world, 1), stress(50.0));
        assert_eq!(advance(&mut world, 99), stress(5e3));
        assert!(world.load_boundary([[2e3, 0.0], [0.0, 1e3]], 10));
        assert_eq!(advance(&mut world, 0), stress(5e3));
        assert_eq!(advance(&mut world, 5), stress(3.5e3));
        assert_eq!(advance(&mut world, 50), stress(2e3));
    }
}

#[test]
fn another_boundary_lets_the_ring_go() {
    let mut world = World::build(round_piece(14.0, 0.01), 1).unwrap();
    let ring = members(&world);
    world.set_boundary(None);
    for id in ring {
        let p = world.particles().index(id).unwrap();
        assert_eq!(world.particles().fixed[p], [false; 3]);
    }
    assert!(!world.set_strain_rate([[0.1, 0.0], [0.0, 0.1]], 0));
    let size = |world: &World| {
        let [low, high] = world.particles().extent();
        high[0] - low[0]
    };
    let before = size(&world);
    for _ in 0..3000 {
        world.cycle().expect("the scene is sound");
    }
    assert!(size(&world) > before, "what was compressed springs back");
}
