//! Boxes: particles binned by centre, so that only near ones are compared.
//!
//! Particles of like size, within a factor of two or, if all are, a little more, share a level of
//! boxes as high as the largest of them reach and, where there may be as many, a quarter or half as
//! wide. One that looks for neighbours looks at the boxes around it on its own level and on the coarser
//! ones: a ball among sand, or sizes over three decades, cost hardly more than equal ones.

use std::ops::{Range, RangeInclusive};

use super::crop;
use super::halos::Halos;
use super::level::{BOXES_PER_PARTICLE, Level};
use super::members::Members;
use super::near::Near;
use super::spot::{Bounds, Spot};
use crate::engine::lanes::Lanes;
use crate::engine::threads::Threads;

/// Boxes over the extent of the assembly. Buffers are kept between searches.
#[derive(Debug, Default)]
pub(super) struct Grid {
    low: [f64; 2],
    /// What the smallest reach [m]: sizes are counted in doublings of it.
    least: f64,
    tol: f64,
    /// Finest first, only those that somebody is on.
    pub(super) levels: Vec<Level>,
    /// Level of each number of doublings.
    level: [u8; SIZES],
    /// First member of each box, one further on.
    starts: Vec<u32>,
    /// By number.
    spots: Vec<Spot>,
    /// Box by box.
    members: Members,
}

/// More doublings of the size than this share the last level.
const SIZES: usize = 32;

/// All share one level as long as a box as wide as the largest reaches is no larger than so many as wide
/// as they reach in the mean square: larger boxes hold more that is looked at in vain. The graded sample of
/// 3 to 1 has 2.3, and its list is made in a tenth less time on one level than on two.
const ALIKE: f64 = 3.0;

impl Grid {
    /// Bytes per particle: its spot, in two orders, and room for the boxes it may be given.
    pub(super) const BYTES: usize =
        size_of::<Spot>() + Members::BYTES + BOXES_PER_PARTICLE * size_of::<u32>();

