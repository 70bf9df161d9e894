//! One level of boxes: where a point lies in it, and which boxes a wall passes.

use std::ops::RangeInclusive;

/// Boxes of one width, row by row: as high as the largest reach, and a share of that wide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Level {
    /// Number of its first box.
    pub(super) first: usize,
    /// Height of a box [m].
    size: f64,
    /// Boxes per metre.
    per_metre: [f64; 2],
    /// Boxes to either side in which neighbours may be.
    pub(super) aside: usize,
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Largest radius on it [m].
    pub(super) largest: f64,
    /// Whether some lie outside, and count as in the nearest box.
    pub(super) open: bool,
}

/// At most so many boxes per particle: far-flung assemblies get larger boxes.
pub(super) const BOXES_PER_PARTICLE: usize = 2;

/// Boxes for a height, where there may be as many: boxes of a row lie one after another, so that to
/// look at narrow ones costs nothing and leaves less that is looked at in vain.
const NARROW: [usize; 2] = [4, 2];

/// Boxes are wider than they must be by this share, more than rounding can move a centre.
const SPARE: f64 = 1e-6;

impl Level {
    /// Boxes over a rectangle of this span [m] for so many particles of up to this radius [m] that
    /// are neighbours within `tol` [m].
    pub(super) fn new(first: usize, span: [f64; 2], count: usize, largest: f64, tol: f64) -> Self {
        let least = (2.0 * largest + tol) * (1.0 + SPARE);
        let limit = Self::limit(count) as f64;
        let too_many = |size: f64, aside: usize| {
            let columns = span[0] / size * aside as f64 + 1.0;
            columns * (span[1] / size + 1.0) > limit
        };
        let mut size = least;
        let fits = |aside: &usize| !too_many(least, *aside);
        let aside = NARROW.into_iter().find(fits).unwrap_or(1);
        while too_many(size, aside) {
            size *= 1.25;
        }
        let per_metre = [aside as f64 / size, 1.0 / size];
        Self {
            first,
            size,
            per_metre,
            aside,
            columns: (span[0] * per_metre[0]) as usize + 1,
            rows: (span[1] * per_metre[1]) as usize + 1,
            largest,
            open: false,
        }
    }

    /// Most boxes for so many particles.
    pub(super) fn limit(count: usize) -> usize {
        if count == 0 {
            0
        } else {
            BOXES_PER_PARTICLE * count + 16
        }
    }

    /// Number of the box after its last one.
    pub(super) fn end(&self) -> usize {
        self.first + self.columns * self.rows
    }

    /// How far from a centre [m] those of this level may be that such a particle has within `tol` [m].
    #[inline(always)]
    pub(super) fn reach(&self, radius: f64, tol: f64) -> f64 {
        (radius + self.largest + tol) * (1.0 + SPARE)
    }

    /// Column and row of a point; what lies outside counts as in the nearest box.
    #[inline(always)]
    pub(super) fn place(&self, low: [f64; 2], x: [f64; 2]) -> [usize; 2] {
        let along = |k: usize, count: usize| {
            // A float below zero becomes zero, one too large the largest number.
            (((x[k] - low[k]) * self.per_metre[k]) as usize).min(count - 1)
        };
        [along(0, self.columns), along(1, self.rows)]
    }

    /// Number of the box of a point.
    #[inline(always)]
    pub(super) fn cell(&self, low: [f64; 2], x: [f64; 2]) -> usize {
        let [column, row] = self.place(low, x);
        self.first + row * self.columns + column
    }

    /// Calls `passed` with the boxes, row by row, that come within `margin` [m] of a stretch of a line.
    pub(super) fn along(
        &self,
        low: [f64; 2],
        [point, direction]: [[f64; 2]; 2],
        [from, to]: [f64; 2],
        margin: f64,
        mut passed: impl FnMut(usize, RangeInclusive<usize>),
    ) {
        let margin = margin * (1.0 + SPARE);
        // Infinitely far along a line that does not go that way.
        let at = |t: f64, k: usize| {
            if direction[k] == 0.0 {
                point[k]
            } else {
                point[k] + t * direction[k]
            }
        };
        let span = |t: [f64; 2], k: usize| {
            let [a, b] = t.map(|t| at(t, k));
            [a.min(b) - margin, a.max(b) + margin]
        };
        let [bottom, top] = span([from, to], 1);
        let first = self.place(low, [low[0], bottom])[1];
        let last = self.place(low, [low[0], top])[1];
        for row in first..=last {
            // Where the line passes within the margin of this row.
            let band = [row, row + 1].map(|row| low[1] + row as f64 * self.size);
            let mut band = [band[0] - margin, band[1] + margin];
            if self.open && row == 0 {
                band[0] = f64::NEG_INFINITY;
            }
            if self.open && row == self.rows - 1 {
                band[1] = f64::INFINITY;
            }
            let mut within = [from, to];
            if direction[1] == 0.0 {
                if point[1] < band[0] || point[1] > band[1] {
                    continue;
                }
            } else {
                let [a, b] = band.map(|y| (y - point[1]) / direction[1]);
                within = [from.max(a.min(b)), to.min(a.max(b))];
                if within[0] > within[1] {
                    continue;
                }
            }
            let [left, right] = span(within, 0);
            let end = low[0] + self.columns as f64 * self.size / self.aside as f64;
            if !self.open && (right < low[0] || left > end) {
                continue;
            }
            let [left, right] = [left, right].map(|x| self.place(low, [x, low[1]])[0]);
            passed(row, left..=right);
        }
    }
}
