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

mod block;

use nalgebra::{Matrix3, Vector3};

use super::World;
use super::contact::quantities::Stiffness;
use super::contact_report::Other;
use super::neighbours::Status;
use super::observe::ContactState;
use block::{Block, Most};

impl World {
    /// Largest stable time step by that bound [s]; infinite without contacts.
    pub fn stable_step(&self) -> f64 {
        Outlook::new(self, 0.0).stable_step()
    }

    /// The same for all that touches, or may touch, within a time from now on [s]: overlaps become what
    /// they will be if everything moves on as it does, and none becomes less than it is.
    pub fn stable_step_within(&self, time: f64) -> f64 {
        Outlook::new(self, time).stable_step()
    }

    /// The bound as a FRAC if the step is above it. Needs no memory, and twice the time.
    pub fn frac_limit_exceeded(&self) -> Option<f64> {
        let outlook = Outlook::new(self, 0.0);
        let all = 0..self.particles.len();
        let least = all.fold(self.dt, |least, p| {
            least.min(outlook.stable_step_below(p, least))
        });
        (least < self.dt).then(|| least / self.base_step)
    }

    /// Largest stable FRAC by that bound.
    pub fn frac_limit(&self) -> f64 {
        self.stable_step() / self.base_step
    }

    /// The bound for one particle [s].
    pub fn stable_step_of(&self, p: usize) -> f64 {
        Outlook::new(self, 0.0).stable_step_below(p, f64::INFINITY)
    }
}

/// Contacts as they are, or as they will be.
struct Outlook<'a> {
    world: &'a World,
    /// How far ahead [s].
    time: f64,
    /// Whether particles turn.
    turns: bool,
}

impl<'a> Outlook<'a> {
    fn new(world: &'a World, time: f64) -> Self {
        let turns = world.model.rotation && world.pass().tangential();
        Self { world, time, turns }
    }

    fn stable_step(&self) -> f64 {
        let most = self.at_most();
        let each = most.iter().map(Most::step);
        let Some((first, least)) = each.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)) else {
            return f64::INFINITY;
        };
        if least == f64::INFINITY {
            return least;
        }
        // The one that may be least goes first: few others are left then.
        let mut least = self.stable_step_below(first, f64::INFINITY);
        for (p, most) in most.iter().enumerate() {
            if most.step() < least {
                least = least.min(self.stable_step_below(p, least));
            }
        }
        least
    }

    /// What the block of each particle is at most, from one look at each contact.
    fn at_most(&self) -> Vec<Most> {
        let world = self.world;
        let mut most = vec![Most::default(); world.particles.len()];
        for k in 0..world.contacts.len() {
            let Some(seen) = self.see(k) else {
                continue;
            };
            let (first, other) = world.bodies(k);
            let [a, b] = self.ways(first, k, false, &seen.at);
            most[first].add(&seen.stiffness, [a, b], self.scale(first));
            if let Other::Particle(second) = other {
                let ways = self.ways(second, k, true, &seen.at);
                most[second].add(&seen.stiffness, ways, self.scale(second));
            }
        }
        most
    }

    /// A contact that touches, or will; none if it does not.
    fn see(&self, k: usize) -> Option<Seen> {
        let world = self.world;
        let apart = world.contacts.status[k] == Status::Apart;
        if apart && self.time == 0.0 {
            return None;
        }
        let at = world.geometry(k);
        let mut overlap = at.overlap;
        if self.time > 0.0 {
            overlap += world.approach(k, &at).max(0.0) * self.time;
        }
        (!apart || overlap > 0.0).then(|| Seen {
            at,
            stiffness: world.pass().stiffness(k, overlap),
        })
    }

    /// How the overlap and the slide of a contact grow with the motion of one of its bodies.
    fn ways(&self, p: usize, k: usize, second: bool, at: &ContactState) -> [Vector3<f64>; 2] {
        let world = self.world;
        let radius = world.particles.row[p].radius;
        let arm = if k < world.contacts.pairs.len() {
            radius * at.arm
        } else {
            radius
        };
        // The slide is (v_i - v_j)·t - (a_i spin_i + a_j spin_j): up to sign, the same for both
        // bodies but for the spin.
        let arm = if second { arm } else { -arm };
        [
            Vector3::new(at.e[0], at.e[1], 0.0),
            Vector3::new(at.e[1], -at.e[0], arm),
        ]
    }

    /// Roots of one over mass, mass and moment of inertia of a particle; 0 where nothing moves it.
    fn scale(&self, p: usize) -> Vector3<f64> {
        let particles = &self.world.particles;
        let root = |mobile: bool, mass: f64| if mobile { mass.sqrt().recip() } else { 0.0 };
        let [x, y, spin] = particles.fixed[p].map(|fixed| !fixed);
        Vector3::new(
            root(x, particles.mass[p]),
            root(y, particles.mass[p]),
            root(spin && self.turns, particles.inertia[p]),
        )
    }

    /// The bound for one particle if that is less than `least`, or anything that is not [s].
    fn stable_step_below(&self, p: usize, least: f64) -> f64 {
        let world = self.world;
        let held = |&[i, j]: &[u32; 2]| {
            let other = if i as usize == p { j } else { i };
            world.particles.is_driven(other as usize)
        };
        let mut contacts = world.contacts.of(p);
        let with = |count: f64| self.block(p, count).step_below(least);
        // Only contacts with what cannot move can be counted in two ways.
        if contacts.any(|(k, _)| world.contacts.pairs.get(k).is_none_or(held)) {
            return with(1.0).max(with(2.0));
        }
        with(2.0)
    }

    /// The block of a particle with contacts against immovable partners counted `held` times.
    fn block(&self, p: usize, held: f64) -> Block {
        let world = self.world;
        let (mut k, mut c) = (Matrix3::zeros(), Matrix3::zeros());
        let scale = self.scale(p);
        for (contact, second) in world.contacts.of(p) {
            let Some(Seen { at, stiffness: s }) = self.see(contact) else {
                continue;
            };
            let free = |&[i, j]: &[u32; 2]| {
                let other = if i as usize == p { j } else { i };
                !world.particles.is_driven(other as usize)
            };
            let count = if world.contacts.pairs.get(contact).is_some_and(free) {
                2.0
            } else {
                held
            };
            let ways = self.ways(p, contact, second, &at);
            let [normal, shear] = ways.map(|way| way.component_mul(&scale));
            let (nn, tt) = (normal * normal.transpose(), shear * shear.transpose());
            k += count * (s.k[0] * nn + s.k[1] * tt);
            c += count * (s.c[0] * nn + s.c[1] * tt);
            k[(2, 2)] += count * s.rolling * scale[2] * scale[2];
        }
        Block { k, c }
    }
}

/// A contact as it is seen.
struct Seen {
    at: ContactState,
    stiffness: Stiffness,
}
