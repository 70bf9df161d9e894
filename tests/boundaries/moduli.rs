//! Moduli of hexagonal lattices by a small strain of the cell: C11 = (√3/4)(3k_n + k_s) and
//! C12 = (√3/4)(k_n - k_s) per unit thickness, ν = (1 - λ)/(3 + λ) with λ = k_s/k_n.

use ballast::measure::region::{Content, Shape};
use ballast::measure::stress::Stress;
use nalgebra::Matrix2;

use crate::cells::{K, built, packed};

/// Small enough that second-order terms stay below 1e-4 of the moduli.
const OVERLAP: f64 = 1e-5;
const STRAIN: f64 = 1e-6;

/// Change of the stress of a hexagonal lattice under a strain, over that strain. Without rotation of
/// its own every disc does as the lattice does, so what the dynamics add is nothing.
fn answer(lambda: f64, rate: [[f64; 2]; 2]) -> Matrix2<f64> {
    let d = 2.0 - OVERLAP;
    let row = d * 3f64.sqrt() / 2.0;
    let mut world = built(packed([d, 0.0], [0.5 * d, row], [2, 2], lambda));
    let stress =
        |world: &ballast::engine::World| Stress::of(world, &Content::of(world, Shape::All)).total;
    let before = stress(&world);
    let cycles = 200;
    let speed = STRAIN / (f64::from(cycles) * world.dt());
    world.set_strain_rate(rate.map(|row| row.map(|e| e * speed)), 0);
    for _ in 0..cycles {
        world.cycle().expect("the scene is sound");
    }
    world.settle();
    (stress(&world) - before) / STRAIN
}

#[test]
fn hexagonal_moduli() {
    for lambda in [0.0, 2.0 / 3.0, 1.0] {
        let exact = [
            3f64.sqrt() / 4.0 * K * (3.0 + lambda),
            3f64.sqrt() / 4.0 * K * (1.0 - lambda),
        ];
        let along = answer(lambda, [[1.0, 0.0], [0.0, 0.0]]);
        let across = answer(lambda, [[0.0, 0.0], [0.0, 1.0]]);
        for (c11, c12) in [
            (along[(0, 0)], along[(1, 1)]),
            (across[(1, 1)], across[(0, 0)]),
        ] {
            assert!(
                (c11 / exact[0] - 1.0).abs() < 1e-4,
                "{lambda} {c11} {}",
                exact[0]
            );
            assert!(
                (c12 - exact[1]).abs() < 1e-4 * exact[0],
                "{lambda} {c12} {}",
                exact[1]
            );
            let poisson = c12 / c11;
            assert!(
                (poisson - (1.0 - lambda) / (3.0 + lambda)).abs() < 1e-4,
                "{poisson}"
            );
        }
        // Pure shear: C11 - C12 by isotropy.
        let shear = answer(lambda, [[0.0, 0.5], [0.5, 0.0]]);
        let g = 0.5 * (exact[0] - exact[1]);
        assert!((shear[(0, 1)] - g).abs() < 1e-4 * exact[0], "{shear} {g}");
    }
}
