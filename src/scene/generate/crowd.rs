//! Everything that a new particle must keep clear of, found by place. Discs of like size share a
//! grid whose boxes are as wide as they are, so that a thousandfold range of sizes costs little.

use super::region::{Region, length};
use crate::engine::setup::WallSetup;
use crate::scene::overlap::distance;

/// A disc that is there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Disc {
    /// Centre [m].
    pub(super) at: [f64; 2],
    /// Radius [m].
    pub(super) radius: f64,
}

/// The region, its walls and the discs in it.
pub(super) struct Crowd<'a> {
    region: &'a Region,
    walls: Vec<&'a WallSetup>,
    /// Least distance between surfaces [m].
    gap: f64,
    /// Sides of a periodic cell, in which the border of the region is none [m].
    cell: Option<[f64; 2]>,
    grids: Vec<Grid>,
    /// Largest radius that is asked about [m].
    largest: f64,
}

/// A disc and the next one of the same box.
#[derive(Clone, Copy)]
struct Linked {
    disc: Disc,
    next: u32,
}

/// No disc.
const NONE: u32 = u32::MAX;

/// Discs of one class of sizes by box. Most are sorted by box, so that those of neighbouring boxes
/// are neighbours in memory; the newest are linked until it pays to sort them in.
struct Grid {
    class: i32,
    /// Largest radius in it [m].
    largest: f64,
    min: [f64; 2],
    width: f64,
    count: [usize; 2],
    /// Discs in the order of their boxes.
    sorted: Vec<Disc>,
    /// Of each box, the first of its sorted discs; then their number.
    start: Vec<u32>,
    /// Discs that came since they were sorted.
    newest: Vec<Linked>,
    /// The last of the newest of each box.
    first: Vec<u32>,
}

/// Sizes within a factor of two share a class.
fn class(radius: f64) -> i32 {
    libm::ilogb(radius)
}

impl<'a> Crowd<'a> {
    /// An empty region between walls, for discs up to a radius.
    pub(super) fn new(
        region: &'a Region,
        walls: &'a [WallSetup],
        gap: f64,
        periodic: bool,
        largest: f64,
    ) -> Self {
        let [min, max] = region.bounds();
        let middle = [0.5 * (min[0] + max[0]), 0.5 * (min[1] + max[1])];
        let reach = 0.5 * length([max[0] - min[0], max[1] - min[1]]) + gap;
        let near = |wall: &&WallSetup| distance(middle, wall) <= reach;
        Self {
            region,
            walls: walls.iter().filter(near).collect(),
            gap,
            cell: periodic.then_some([max[0] - min[0], max[1] - min[1]]),
            grids: Vec::new(),
            largest,
        }
    }

    /// Whether a disc can be in the way of any that is placed.
    pub(super) fn matters(&self, disc: Disc) -> bool {
        let [min, max] = self.region.bounds();
        let reach = disc.radius + self.margin();
        (0..2).all(|k| disc.at[k] > min[k] - reach && disc.at[k] < max[k] + reach)
    }

    /// How far outside of the rectangle around the region a surface is still asked about [m].
    fn margin(&self) -> f64 {
        3.0 * self.largest + self.gap
    }

    /// Makes room for discs of these sizes, each with how many there may be of it. Of each class of
    /// sizes the grid is made once, so all sizes must be known before the first disc is added.
    pub(super) fn expect(&mut self, sizes: impl Iterator<Item = (f64, usize)>) {
        for (radius, count) in sizes {
            let own = class(radius);
            let grid = match self.grids.iter_mut().position(|grid| grid.class == own) {
                Some(k) => &mut self.grids[k],
                None => {
                    self.grids.push(Grid {
                        class: own,
                        largest: 0.0,
                        min: [0.0; 2],
                        width: 0.0,
                        // Until the boxes are laid: how many discs are expected.
                        count: [0, 0],
                        sorted: Vec::new(),
                        start: Vec::new(),
                        newest: Vec::new(),
                        first: Vec::new(),
                    });
                    self.grids.last_mut().expect("it was just put there")
                }
            };
            grid.largest = grid.largest.max(radius);
            grid.count[0] = grid.count[0].saturating_add(count);
        }
    }

    /// Lays the boxes of the grids.
    pub(super) fn lay(&mut self) {
        let [min, max] = self.region.bounds();
        let margin = self.margin();
        for grid in &mut self.grids {
            // Every disc that can matter has its centre in the grid; others are clipped to its edge.
            let margin = margin + grid.largest;
            let side = [0, 1].map(|k| max[k] - min[k] + 2.0 * margin);
            let most = 4.0 * grid.count[0] as f64 + 1024.0;
            grid.width = 2.0 * grid.largest;
            while (side[0] / grid.width + 1.0) * (side[1] / grid.width + 1.0) > most {
                grid.width *= 1.5;
            }
            grid.min = min.map(|x| x - margin);
            grid.count = side.map(|side| (side / grid.width) as usize + 1);
            let boxes = grid.count[0] * grid.count[1];
            grid.first = vec![NONE; boxes];
            grid.start = vec![0; boxes + 1];
        }
    }

