//! The contact list, its slots, and each particle's way to its own slots.

use serde::{Deserialize, Serialize};

use super::blocks::Blocks;
use super::carry::{NEW, carry, places};
use super::found::Meant;
use super::grid::Grid;
use super::images::Images;
use super::party::Party;
use super::periodic::Tiling;
use super::search::{self, Sought};
use super::skin::Use;
use super::spot::Bounds;
use super::travel::Travel;
use super::whose::Whose;
use super::{Slot, Status, room};
use crate::engine::boundary::cell::Cell;
use crate::engine::keep::only;
use crate::engine::lanes::Isa;
use crate::engine::particles::{Particles, Row};
use crate::engine::threads::Threads;
use crate::engine::wall::Wall;
use crate::engine::wall_contact::{WallPair, WallTouch};

/// All pairs within TOL of touching, particle pairs first, then particle-wall pairs.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct ContactList {
    /// Pairs of particle indices, lower first, ascending.
    pub pairs: Vec<[u32; 2]>,
    /// Which image of the second particle each pair means.
    pub(in crate::engine) images: Images,
    /// Pairs of particle and wall, ascending.
    pub walls: Vec<WallPair>,
    /// Where the wall pairs stand now.
    pub touches: Vec<WallTouch>,
    /// Force of each contact on its first body, and one more that is nobody's: always zero.
    pub slots: Vec<Slot>,
    /// How each contact stands.
    pub status: Vec<Status>,
    /// Which contacts are whose.
    #[serde(skip)]
    whose: Whose,
    /// How far everything has moved since the list was made.
    pub(in crate::engine) travel: Travel,
    /// Smallest radius [m].
    pub(in crate::engine) smallest: f64,
    /// Mean radius [m].
    pub(in crate::engine) radius: f64,
    /// Cycle in which the list was made.
    pub(in crate::engine) made: u64,
    /// Times the list was made.
    pub rebuilds: u64,
    /// Whether any contact resists rolling.
    pub rolls: bool,
    /// Box around all particles and their halos until the list is made again: lower and upper
    /// corner [m].
    pub span: [[f64; 2]; 2],
    #[serde(skip)]
    work: Work,
}

/// Smaller assemblies have one halo everywhere: with several, single grains ended the lists of 500 in a
/// hopper after 18 cycles instead of 380.
const MANY: usize = 4096;

/// A list that is wanted, and by whom.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Wanted<'a> {
    /// Halo, averaged over the particles [m].
    pub(in crate::engine) tol: f64,
    /// Whether it may be wide in one place and narrow in another.
    pub(in crate::engine) local: bool,
    pub(in crate::engine) isa: Isa,
    pub(in crate::engine) threads: &'a Threads,
}

/// Buffers of the rebuild.
#[derive(Debug, Default)]
struct Work {
    grid: Grid,
    tiling: Tiling,
    party: Party,
    walls: Vec<WallPair>,
    old: Vec<u32>,
}

impl ContactList {
    /// Number of listed contacts.
    pub fn len(&self) -> usize {
        self.pairs.len() + self.walls.len()
    }

    /// Whether nothing is listed.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Makes the list anew: everything that is sought. Answers where each contact stood in the old list,
    /// in a buffer to be given back.
    pub(in crate::engine) fn rebuild(
        &mut self,
        particles: &Particles,
        walls: &[Wall],
        cell: Option<&Cell>,
        wanted: Wanted<'_>,
    ) -> Vec<u32> {
        let rows = &particles.row;
        let Wanted {
            tol,
            local,
            isa,
            threads,
        } = wanted;
        // The boxes have bounds of their own: in a cell images are in them, too.
        let mut bounds = Bounds::default();
        self.travel.begin(rows.iter().map(|&Row { x, radius, .. }| {
            bounds.take_in(x, radius);
            x
        }));
        let [smallest, largest] = bounds.radii;
        self.smallest = smallest;
        self.radius = bounds.sums[0] / rows.len() as f64;
        let assembly = (bounds.extent, [largest, self.radius]);
        let local = (local && cell.is_none() && rows.len() >= MANY).then_some(assembly);
        self.travel.lay(local, tol);
        let halos = &self.travel.halos;
        let sought = Sought {
            halos,
            isa,
            threads,
        };
        let work = &mut self.work;
        let [pairs, at_walls] = room(rows.len());
        work.walls.clear();
        work.walls.reserve(at_walls);
        let (grid, party) = (&mut work.grid, &mut work.party);
        // In a periodic cell the boxes have what strayed at home.
        let boxes = match cell {
            None => {
                search::pairs(grid, rows, sought, party);
                Some(&*grid)
            }
            Some(cell) => {
                let all = (&**rows, cell);
                work.tiling.pairs(grid, all, sought, party);
                None
            }
        };
        search::wall_pairs(boxes, rows, walls, halos.wall(), &mut work.walls);
        let (mean, margin) = (halos.mean(), largest + 2.0 * halos.wall());
        self.carry_over([pairs, at_walls], rows.len(), threads);
        self.span = [
            bounds.extent.low.map(|x| x - margin),
            bounds.extent.high.map(|x| x + margin),
        ];
        self.travel.within(self.span, 2.0 * largest + mean);
        self.rebuilds += 1;
        std::mem::take(&mut self.work.old)
    }

