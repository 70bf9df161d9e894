//! Candidate boxes: squares that together hold every place where a disc may still fit. A point is
//! drawn uniformly from all of them; where it does not fit, its box is cut into four and the parts
//! without room are put aside until smaller discs come. So what is drawn stays uniform over the
//! places that are left, and when no box is left there is certainly no room.

use super::chance::Chance;

/// A square.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Square {
    /// How often the first squares were halved.
    pub(super) level: u8,
    /// Its place among squares of the level.
    pub(super) index: [u32; 2],
}

/// The squares.
pub(super) struct Boxes {
    min: [f64; 2],
    /// Width [m] and area [m²] of a square of each level.
    size: Vec<[f64; 2]>,
    /// Squares to draw from, by level.
    awake: Vec<Vec<[u32; 2]>>,
    /// The radii that are placed, largest first [m].
    radii: Vec<f64>,
    /// Squares without room for larger discs than the radius of this place.
    asleep: Vec<Vec<Square>>,
}

/// Halvings after which a square counts as too small to hold a place: 1e-7 of the first width.
const DEEPEST: u8 = 24;

impl Boxes {
    /// Covers a rectangle with squares for discs of these radii, largest first.
    pub(super) fn cover([min, max]: [[f64; 2]; 2], radii: Vec<f64>) -> Self {
        // The width of which the fewest attempts are in vain.
        let width = 2.0 * radii.first().copied().unwrap_or_default();
        let side = [max[0] - min[0], max[1] - min[1]];
        // Wider where there would be more than 2^24 of them.
        let width = width.max((side[0] * side[1] / f64::from(1 << 24)).sqrt());
        let width = width.max(side[0].max(side[1]) / f64::from(1 << 24));
        let [nx, ny] = side.map(|side| ((side / width).ceil() as u32).max(1));
        let rows = (0..ny).flat_map(|y| (0..nx).map(move |x| [x, y]));
        let halved = (0..=DEEPEST).map(|level| width / (1u64 << level) as f64);
        Self {
            min,
            size: halved.map(|width| [width, width * width]).collect(),
            awake: vec![rows.collect()],
            asleep: vec![Vec::new(); radii.len()],
            radii,
        }
    }

    /// Total area of the squares to draw from [m²].
    pub(super) fn area(&self) -> f64 {
        let levels = self.awake.iter().zip(&self.size);
        levels
            .map(|(squares, [_, area])| squares.len() as f64 * area)
            .sum()
    }

    /// Wakes the squares with room for discs of the radius of this place.
    pub(super) fn wake(&mut self, place: usize) {
        for square in std::mem::take(&mut self.asleep[place]) {
            self.put(square);
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
            let here = squares.len() as f64 * self.size[level][1];
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
        let level = usize::from(square.level);
        if level >= self.awake.len() {
            self.awake.resize(level + 1, Vec::new());
        }
        self.awake[level].push(square.index);
    }

    /// Puts a square aside until discs come that are no larger than its room, if ever.
    pub(super) fn put_aside(&mut self, square: Square, room: f64) {
        let place = self.radii.partition_point(|&radius| radius > room);
        if let Some(asleep) = self.asleep.get_mut(place) {
            asleep.push(square);
        }
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
        let [width, _] = self.size[usize::from(square.level)];
        [0, 1].map(|k| self.min[k] + (f64::from(square.index[k]) + within[k]) * width)
    }

    /// Half the diagonal of squares of a level [m].
    pub(super) fn half_diagonal(&self, level: u8) -> f64 {
        self.size[usize::from(level)][0] * std::f64::consts::FRAC_1_SQRT_2
    }
}
