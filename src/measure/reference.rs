//! The state that differences are measured from: displacements, rotations, strain, contacts broken
//! and made.

use nalgebra::Matrix2;
use serde::{Deserialize, Serialize};

use super::link::Link;
use super::tensor::matrix;
use crate::engine::World;
use crate::engine::contact_report::Other;

/// Positions, angles and touching contacts at some cycle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Reference {
    /// Cycle at which it was taken.
    pub cycle: u64,
    /// Particle numbers, ascending; empty where they are 1, 2, 3 and so on.
    ids: Vec<u32>,
    /// Positions [m] in the coordinates the world computes in.
    places: Vec<[f64; 2]>,
    /// Angles [rad]; empty where all are zero.
    angles: Vec<f64>,
    /// Touching pairs of particles by their numbers, ascending.
    pairs: Vec<[u32; 2]>,
    /// Names of the walls.
    walls: Vec<String>,
    /// Touching pairs of a particle, by its number, and a wall, by its place above; ascending.
    at_walls: Vec<(u32, u32)>,
    /// Strain that the boundary had imposed.
    imposed: [[f64; 2]; 2],
}

/// What a particle touched at the reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Was<'a> {
    /// The particle of this number.
    Particle(u32),
    /// The wall of this name.
    Wall(&'a str),
}

impl Reference {
    /// The present state.
    pub fn of(world: &World) -> Self {
        let particles = world.particles();
        let id = |p: usize| particles.id[p];
        let counted = (1..).zip(&particles.id).all(|(k, id)| k == *id);
        let turned = particles.row.iter().any(|row| row.angle.to_bits() != 0);
        let angles = particles.row.iter().map(|row| row.angle);
        let (mut pairs, mut at_walls) = (Vec::new(), Vec::new());
        for link in Link::all(world).filter(Link::is_touching) {
            match link.other {
                Other::Particle(second) => pairs.push([id(link.first), id(second)]),
                Other::Wall(wall) => at_walls.push((id(link.first), wall as u32)),
            }
        }
        // The list of contacts has this order; searching relies on it.
        pairs.sort_unstable();
        at_walls.sort_unstable();
        Self {
            cycle: world.cycle_number(),
            ids: if counted {
                Vec::new()
            } else {
                particles.id.clone()
            },
            places: particles.row.iter().map(|row| row.x).collect(),
            angles: if turned { angles.collect() } else { Vec::new() },
            pairs,
            walls: world.walls().iter().map(|wall| wall.name.clone()).collect(),
            at_walls,
            imposed: world.imposed_strain().unwrap_or_default(),
        }
    }

    /// Strain that the boundary had imposed then.
    pub(super) fn imposed(&self) -> Matrix2<f64> {
        matrix(self.imposed)
    }

    /// Position [m], in the coordinates the world computes in, and angle [rad] of a particle then;
    /// `None` for one that is newer.
    pub(super) fn state(&self, id: u32) -> Option<([f64; 2], f64)> {
        let p = if self.ids.is_empty() {
            (id as usize).checked_sub(1)?
        } else {
            self.ids.binary_search(&id).ok()?
        };
        let angle = self.angles.get(p).copied().unwrap_or_default();
        Some((*self.places.get(p)?, angle))
    }

    /// Displacement [m] and rotation [rad] since then; `None` for a particle that is newer or gone.
    pub fn change(&self, world: &World, id: u32) -> Option<([f64; 2], f64)> {
        let then = self.state(id)?;
        let now = &world.particles().row[world.particles().index(id)?];
        Some((
            [now.x[0] - then.0[0], now.x[1] - then.0[1]],
            now.angle - then.1,
        ))
    }

    /// Whether a contact of the world touched then.
    pub(super) fn touched(&self, world: &World, link: &Link) -> bool {
        let id = |p: usize| world.particles().id[p];
        match link.other {
            Other::Particle(second) => {
                let pair = [id(link.first), id(second)];
                self.pairs.binary_search(&pair).is_ok()
            }
            Other::Wall(wall) => {
                let name = &world.walls()[wall].name;
                let place = self.walls.iter().position(|known| known == name);
                place.is_some_and(|place| {
                    let pair = (id(link.first), place as u32);
                    self.at_walls.binary_search(&pair).is_ok()
                })
            }
        }
    }

    /// All contacts that touched then, by the number of the first particle.
    pub(super) fn contacts(&self) -> impl Iterator<Item = (u32, Was<'_>)> {
        let pairs = self.pairs.iter().map(|&[i, j]| (i, Was::Particle(j)));
        let at_walls = self.at_walls.iter();
        pairs.chain(at_walls.map(|&(i, wall)| (i, Was::Wall(&self.walls[wall as usize]))))
    }
}
