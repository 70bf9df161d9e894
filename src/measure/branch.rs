//! Contacts as stress sees them: from where to where, and what they carry.

use nalgebra::Vector2;

use crate::engine::World;
use crate::engine::contact_report::Other;
use crate::engine::neighbours::{Slot, Status};

/// The branch of a contact that is not apart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branch {
    /// Its place in the list of contacts.
    pub place: usize,
    /// Index of the first particle.
    pub first: usize,
    /// What it touches.
    pub other: Other,
    /// Unit normal, from the first body to the second.
    pub e: Vector2<f64>,
    /// From each centre to the contact along the normal [m]: the distance of the centres, split as
    /// the lever arms; from the centre to the surface of a wall, which has no part of its own.
    pub arms: [f64; 2],
    /// Overlap [m].
    pub overlap: f64,
    /// Force on the first particle [N].
    pub force: Vector2<f64>,
}

impl Branch {
    /// Those of all contacts that are not apart, in the order of the list: sums over it have the same
    /// bits whatever the number of threads.
    pub fn all(world: &World) -> impl Iterator<Item = Self> + '_ {
        let list = world.contacts();
        (0..list.len())
            .filter(|&k| list.status[k] != Status::Apart)
            .map(|k| Self::of(world, k))
    }

    fn of(world: &World, k: usize) -> Self {
        let geometry = world.geometry(k);
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
            arms,
            overlap: geometry.overlap,
            force: Vector2::new(fx, fy),
        }
    }

    /// Normal force [N], compression positive; what presses touches.
    pub fn normal(&self) -> f64 {
        // Adding zero turns a negative one into the plain one that people expect.
        0.0 - (self.force.x * self.e.x + self.force.y * self.e.y)
    }

    /// Length of its arms that belong to particles marked as inside [m].
    pub fn reach(&self, inside: &[bool]) -> f64 {
        reach(self.first, self.other, self.arms, inside)
    }
}

/// Length of the arms of two bodies that belong to particles marked as inside [m].
pub(super) fn reach(first: usize, other: Other, arms: [f64; 2], inside: &[bool]) -> f64 {
    let end = |p: usize, arm: f64| if inside[p] { arm } else { 0.0 };
    let second = match other {
        Other::Particle(second) => end(second, arms[1]),
        Other::Wall(_) => 0.0,
    };
    end(first, arms[0]) + second
}