    /// Takes the buffer back that making the list gave.
    pub(in crate::engine) fn give_back(&mut self, old: Vec<u32>) {
        self.work.old = old;
    }

    /// Slots, status and sides of contacts that were listed before stay what they are, and everybody
    /// learns which are theirs.
    fn carry_over(&mut self, [pairs, at_walls]: [usize; 2], particles: usize, threads: &Threads) {
        let Work {
            party, walls, old, ..
        } = &mut self.work;
        let found = party.found();
        let from = found.early.len();
        old.clear();
        old.reserve(pairs + at_walls);
        old.resize(from, NEW);
        let (before, now) = ((&*self.pairs, &self.images), (&*found.early, &found.images));
        threads.each(old, |first, old| {
            places(|pair| *pair, before, now, first, old);
        });
        old.resize(from + walls.len(), NEW);
        let none = Images::default();
        let bodies = |at: &WallPair| [at.particle, at.wall];
        let (before, now) = ((&*self.walls, &none), (&**walls, &none));
        places(bodies, before, now, 0, &mut old[from..]);
        for (pair, &old) in walls.iter_mut().zip(&old[from..]) {
            if let Some(before) = self.walls.get(old as usize) {
                pair.side = before.side;
            }
        }
        carry(&mut self.touches, &old[from..], 0, at_walls, |_| {
            WallTouch::default()
        });
        let shift = self.pairs.len() as u32;
        for old in old[from..].iter_mut().filter(|old| **old != NEW) {
            *old += shift;
        }
        let (room, whose) = (pairs + at_walls, &mut self.whose);
        let (slots, status) = (&mut self.slots, &mut self.status);
        threads.both(
            || {
                carry(slots, old, 0, room + 1, |_| Slot::default());
                slots.push(Slot::default());
                carry(status, old, 0, room, |_| Status::default());
            },
            || whose.note(particles, &found.early, walls),
        );
        std::mem::swap(&mut self.pairs, &mut found.early);
        std::mem::swap(&mut self.images, &mut found.images);
        std::mem::swap(&mut self.walls, walls);
    }

    /// After reading a checkpoint: works out whose contacts are whose. False if the list is not one of
    /// so many particles and walls: loops rely on it.
    #[must_use]
    pub(in crate::engine) fn unpack(&mut self, particles: usize, walls: usize) -> bool {
        let [pairs, at_walls, all] = [self.pairs.len(), self.walls.len(), self.len()];
        let known = |p: u32| (p as usize) < particles;
        let fits = self.pairs.is_sorted()
            && (self.rebuilds == 0 || self.travel.unpack(particles))
            && self.pairs.iter().flatten().all(|&p| known(p))
            && self.walls.is_sorted_by_key(|wall| wall.particle)
            && (self.walls.iter()).all(|at| known(at.particle) && (at.wall as usize) < walls)
            && self.images.fit(pairs)
            && [self.slots.len(), self.status.len()] == [all + 1, all]
            && self.slots.last() == Some(&Slot::default())
            && self.touches.len() == at_walls;
        if fits {
            self.whose.note(particles, &self.pairs, &self.walls);
        }
        fits
    }

