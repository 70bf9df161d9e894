//! What is known of the tiles that halos differ by: how their particles have moved, and what of the halos
//! is spent.

use super::blocks::Member;
use super::halos::Halos;
use crate::engine::extent::Extent;
use crate::engine::lanes::Lanes;

/// Numbers of each tile. Buffers are kept between lists.
#[derive(Debug, Default)]
pub(super) struct Tiles {
    particles: Vec<u32>,
    /// Box around the ways of those in it and in the tiles around it [m].
    ways: Vec<Extent>,
    /// By how much any of those in it can have come nearer to others [m].
    nearer: Vec<f64>,
    /// What its halo should be like [m].
    wanted: Vec<f64>,
    /// Whether its halo, or that of a tile beside it, may be spent.
    doubtful: Vec<bool>,
    /// Box around all ways [m].
    all: Extent,
    buffers: (Vec<Extent>, Vec<f64>, Vec<bool>),
}

impl Tiles {
    /// Bytes of each.
    pub(super) const BYTES: usize =
        size_of::<u32>() + 2 * size_of::<Extent>() + 4 * size_of::<f64>() + 2;

    /// There are so many, with nobody in them.
    pub(super) fn begin(&mut self, count: usize) {
        self.particles.clear();
        self.particles.resize(count, 0);
    }

    /// A particle is in this one.
    #[inline(always)]
    pub(super) fn enter(&mut self, tile: u32) {
        self.particles[tile as usize] += 1;
    }

    /// Looks by how much any in each can have come nearer to others: blocks went these ways [m], and have
    /// members in them.
    pub(super) fn look(&mut self, halos: &Halos, blocks: &[Extent], members: &[Member]) {
        let nowhere = Extent::default();
        self.all = blocks.iter().fold(nowhere, |all, way| all.and(*way));
        self.ways.clear();
        self.ways.resize(self.particles.len(), nowhere);
        for member in members {
            let way = &mut self.ways[member.tile as usize];
            *way = way.and(blocks[member.block as usize]);
        }
        halos.around(&mut self.ways, &mut self.buffers.0, Extent::and);
        self.nearer.clear();
        let nearer = self.ways.iter().zip(&self.particles).map(|(way, count)| {
            // Where nobody is, nobody comes nearer.
            if *count == 0 { 0.0 } else { diagonal(way) }
        });
        self.nearer.extend(nearer);
    }

    /// How near any came, and how near they may [m]: those of each tile, of tiles that do not touch, and to
    /// walls, which went so far.
    fn limits(&self, halos: &Halos, wall: f64) -> impl Iterator<Item = (f64, f64)> {
        let of_all = (diagonal(&self.all), halos.apart());
        let at_walls = (self.furthest() + wall, halos.wall());
        let of_tiles = self.nearer.iter().copied();
        let of_tiles = of_tiles.zip(halos.widths().iter().copied());
        of_tiles.chain([of_all, at_walls])
    }

    /// The largest share of a halo that is spent, as far as was looked; walls went so far [m].
    pub(super) fn spent(&self, halos: &Halos, wall: f64) -> f64 {
        let spent = self.limits(halos, wall).map(|(near, halo)| near / halo);
        spent.fold(0.0, |most, next| next.larger(most))
    }

    /// The least that is left of a halo [m]; walls went so far [m].
    pub(super) fn left(&self, halos: &Halos, wall: f64) -> f64 {
        let left = self.limits(halos, wall).map(|(near, halo)| halo - near);
        left.fold(f64::INFINITY, |least, next| next.smaller(least))
    }

    /// What halos should be like: as wide as ways are long, there or in the tiles around, since what moves
    /// is there soon, and none less than a share of the widest. Answers the mean of all particles [m].
    pub(super) fn want(&mut self, halos: &Halos, share: f64) -> f64 {
        self.wanted.clone_from(&self.nearer);
        halos.around(&mut self.wanted, &mut self.buffers.1, f64::max);
        let least = share * self.wanted.iter().copied().fold(0.0, f64::max);
        for wanted in &mut self.wanted {
            *wanted = wanted.max(least);
        }
        self.mean(&self.wanted)
    }

    /// Makes the halos so many times what is [wanted](Self::want), and that of walls so many times what
    /// particles and walls went, and half of it more.
    pub(super) fn widen(&self, halos: &mut Halos, share: f64, wall: f64) {
        // Infinite where nothing has moved yet: the halos stay as they are.
        if share.is_finite() {
            halos.widen(&self.wanted, share);
            let mean = self.mean(halos.widths());
            halos.set_mean(mean);
        }
        halos.widen_wall(AT_WALLS * (self.furthest() + wall), share);
    }

    /// Notes where halos may be spent; false if it is none of a tile.
    pub(super) fn doubt(&mut self, halos: &Halos) -> bool {
        let of_tiles = self.nearer.iter().zip(halos.widths());
        self.doubtful.clear();
        (self.doubtful).extend(of_tiles.map(|(nearer, halo)| nearer >= halo));
        let any = self.doubtful.contains(&true);
        halos.around(&mut self.doubtful, &mut self.buffers.2, |a, b| a | b);
        any
    }

    /// Whether the halo of this one, or of one beside it, may be spent.
    pub(super) fn is_doubtful(&self, tile: u32) -> bool {
        self.doubtful[tile as usize]
    }

    /// Of something of each tile, one particle with another.
    fn mean(&self, tiles: &[f64]) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (value, particles) in tiles.iter().zip(&self.particles) {
            sum += value * f64::from(*particles);
            count += f64::from(*particles);
        }
        sum / count
    }

    /// No particle went further [m].
    fn furthest(&self) -> f64 {
        let Extent { low, high } = self.all;
        let [d1, d2] = [0, 1].map(|k| (-low[k]).larger(high[k]).larger(0.0));
        (d1 * d1 + d2 * d2).sqrt()
    }
}

/// The halo of walls is so many times as wide as it must be if all goes on as it does, since what falls
/// gets faster; few are near walls, so that a wide one costs little.
const AT_WALLS: f64 = 1.5;

/// Of a box [m]; that around nothing has none.
#[inline(always)]
fn diagonal(around: &Extent) -> f64 {
    let [width, height] = around.size().map(|size| size.larger(0.0));
    (width * width + height * height).sqrt()
}
