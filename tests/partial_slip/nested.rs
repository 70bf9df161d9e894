//! Smooth histories with nested loops in steps of any size: what a bounded memory makes of them.

use std::f64::consts::TAU;

use ballast::engine::contact::diagram::{Diagram, Partial};

use crate::annuli::{Annuli, Keep};

/// Largest error of T over μN on a thousand points of a history: of 16 nodes, and of 16 nodes by the
/// rule of the smallest triangle without carried areas.
fn errors(history: fn(f64) -> [f64; 2], steps: usize) -> [f64; 2] {
    let law = Partial::new(1.0, 1.0, 1.0, 16);
    let mut memory = Diagram::<16>::default();
    let mut all = Annuli::new(Keep::All);
    let mut plain = Annuli::new(Keep::SmallestTriangle(16));
    let (mut worst, mut before) = ([0.0_f64; 2], 0.0);
    for k in 0..=steps {
        let [overlap, delta] = history(k as f64 / steps as f64);
        let d = delta - before;
        let force = all.step(overlap, d);
        let errors = [
            law.advance(overlap, d, &mut memory).force - force,
            plain.step(overlap, d) - force,
        ];
        before = delta;
        if k % (steps / 1000) == 0 {
            let load = overlap * overlap.sqrt();
            for (worst, error) in worst.iter_mut().zip(errors) {
                *worst = worst.max(error.abs() / load);
            }
        }
    }
    assert!(memory.len() <= 16 && all.len() > 16, "{}", all.len());
    worst
}

/// Swings in both that die away, in step with each other.
fn dying(s: f64) -> [f64; 2] {
    let left = 1.0 - s;
    [
        1.0 - left * (0.5 + 0.45 * (TAU * 2.5 * s).cos()),
        0.35 * left * (TAU * 2.5 * s + 0.6).cos(),
    ]
}

/// More of them, about a mean overlap.
fn crowded(s: f64) -> [f64; 2] {
    let left = 1.0 - s;
    [
        0.6 - 0.4 * left * (TAU * 5.0 * s).cos(),
        0.25 * left * (TAU * 5.0 * s + 0.9).cos(),
    ]
}

/// Few and slow ones, with long growth along a curve.
fn slow(s: f64) -> [f64; 2] {
    let left = 1.0 - s;
    [
        0.6 - 0.4 * left * (TAU * 3.0 * s).cos(),
        0.25 * left * (TAU * 3.0 * s + 0.3).cos(),
    ]
}

/// Swings of different periods with more corners than there are nodes.
fn many(s: f64) -> [f64; 2] {
    let left = 1.0 - s;
    [
        0.6 - 0.4 * left * (TAU * 3.0 * s).cos(),
        0.1 * left * (TAU * 10.0 * s + 0.9).cos(),
    ]
}

/// The error does not grow with the number of steps. The control: without carried areas the memory
/// is worn away, a little in every step.
#[test]
fn any_number_of_steps() {
    for (history, most) in [(dying, 3e-5), (crowded, 3e-5), (slow, 3e-5), (many, 1.5e-4)]
        as [(fn(f64) -> [f64; 2], f64); 4]
    {
        for steps in [1000, 10_000, 1_000_000] {
            let [ours, plain] = errors(history, steps);
            assert!(ours < most, "{steps}: {ours}");
            assert!(steps < 1_000_000 || plain > 5e-4, "{plain}");
        }
    }
}