    /// Contact numbers of a particle, and whether it is the second body there: ascending partners,
    /// then walls.
    pub fn of(&self, p: usize) -> impl Iterator<Item = (usize, bool)> + '_ {
        let second = self.whose.second(p).map(|k| (k, true));
        let first = self.whose.first(p).chain(self.whose.at_walls(p));
        second.chain(first.map(|k| (k, false)))
    }

    /// Which contacts are whose.
    #[inline(always)]
    pub(in crate::engine) fn whose(&self) -> &Whose {
        &self.whose
    }

    /// The halo, averaged over the particles [m].
    pub(in crate::engine) fn halo(&self) -> f64 {
        self.travel.halos.mean()
    }

    /// Whether it differs from place to place.
    pub(in crate::engine) fn has_halos(&self) -> bool {
        !self.travel.halos.is_one()
    }

    /// How the list was used in the cycles up to this one.
    pub(in crate::engine) fn usage(&mut self, cycle: u64) -> Use {
        let apart = |status: &&Status| **status == Status::Apart;
        Use {
            local: self.has_halos(),
            tol: self.travel.halos.mean(),
            nearer: self.travel.spending(),
            cycles: cycle.saturating_sub(self.made),
            apart: self.status.iter().filter(apart).count(),
            particles: self.travel.particles(),
            radius: self.radius,
        }
    }

    /// Drops the contacts of particles that do not stay and renumbers the others. Answers which
    /// contacts are left, by their old numbers; the list must be made anew.
    pub(in crate::engine) fn keep_only(&mut self, stays: &[bool]) -> Vec<u32> {
        let stay = |p: u32| stays[p as usize];
        let left = self.retain(
            |&[i, j]| stay(i) && stay(j),
            |wall: &WallPair| stay(wall.particle),
        );
        let mut next = 0;
        let number = |stays: &bool| {
            let number = next;
            next += u32::from(*stays);
            number
        };
        let numbers: Vec<u32> = stays.iter().map(number).collect();
        let renumber = |p: &mut u32| *p = numbers[*p as usize];
        self.pairs.iter_mut().flatten().for_each(renumber);
        let walls = self.walls.iter_mut();
        walls.for_each(|wall| renumber(&mut wall.particle));
        left
    }

    /// The same for a wall.
    pub(in crate::engine) fn forget_wall(&mut self, w: usize) -> Vec<u32> {
        let w = w as u32;
        let left = self.retain(|_| true, |wall| wall.wall != w);
        self.walls
            .iter_mut()
            .for_each(|wall| wall.wall -= u32::from(wall.wall > w));
        left
    }

    fn retain(
        &mut self,
        pair: impl Fn(&[u32; 2]) -> bool,
        wall: impl Fn(&WallPair) -> bool,
    ) -> Vec<u32> {
        let keep: Vec<bool> = self
            .pairs
            .iter()
            .map(pair)
            .chain(self.walls.iter().map(wall))
            .collect();
        let walls = &keep[self.pairs.len()..];
        only(&mut self.touches, walls);
        only(&mut self.walls, walls);
        self.images = self.images.chosen(&keep[..self.pairs.len()]);
        only(&mut self.pairs, &keep);
        // That of nobody is beyond the end.
        only(&mut self.slots, &keep);
        self.slots.push(Slot::default());
        only(&mut self.status, &keep);
        (0..keep.len() as u32)
            .filter(|&k| keep[k as usize])
            .collect()
    }

    /// Bytes of the list per contact and per particle, buffers included, in a periodic cell or not, made
    /// by several threads or not; pairs that reach over an edge of a cell are few.
    pub(in crate::engine) fn bytes(&self, cell: bool, shared: bool) -> [usize; 2] {
        let pair = size_of::<[u32; 2]>();
        // Two lists of pairs, and the old place of each.
        let mut contact = 2 * pair + size_of::<Slot>() + size_of::<Status>() + size_of::<u32>();
        let mut particle = Travel::BYTES + Whose::BYTES + Grid::BYTES;
        if self.has_halos() {
            particle += Blocks::BYTES;
        }
        if shared {
            // What each thread found.
            contact += pair;
        }
        if self.work.grid.levels.len() > 1 {
            // What smaller ones found, at most.
            contact += size_of::<Meant>();
        }
        if cell {
            // Pairs as they are seen.
            contact += pair;
            particle += Tiling::BYTES;
        }
        [contact, particle]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_list_of_another_world_is_refused() {
        let list = |pairs: &[[u32; 2]]| ContactList {
            pairs: pairs.to_vec(),
            slots: vec![Slot::default(); pairs.len() + 1],
            status: vec![Status::Apart; pairs.len()],
            ..ContactList::default()
        };
        assert!(list(&[[0, 1], [0, 2], [1, 2]]).unpack(3, 0));
        // A particle that is not there, another order, a slot too few, and a force on nobody.
        assert!(!list(&[[0, 1], [0, 2], [1, 2]]).unpack(2, 0));
        assert!(!list(&[[1, 2], [0, 1]]).unpack(3, 0));
        assert!(!list(&[[0, 2], [0, 1]]).unpack(3, 0));
        let mut made = list(&[[0, 1]]);
        made.rebuilds = 1;
        assert!(!made.unpack(2, 0));
        made.travel.begin([[0.0; 2]; 2].into_iter());
        assert!(!made.unpack(2, 0));
        made.travel.lay(None, 0.1);
        assert!(made.unpack(2, 0));
        let mut short = list(&[[0, 1], [1, 2]]);
        short.slots.pop();
        assert!(!short.unpack(3, 0));
        let mut pushed = list(&[[0, 1]]);
        pushed.slots[1] = Slot([1.0, 0.0, 0.0, 0.0]);
        assert!(!pushed.unpack(3, 0));
    }
}
