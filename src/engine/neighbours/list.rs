//! The contact list, its slots, and each particle's way to its own slots.

use serde::{Deserialize, Serialize};

use super::grid::Grid;
use super::periodic::Tiling;
use super::whose::Whose;
use super::{Slot, Status};
use crate::engine::boundary::cell::{Cell, HERE, Image};
use crate::engine::particles::{Particles, Row};
use crate::engine::wall::Wall;
use crate::engine::wall_contact::{self, WallPair, WallTouch};

/// No place in the old list.
pub(in crate::engine) const NEW: u32 = u32::MAX;

/// All pairs within TOL of touching, particle pairs first, then particle-wall pairs.
#[derive(Debug, Default, Serialize, Deserialize)]
pub struct ContactList {
    /// Pairs of particle indices, lower first, ascending.
    pub pairs: Vec<[u32; 2]>,
    /// Which image of the second particle each pair means; empty without a periodic cell.
    pub images: Vec<Image>,
    /// Pairs of particle and wall, ascending.
    pub walls: Vec<WallPair>,
    /// Where the wall pairs stand now.
    pub touches: Vec<WallTouch>,
    /// Force of each contact on its first body.
    pub slots: Vec<Slot>,
    /// How each contact stands.
    pub status: Vec<Status>,
    /// Which contacts are whose.
    whose: Whose,
    /// Centres when the list was made.
    reference: Vec<[f64; 2]>,
    /// No particle has moved further since then [m].
    pub travel: f64,
    /// No point of a wall near the assembly has moved further since then [m].
    pub wall_travel: f64,
    /// No distance has been stretched by a larger share in the imposed flow since then.
    pub(in crate::engine) stretch: f64,
    /// Largest distance of centres in the list [m].
    pub(in crate::engine) reach: f64,
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

/// Buffers of the rebuild.
#[derive(Debug, Default)]
struct Work {
    grid: Grid,
    tiling: Tiling,
    pairs: Vec<[u32; 2]>,
    images: Vec<Image>,
    walls: Vec<WallPair>,
    slots: Vec<Slot>,
    status: Vec<Status>,
    touches: Vec<WallTouch>,
    old: Vec<u32>,
}

impl Work {
    fn pairs(&mut self, rows: &[Row], largest: f64, tol: f64) {
        self.grid.fill(rows, 2.0 * largest + tol);
        for p in 0..rows.len() {
            let first = self.pairs.len();
            let (a, pairs) = (&rows[p], &mut self.pairs);
            self.grid.around(p, |q| {
                let b = &rows[q];
                let d = [b.x[0] - a.x[0], b.x[1] - a.x[1]];
                let reach = a.radius + b.radius + tol;
                if p < q && d[0] * d[0] + d[1] * d[1] < reach * reach {
                    pairs.push([p as u32, q as u32]);
                }
            });
            self.pairs[first..].sort_unstable();
        }
    }

    fn periodic_pairs(&mut self, rows: &[Row], cell: &Cell, largest: f64, tol: f64) {
        let (pairs, images) = (&mut self.pairs, &mut self.images);
        let sizes = [largest, tol];
        self.tiling
            .pairs(&mut self.grid, cell, rows, sizes, |pair, image| {
                pairs.push(pair);
                images.push(image);
            });
    }
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

    /// Contacts that so many particles can have without asking for memory: three pairs each, the
    /// limit of a planar network of neighbours, and every second particle at a wall.
    pub fn room(particles: usize) -> [usize; 2] {
        [3 * particles + 8, particles / 2 + 16]
    }

