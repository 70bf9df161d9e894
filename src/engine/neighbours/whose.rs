//! Which contacts are whose: how a particle finds the slots with its forces.
//!
//! A few places for each particle, so that its forces can be summed without asking how many there
//! are; those who touch more have the others noted elsewhere.

use std::ops::Range;

use crate::engine::wall_contact::WallPair;

/// Places for pairs in which a particle is the second body, and for those in which it is the first:
/// more than five of either have six in a thousand.
const PLACES: [usize; 2] = [5, 5];

/// A last place with this bit says where there are more.
const MORE: u32 = 1 << 31;

/// A place holds the first of the numbers of a slot: its contact times this.
pub(in crate::engine) const NUMBERS: u32 = 4;

/// Places of a particle: pairs in which it is the second body, and then those in which it is the first,
/// either ascending and filled up with nobody's.
pub(in crate::engine) type Places = [u32; PLACES[0] + PLACES[1]];

/// The last of each kind.
pub(in crate::engine) const LASTS: [usize; 2] = [PLACES[0] - 1, PLACES[0] + PLACES[1] - 1];

/// Where those of each kind are.
const KINDS: [Range<usize>; 2] = [0..PLACES[0], PLACES[0]..PLACES[0] + PLACES[1]];

/// The contacts of each particle.
#[derive(Debug, Default)]
pub(in crate::engine) struct Whose {
    /// Of each particle. Of more pairs than places the last says where it and the others are.
    places: Vec<Places>,
    /// The others: how many, and then they.
    more: Vec<u32>,
    /// First contact of each particle with a wall; empty without walls.
    walls: Vec<u32>,
    /// What stands where there is no contact.
    nobody: u32,
    /// Buffers: places that are taken of each kind, and those for whom there was none: twice the
    /// particle and the kind, and the slot.
    counts: [Vec<u8>; 2],
    crowd: Vec<(u64, u32)>,
}

impl Whose {
    /// Bytes per particle.
    pub(super) const BYTES: usize = size_of::<Places>() + 2 * size_of::<u8>();

    /// Notes the contacts of so many particles.
    ///
    /// # Panics
    /// If there are 2²⁹ contacts or more.
    pub(super) fn note(&mut self, particles: usize, pairs: &[[u32; 2]], walls: &[WallPair]) {
        let contacts = pairs.len() + walls.len();
        assert!(
            contacts < (MORE / NUMBERS) as usize,
            "too many contacts to number"
        );
        self.nobody = contacts as u32 * NUMBERS;
        self.places.clear();
        self.places
            .resize(particles, [self.nobody; PLACES[0] + PLACES[1]]);
        for counts in &mut self.counts {
            counts.clear();
            counts.resize(particles, 0);
        }
        self.crowd.clear();
        // So that a list made again seldom asks for memory.
        self.crowd.reserve(particles);
        for (k, &[i, j]) in (0..).zip(pairs) {
            self.enter(k * NUMBERS, j, 0);
            self.enter(k * NUMBERS, i, 1);
        }
        self.seat_crowd(particles);
        self.note_walls(particles, pairs.len() as u32, walls);
    }

    #[inline(always)]
    fn enter(&mut self, slot: u32, p: u32, kind: usize) {
        let taken = &mut self.counts[kind][p as usize];
        let free = usize::from(*taken);
        if free < PLACES[kind] {
            self.places[p as usize][KINDS[kind].start + free] = slot;
            *taken += 1;
        } else {
            self.crowd.push((2 * u64::from(p) + kind as u64, slot));
        }
    }

    /// Those for whom there was no place are noted elsewhere, with the last one that had a place.
    fn seat_crowd(&mut self, particles: usize) {
        self.more.clear();
        self.more.reserve(particles);
        self.crowd.sort_unstable();
        for group in self.crowd.chunk_by(|a, b| a.0 == b.0) {
            let (p, kind) = ((group[0].0 / 2) as usize, (group[0].0 % 2) as usize);
            let last = &mut self.places[p][LASTS[kind]];
            let at = self.more.len() as u32;
            self.more.extend([1 + group.len() as u32, *last]);
            self.more.extend(group.iter().map(|(_, slot)| *slot));
            *last = MORE | at;
        }
    }

    fn note_walls(&mut self, particles: usize, pairs: u32, walls: &[WallPair]) {
        self.walls.clear();
        if walls.is_empty() {
            return;
        }
        self.walls.resize(particles + 1, 0);
        for wall in walls {
            self.walls[wall.particle as usize + 1] += 1;
        }
        self.walls[0] = pairs;
        for p in 0..particles {
            self.walls[p + 1] += self.walls[p];
        }
    }

    /// Places of each particle.
    #[inline(always)]
    pub(in crate::engine) fn places(&self) -> &[Places] {
        &self.places
    }

    /// Whether a last place stands for several.
    #[inline(always)]
    pub(in crate::engine) fn is_more(last: u32) -> bool {
        last & MORE != 0
    }

