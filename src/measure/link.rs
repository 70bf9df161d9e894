//! Contacts as the measures see them: which way they point, what they carry, how much of them
//! belongs to a region.

use nalgebra::Vector2;

use crate::engine::World;
use crate::engine::contact_report::Other;
use crate::engine::neighbours::{Slot, Status};

/// A contact that is not apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Link {
    /// Its place in the list of contacts.
    pub place: usize,
    /// Index of the first particle.
    pub first: usize,
    /// What it touches.
    pub other: Other,
    /// Unit normal, from the first body to the second.
    pub e: Vector2<f64>,
    /// Unit tangent (e2, -e1).
    pub t: Vector2<f64>,
    /// From each centre to the contact along the normal [m]: the distance of the centres, split as
    /// the lever arms; from the centre to the surface of a wall, which has no part of its own.
    pub arms: [f64; 2],
    /// Force on the first particle [N].
    pub force: Vector2<f64>,
    /// Normal force [N], compression positive.
    pub normal: f64,
    /// Tangential force [N].
    pub tangential: f64,
    /// Whether it slid in the last cycle.
    pub sliding: bool,
    /// Whether it has a friction limit.
    pub frictional: bool,
}

impl Link {
    /// All contacts that are not apart, in the order of the list: sums over it have the same bits
    /// whatever the number of threads.
    pub fn all(world: &World) -> impl Iterator<Item = Self> + '_ {
        let list = world.contacts();
        (0..list.len())
            .filter(|&k| list.status[k] != Status::Apart)
            .map(|k| Self::of(world, k))
    }

    fn of(world: &World, k: usize) -> Self {
        let (geometry, reaction) = (world.geometry(k), world.reaction(k));
        let Slot([fx, fy, ..]) = world.contacts().slots[k];
        let radius = |p: usize| world.particles().row[p].radius;
        let (first, other) = world.bodies(k);
        let arms = match other {
            Other::Particle(j) => [radius(first) * geometry.arm, radius(j) * geometry.arm],
            Other::Wall(_) => [geometry.distance, 0.0],
        };
        let [e1, e2] = geometry.e;
        Self {
            place: k,
            first,
            other,
            e: Vector2::new(e1, e2),
            t: Vector2::new(e2, -e1),
            arms,
            force: Vector2::new(fx, fy),
            normal: reaction.normal,
            tangential: reaction.tangential,
            sliding: reaction.sliding,
            frictional: world.pass().is_frictional(k),
        }
    }

    /// Index of the second particle; `None` for a wall.
    pub fn second(&self) -> Option<usize> {
        match self.other {
            Other::Particle(second) => Some(second),
            Other::Wall(_) => None,
        }
    }

    /// Whether it presses; what is counted over contacts is counted over these.
    pub fn is_touching(&self) -> bool {
        self.normal > 0.0
    }

    /// How much of it counts for the particles marked as inside: half for each end, a wall contact
    /// whole.
    pub fn weight(&self, inside: &[bool]) -> f64 {
        let end = |p: usize| f64::from(u8::from(inside[p]));
        match self.second() {
            Some(second) => 0.5 * (end(self.first) + end(second)),
            None => end(self.first),
        }
    }

    /// Length of its arms that belong to particles marked as inside [m].
    pub fn reach(&self, inside: &[bool]) -> f64 {
        let end = |p: usize, arm: f64| if inside[p] { arm } else { 0.0 };
        end(self.first, self.arms[0]) + self.second().map_or(0.0, |p| end(p, self.arms[1]))
    }
}

/// Normal force [N] of each touching contact of the particles marked as inside, and what the contact
/// counts for.
pub fn normal_forces(world: &World, inside: &[bool]) -> Vec<(f64, f64)> {
    let touching = Link::all(world).filter(Link::is_touching);
    touching
        .map(|link| (link.normal, link.weight(inside)))
        .filter(|(_, weight)| *weight > 0.0)
        .collect()
}