    /// Makes the list anew: everything nearer than `tol` [m]. Answers where each contact stood in
    /// the old list, in a buffer to be given back.
    pub fn rebuild(
        &mut self,
        particles: &Particles,
        walls: &[Wall],
        cell: Option<&Cell>,
        tol: f64,
    ) -> Vec<u32> {
        let rows = &particles.row;
        let largest = rows.iter().fold(0.0, |most: f64, row| most.max(row.radius));
        let work = &mut self.work;
        work.pairs.clear();
        work.images.clear();
        work.walls.clear();
        let [pairs, at_walls] = Self::room(rows.len());
        work.pairs.reserve(pairs);
        work.walls.reserve(at_walls);
        match cell {
            None => work.pairs(rows, largest, tol),
            Some(cell) => {
                work.images.reserve(pairs);
                work.periodic_pairs(rows, cell, largest, tol);
            }
        }
        for (p, a) in rows.iter().enumerate() {
            for (w, wall) in walls.iter().enumerate() {
                if wall_contact::distance(wall, a.x) < a.radius + tol {
                    let side = wall_contact::side(wall, a.x);
                    work.walls.push(WallPair {
                        particle: p as u32,
                        wall: w as u32,
                        side,
                    });
                }
            }
        }
        self.carry_over([pairs, at_walls]);
        let room = Self::room(rows.len());
        self.whose.note(rows.len(), &self.pairs, &self.walls, room);
        self.reference.clear();
        self.reference.extend(rows.iter().map(|row| row.x));
        self.travel = 0.0;
        self.wall_travel = 0.0;
        self.stretch = 0.0;
        self.reach = 2.0 * largest + tol;
        let [low, high] = particles.extent();
        let margin = largest + 2.0 * tol;
        self.span = [low.map(|x| x - margin), high.map(|x| x + margin)];
        self.rebuilds += 1;
        std::mem::take(&mut self.work.old)
    }

    /// Takes the buffer of [`Self::rebuild`] back.
    pub fn give_back(&mut self, old: Vec<u32>) {
        self.work.old = old;
    }

    /// Slots, status and sides of contacts that were listed before stay what they are.
    fn carry_over(&mut self, [pairs, at_walls]: [usize; 2]) {
        let work = &mut self.work;
        work.old.clear();
        work.old.reserve(pairs + at_walls);
        let meant = |pairs: &[[u32; 2]], images: &[Image], k: usize| {
            (pairs[k], images.get(k).copied().unwrap_or(HERE))
        };
        match_sorted(
            [self.pairs.len(), work.pairs.len()],
            |k| meant(&self.pairs, &self.images, k),
            |k| meant(&work.pairs, &work.images, k),
            &mut work.old,
        );
        let shift = self.pairs.len() as u32;
        let from = work.old.len();
        match_sorted(
            [self.walls.len(), work.walls.len()],
            |k| [self.walls[k].particle, self.walls[k].wall],
            |k| [work.walls[k].particle, work.walls[k].wall],
            &mut work.old,
        );
        work.slots.clear();
        work.status.clear();
        work.touches.clear();
        work.slots.reserve(pairs + at_walls);
        work.status.reserve(pairs + at_walls);
        work.touches.reserve(at_walls);
        for old in &mut work.old[from..] {
            if *old != NEW {
                *old += shift;
            }
        }
        for &old in &work.old {
            work.slots
                .push(self.slots.get(old as usize).copied().unwrap_or_default());
            work.status
                .push(self.status.get(old as usize).copied().unwrap_or_default());
        }
        for (pair, &old) in work.walls.iter_mut().zip(&work.old[from..]) {
            let before = (old != NEW).then(|| (old - shift) as usize);
            work.touches
                .push(before.map(|k| self.touches[k]).unwrap_or_default());
            if let Some(k) = before {
                pair.side = self.walls[k].side;
            }
        }
        std::mem::swap(&mut self.pairs, &mut work.pairs);
        std::mem::swap(&mut self.images, &mut work.images);
        std::mem::swap(&mut self.walls, &mut work.walls);
        std::mem::swap(&mut self.slots, &mut work.slots);
        std::mem::swap(&mut self.status, &mut work.status);
        std::mem::swap(&mut self.touches, &mut work.touches);
    }

