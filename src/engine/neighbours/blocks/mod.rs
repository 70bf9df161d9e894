//! How blocks of particles have moved since the list was made, and who may have come nearer by what.
//!
//! A block is a few particles of neighbouring numbers, who are, as a rule, neighbours in place, too. A box
//! around their ways grows cycle by cycle with their velocities; where that outgrows a halo, ways are
//! worked out. Nobody in a tile has come nearer to anybody there or in the tiles around than by the
//! diagonal of the box around all their ways.

use serde::{Deserialize, Serialize};

use super::halos::{Halos, IN_A_TILE};
use crate::engine::extent::Extent;
use crate::engine::lanes::Lanes;
use crate::engine::particles::Row;
use crate::engine::threads::Threads;

/// Particles of a block: as few as lie in a tile where they fall thinly.
pub(in crate::engine) const BLOCK: usize = 16;

/// Blocks are of no use if they are in more tiles than this, one with another.
const TILES: usize = 8;

/// A list goes on until this share of a halo is spent.
const SPENT: f64 = 0.97;

/// A halo is at least a share of the widest between these, for what nobody foresees.
const LEAST: [f64; 2] = [0.06, 1.0];

/// That share grows by the first factor if, one particle with another, less than the second of a halo is spent
/// when a list ends, as one place ended it that nobody foresaw, and shrinks by the third above the fourth.
const GROWS: [f64; 2] = [2.0, 0.4];
const SHRINKS: [f64; 2] = [0.8, 0.7];

/// The halo of walls is so many times as wide as it must be if all goes on as it does: few are near walls.
const AT_WALLS: f64 = 1.5;

/// Ways of blocks; none where the halo is the same everywhere.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(in crate::engine) struct Blocks {
    /// Box around the ways of the particles of each [m].
    ways: Vec<Extent>,
    /// Two particles, or one and a wall, may still come nearer by this, whoever they are [m].
    left: f64,
    /// Particles moved in a way that the boxes do not know of.
    lost: bool,
    /// Share of the widest halo that any has at least.
    least: Share,
    #[serde(skip)]
    members: Vec<Member>,
    #[serde(skip)]
    tiles: Tiles,
}

/// A number between the two of [`LEAST`].
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
struct Share(f64);

impl Default for Share {
    fn default() -> Self {
        Self(LEAST[0])
    }
}

/// A block that has particles in a tile.
#[derive(Debug, Clone, Copy)]
struct Member {
    tile: u32,
    block: u32,
}

/// What is known of each tile, and buffers.
#[derive(Debug, Default)]
struct Tiles {
    particles: Vec<u32>,
    /// Box around the ways of those in it and in the tiles around it [m].
    ways: Vec<Extent>,
    /// By how much any of those in it can have come nearer to others [m].
    nearer: Vec<f64>,
    /// What its halo should be like [m].
    wanted: Vec<f64>,
    /// Whether its halo may be spent, and whether a block has to do with that.
    doubtful: Vec<bool>,
    doubtful_blocks: Vec<bool>,
    /// Box around all ways [m].
    all: Extent,
    buffers: (Vec<Extent>, Vec<f64>, Vec<bool>),
}

