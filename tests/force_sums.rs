//! Sums of contact forces on a particle, and FRACC that is judged by their change.

mod common;

use ballast::engine::Isa;
use ballast::engine::World;
use ballast::engine::neighbours::Slot;
use ballast::engine::setup::{ParticleSetup, Setup};
use common::*;

/// A large disc in a ring of `small` ones that overlap it, and each other not, numbered before or after
/// them: it has more contacts than a particle has places of its own.
fn crowded(small: usize, first: bool) -> Setup {
    let mut setup = scene(material(1e5, 1e5, 0.3));
    setup.damping = contact_damping(0.1);
    let ring = (0..small).map(|k| {
        let angle = std::f64::consts::TAU * k as f64 / small as f64 + 0.1;
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let radius = 0.9 + 0.005 * k as f64;
        ParticleSetup {
            velocity: [-0.3 * cos - 0.1 * sin, -0.3 * sin + 0.2 * cos],
            ..particle(10.0 * cos, 10.0 * sin, radius)
        }
    });
    let large = particle(0.0, 0.0, 9.11);
    setup.particles = if first {
        std::iter::once(large).chain(ring).collect()
    } else {
        ring.chain([large]).collect()
    };
    setup
}

/// The sum over all contacts of a particle of what their slots hold, and how far rounding may take another
/// order of it: of n terms, by (n - 1) half last places of the sum of their sizes, either way.
fn independent(world: &World, p: usize) -> ([f64; 3], f64) {
    let mut sum = [0.0; 3];
    let mut size = 0.0;
    for (k, second) in world.contacts().of(p) {
        let Slot([f1, f2, tau, _]) = world.contacts().slots[k];
        let sign = if second { -1.0 } else { 1.0 };
        sum = [sum[0] + sign * f1, sum[1] + sign * f2, sum[2] + tau];
        size += f1.abs().max(f2.abs()).max(tau.abs());
    }
    let count = world.contacts().of(p).count() as f64;
    (sum, count * f64::EPSILON * size)
}

#[test]
fn who_has_more_contacts_than_places_is_pushed_by_all_of_them() {
    for first in [true, false] {
        let mut hashes = Vec::new();
        for isa in Isa::ALL.into_iter().filter(|isa| isa.is_here()) {
            let mut world = world(crowded(21, first));
            world.use_instructions(isa);
            for _ in 0..40 {
                run(&mut world, 1);
                world.settle();
                for p in 0..world.particles().len() {
                    let ([f1, f2, tau], rounding) = independent(&world, p);
                    let sum = world.particles().force[p];
                    let off = [sum.f[0] - f1, sum.f[1] - f2, sum.tau - tau];
                    assert!(off.iter().all(|off| off.abs() <= rounding), "{p}: {off:?}");
                }
            }
            let large = if first { 0 } else { 21 };
            let touched = world.contacts().of(large).count();
            assert_eq!(touched, 21, "all of them are contacts of the large one");
            hashes.push(world.state_hash());
        }
        hashes.dedup();
        assert_eq!(
            hashes.len(),
            1,
            "the bits are the same with all instructions"
        );
    }
}

/// A falling pile that takes FRACC each `every` cycles.
fn pile(every: u32) -> World {
    let mut setup = collapsing_pile(6, 0.2);
    // Books would look at every boundary.
    setup.ledger = false;
    setup.fracc_every = every;
    world(setup)
}

#[test]
fn fracc_now_and_then_is_that_of_every_cycle() {
    // Boundary by boundary, each looked at.
    let mut looked = pile(1);
    let always: Vec<f64> = (0..700)
        .map(|_| {
            run(&mut looked, 1);
            looked.take_fracc().expect("taken at every boundary")
        })
        .collect();
    for every in [1, 2, 7, 100] {
        let mut world = pile(every);
        let mut largest: f64 = 0.0;
        for cycle in 0..700 {
            // Judges the boundary it begins with; nobody looks.
            run(&mut world, 1);
            if cycle > 0 && cycle % every as usize == 0 {
                largest = largest.max(always[cycle - 1]);
            }
            let seen = world.fracc_monitor().largest.unwrap_or(0.0);
            assert_eq!(seen, largest, "every {every}, cycle {cycle}");
        }
        assert!(largest > 0.1, "{largest}");
    }
}
