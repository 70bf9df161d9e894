//! Contacts as the measures see them: which way they point, what they carry, how much of them
//! belongs to a region.

use nalgebra::Vector2;

use super::branch::{Branch, reach};
use crate::engine::World;
use crate::engine::contact_report::Other;

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
    /// Whether a bond holds it.
    pub bonded: bool,
}

impl Link {
    /// All contacts that are not apart, in the order of the list: sums over it have the same bits
    /// whatever the number of threads.
    pub fn all(world: &World) -> impl Iterator<Item = Self> + '_ {
        Branch::all(world).map(|branch| Self::of(world, &branch))
    }

    fn of(world: &World, branch: &Branch) -> Self {
        let k = branch.place;
        let reaction = world.reaction_along(k, branch.e.into());
        Self {
            place: k,
            first: branch.first,
            other: branch.other,
            e: branch.e,
            t: Vector2::new(branch.e.y, -branch.e.x),
            arms: branch.arms,
            force: branch.force,
            normal: reaction.normal,
            tangential: reaction.tangential,
            sliding: reaction.sliding,
            frictional: world.pass().is_frictional(k),
            bonded: world.is_bonded(k),
        }
    }

    /// Index of the second particle; `None` for a wall.
    pub fn second(&self) -> Option<usize> {
        match self.other {
            Other::Particle(second) => Some(second),
            Other::Wall(_) => None,
        }
    }

    /// Whether it presses or is bonded; what is counted over contacts is counted over these.
    pub fn is_touching(&self) -> bool {
        self.normal > 0.0 || self.bonded
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
        reach(self.first, self.other, self.arms, inside)
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
