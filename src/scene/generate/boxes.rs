//! Candidate boxes: squares that together hold every place where a disc may still fit. A point is
//! drawn uniformly from all of them; where it does not fit, its box is cut into four and the parts
//! without room are put aside until smaller discs come. So what is drawn stays uniform over the
//! places that are left, and when no box is left there is certainly no room.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::chance::Chance;

/// A square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Square {
    /// How often the first squares were halved.
    pub(super) level: u8,
    /// Its place among squares of the level.
    pub(super) index: [u32; 2],
}

/// A square without room for discs larger than this.
struct Asleep {
    room: f64,
    square: Square,
}

/// The squares.
pub(super) struct Boxes {
    min: [f64; 2],
    width: f64,
    /// Squares to draw from, by level.
    awake: Vec<Vec<[u32; 2]>>,
    /// The others, those with most room first.
    asleep: BinaryHeap<Asleep>,
}

/// Halvings after which a square counts as too small to hold a place: 1e-7 of the first width.
const DEEPEST: u8 = 24;

impl Boxes {
    /// Covers a rectangle with squares of about this width.
    pub(super) fn cover([min, max]: [[f64; 2]; 2], width: f64) -> Self {
        let side = [max[0] - min[0], max[1] - min[1]];
        // Wider where there would be more than 2^24 of them.
        let width = width.max((side[0] * side[1] / f64::from(1 << 24)).sqrt());
        let width = width.max(side[0].max(side[1]) / f64::from(1 << 24));
        let [nx, ny] = side.map(|side| ((side / width).ceil() as u32).max(1));
        let rows = (0..ny).flat_map(|y| (0..nx).map(move |x| [x, y]));
        let mut awake = vec![Vec::new(); usize::from(DEEPEST) + 1];
        awake[0] = rows.collect();
        Self {
            min,
            width,
            awake,
            asleep: BinaryHeap::new(),
        }
    }

    /// Total area of the squares to draw from [m²].
    pub(super) fn area(&self) -> f64 {
        let area = |(level, squares): (usize, &Vec<_>)| {
            let width = self.width_at(level as u8);
            squares.len() as f64 * width * width
        };
        self.awake.iter().enumerate().map(area).sum()
    }

    /// Wakes the squares with room for discs of this radius.
    pub(super) fn wake(&mut self, radius: f64) {
        while self.asleep.peek().is_some_and(|top| top.room >= radius) {
            if let Some(Asleep { square, .. }) = self.asleep.pop() {
                self.put(square);
            }
        }
    }

    /// Takes a square out, each as likely as it is large; none if there is none.
    pub(super) fn draw(&mut self, chance: &mut Chance) -> Option<Square> {
        let mut left = chance.fraction() * self.area();
        let mut last = None;
        for (level, squares) in self.awake.iter().enumerate() {
            if squares.is_empty() {
                continue;
            }
            last = Some(level);
            let width = self.width_at(level as u8);
            let here = squares.len() as f64 * width * width;
            if left < here {
                break;
            }
            left -= here;
        }
        let level = last?;
        let squares = &mut self.awake[level];
        let index = squares.swap_remove(chance.below(squares.len()));
        let level = level as u8;
        Some(Square { level, index })
    }

    /// Puts a square among those to draw from.
    pub(super) fn put(&mut self, square: Square) {
        self.awake[usize::from(square.level)].push(square.index);
    }

    /// Puts a square aside until discs come that are no larger than its room.
    pub(super) fn put_aside(&mut self, square: Square, room: f64) {
        self.asleep.push(Asleep { room, square });
    }

    /// The four parts of a square; none if it is too small.
    pub(super) fn parts(square: Square) -> Option<[Square; 4]> {
        let level = square.level + 1;
        let [x, y] = square.index.map(|index| 2 * index);
        let part = |index| Square { level, index };
        (level <= DEEPEST).then(|| [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]].map(part))
    }

    /// Centre of a square [m].
    pub(super) fn centre(&self, square: Square) -> [f64; 2] {
        self.point(square, [0.5; 2])
    }

    /// A point of a square, by its place within it from 0 to 1 [m].
    pub(super) fn point(&self, square: Square, within: [f64; 2]) -> [f64; 2] {
        let width = self.width_at(square.level);
        [0, 1].map(|k| self.min[k] + (f64::from(square.index[k]) + within[k]) * width)
    }

    /// Half the diagonal of squares of a level [m].
    pub(super) fn half_diagonal(&self, level: u8) -> f64 {
        self.width_at(level) * std::f64::consts::FRAC_1_SQRT_2
    }

    fn width_at(&self, level: u8) -> f64 {
        // Exact: a power of two.
        self.width / (1u64 << level) as f64
    }
}

impl Ord for Asleep {
    fn cmp(&self, other: &Self) -> Ordering {
        // Equal rooms in a fixed order, so that the heap is the same everywhere.
        let key = |asleep: &Self| (asleep.square.level, asleep.square.index);
        let room = self.room.total_cmp(&other.room);
        room.then_with(|| key(self).cmp(&key(other)))
    }
}

impl PartialOrd for Asleep {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Asleep {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Asleep {}