/// What ways are measured between: where particles are, and where they were when the list was made.
#[derive(Clone, Copy)]
pub(super) struct Moved<'a> {
    pub(super) rows: &'a [Row],
    pub(super) reference: &'a [[f64; 2]],
    pub(super) threads: &'a Threads,
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

    /// Does without any.
    pub(super) fn dissolve(&mut self) {
        self.ways.clear();
        self.members.clear();
    }

    /// A list is to be made of particles that stand here [m]: widens the halos where ways since the last
    /// one were long; walls have gone so far [m]. If blocks are of no use, the halo becomes one.
    pub(super) fn begin(&mut self, centres: &[[f64; 2]], halos: &mut Halos, wall: f64) {
        if halos.is_one() || !self.note_members(centres, halos) {
            halos.be_one(halos.mean());
            return self.dissolve();
        }
        let none = Extent::of([0.0; 2]);
        self.ways.resize(centres.len().div_ceil(BLOCK), none);
        self.look(halos);
        let all = self.tiles.all;
        let share = halos.mean() / self.want(halos);
        let at_wall = AT_WALLS * (furthest(&all) + wall);
        halos.widen(&self.tiles.wanted, &self.tiles.particles, at_wall, share);
        self.ways.fill(none);
        (self.left, self.lost) = (0.0, false);
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
        let (members, particles) = (&mut self.members, &mut self.tiles.particles);
        members.clear();
        members.reserve(most + BLOCK);
        particles.clear();
        particles.resize(halos.widths().len(), 0);
        for (block, centres) in (0..).zip(centres.chunks(BLOCK)) {
            let first = members.len();
            for x in centres {
                let tile = halos.tile(*x);
                particles[tile as usize] += 1;
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
        if self.lost || self.left > 0.0 {
            return !self.lost;
        }
        self.look(halos);
        if self.spent(halos, wall) >= 1.0 {
            self.doubt(halos);
            let doubtful = std::mem::take(&mut self.tiles.doubtful_blocks);
            self.measure(moved, |block| doubtful[block]);
            self.tiles.doubtful_blocks = doubtful;
            self.look(halos);
            if self.is_spent(halos, wall) {
                return false;
            }
        }
        self.left = self.room(halos, wall);
        true
    }

    /// Works the ways of all out.
    pub(super) fn measure_all(&mut self, halos: &Halos, moved: Moved<'_>) {
        self.measure(moved, |_| true);
        self.look(halos);
    }

    /// After all was worked out: by how much particles came nearer to others, by what halos should be like,
    /// the mean [m]. If a list ends here, the next one is made with what was learnt of it; walls have gone so
    /// far [m].
    pub(super) fn spending(&mut self, halos: &Halos, wall: f64) -> f64 {
        let nearer = self.want(halos);
        if self.is_spent(halos, wall) {
            let (spent, [least, most]) = (nearer / halos.mean(), LEAST);
            if spent < GROWS[1] {
                self.least.0 = (self.least.0 * GROWS[0]).min(most);
            } else if spent > SHRINKS[1] {
                self.least.0 = (self.least.0 * SHRINKS[0]).max(least);
            }
        }
        nearer
    }

    /// Whether, as far as was looked, nearly all of a halo is spent; walls have gone so far [m].
    pub(super) fn is_spent(&self, halos: &Halos, wall: f64) -> bool {
        self.lost || self.spent(halos, wall) >= SPENT
    }

    /// The largest share of a halo that is spent.
    fn spent(&self, halos: &Halos, wall: f64) -> f64 {
        let Tiles { nearer, all, .. } = &self.tiles;
        let of_all = diagonal(all) / halos.apart();
        let at_walls = (furthest(all) + wall) / halos.wall();
        let of_tiles = nearer.iter().zip(halos.widths());
        of_tiles
            .map(|(nearer, halo)| nearer / halo)
            .fold(of_all.larger(at_walls), |most, next| next.larger(most))
    }

    /// The least that is left of a halo [m].
    fn room(&self, halos: &Halos, wall: f64) -> f64 {
        let Tiles { nearer, all, .. } = &self.tiles;
        let of_all = halos.apart() - diagonal(all);
        let at_walls = halos.wall() - furthest(all) - wall;
        let of_tiles = nearer.iter().zip(halos.widths());
        of_tiles
            .map(|(nearer, halo)| halo - nearer)
            .fold(of_all.smaller(at_walls), |least, next| next.smaller(least))
    }

    /// Looks by how much any in each tile can have come nearer to others.
    fn look(&mut self, halos: &Halos) {
        let Tiles {
            particles,
            ways,
            nearer,
            all,
            buffers,
            ..
        } = &mut self.tiles;
        *all = (self.ways.iter()).fold(Extent::default(), |all, way| all.and(*way));
        ways.clear();
        ways.resize(particles.len(), Extent::default());
        for &Member { tile, block } in &self.members {
            let way = &mut ways[tile as usize];
            *way = way.and(self.ways[block as usize]);
        }
        halos.around(ways, &mut buffers.0, Extent::and);
        nearer.clear();
        nearer.extend(ways.iter().zip(particles).map(|(way, particles)| {
            // Where nobody is, nobody comes nearer.
            if *particles == 0 { 0.0 } else { diagonal(way) }
        }));
    }

    /// What halos should be like: as wide as ways are long, there or in the tiles around, since what moves
    /// is there soon. Answers the mean of all particles [m].
    fn want(&mut self, halos: &Halos) -> f64 {
        let Tiles {
            particles,
            nearer,
            wanted,
            buffers,
            ..
        } = &mut self.tiles;
        wanted.clone_from(nearer);
        halos.around(wanted, &mut buffers.1, f64::max);
        let least = self.least.0 * wanted.iter().copied().fold(0.0, f64::max);
        for wanted in &mut *wanted {
            *wanted = wanted.max(least);
        }
        mean(wanted, particles)
    }

    /// Notes the blocks that have to do with a halo that may be spent.
    fn doubt(&mut self, halos: &Halos) {
        let Tiles {
            nearer,
            doubtful,
            doubtful_blocks,
            buffers,
            ..
        } = &mut self.tiles;
        doubtful.clear();
        let of_tiles = nearer.iter().zip(halos.widths());
        doubtful.extend(of_tiles.map(|(nearer, halo)| nearer >= halo));
        // If it is none of a tile, it is one that all have to do with.
        let all = !doubtful.contains(&true);
        halos.around(doubtful, &mut buffers.2, |one, other| one | other);
        doubtful_blocks.clear();
        doubtful_blocks.resize(self.ways.len(), all);
        for &Member { tile, block } in &self.members {
            doubtful_blocks[block as usize] |= doubtful[tile as usize];
        }
    }

    /// Works the ways of chosen blocks out.
    fn measure(&mut self, moved: Moved<'_>, chosen: impl Fn(usize) -> bool + Sync) {
        let Moved {
            rows,
            reference,
            threads,
        } = moved;
        threads.each(&mut self.ways, |first, ways| {
            let of = |block: usize| block * BLOCK..rows.len().min((block + 1) * BLOCK);
            for (block, way) in (first..).zip(ways).filter(|(block, _)| chosen(*block)) {
                *way = Extent::default();
                for (row, old) in rows[of(block)].iter().zip(&reference[of(block)]) {
                    way.take_in([row.x[0] - old[0], row.x[1] - old[1]]);
                }
            }
        });
    }
}

impl Tiles {
    /// Bytes per tile.
    const BYTES: usize = size_of::<u32>() + 2 * size_of::<Extent>() + 4 * size_of::<f64>() + 2;
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

/// Of all particles, of which there are so many in each tile.
pub(super) fn mean(tiles: &[f64], particles: &[u32]) -> f64 {
    let sum = |all: f64, (value, particles): (&f64, &u32)| all + value * f64::from(*particles);
    let count: u32 = particles.iter().sum();
    tiles.iter().zip(particles).fold(0.0, sum) / f64::from(count)
}

/// Of a box [m]; that around nothing has none.
#[inline(always)]
fn diagonal(around: &Extent) -> f64 {
    let [width, height] = around.size().map(|size| size.larger(0.0));
    (width * width + height * height).sqrt()
}

/// Of the corners of a box around ways, how far the furthest is [m].
fn furthest(around: &Extent) -> f64 {
    let [d1, d2] = [0, 1].map(|k| (-around.low[k]).larger(around.high[k]).larger(0.0));
    (d1 * d1 + d2 * d2).sqrt()
}

#[cfg(test)]
mod tests;
