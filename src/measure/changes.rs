//! What has changed since the reference: contacts broken and made, rotations (Randall 1989, 4.2 and
//! fig. 6.35).

use super::frame::home;
use super::link::Link;
use super::reference::{Reference, Was};
use super::tensor::ratio;
use crate::engine::World;
use crate::engine::contact_report::Other;

/// Changes of a region since the reference. Contacts at its edge count by half; which particles are
/// inside is a matter of now.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Changes {
    /// Contacts that touched at the reference and do not now.
    pub broken: f64,
    /// Contacts that touch now and did not at the reference.
    pub made: f64,
    /// Contacts that touch now and did at the reference.
    pub kept: f64,
    /// Mean size of the rotation of particles that were there [rad].
    pub rotation: f64,
    /// Largest size of it [rad].
    pub rotation_max: f64,
    /// Mean sliding way of the touching contacts [m]; NaN when it is not booked.
    pub slid: f64,
    /// Longest sliding way of a touching contact [m]; NaN when it is not booked.
    pub slid_max: f64,
}

/// Tangential way of listed contact k while it slid as a whole, since the reference, or since it
/// touched if that was later [m]; `None` when energies, and ways with them, are not booked.
pub fn slid(world: &World, k: usize) -> Option<f64> {
    world.ledger().map(|_| world.pass().book(k).slid)
}

impl Changes {
    /// Compares the particles marked as inside. A contact of a particle that is gone is broken, and
    /// counts for the one that is left.
    pub fn of(world: &World, inside: &[bool], reference: &Reference) -> Self {
        let (mut made, mut kept) = (0.0, 0.0);
        let (mut way, mut longest) = (0.0, 0f64);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(inside);
            let slid = slid(world, link.place).unwrap_or(f64::NAN);
            if weight > 0.0 {
                way += weight * slid;
                // NaN stays.
                longest = if slid <= longest { longest } else { slid };
            }
            if reference.touched(world, &link) {
                kept += weight;
            } else {
                made += weight;
            }
        }
        let ends = |id: u32| {
            let found = world.particles().index(id);
            found.map_or(0.0, |p| f64::from(u8::from(inside[p])))
        };
        let all = reference.contacts().map(|(first, other)| match other {
            Was::Particle(second) => 0.5 * (ends(first) + ends(second)),
            Was::Wall(_) => ends(first),
        });
        let particles = world.particles();
        let turned = (0..particles.len()).filter(|&p| inside[p]);
        let turned = turned.filter_map(|p| reference.change(world, particles.id[p]));
        let (mut sum, mut rotation_max, mut count) = (0.0, 0f64, 0.0);
        for (_, rotation) in turned {
            sum += rotation.abs();
            rotation_max = rotation_max.max(rotation.abs());
            count += 1.0;
        }
        Self {
            // Halves and ones: exact in binary.
            broken: all.sum::<f64>() - kept,
            made,
            kept,
            rotation: ratio(sum, count),
            rotation_max,
            slid: ratio(way, made + kept),
            slid_max: longest,
        }
    }

    /// Broken contacts over those there were.
    pub fn broken_fraction(&self) -> f64 {
        ratio(self.broken, self.broken + self.kept)
    }
}

/// How a bond of the space lattice stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bond {
    /// It touched at the reference and touches now.
    Kept,
    /// It touches now only.
    Made,
    /// It touched at the reference only.
    Broken,
}

/// The space lattice: a line for every contact, from centre to centre or to the foot on a wall [m], in
/// the coordinates of the preset. Broken contacts at walls have no foot any more and are left out.
pub fn lattice(world: &World, reference: &Reference) -> Vec<(Bond, [[f64; 2]; 2])> {
    let mut bonds = Vec::new();
    let mut touching = Vec::new();
    let id = |p: usize| world.particles().id[p];
    for link in Link::all(world).filter(Link::is_touching) {
        let from = home(world, world.position(link.first));
        let reach: f64 = link.arms.iter().sum();
        let to = [0, 1].map(|k| from[k] + reach * link.e[k]);
        let bond = if reference.touched(world, &link) {
            Bond::Kept
        } else {
            Bond::Made
        };
        bonds.push((bond, [from, to]));
        if let Other::Particle(second) = link.other {
            touching.push([id(link.first), id(second)]);
        }
    }
    touching.sort_unstable();
    let place = |id: u32| {
        let p = world.particles().index(id)?;
        Some(home(world, world.position(p)))
    };
    for (first, other) in reference.contacts() {
        if let Was::Particle(second) = other
            && touching.binary_search(&[first, second]).is_err()
            && let (Some(from), Some(to)) = (place(first), place(second))
        {
            bonds.push((Bond::Broken, [from, nearest(world, from, to)]));
        }
    }
    bonds
}

/// Of a point and its images in a periodic cell, the one nearest to another point [m].
fn nearest(world: &World, from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let Some(cell) = world.cell() else {
        return to;
    };
    let square = |x: [f64; 2]| {
        let d = [x[0] - from[0], x[1] - from[1]];
        d[0] * d[0] + d[1] * d[1]
    };
    let mut best = to;
    for n in -1..=1 {
        for m in -1..=1 {
            let shift = cell.shift([n, m]);
            let image = [to[0] + shift[0], to[1] + shift[1]];
            if square(image) < square(best) {
                best = image;
            }
        }
    }
    best
}
