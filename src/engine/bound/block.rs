//! The block of one particle, and the step that its largest eigenvalues allow.

use nalgebra::{Matrix3, Vector3};

use crate::engine::contact::quantities::Stiffness;

/// Stiffness and viscosity of a particle over its masses.
pub(super) struct Block {
    /// [1/s²]
    pub(super) k: Matrix3<f64>,
    /// [1/s]
    pub(super) c: Matrix3<f64>,
}

impl Block {
    /// The step that it allows if that is less than `least`, or anything that is not [s].
    pub(super) fn step_below(&self, least: f64) -> f64 {
        // Most particles are not the one that decides: eigenvalues are for those who may be.
        let no_less = allowed(at_most(&self.k), at_most(&self.c).max(0.0));
        if no_less >= least {
            return no_less;
        }
        let stiffness = self.k.symmetric_eigenvalues().max();
        if stiffness <= 0.0 {
            return f64::INFINITY;
        }
        allowed(stiffness, self.c.symmetric_eigenvalues().max().max(0.0))
    }
}

/// Sums over the contacts of a particle, each counted twice, of which no eigenvalue of its block is more.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Most {
    k: Symmetric,
    c: Symmetric,
}

/// Upper half of a symmetric matrix, row by row.
type Symmetric = [f64; 6];

impl Most {
    /// Adds a contact, with the ways in which the particle changes overlap and slide.
    pub(super) fn add(&mut self, s: &Stiffness, ways: [Vector3<f64>; 2], scale: Vector3<f64>) {
        for (kind, way) in ways.into_iter().enumerate() {
            let [x, y, z] = way.component_mul(&scale).into();
            let products = [x * x, x * y, x * z, y * y, y * z, z * z];
            for (n, product) in products.into_iter().enumerate() {
                self.k[n] += 2.0 * s.k[kind] * product;
                self.c[n] += 2.0 * s.c[kind] * product;
            }
        }
        self.k[5] += 2.0 * s.rolling * scale[2] * scale[2];
    }

    /// The particle allows no smaller step than this [s].
    pub(super) fn step(&self) -> f64 {
        if self.k == [0.0; 6] && self.c == [0.0; 6] {
            return f64::INFINITY;
        }
        let [k, c] = [&self.k, &self.c].map(full);
        allowed(at_most(&k), at_most(&c).max(0.0))
    }
}

fn full(&[xx, xy, xz, yy, yz, zz]: &Symmetric) -> Matrix3<f64> {
    Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
}

/// Leapfrog with lagged dashpots is stable while dt² ω² + 2 dt c/m <= 4 [s].
fn allowed(stiffness: f64, viscosity: f64) -> f64 {
    4.0 / (viscosity + (viscosity * viscosity + 4.0 * stiffness).sqrt())
}

/// No eigenvalue of a symmetric matrix of three rows is larger: their mean is a third of the trace, their
/// squares add up to those of all entries, and the largest is furthest from the mean when the other two
/// are equal (Wolkowicz & Styan 1980).
fn at_most(a: &Matrix3<f64>) -> f64 {
    let mean = a.trace() / 3.0;
    let spread = (a.norm_squared() / 3.0 - mean * mean).max(0.0);
    // Room for rounding, of the spread too, which is a difference.
    let size = a.norm();
    mean + (2.0 * spread).sqrt() + ROUNDING * size
}

/// Rounding of the spread, a few last places of the squares, is at most the root of that in the root.
const ROUNDING: f64 = 1e-7;

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers from -1 to 1 that look random.
    fn numbers(seed: u64) -> impl Iterator<Item = f64> {
        let next = |x: &u64| Some(x.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1));
        std::iter::successors(Some(seed), next)
            .map(|x| (x >> 11) as f64 / (1u64 << 52) as f64 - 1.0)
    }

    /// A sum of so many v vᵀ, as contacts add up to.
    fn block(count: usize, seed: u64) -> Matrix3<f64> {
        let mut numbers = numbers(seed);
        let mut vector = || Vector3::from_fn(|_, _| numbers.next().expect("endless"));
        let terms = (0..count).map(|_| vector());
        terms.fold(Matrix3::zeros(), |sum, v| sum + v * v.transpose())
    }

    #[test]
    fn no_eigenvalue_is_above_what_they_are_at_most_and_of_one_contact_it_is_that() {
        for seed in 1..2000 {
            for count in 1..7 {
                let a = block(count, seed);
                let (largest, most) = (a.symmetric_eigenvalues().max(), at_most(&a));
                assert!(most >= largest, "{count} {seed}: {most} {largest}");
                if count == 1 {
                    assert!(most <= largest * (1.0 + 1e-6), "{seed}: {most} {largest}");
                }
                let [k, c] = [a, block(count, seed + 5000)];
                let exact = Block { k, c }.step_below(f64::INFINITY);
                for least in [0.5, 0.99, 1.01, 2.0].map(|share| share * exact) {
                    let found = Block { k, c }.step_below(least);
                    assert_eq!(found.min(least), exact.min(least));
                }
            }
        }
        let unit = Matrix3::identity();
        assert!(at_most(&unit) >= 1.0 && at_most(&unit) < 1.0 + 1e-6);
    }
}