    /// What the last place of a particle stands for, if not for a slot itself.
    fn others(&self, last: u32) -> Option<&[u32]> {
        Self::more_at(last).map(|at| {
            let (count, rest) = (self.more[at] as usize, &self.more[at + 1..]);
            &rest[..count]
        })
    }

    /// Offset in [`more`](Self::more) of the contacts that a last place refers to, if it refers to several: how
    /// many, and then their slots.
    #[inline(always)]
    pub(in crate::engine) fn more_at(last: u32) -> Option<usize> {
        Self::is_more(last).then_some((last & !MORE) as usize)
    }

    /// Places of those that had none of their own.
    pub(in crate::engine) fn more(&self) -> &[u32] {
        &self.more
    }

    /// Whether so many contacts were noted.
    pub(in crate::engine) fn is_of(&self, contacts: usize) -> bool {
        self.nobody as usize == contacts * NUMBERS as usize
    }

    /// Whether anybody is near a wall.
    pub(in crate::engine) fn meet_walls(&self) -> bool {
        !self.walls.is_empty()
    }

    /// First contact of each particle with a wall, and one further on; empty without walls.
    pub(in crate::engine) fn walls(&self) -> &[u32] {
        &self.walls
    }

    /// Contacts of a particle with walls.
    #[inline(always)]
    pub(in crate::engine) fn at_walls(&self, p: usize) -> Range<usize> {
        if self.walls.is_empty() {
            return 0..0;
        }
        self.walls[p] as usize..self.walls[p + 1] as usize
    }

    /// Pairs in which the particle is the second body, ascending.
    pub(super) fn second(&self, p: usize) -> impl Iterator<Item = usize> + '_ {
        self.pairs(p, 0)
    }

    /// Pairs in which it is the first, ascending.
    pub(super) fn first(&self, p: usize) -> impl Iterator<Item = usize> + '_ {
        self.pairs(p, 1)
    }

    fn pairs(&self, p: usize, kind: usize) -> impl Iterator<Item = usize> + '_ {
        let places = &self.places[p][KINDS[kind].clone()];
        let others = self.others(places[places.len() - 1]).unwrap_or_default();
        let own = places.iter().filter(|&&slot| slot < self.nobody);
        own.chain(others).map(|slot| (slot / NUMBERS) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wall(particle: u32) -> WallPair {
        WallPair {
            particle,
            wall: 0,
            side: 1.0,
        }
    }

    /// What each particle finds, and what it should, by the kind of its pairs.
    fn assert_all_are_found(whose: &Whose, particles: usize, pairs: &[[u32; 2]]) {
        for p in 0..particles {
            let of = |body: usize| {
                let pairs = pairs.iter().enumerate();
                let found = pairs.filter(move |(_, pair)| pair[body] as usize == p);
                found.map(|(k, _)| k).collect::<Vec<_>>()
            };
            assert_eq!(whose.second(p).collect::<Vec<_>>(), of(1), "{p}");
            assert_eq!(whose.first(p).collect::<Vec<_>>(), of(0), "{p}");
        }
    }

    #[test]
    fn everybody_finds_all_of_theirs_in_order() {
        let pairs = [[0, 1], [0, 3], [1, 1], [1, 3], [2, 3]];
        let mut whose = Whose::default();
        whose.note(4, &pairs, &[wall(1), wall(3), wall(3)]);
        assert_all_are_found(&whose, 4, &pairs);
        assert_eq!(whose.places()[3], [4, 12, 16, 32, 32, 32, 32, 32, 32, 32]);
        let at_walls: Vec<Range<usize>> = (0..4).map(|p| whose.at_walls(p)).collect();
        assert_eq!(at_walls, [5..5, 5..6, 6..6, 6..8]);
        whose.note(4, &pairs[..1], &[]);
        assert_all_are_found(&whose, 4, &pairs[..1]);
        assert_eq!((whose.at_walls(3), whose.meet_walls()), (0..0, false));
    }

    #[test]
    fn who_has_more_contacts_than_places_finds_them_elsewhere() {
        // Particle 5 is the second body of 5 pairs, 6 of 6, 7 of 7; 0 is the first of 9.
        let mut pairs: Vec<[u32; 2]> = (0..5).map(|i| [i, 5]).collect();
        pairs.extend((0..6).map(|i| [i, 6]));
        pairs.extend((0..7).map(|i| [i, 7]));
        pairs.extend((8..14).map(|j| [0, j]));
        pairs.sort_unstable();
        let mut whose = Whose::default();
        whose.note(14, &pairs, &[]);
        assert_all_are_found(&whose, 14, &pairs);
        let others = |p: usize, place: usize| whose.others(whose.places()[p][place]);
        assert_eq!([others(5, 4), others(1, 9)], [None; 2]);
        assert_eq!(others(6, 4).map(<[u32]>::len), Some(2));
        assert_eq!(others(7, 4).map(<[u32]>::len), Some(3));
        assert_eq!(others(0, 9).map(<[u32]>::len), Some(5));
    }
}
