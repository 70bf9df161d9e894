//! Which contacts are whose: how a particle finds the slots with its forces.
//!
//! In the list the contacts of a particle with higher ones follow each other, and so do those with
//! walls: where they begin is enough. Only those with lower ones are named one by one.

use std::ops::Range;

use crate::engine::wall_contact::WallPair;

/// The contacts of each particle.
#[derive(Debug, Default)]
pub(in crate::engine) struct Whose {
    /// First pair of each particle with a higher one.
    own: Vec<u32>,
    /// First of each particle in `second`.
    starts: Vec<u32>,
    /// Pairs in which the particle is the second body, ascending.
    second: Vec<u32>,
    /// First contact of each particle with a wall; empty without walls.
    walls: Vec<u32>,
}

impl Whose {
    /// Bytes per particle.
    pub(super) const BYTES: usize = 3 * size_of::<u32>();

    /// Notes the contacts of so many particles. `room` is how many memory is kept ready for.
    pub(super) fn note(
        &mut self,
        particles: usize,
        pairs: &[[u32; 2]],
        walls: &[WallPair],
        room: [usize; 2],
    ) {
        begin(
            &mut self.own,
            particles,
            0,
            pairs.iter().map(|pair| pair[0]),
        );
        begin(
            &mut self.starts,
            particles,
            0,
            pairs.iter().map(|pair| pair[1]),
        );
        self.second.clear();
        self.second.reserve(room[0]);
        self.second.resize(pairs.len(), 0);
        for (k, pair) in pairs.iter().enumerate().rev() {
            // Filled from the back: what follows a particle's start moves down to it.
            let next = &mut self.starts[pair[1] as usize + 1];
            *next -= 1;
            self.second[*next as usize] = k as u32;
        }
        // Each start now stands where the next one's was.
        self.starts.rotate_left(1);
        if let Some(last) = self.starts.last_mut() {
            *last = pairs.len() as u32;
        }
        self.walls.clear();
        if !walls.is_empty() {
            let of = walls.iter().map(|wall| wall.particle);
            begin(&mut self.walls, particles, pairs.len(), of);
        }
    }

    /// Pairs in which the particle is the second body.
    #[inline(always)]
    pub(in crate::engine) fn second(&self, p: usize) -> &[u32] {
        &self.second[self.starts[p] as usize..self.starts[p + 1] as usize]
    }

    /// Pairs in which it is the first, and its contacts with walls.
    #[inline(always)]
    pub(in crate::engine) fn first(&self, p: usize) -> [Range<usize>; 2] {
        let own = self.own[p] as usize..self.own[p + 1] as usize;
        if self.walls.is_empty() {
            return [own, 0..0];
        }
        [own, self.walls[p] as usize..self.walls[p + 1] as usize]
    }
}

/// Where the items of each particle begin, counted from `first`, and where the last end.
fn begin(starts: &mut Vec<u32>, particles: usize, first: usize, of: impl Iterator<Item = u32>) {
    starts.clear();
    starts.resize(particles + 1, 0);
    for p in of {
        starts[p as usize + 1] += 1;
    }
    starts[0] = first as u32;
    for p in 1..starts.len() {
        starts[p] += starts[p - 1];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everybody_finds_all_of_theirs_in_order() {
        let pairs = [[0, 1], [0, 3], [1, 1], [1, 3], [2, 3]];
        let wall = |particle| WallPair {
            particle,
            wall: 0,
            side: 1.0,
        };
        let walls = [wall(1), wall(3), wall(3)];
        let mut whose = Whose::default();
        whose.note(4, &pairs, &walls, [8, 4]);
        let second: Vec<&[u32]> = (0..4).map(|p| whose.second(p)).collect();
        assert_eq!(second, [&[][..], &[0, 2], &[], &[1, 3, 4]]);
        let first: Vec<[Range<usize>; 2]> = (0..4).map(|p| whose.first(p)).collect();
        let expected = [[0..2, 5..5], [2..4, 5..6], [4..5, 6..6], [5..5, 6..8]];
        assert_eq!(first, expected);
        whose.note(4, &pairs[..1], &[], [8, 4]);
        assert_eq!(whose.first(3), [1..1, 0..0]);
        assert_eq!(whose.second(1), [0]);
    }
}