    /// Contact numbers of a particle, and whether it is the second body there: ascending partners,
    /// then walls.
    pub fn of(&self, p: usize) -> impl Iterator<Item = (usize, bool)> + '_ {
        let [own, walls] = self.whose.first(p);
        let second = self.whose.second(p).iter().map(|&k| (k as usize, true));
        second.chain(own.chain(walls).map(|k| (k, false)))
    }

    /// Which contacts are whose.
    #[inline(always)]
    pub(in crate::engine) fn whose(&self) -> &Whose {
        &self.whose
    }

    /// Takes the centres that travel is measured from along with an imposed flow.
    pub(in crate::engine) fn carry_along(&mut self, moved: impl Fn([f64; 2]) -> [f64; 2]) {
        for x in &mut self.reference {
            *x = moved(*x);
        }
    }

    /// Furthest that any particle really moved since the list was made, but for the imposed flow [m].
    pub fn measured_travel(&self, particles: &Particles) -> f64 {
        let square =
            particles
                .row
                .iter()
                .zip(&self.reference)
                .fold(0.0, |most: f64, (row, old)| {
                    let d = [row.x[0] - old[0], row.x[1] - old[1]];
                    most.max(d[0] * d[0] + d[1] * d[1])
                });
        square.sqrt()
    }

    /// Drops the contacts of particle p and renumbers those above it, as the particle is removed.
    /// Answers which contacts are left, by their old numbers; the list must be made anew.
    pub fn forget(&mut self, p: usize) -> Vec<u32> {
        let p = p as u32;
        let left = self.retain(|pair| !pair.contains(&p), |wall| wall.particle != p);
        let above = |q: &mut u32| *q -= u32::from(*q > p);
        self.pairs.iter_mut().flatten().for_each(above);
        self.walls
            .iter_mut()
            .for_each(|wall| above(&mut wall.particle));
        left
    }

    /// The same for a wall.
    pub fn forget_wall(&mut self, w: usize) -> Vec<u32> {
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
        self.touches = chosen(&self.touches, walls);
        self.walls = chosen(&self.walls, walls);
        if !self.images.is_empty() {
            self.images = chosen(&self.images, &keep[..self.pairs.len()]);
        }
        self.pairs = chosen(&self.pairs, &keep[..self.pairs.len()]);
        self.slots = chosen(&self.slots, &keep);
        self.status = chosen(&self.status, &keep);
        (0..keep.len() as u32)
            .filter(|&k| keep[k as usize])
            .collect()
    }

    /// Bytes of the list per contact and per particle, buffers included.
    pub fn bytes() -> [usize; 2] {
        let contact = size_of::<[u32; 2]>() + size_of::<Slot>() + size_of::<Status>();
        [
            2 * (contact + size_of::<u32>()),
            size_of::<[f64; 2]>() + 4 * size_of::<u32>(),
        ]
    }
}

fn chosen<T: Copy>(items: &[T], keep: &[bool]) -> Vec<T> {
    items
        .iter()
        .zip(keep)
        .filter(|(_, keep)| **keep)
        .map(|(item, _)| *item)
        .collect()
}

/// For each of the sorted new items, its place among the sorted old ones, or [`NEW`].
fn match_sorted<K: Ord>(
    [old, new]: [usize; 2],
    old_key: impl Fn(usize) -> K,
    new_key: impl Fn(usize) -> K,
    places: &mut Vec<u32>,
) {
    let mut k = 0;
    for item in 0..new {
        let wanted = new_key(item);
        while k < old && old_key(k) < wanted {
            k += 1;
        }
        let found = k < old && old_key(k) == wanted;
        places.push(if found { k as u32 } else { NEW });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_found_by_walking() {
        let mut places = Vec::new();
        let old = [[0, 1], [0, 3], [2, 5]];
        let new = [[0, 2], [0, 3], [2, 5], [3, 4]];
        match_sorted([3, 4], |k| old[k], |k| new[k], &mut places);
        assert_eq!(places, [NEW, 1, 2, NEW]);
    }
}
