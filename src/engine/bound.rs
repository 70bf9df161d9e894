//! The stability bound: the largest step the present contacts allow for certain.
//!
//! A contact's energy k (b_i·u_i + b_j·u_j)²/2 is at most k ((b_i·u_i)² + (b_j·u_j)²), so the
//! stiffness matrix is bounded by one 3×3 block per particle, twice its own stiffness against fixed
//! neighbours, and ω² by the largest eigenvalue of any block over its masses. Against a wall once
//! is enough, but twice bounds as well and can be better, since it keeps a block symmetric: the
//! smaller of the two counts.
//! Moving one particle alone gives at least half of that: the bound is never above the true limit
//! and at most a factor √2 below it. In an endless regular lattice it is the limit itself.
//!
//! With dashpots dt² k + 2 dt c may be 4 at most, in units of mass, and the bound is where twice the
//! largest eigenvalues of a block's k and c, A + B with A = 2 dt² k and B = 4 dt c, reach that. At f
//! times this step the particle alone has at least max(f² A, f B)/2, for the two may stand across
//! each other. That is 4 or more for every A + B = 4 from f = 1 + √3 = 2.73 on: further below the
//! limit the bound never is.

use nalgebra::{Matrix3, Vector3};

use super::World;
use super::contact_report::Other;
use super::neighbours::Status;

impl World {
    /// Largest stable time step by that bound [s]; infinite without contacts.
    pub fn stable_step(&self) -> f64 {
        let mut least = f64::INFINITY;
        for k in (0..self.contacts.len()).filter(|&k| self.touches(k)) {
            let (first, other) = self.bodies(k);
            let second = match other {
                Other::Particle(second) => Some(second),
                Other::Wall(_) => None,
            };
            for p in std::iter::once(first).chain(second) {
                // Each particle at the first of its contacts only.
                let mut touching = self.contacts.of(p).filter(|(k, _)| self.touches(*k));
                if touching.next().is_some_and(|(own, _)| own == k) {
                    least = least.min(self.stable_step_below(p, least));
                }
            }
        }
        least
    }

    fn touches(&self, k: usize) -> bool {
        self.contacts.status[k] != Status::Apart
    }

    /// Largest stable FRAC by that bound.
    pub fn frac_limit(&self) -> f64 {
        self.stable_step() / self.base_step
    }

    /// The bound for one particle [s].
    pub fn stable_step_of(&self, p: usize) -> f64 {
        self.stable_step_below(p, f64::INFINITY)
    }

    /// The same if it is less than `least`, or anything that is not [s].
    fn stable_step_below(&self, p: usize, least: f64) -> f64 {
        let held = |&[i, j]: &[u32; 2]| {
            let other = if i as usize == p { j } else { i };
            self.particles.is_driven(other as usize)
        };
        let mut contacts = self.contacts.of(p);
        let with = |count: f64| self.block(p, count).step_below(least);
        // Only contacts with what cannot move can be counted in two ways.
        if contacts.any(|(k, _)| self.contacts.pairs.get(k).is_none_or(held)) {
            return with(1.0).max(with(2.0));
        }
        with(2.0)
    }

    /// The block of a particle with contacts against immovable partners counted `held` times.
    fn block(&self, p: usize, held: f64) -> Block {
        let mut k = Matrix3::zeros();
        let mut c = Matrix3::zeros();
        let mobile = |q: usize, axis: usize| !self.particles.fixed[q][axis];
        let turns = self.model.rotation && self.pass().tangential();
        let scale = Vector3::new(
            if mobile(p, 0) {
                self.particles.mass[p].sqrt().recip()
            } else {
                0.0
            },
            if mobile(p, 1) {
                self.particles.mass[p].sqrt().recip()
            } else {
                0.0
            },
            if mobile(p, 2) && turns {
                self.particles.inertia[p].sqrt().recip()
            } else {
                0.0
            },
        );
        for (contact, second) in self.contacts.of(p) {
            if !self.touches(contact) {
                continue;
            }
            let g = self.geometry(contact);
            let (count, arm) = match self.contacts.pairs.get(contact) {
                None => (held, self.particles.row[p].radius),
                Some(&[i, j]) => {
                    let other = if i as usize == p { j } else { i } as usize;
                    let count = if self.particles.is_driven(other) {
                        held
                    } else {
                        2.0
                    };
                    (count, self.particles.row[p].radius * g.arm)
                }
            };
            let s = self.pass().stiffness(contact, g.overlap);
            let normal = Vector3::new(g.e[0], g.e[1], 0.0).component_mul(&scale);
            // The slide is (v_i - v_j)·t - (a_i spin_i + a_j spin_j): up to sign, the same for both
            // bodies but for the spin.
            let arm = if second { arm } else { -arm };
            let shear = Vector3::new(g.e[1], -g.e[0], arm).component_mul(&scale);
            let (nn, tt) = (normal * normal.transpose(), shear * shear.transpose());
            k += count * (s.k[0] * nn + s.k[1] * tt);
            c += count * (s.c[0] * nn + s.c[1] * tt);
            k[(2, 2)] += count * s.rolling * scale[2] * scale[2];
        }
        Block { k, c }
    }
}

/// Stiffness and viscosity of a particle over its masses.
struct Block {
    /// [1/s²]
    k: Matrix3<f64>,
    /// [1/s]
    c: Matrix3<f64>,
}

impl Block {
    /// The step that it allows if that is less than `least`, or anything that is not [s].
    fn step_below(&self, least: f64) -> f64 {
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