    /// Adds a disc; in a periodic cell its images too, as far as they reach into it.
    pub(super) fn add(&mut self, disc: Disc) {
        let Some([width, height]) = self.cell else {
            self.put(disc);
            return;
        };
        for across in [0.0, width, -width] {
            for up in [0.0, height, -height] {
                let at = [disc.at[0] + across, disc.at[1] + up];
                let image = Disc { at, ..disc };
                if self.matters(image) {
                    self.put(image);
                }
            }
        }
    }

    fn put(&mut self, disc: Disc) {
        let own = class(disc.radius);
        let grid = self.grids.iter_mut().find(|grid| grid.class == own);
        let grid = grid.expect("every size is expected before it is added");
        grid.add(disc);
    }

    /// Collects the discs whose surface is nearer to a point than `reach`, the gap left out. Stops at
    /// the first that is nearer than `enough` and answers how near that is.
    pub(super) fn gather(
        &self,
        at: [f64; 2],
        reach: f64,
        enough: f64,
        near: &mut Vec<Disc>,
    ) -> Option<f64> {
        near.clear();
        let (reach, enough) = (reach + self.gap, enough + self.gap);
        for grid in &self.grids {
            let around = reach + grid.largest;
            let [from, to] = [-around, around].map(|d| [0, 1].map(|k| grid.index(at[k] + d, k)));
            let mut take = |disc: &Disc| {
                let d = [disc.at[0] - at[0], disc.at[1] - at[1]];
                let (square, apart) = (d[0] * d[0] + d[1] * d[1], reach + disc.radius);
                if square >= apart * apart {
                    return None;
                }
                near.push(*disc);
                let apart = enough + disc.radius;
                (apart > 0.0 && square < apart * apart)
                    .then(|| square.sqrt() - disc.radius - self.gap)
            };
            for y in from[1]..=to[1] {
                let row = y * grid.count[0];
                let (left, right) = (row + from[0], row + to[0]);
                let sorted = grid.start[left] as usize..grid.start[right + 1] as usize;
                if let Some(nearest) = grid.sorted[sorted].iter().find_map(&mut take) {
                    return Some(nearest);
                }
                for &first in &grid.first[left..=right] {
                    let mut k = first;
                    while k != NONE {
                        let Linked { disc, next } = &grid.newest[k as usize];
                        if let Some(nearest) = take(disc) {
                            return Some(nearest);
                        }
                        k = *next;
                    }
                }
            }
        }
        None
    }

    /// Largest radius that a disc at this point may have, given the discs near it [m]; never more
    /// than `enough` matters. Changes by no more than the distance from one point to another.
    pub(super) fn room(&self, at: [f64; 2], near: &[Disc], enough: f64) -> f64 {
        let mut room = enough;
        if self.cell.is_none() {
            room = room.min(self.region.depth(at));
        }
        for wall in &self.walls {
            room = room.min(distance(at, wall) - self.gap);
        }
        for disc in near {
            let d = [disc.at[0] - at[0], disc.at[1] - at[1]];
            let square = d[0] * d[0] + d[1] * d[1];
            let limit = room + disc.radius + self.gap;
            // A square root only where it matters.
            if limit > 0.0 && square < limit * limit || limit <= 0.0 {
                room = room.min(square.sqrt() - disc.radius - self.gap);
            }
        }
        room
    }
}

impl Grid {
    fn add(&mut self, disc: Disc) {
        let own = self.place(&disc);
        self.newest.push(Linked {
            disc,
            next: self.first[own],
        });
        self.first[own] = self.newest.len() as u32 - 1;
        // Each disc is sorted a few times in all.
        if self.newest.len() > 1024 + self.sorted.len() / 4 {
            self.sort();
        }
    }

    /// Sorts the newest in by counting.
    fn sort(&mut self) {
        let mut all = std::mem::take(&mut self.sorted);
        all.extend(self.newest.drain(..).map(|linked| linked.disc));
        self.first.fill(NONE);
        self.start.fill(0);
        for disc in &all {
            let own = self.place(disc);
            self.start[own + 1] += 1;
        }
        let mut before = 0;
        for start in &mut self.start {
            before += *start;
            *start = before;
        }
        let mut next = self.start.clone();
        self.sorted = all.clone();
        for disc in all {
            let own = self.place(&disc);
            self.sorted[next[own] as usize] = disc;
            next[own] += 1;
        }
    }

    /// Number of the box of a disc.
    fn place(&self, disc: &Disc) -> usize {
        self.index(disc.at[1], 1) * self.count[0] + self.index(disc.at[0], 0)
    }

    /// Number of the box along an axis, clipped to the grid.
    fn index(&self, x: f64, k: usize) -> usize {
        // A negative number becomes 0.
        (((x - self.min[k]) / self.width) as usize).min(self.count[k] - 1)
    }
}
