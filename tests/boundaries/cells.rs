//! Periodic cells: what is inside does not know where the cell begins.

use ballast::engine::World;
use ballast::engine::setup::{BoundarySetup, Damping, Dashpot, ParticleSetup, Setup};
use ballast::measure::fabric::Fabric;
use ballast::measure::region::{Content, Shape};
use ballast::measure::stress::Stress;
use ballast::record::checkpoint::{decode, encode};

use crate::common::{law, material, moving, particle, scene};

pub(crate) const K: f64 = 1e6;

fn cell(edges: [[f64; 2]; 2]) -> BoundarySetup {
    BoundarySetup::Cell {
        corner: [0.0; 2],
        edges,
    }
}

/// Discs of radius 1 at the places of a lattice, n by m of them in a cell with these steps.
pub(crate) fn packed(a: [f64; 2], b: [f64; 2], [n, m]: [usize; 2], shear: f64) -> Setup {
    let along = |v: [f64; 2], k: usize| v.map(|x| x * k as f64);
    let places = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    let at = |(i, j)| {
        let (p, q) = (along(a, i), along(b, j));
        particle(p[0] + q[0], p[1] + q[1], 1.0)
    };
    Setup {
        particles: places.map(at).collect(),
        boundary: Some(cell([along(a, n), along(b, m)])),
        ..scene(material(K, shear * K, if shear > 0.0 { 1e9 } else { 0.0 }))
    }
}

pub(crate) fn built(setup: Setup) -> World {
    let mut world = World::build(setup, 1).expect("the scene is sound");
    world.settle();
    world
}

const OVERLAP: f64 = 0.02;
const D: f64 = 2.0 - OVERLAP;
const F: f64 = K * OVERLAP;

/// Every disc has all its neighbours, in a cell of one disc, of several, and of one row.
#[test]
fn lattices_have_their_closed_forms_in_cells_of_any_size() {
    let row = D * 3f64.sqrt() / 2.0;
    let hexagonal = ([D, 0.0], [0.5 * D, row], 3f64.sqrt() * F / D, 3.0, row);
    let square = ([D, 0.0], [0.0, D], F / D, 2.0, D);
    for (a, b, pressure, per_disc, height) in [hexagonal, square] {
        for size in [[1, 1], [1, 3], [2, 2], [4, 5]] {
            let world = built(packed(a, b, size, 0.0));
            let count = (size[0] * size[1]) as f64;
            let content = Content::of(&world, Shape::All);
            let close = |x: f64, exact: f64| (x - exact).abs() < 1e-9 * exact.abs().max(1e-3);
            assert!(close(content.area, count * D * height), "{size:?}");
            let porosity = 1.0 - std::f64::consts::PI / (D * height);
            assert!(close(content.porosity(), porosity), "{size:?}");
            let stress = Stress::of(&world, &content).total;
            assert!(close(stress[(0, 0)], pressure), "{size:?} {stress}");
            assert!(close(stress[(1, 1)], pressure), "{size:?} {stress}");
            assert!(stress[(0, 1)].abs() < 1e-9 * pressure, "{size:?} {stress}");
            let fabric = Fabric::of(&world, &content).plain;
            assert!(
                close(fabric[(0, 0)], 0.5) && close(fabric[(1, 1)], 0.5),
                "{fabric}"
            );
            let touching = world.contacts().status.len() as f64;
            assert!(touching >= per_disc * count, "{size:?} {touching}");
        }
    }
}

fn crowd(shift: [f64; 2]) -> Vec<ParticleSetup> {
    // A loose crowd that collides: places and velocities from a fixed sequence.
    let mut seed = 7u64;
    let mut next = || {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (seed >> 33) as f64 / f64::from(1u32 << 31) - 0.5
    };
    let mut crowd = Vec::new();
    for i in 0..6 {
        for j in 0..6 {
            let x = [3.0 * f64::from(i) + next(), 3.0 * f64::from(j) + next()];
            let v = [2.0 * next(), 2.0 * next()];
            let radius = 1.1 + 0.2 * next();
            crowd.push(moving(x[0] + shift[0], x[1] + shift[1], radius, v, next()));
        }
    }
    crowd
}

