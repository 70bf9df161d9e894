//! How blocks of particles have moved since the list was made, and who may have come nearer by what.
//!
//! A block is a few particles of neighbouring numbers, who are, as a rule, neighbours in place, too. A box
//! around their ways grows cycle by cycle with their velocities; where that outgrows a halo, ways are
//! worked out. Nobody in a tile has come nearer to anybody there or in the tiles around than by the
//! diagonal of the box around all their ways.

use serde::{Deserialize, Serialize};

use super::halos::{Halos, IN_A_TILE};
use super::tiles::Tiles;
use crate::engine::extent::Extent;
use crate::engine::particles::Row;
use crate::engine::threads::Threads;

/// Particles of a block: as few as lie in a tile where they fall thinly. Where 100 000 discs rain lists of
/// blocks of 64 and 32 lasted 16 and 23 cycles, those of 16 lasted 28.
pub(in crate::engine) const BLOCK: usize = 16;

/// Blocks are of no use if they are in more tiles than this, one with another.
const TILES: usize = 8;

/// A list goes on until this share of a halo is spent: to work ways out is cheap where few are in doubt.
const SPENT: f64 = 0.97;

/// A halo is at least a share of the widest between these, for what nobody foresees. Where discs rain a
/// front comes to tiles that were at rest: .03 to .15 made no difference beyond noise.
const LEAST: [f64; 2] = [0.06, 1.0];

/// The least share grows by the first factor when a list ends with less than the second of the mean halo
/// spent: one place ended it that nobody foresaw. Where all goes as foreseen .75 to 1.08 are spent, at a
/// surprise .2 to .4.
const GROWS: [f64; 2] = [2.0, 0.4];

/// It shrinks by the first factor when a list ends with more than the second of the mean halo spent.
const SHRINKS: [f64; 2] = [0.8, 0.7];

/// Ways of blocks; none where the halo is the same everywhere.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(in crate::engine) struct Blocks {
    /// Box around the ways of the particles of each [m].
    ways: Vec<Extent>,
    /// Two particles, or one and a wall, may still come nearer by this, whoever they are [m].
    left: f64,
    /// Particles moved in a way that the boxes do not know of.
    lost: bool,
    /// Least halo as a share of the widest, as earlier lists would have needed it.
    learnt: f64,
    #[serde(skip)]
    members: Vec<Member>,
    #[serde(skip)]
    tiles: Tiles,
    /// Whether the tiles know of all ways.
    #[serde(skip)]
    looked: bool,
    /// Blocks that are to be looked at: a buffer.
    #[serde(skip)]
    doubtful: Vec<bool>,
}

/// A block that has particles in a tile.
#[derive(Debug, Clone, Copy)]
pub(super) struct Member {
    pub(super) tile: u32,
    pub(super) block: u32,
}

/// What ways are measured between: where particles are, and where they were when the list was made.
#[derive(Clone, Copy)]
pub(super) struct Moved<'a> {
    rows: &'a [Row],
    reference: &'a [[f64; 2]],
    threads: &'a Threads,
}

impl<'a> Moved<'a> {
    pub(super) fn new(rows: &'a [Row], reference: &'a [[f64; 2]], threads: &'a Threads) -> Self {
        Self {
            rows,
            reference,
            threads,
        }
    }
}

impl Blocks {
    /// Bytes per particle, at most, tiles included.
    pub(super) const BYTES: usize = (size_of::<Extent>() + TILES * size_of::<Member>())
        .div_ceil(BLOCK)
        + Tiles::BYTES / IN_A_TILE;

    /// Whether there are any.
    pub(super) fn are_there(&self) -> bool {
        !self.ways.is_empty()
    }

    /// A list is to be made of particles that stand here [m]: widens the halos where ways since the last
    /// one were long; walls have gone so far [m]. If blocks are of no use, the halo becomes one.
    pub(super) fn begin(&mut self, centres: &[[f64; 2]], halos: &mut Halos, wall: f64) {
        if halos.is_one() || !self.note_members(centres, halos) {
            halos.be_one(halos.mean());
            return self.ways.clear();
        }
        let none = Extent::of([0.0; 2]);
        self.ways.resize(centres.len().div_ceil(BLOCK), none);
        self.look(halos);
        let share = halos.mean() / self.want(halos);
        self.tiles.widen(halos, share, wall);
        self.ways.fill(none);
        (self.left, self.lost) = (0.0, false);
    }

    /// A list with these halos is done with: the next one is made with what was seen of it. Walls have gone
    /// so far [m].
    pub(super) fn learn(&mut self, halos: &Halos, wall: f64) {
        if !self.are_there() {
            return;
        }
        // Ways may have grown since, or come from a checkpoint: what is learnt must not depend on when
        // somebody looked.
        if !self.looked {
            self.look(halos);
        }
        if !self.is_spent(halos, wall) {
            return;
        }
        let (spent, [least, most]) = (self.want(halos) / halos.mean(), LEAST);
        // Where all halos are alike, as in the first list, it is no surprise that one place ends it.
        let widths = halos.widths();
        let differ = widths.iter().any(|width| *width != widths[0]);
        if differ && spent < GROWS[1] {
            self.learnt = (self.least() * GROWS[0]).min(most);
        } else if spent > SHRINKS[1] {
            self.learnt = (self.least() * SHRINKS[0]).max(least);
        }
    }

