//! How wide the halo is where: square tiles over the assembly, each with a width of its own.
//!
//! Where all fall together, or lie, hardly anybody comes nearer to anybody; where what falls meets what
//! lies they do, and only there neighbours must be listed from afar.

use serde::{Deserialize, Serialize};

use crate::engine::extent::Extent;

/// A tile is at least so many mean radii wide: narrow enough to tell a front from what is before and behind
/// it. Where 100 000 discs rain, 9 were slower than 12, and 15 no faster.
const WIDE: f64 = 12.0;

/// Particles of tiles that do not touch are at least so many mean radii from touching: no halo is wider.
const APART: f64 = 8.0;

/// Fewer tiles than this tell nothing from anything.
const FEWEST: usize = 25;

/// There is a tile for so many particles at most: assemblies that fly apart get larger ones.
pub(super) const IN_A_TILE: usize = 8;

/// Tiles are wider than they must be by this share, more than rounding can move a centre.
const SPARE: f64 = 1e-6;

/// Tiles, row by row, and their halos.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(in crate::engine) struct Halos {
    low: [f64; 2],
    /// Tiles per metre.
    per_metre: f64,
    columns: usize,
    rows: usize,
    /// Of each tile [m].
    widths: Vec<f64>,
    /// Of all particles, the mean [m].
    mean: f64,
    /// That of walls [m].
    wall: f64,
    /// Two particles of tiles that do not touch are further from touching than this [m].
    apart: f64,
}

impl Default for Halos {
    /// Of no list yet: it is taken and put back each time, and asks for no memory.
    fn default() -> Self {
        Self {
            low: [0.0; 2],
            per_metre: 0.0,
            columns: 1,
            rows: 1,
            widths: Vec::new(),
            mean: 0.0,
            wall: 0.0,
            apart: f64::INFINITY,
        }
    }
}

impl Halos {
    /// The same halo [m] everywhere.
    #[cfg(test)]
    pub(super) fn everywhere(tol: f64) -> Self {
        let mut halos = Self::default();
        halos.be_one(tol);
        halos
    }

    /// Makes it the same [m] everywhere.
    pub(super) fn be_one(&mut self, tol: f64) {
        (self.low, self.per_metre, self.apart) = ([0.0; 2], 0.0, f64::INFINITY);
        self.begin([1, 1], tol);
    }

    /// Lays tiles over an assembly of so many particles with this largest and this mean radius [m], each
    /// with this halo [m]: only one if more would be of no use.
    pub(super) fn lay(
        &mut self,
        extent: &Extent,
        (particles, [largest, mean]): (usize, [f64; 2]),
        tol: f64,
    ) {
        let size = extent.size();
        let fits = |x: f64| x.is_finite() && x > 0.0;
        let mut width = (WIDE * mean).max(2.0 * largest + APART * mean) * (1.0 + SPARE);
        if !fits(width) || !size.into_iter().all(fits) {
            return self.be_one(tol);
        }
        let tiles = |width: f64| size.map(|size| ((size / width) as usize).saturating_add(1));
        let count = |[columns, rows]: [usize; 2]| columns.saturating_mul(rows);
        while count(tiles(width)) > particles.div_ceil(IN_A_TILE).max(FEWEST) {
            width *= 1.25;
        }
        let tiles = tiles(width);
        if count(tiles) < FEWEST {
            return self.be_one(tol);
        }
        (self.low, self.per_metre) = (extent.low, 1.0 / width);
        self.apart = width / (1.0 + SPARE) - 2.0 * largest;
        self.begin(tiles, tol);
    }

    fn begin(&mut self, [columns, rows]: [usize; 2], tol: f64) {
        (self.columns, self.rows) = (columns, rows);
        self.widths.clear();
        self.widths.resize(columns * rows, tol);
        (self.mean, self.wall) = (tol, tol);
    }

    /// Whether it is the same everywhere.
    pub(super) fn is_one(&self) -> bool {
        self.widths.len() <= 1
    }

    /// The tile of a place; one outside counts as in the nearest.
    #[inline(always)]
    pub(super) fn tile(&self, x: [f64; 2]) -> u32 {
        // A float below zero becomes zero.
        let along = |k: usize, count: usize| {
            (((x[k] - self.low[k]) * self.per_metre) as usize).min(count - 1)
        };
        (along(1, self.rows) * self.columns + along(0, self.columns)) as u32
    }

    /// Halo of a tile [m].
    #[inline(always)]
    pub(super) fn of(&self, tile: u32) -> f64 {
        self.widths[tile as usize]
    }

    /// Halos of all tiles [m].
    pub(super) fn widths(&self) -> &[f64] {
        &self.widths
    }

    /// The halo, averaged over the particles [m].
    pub(in crate::engine) fn mean(&self) -> f64 {
        self.mean
    }

    /// Halo of walls [m].
    pub(super) fn wall(&self) -> f64 {
        self.wall
    }