    /// Bins so many spots, of which `spot` answers each, in boxes that suit a search for pairs nearer than
    /// `tol` [m].
    pub(super) fn fill(
        &mut self,
        count: usize,
        tol: f64,
        threads: &Threads,
        spot: impl Fn(usize) -> Spot + Sync,
    ) {
        // Boxes and indices, also as numbers in lanes.
        assert!(count < 1 << 30, "too many to number");
        let mut spots = std::mem::take(&mut self.spots);
        spots.resize(count, Spot::default());
        let lay_out = |first: usize, spots: &mut [Spot]| {
            let mut bounds = Bounds::default();
            for (k, place) in spots.iter_mut().enumerate() {
                *place = spot(first + k);
                bounds.take_in(place.x, place.radius);
            }
            bounds
        };
        let bounds = threads.join(&mut spots, Bounds::default(), lay_out, Bounds::and);
        self.starts.clear();
        self.lay(&spots, tol, &bounds);
        threads.each(&mut spots, |_, spots| {
            for spot in spots {
                spot.home = self.home(spot) as u32;
            }
        });
        self.spots = spots;
        let boxes = self.levels.last().map_or(0, Level::end);
        self.starts.resize(boxes + 2, 0);
        for spot in &self.spots {
            self.starts[spot.home as usize + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.members.make_room(self.spots.len());
        for (k, spot) in self.spots.iter().enumerate().rev() {
            // Filled from the back: `starts` ends up at the beginning of each box.
            let end = &mut self.starts[spot.home as usize + 1];
            *end -= 1;
            self.members.put(*end as usize, spot, k as u32);
        }
    }

    /// The box of a spot.
    #[inline(always)]
    fn home(&self, spot: &Spot) -> usize {
        self.levels[self.level_of(spot.radius)].cell(self.low, spot.x)
    }

    /// Lays the levels.
    fn lay(&mut self, spots: &[Spot], tol: f64, bounds: &Bounds) {
        let count = spots.len();
        let [least, most] = bounds.radii.map(|radius| 2.0 * radius + tol);
        let mean_square = bounds.mean_square_of_reach(count, tol);
        let crowd = crop::crowd(spots, bounds.extent, mean_square);
        let extent = crowd.unwrap_or(bounds.extent);
        let span = extent.size();
        (self.low, self.tol, self.least) = (extent.low, tol, least);
        self.levels.clear();
        let alike = most * most <= ALIKE * mean_square;
        // How many there are of each size, and the largest radius among them.
        let mut sizes = [(0, 0.0f64); SIZES];
        if alike {
            self.least = most;
            sizes[0] = (count, bounds.radii[1]);
        } else {
            for &Spot { radius, .. } in spots {
                let size = &mut sizes[self.doublings(radius)];
                *size = (size.0 + 1, size.1.max(radius));
            }
        }
        let mut first = 0;
        for (size, &(count, largest)) in sizes.iter().enumerate().filter(|(_, size)| size.0 > 0) {
            let mut level = Level::new(first, span, count, largest, tol);
            level.open = crowd.is_some();
            first = level.end();
            self.level[size] = self.levels.len() as u8;
            self.levels.push(level);
        }
        // As many as there may be, whatever shape the assembly takes.
        let limit: usize = sizes.iter().map(|size| Level::limit(size.0)).sum();
        self.starts.reserve(limit + 2);
    }

    /// How often the reach of the smallest doubles to come near that of a particle.
    #[inline(always)]
    fn doublings(&self, radius: f64) -> usize {
        let ratio = (2.0 * radius + self.tol) / self.least;
        // The exponent of a number that is one or, by a hair, less.
        let exponent = (ratio.to_bits() >> 52).saturating_sub(1023) as usize;
        exponent.min(SIZES - 1)
    }

    /// The level that particles of this radius [m] are on.
    #[inline(always)]
    fn level_of(&self, radius: f64) -> usize {
        if self.levels.len() == 1 {
            return 0;
        }
        usize::from(self.level[self.doublings(radius)])
    }

    /// Notes for each of a few particles what is nearer to it than its halo: those after it on its own
    /// level, where the other one looks, too, and all on coarser ones.
    #[inline(always)]
    pub(super) fn gather<V: Lanes>(&self, few: Range<usize>, halos: &Halos, near: &mut Near) {
        near.begin();
        for (k, p) in few.enumerate() {
            let a = &self.spots[p];
            let (own, tol) = (self.level_of(a.radius), halos.of(a.tile));
            self.look::<V>(own, a, (tol, p as u32 + 1), near);
            near.own_done(k);
            for coarser in own + 1..self.levels.len() {
                self.look::<V>(coarser, a, (tol, 0), near);
            }
            near.all_done(k);
        }
    }

    /// Notes everything on a level that is nearer to a spot than this [m] and has at least this index.
    #[inline(always)]
    fn look<V: Lanes>(&self, level: usize, a: &Spot, (tol, least): (f64, u32), near: &mut Near) {
        let level = &self.levels[level];
        let reach = level.reach(a.radius, tol);
        let [left, bottom] = level.place(self.low, a.x.map(|x| x - reach));
        let [right, top] = level.place(self.low, a.x.map(|x| x + reach));
        for y in bottom..=top {
            let places = self.row(level, y, left..=right);
            self.members.near::<V>(places, a, (tol, least), near);
        }
    }

    /// Calls `near` with the index of everything on a level whose box comes within `margin` [m] of a
    /// stretch of a line, `ends` being the multiples of the direction at which it begins and ends.
    pub(super) fn along(
        &self,
        level: &Level,
        [point, direction]: [[f64; 2]; 2],
        ends: [f64; 2],
        margin: f64,
        mut near: impl FnMut(usize),
    ) {
        level.along(
            self.low,
            [point, direction],
            ends,
            margin,
            |row, columns| {
                let places = self.row(level, row, columns);
                self.members.indices(places).for_each(&mut near);
            },
        );
    }

    /// Where the members of neighbouring boxes of a row are.
    #[inline(always)]
    fn row(&self, level: &Level, row: usize, columns: RangeInclusive<usize>) -> Range<usize> {
        let first = level.first + row * level.columns;
        let from = self.starts[first + columns.start() + 1] as usize;
        // The box after the last one of a level is the first of the next.
        let to = self.starts.get(first + columns.end() + 2);
        from..to.map_or(self.members.len(), |to| *to as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Levels for so many spots of each radius.
    fn levels(sizes: &[(usize, f64)]) -> usize {
        let radii: Vec<f64> = (sizes.iter())
            .flat_map(|&(count, radius)| std::iter::repeat_n(radius, count))
            .collect();
        let mut grid = Grid::default();
        let spot = |k: usize| Spot::new([k as f64, 0.0], radii[k]);
        grid.fill(radii.len(), 0.01, &Threads::default(), spot);
        grid.levels.len()
    }

    #[test]
    fn a_few_large_ones_do_not_widen_the_boxes_of_all() {
        assert_eq!(levels(&[(1000, 1.0)]), 1);
        // Randall's grading, 3 to 1.
        let graded = [
            (30, 0.92),
            (138, 0.76),
            (172, 0.61),
            (230, 0.46),
            (30, 0.31),
        ];
        assert_eq!(levels(&graded), 1);
        assert_eq!(levels(&[(1000, 1.0), (1, 3.0)]), 2);
        assert_eq!(levels(&[(1000, 1.0), (1, 100.0)]), 2);
    }
}