fn gas(shift: [f64; 2], tol: Option<f64>) -> Setup {
    Setup {
        particles: crowd(shift),
        boundary: Some(cell([[18.0, 0.0], [4.0, 18.0]])),
        law: law("linear"),
        tol,
        frac: 0.1,
        ..scene(material(K, 0.8 * K, 0.5))
    }
}

fn momentum(world: &World) -> [f64; 2] {
    let p = world.particles();
    p.row.iter().zip(&p.mass).fold([0.0; 2], |sum, (row, m)| {
        [sum[0] + m * row.v[0], sum[1] + m * row.v[1]]
    })
}

#[test]
fn momentum_and_energy_stay_while_particles_leave_and_come_in() {
    // What is missing in the ledger: steps that end in the middle of sliding leave it.
    let errors = [0.02, 0.01].map(|frac| {
        let mut world = built(Setup {
            frac,
            ..gas([0.0; 2], None)
        });
        let before = momentum(&world);
        let scale: f64 = (world.particles().row.iter().zip(&world.particles().mass))
            .map(|(row, m)| m * (row.v[0].abs() + row.v[1].abs()))
            .sum();
        let cycles = (2000.0 / frac) as u64;
        for _ in 0..cycles {
            world.cycle().expect("the scene is sound");
        }
        let cell = world.cell().unwrap();
        let far = (world.particles().row.iter()).filter(|row| cell.image(row.x) != [0, 0]);
        let far = far.count();
        assert!(far > 3, "nothing crossed an edge: {far}");
        let after = momentum(&world);
        for k in 0..2 {
            // At most 200 000 sums of 36 terms, each wrong by 1e-16 of the scale to either side.
            assert!(
                (after[k] - before[k]).abs() < 1e-10 * scale,
                "{before:?} {after:?} {scale}"
            );
        }
        world.bookings().unwrap().energy_error
    });
    // The same collisions with half the step: a quarter of the error, as of one of second order.
    let ratio = errors[0] / errors[1];
    assert!(
        errors[1].abs() < 1e-4 && (3.0..6.0).contains(&ratio),
        "{errors:?}"
    );
}

/// Where particles stand in the cell says nothing: all shifted alike, some leave it at once.
#[test]
fn a_shift_changes_nothing() {
    let mut here = built(gas([0.0; 2], None));
    // A power of two over a thousand: exact, and half of the crowd starts in other images.
    let shift = [8.0, -16.0];
    let mut there = built(gas(shift, None));
    for _ in 0..300 {
        here.cycle().unwrap();
        there.cycle().unwrap();
    }
    for (a, b) in here.particles().row.iter().zip(&there.particles().row) {
        for (k, shift) in shift.into_iter().enumerate() {
            assert!((b.x[k] - a.x[k] - shift).abs() < 1e-9, "{a:?} {b:?}");
            assert!((b.v[k] - a.v[k]).abs() < 1e-9, "{a:?} {b:?}");
        }
    }
}

#[test]
fn neither_the_halo_nor_threads_change_a_bit() {
    let hashes: Vec<u64> = [(None, 1), (Some(0.4), 1), (Some(0.02), 1), (None, 3)]
        .into_iter()
        .map(|(tol, threads)| {
            let mut setup = gas([0.0; 2], tol);
            setup.strain_rate = [[0.05, 0.01], [0.0, 0.03]];
            let mut world = World::build(setup, threads).unwrap();
            for _ in 0..3000 {
                world.cycle().expect("the scene is sound");
            }
            world.state_hash()
        })
        .collect();
    assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{hashes:?}");
}

