//! Random placing without contacts, largest discs first (Randall 1989, 4.4): each is as likely to
//! be anywhere it fits. When a size no longer fits, the next smaller one is tried.

use super::boxes::{Boxes, Square};
use super::chance::Chance;
use super::crowd::{Crowd, Disc};
use super::region::Region;
use crate::engine::setup::WallSetup;

/// What is to be placed where.
pub(super) struct Task<'a> {
    /// Where.
    pub(super) region: &'a Region,
    /// Walls to keep clear of.
    pub(super) walls: &'a [WallSetup],
    /// Discs to keep clear of.
    pub(super) there: &'a [Disc],
    /// Radius and number of each size, largest first.
    pub(super) sizes: &'a [Size],
    /// Least distance between surfaces [m].
    pub(super) gap: f64,
    /// Whether what leaves the region on one side comes back on the other.
    pub(super) periodic: bool,
    /// Attempts in a row, uniform over the region, after which a size no longer fits; `None`: when
    /// there is certainly no room.
    pub(super) tries: Option<u64>,
    /// Whether all ends where a size no longer fits, as before the thesis, or goes on with the next smaller.
    pub(super) stops: bool,
}

/// How many of a size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Size {
    /// Radius [m].
    pub(super) radius: f64,
    /// How many are asked for.
    pub(super) count: usize,
}

/// Densest packing of equal discs: the area each takes is 2√3 R².
const CLOSEST: f64 = 3.464;

/// Places discs; answers them in the order they were placed, and how many of each size.
pub(super) fn fill(task: &Task<'_>, chance: &mut Chance) -> (Vec<Disc>, Vec<usize>) {
    let mut placed = Vec::new();
    let mut counts = vec![0; task.sizes.len()];
    let Some(largest) = task.sizes.first().map(|size| size.radius) else {
        return (placed, counts);
    };
    let mut filler = Filler::new(task, largest);
    for (k, size) in task.sizes.iter().enumerate() {
        filler.boxes.wake(k);
        while counts[k] < size.count {
            let Some(disc) = filler.place(size.radius, chance) else {
                if task.stops {
                    return (placed, counts);
                }
                break;
            };
            placed.push(disc);
            counts[k] += 1;
        }
    }
    (placed, counts)
}

struct Filler<'a> {
    task: &'a Task<'a>,
    crowd: Crowd<'a>,
    boxes: Boxes,
    area: f64,
    near: Vec<Disc>,
}

impl<'a> Filler<'a> {
    fn new(task: &'a Task<'a>, largest: f64) -> Self {
        let mut crowd = Crowd::new(task.region, task.walls, task.gap, task.periodic, largest);
        let there: Vec<Disc> = task
            .there
            .iter()
            .copied()
            .filter(|disc| task.periodic || crowd.matters(*disc))
            .collect();
        let area = task.region.area();
        let radii = task.sizes.iter().map(|size| size.radius);
        crowd.expect(there.iter().map(|disc| (disc.radius, 1)));
        crowd.expect(task.sizes.iter().map(|size| {
            let most = (area / (CLOSEST * size.radius * size.radius)) as usize;
            (size.radius, size.count.min(most + 1))
        }));
        crowd.lay();
        for disc in there {
            crowd.add(disc);
        }
        Self {
            task,
            crowd,
            boxes: Boxes::cover(task.region.bounds(), radii.collect()),
            area,
            near: Vec::new(),
        }
    }

    /// Places a disc anywhere it fits.
    fn place(&mut self, radius: f64, chance: &mut Chance) -> Option<Disc> {
        let mut failed = 0;
        loop {
            if let Some(tries) = self.task.tries {
                // Attempts that fall outside of the candidate boxes need not be made.
                failed += self.misses(chance);
                if failed >= tries {
                    return None;
                }
            }
            let square = self.boxes.draw(chance)?;
            let within = [chance.fraction(), chance.fraction()];
            let half = self.boxes.half_diagonal(square.level);
            let centre = self.boxes.centre(square);
            // Enough for every point of the square; or one disc that leaves none of them free.
            let (reach, enough) = (radius + half, radius - half);
            let nearest = self.crowd.gather(centre, reach, enough, &mut self.near);
            if let Some(nearest) = nearest {
                self.boxes.put_aside(square, nearest + half);
                failed += 1;
                continue;
            }
            let at = self.boxes.point(square, within);
            let fits = self.task.region.depth(at) >= 0.0
                && self.crowd.room(at, &self.near, radius) >= radius;
            let disc = Disc { at, radius };
            if fits {
                self.crowd.add(disc);
                self.near.push(disc);
            }
            self.cut(square, radius);
            if fits {
                return Some(disc);
            }
            failed += 1;
        }
    }

    /// Cuts a square whose surroundings are gathered, and sorts its parts.
    fn cut(&mut self, square: Square, radius: f64) {
        let Some(parts) = Boxes::parts(square) else {
            return;
        };
        for part in parts {
            let half = self.boxes.half_diagonal(part.level);
            let centre = self.boxes.centre(part);
            if self.task.region.depth(centre) < -half {
                continue;
            }
            let room = self.crowd.room(centre, &self.near, radius) + half;
            if room >= radius {
                self.boxes.put(part);
            } else {
                self.boxes.put_aside(part, room);
            }
        }
    }

    /// How many attempts, uniform over the region, fall outside of the boxes before one that does
    /// not: geometric.
    fn misses(&self, chance: &mut Chance) -> u64 {
        let hit = self.boxes.area() / self.area;
        if hit >= 1.0 {
            return 0;
        }
        // A float too large becomes the largest number.
        (libm::log(chance.above_zero()) / libm::log1p(-hit)) as u64
    }
}