    /// Two particles of tiles that do not touch are further from touching than this [m].
    pub(super) fn apart(&self) -> f64 {
        self.apart
    }

    /// Makes those of the tiles so many times what is wanted [m], and none wider than is of use.
    pub(super) fn widen(&mut self, wanted: &[f64], share: f64) {
        for (width, wanted) in self.widths.iter_mut().zip(wanted) {
            *width = (share * wanted).min(self.apart);
        }
    }

    /// Of all particles, the mean is this [m].
    pub(super) fn set_mean(&mut self, mean: f64) {
        self.mean = mean;
    }

    /// The same of walls, not below the mean; as it is if nothing is wanted.
    pub(super) fn widen_wall(&mut self, wanted: f64, share: f64) {
        if wanted > 0.0 {
            self.wall = (share * wanted).min(self.apart).max(self.mean);
        }
    }

    /// Joins what each tile has with what the eight around it have. `buffer` is one.
    pub(super) fn around<T: Copy>(
        &self,
        tiles: &mut [T],
        buffer: &mut Vec<T>,
        join: impl Fn(T, T) -> T,
    ) {
        let columns = self.columns;
        buffer.clear();
        for row in tiles.chunks_exact(columns) {
            // Each with the one before it, and then with the one after.
            let mut before = row[0];
            for (k, &tile) in row.iter().enumerate() {
                let after = row.get(k + 1).map_or(tile, |after| *after);
                buffer.push(join(join(before, tile), after));
                before = tile;
            }
        }
        tiles.copy_from_slice(buffer);
        let joined = |tiles: &mut [T], others: &[T]| {
            for (tile, other) in tiles.iter_mut().zip(others) {
                *tile = join(*tile, *other);
            }
        };
        joined(tiles, &buffer[columns..]);
        joined(&mut tiles[columns..], buffer);
    }

    /// Whether there is one of each tile.
    pub(super) fn fit(&self) -> bool {
        self.columns > 0
            && self.rows > 0
            && self.columns.checked_mul(self.rows) == Some(self.widths.len())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn over(extent: &Extent, radii: [f64; 2]) -> Halos {
        let mut halos = Halos::everywhere(0.1);
        halos.lay(extent, (1000, radii), 0.5);
        halos
    }

    fn tiles() -> Halos {
        let extent = Extent {
            low: [-20.0, 5.0],
            high: [40.0, 130.0],
        };
        over(&extent, [1.25, 1.0])
    }

    #[test]
    fn few_tiles_are_one() {
        assert_eq!((tiles().columns, tiles().rows), (5, 11));
        assert!(!tiles().is_one());
        let small = Extent {
            low: [0.0; 2],
            high: [30.0; 2],
        };
        let one = over(&small, [1.0, 1.0]);
        assert_eq!(one, Halos::everywhere(0.5));
        // A large ball among small ones, and nothing at all.
        assert!(over(&small, [10.0, 1.0]).is_one());
        assert!(over(&Extent::default(), [0.0, f64::NAN]).is_one());
        // One that flew away makes them larger, not many, unless it is nowhere.
        let with = |x: f64| {
            let mut extent = small;
            extent.high[0] = x;
            over(&extent, [1.0, 1.0])
        };
        assert!((FEWEST..=125).contains(&with(1e6).widths.len()));
        assert!((FEWEST..=125).contains(&with(1e300).widths.len()));
        assert!(with(f64::INFINITY).is_one());
    }

    proptest! {
        #[test]
        fn tiles_that_do_not_touch_are_apart(
            a in [-20.0..40.0f64, 5.0..130.0f64],
            b in [-20.0..40.0f64, 5.0..130.0f64],
        ) {
            let tiles = tiles();
            let place = |x: [f64; 2]| {
                let tile = tiles.tile(x) as usize;
                [tile % tiles.columns, tile / tiles.columns]
            };
            let (one, other) = (place(a), place(b));
            if (0..2).any(|k| one[k].abs_diff(other[k]) > 1) {
                let [d1, d2] = [0, 1].map(|k| b[k] - a[k]);
                prop_assert!(libm::hypot(d1, d2) - 2.0 * 1.25 > tiles.apart());
            }
        }

        #[test]
        fn the_eight_around_are_joined(numbers in prop::collection::vec(0..1000u32, 55)) {
            let tiles = tiles();
            let mut joined = numbers.clone();
            tiles.around(&mut joined, &mut Vec::new(), u32::max);
            for (k, most) in joined.into_iter().enumerate() {
                let [x, y] = [k % 5, k / 5];
                let near = |n: &usize| (n % 5).abs_diff(x) <= 1 && (n / 5).abs_diff(y) <= 1;
                let all = (0..55).filter(near).map(|n| numbers[n]).max();
                prop_assert_eq!(Some(most), all);
            }
        }
    }
}