    /// Share of the widest halo that each has at least.
    fn least(&self) -> f64 {
        self.learnt.max(LEAST[0])
    }

    /// After reading a checkpoint. False if they are not those of a list that was made of particles that
    /// stood here [m].
    #[must_use]
    pub(super) fn unpack(&mut self, centres: &[[f64; 2]], halos: &Halos) -> bool {
        if !self.are_there() {
            return halos.is_one();
        }
        self.ways.len() == centres.len().div_ceil(BLOCK)
            && !halos.is_one()
            && self.note_members(centres, halos)
    }

    /// Notes which blocks have particles in which tiles. False if that is of no use.
    fn note_members(&mut self, centres: &[[f64; 2]], halos: &Halos) -> bool {
        let most = TILES * centres.len().div_ceil(BLOCK);
        let members = &mut self.members;
        members.clear();
        members.reserve(most + BLOCK);
        self.tiles.begin(halos.widths().len());
        for (block, centres) in (0..).zip(centres.chunks(BLOCK)) {
            let first = members.len();
            for x in centres {
                let tile = halos.tile(*x);
                self.tiles.enter(tile);
                if members[first..].iter().all(|member| member.tile != tile) {
                    members.push(Member { tile, block });
                }
            }
            if members.len() > most {
                return false;
            }
        }
        true
    }

    /// The boxes, for whoever moves particles and makes them [go on](go_on).
    pub(in crate::engine) fn take(&mut self) -> Vec<Extent> {
        self.looked = false;
        std::mem::take(&mut self.ways)
    }

    /// Takes them back.
    pub(in crate::engine) fn give_back(&mut self, ways: Vec<Extent>) {
        self.ways = ways;
    }

    /// In one more cycle nobody came nearer to anybody or to a wall by more than this [m].
    pub(super) fn come_nearer(&mut self, by: f64) {
        self.left -= by;
    }

    /// Particles moved in a way that the boxes do not know of.
    pub(super) fn lose(&mut self) {
        self.lost = true;
    }

    /// Whether all who can touch are listed for certain. Ways are worked out where the boxes leave it open;
    /// walls have gone so far [m].
    pub(super) fn last(&mut self, halos: &Halos, wall: f64, moved: Moved<'_>) -> bool {
        if self.lost {
            return false;
        }
        if self.left > 0.0 {
            return true;
        }
        self.look(halos);
        if self.tiles.spent(halos, wall) >= 1.0 {
            self.measure_doubtful(halos, moved);
            if self.is_spent(halos, wall) {
                return false;
            }
        }
        self.left = self.tiles.left(halos, wall);
        true
    }

    /// Whether, as far as was looked, nearly all of a halo is spent; walls have gone so far [m].
    pub(super) fn is_spent(&self, halos: &Halos, wall: f64) -> bool {
        self.lost || self.tiles.spent(halos, wall) >= SPENT
    }

    /// By how much particles came nearer to others, as far as was looked, by what halos should be like: the
    /// mean [m].
    pub(super) fn want(&mut self, halos: &Halos) -> f64 {
        self.tiles.want(halos, self.least())
    }

    /// Works the ways of all out.
    pub(super) fn measure_all(&mut self, halos: &Halos, moved: Moved<'_>) {
        measure(&mut self.ways, moved, |_| true);
        self.look(halos);
    }

    /// Works out the ways of blocks that have to do with a halo that may be spent.
    fn measure_doubtful(&mut self, halos: &Halos, moved: Moved<'_>) {
        // If it is that of no tile, it is one that all have to do with.
        let all = !self.tiles.doubt(halos);
        self.doubtful.clear();
        self.doubtful.resize(self.ways.len(), all);
        for member in &self.members {
            self.doubtful[member.block as usize] |= self.tiles.is_doubtful(member.tile);
        }
        measure(&mut self.ways, moved, |block| self.doubtful[block]);
        self.look(halos);
    }

    fn look(&mut self, halos: &Halos) {
        self.looked = true;
        self.tiles.look(halos, &self.ways, &self.members);
    }
}

/// Works out the ways of chosen blocks.
fn measure(ways: &mut [Extent], moved: Moved<'_>, chosen: impl Fn(usize) -> bool + Sync) {
    let Moved {
        rows,
        reference,
        threads,
    } = moved;
    threads.each(ways, |first, ways| {
        let of = |block: usize| block * BLOCK..rows.len().min((block + 1) * BLOCK);
        for (block, way) in (first..).zip(ways).filter(|(block, _)| chosen(*block)) {
            *way = Extent::default();
            for (row, old) in rows[of(block)].iter().zip(&reference[of(block)]) {
                way.take_in([row.x[0] - old[0], row.x[1] - old[1]]);
            }
        }
    });
}

/// Makes the boxes of blocks grow by what their particles go in a time [s].
#[inline(always)]
pub(in crate::engine) fn go_on(ways: &mut [Extent], rows: &[Row], dt: f64) {
    for (way, rows) in ways.iter_mut().zip(rows.chunks(BLOCK)) {
        let mut velocities = Extent::default();
        for row in rows {
            velocities.take_in(row.v);
        }
        for k in 0..2 {
            way.low[k] += velocities.low[k] * dt;
            way.high[k] += velocities.high[k] * dt;
        }
    }
}

#[cfg(test)]
mod tests;