/// So many discs that four threads have a stretch each, on their ways through the edges of a sheared cell.
fn many(threads: usize) -> World {
    let row = D * 3f64.sqrt() / 2.0;
    let mut setup = packed([D, 0.0], [0.5 * D, row], [26, 24], 0.8);
    for (k, disc) in setup.particles.iter_mut().enumerate() {
        disc.velocity = [(k % 7) as f64 - 3.0, (k % 5) as f64 - 2.0];
    }
    setup.strain_rate = [[0.05, 0.01], [0.0, -0.03]];
    let world = World::build(setup, threads).expect("the scene is sound");
    let (team, all) = (world.threads(), world.particles().len());
    assert!(team == threads && all / threads > 128, "{team} threads");
    world
}

fn go(world: &mut World, cycles: u32) -> u64 {
    for _ in 0..cycles {
        world.cycle().expect("the scene is sound");
    }
    world.state_hash()
}

#[test]
fn images_follow_whichever_thread_moves_their_particles() {
    let hashes = [1, 2, 3, 4].map(|threads| go(&mut many(threads), 500));
    assert_eq!(hashes, [hashes[0]; 4]);
}

#[test]
fn images_stand_where_they_should_after_every_change() {
    let stored = |world: &World| {
        let mut stored: World = decode(&encode(world).unwrap()).unwrap();
        assert!(stored.unpack(world.threads()));
        stored
    };
    for threads in [1, 4] {
        let mut world = many(threads);
        let changes: [fn(&mut World); 4] = [
            |world| world.delete(300),
            |world| world.set_boundary(None),
            |world| world.set_boundary(Some(cell([[26.0 * D, 0.0], [12.0 * D, 42.0]]))),
            |world| world.set_radius(0, 0.95),
        ];
        for change in changes {
            go(&mut world, 50);
            change(&mut world);
            // What was read from a checkpoint has looked for its images anew.
            let mut other = stored(&world);
            assert_eq!(go(&mut world, 50), go(&mut other, 50));
        }
    }
}

/// The cell of one disc and that of many are the same material in every cycle of a compression.
#[test]
fn cells_of_one_and_of_many_discs_are_one_material() {
    let row = D * 3f64.sqrt() / 2.0;
    let strained = |size| {
        let mut setup = packed([D, 0.0], [0.5 * D, row], size, 0.6);
        setup.strain_rate = [[0.003, 0.001], [0.0, -0.001]];
        setup.damping = Damping {
            contact: Dashpot::Fraction(0.1),
            ..Damping::default()
        };
        let mut world = built(setup);
        for _ in 0..2000 {
            world.cycle().expect("the scene is sound");
        }
        world.settle();
        Stress::of(&world, &Content::of(&world, Shape::All)).total
    };
    let (one, many) = (strained([1, 1]), strained([3, 4]));
    assert!(one.norm() > 0.1 * K * OVERLAP);
    assert!((one - many).norm() < 1e-9 * one.norm(), "{one} {many}");
}

/// A cell that shrinks to nothing is a fault, not an endless search among its images.
#[test]
fn a_cell_cannot_be_narrower_than_a_particle() {
    let mut setup = packed([D, 0.0], [0.0, D], [1, 1], 0.0);
    setup.strain_rate = [[0.05, 0.0], [0.0, 0.05]];
    let mut world = built(setup);
    let fault = (0..20_000).find_map(|_| world.cycle().err());
    assert!(
        matches!(fault, Some(ballast::engine::Fault::Narrow { .. })),
        "{fault:?}"
    );
}

/// Who goes through cell after cell is lost before the count of the cells is.
#[test]
fn a_particle_is_lost_before_its_images_are() {
    let setup = || packed([D, 0.0], [0.0, D], [1, 1], 0.0);
    let dt = built(setup()).dt();
    let mut fast = setup();
    for particle in &mut fast.particles {
        particle.velocity = [0.3 * particle.radius / dt, 0.0];
    }
    let mut world = built(fast);
    let fault = (0..200_000).find_map(|_| world.cycle().err());
    let Some(ballast::engine::Fault::Lost { distance, .. }) = fault else {
        panic!("{fault:?}");
    };
    let cells = distance / D;
    assert!((15_000.0..17_000.0).contains(&cells), "{cells}");
}
