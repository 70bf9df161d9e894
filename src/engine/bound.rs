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
use super::neighbours::Status;

impl World {
    /// Largest stable time step by that bound [s]; infinite without contacts.
    pub fn stable_step(&self) -> f64 {
        (0..self.particles.len())
            .map(|p| self.stable_step_of(p))
            .fold(f64::INFINITY, f64::min)
    }

    /// Largest stable FRAC by that bound.
    pub fn frac_limit(&self) -> f64 {
        self.stable_step() / self.base_step
    }

    /// The bound for one particle [s].
    pub fn stable_step_of(&self, p: usize) -> f64 {
        let held = |&[i, j]: &[u32; 2]| {
            let other = if i as usize == p { j } else { i };
            self.particles.is_driven(other as usize)
        };
        let mut contacts = self.contacts.of(p);
        // Only contacts with what cannot move can be counted in two ways.
        if contacts.any(|(k, _)| self.contacts.pairs.get(k).is_none_or(held)) {
            let once = self.stable_step_with(p, 1.0);
            return once.max(self.stable_step_with(p, 2.0));
        }
        self.stable_step_with(p, 2.0)
    }

    /// The bound with contacts against immovable partners counted `held` times [s].
    fn stable_step_with(&self, p: usize, held: f64) -> f64 {
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
            if self.contacts.status[contact] == Status::Apart {
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
        let stiffness = k.symmetric_eigenvalues().max();
        if stiffness <= 0.0 {
            return f64::INFINITY;
        }
        // Leapfrog with lagged dashpots is stable while dt² ω² + 2 dt c/m <= 4.
        let viscosity = c.symmetric_eigenvalues().max().max(0.0);
        4.0 / (viscosity + (viscosity * viscosity + 4.0 * stiffness).sqrt())
    }
}
