//! Boxes: particles binned by centre, so that only near ones are compared.

use crate::engine::particles::Row;

/// Boxes over the extent of the assembly. Buffers are kept between searches.
#[derive(Debug, Default)]
pub struct Grid {
    low: [f64; 2],
    size: f64,
    columns: usize,
    rows: usize,
    /// First entry of each box in `members`.
    starts: Vec<u32>,
    /// Particles box by box, ascending within a box.
    members: Vec<u32>,
    /// Box of each particle.
    home: Vec<u32>,
}

/// At most so many boxes per particle: far-flung assemblies get larger boxes.
const BOXES_PER_PARTICLE: f64 = 4.0;

impl Grid {
    /// Bins the particles in boxes no smaller than `least` [m].
    pub fn fill(&mut self, rows: &[Row], least: f64) {
        let mut high = [f64::NEG_INFINITY; 2];
        self.low = [f64::INFINITY; 2];
        for row in rows {
            self.low = [self.low[0].min(row.x[0]), self.low[1].min(row.x[1])];
            high = [high[0].max(row.x[0]), high[1].max(row.x[1])];
        }
        let span = [high[0] - self.low[0], high[1] - self.low[1]];
        let limit = BOXES_PER_PARTICLE * rows.len() as f64 + 16.0;
        self.size = least;
        while (span[0] / self.size + 1.0) * (span[1] / self.size + 1.0) > limit {
            self.size *= 2.0;
        }
        self.columns = (span[0] / self.size) as usize + 1;
        self.rows = (span[1] / self.size) as usize + 1;
        self.starts.clear();
        // As many as there may be, whatever shape the assembly takes.
        self.starts.reserve(limit as usize + 2);
        self.starts.resize(self.columns * self.rows + 1, 0);
        self.home.clear();
        for row in rows {
            let cell = self.cell(row.x);
            self.home.push(cell as u32);
            self.starts[cell + 1] += 1;
        }
        for cell in 1..self.starts.len() {
            self.starts[cell] += self.starts[cell - 1];
        }
        self.members.clear();
        self.members.resize(rows.len(), 0);
        for (p, &cell) in self.home.iter().enumerate().rev() {
            // Filled from the back: `starts` ends up at the beginning of each box.
            let end = &mut self.starts[cell as usize + 1];
            *end -= 1;
            self.members[*end as usize] = p as u32;
        }
        self.starts.remove(0);
        self.starts.push(rows.len() as u32);
    }

    fn cell(&self, x: [f64; 2]) -> usize {
        let along =
            |k: usize, count: usize| (((x[k] - self.low[k]) / self.size) as usize).min(count - 1);
        along(1, self.rows) * self.columns + along(0, self.columns)
    }

    /// Calls `near` with every particle in the boxes around particle p, itself included.
    pub fn around(&self, p: usize, mut near: impl FnMut(usize)) {
        let home = self.home[p] as usize;
        let (column, row) = (home % self.columns, home / self.columns);
        let left = column.saturating_sub(1);
        let right = (column + 1).min(self.columns - 1);
        for y in row.saturating_sub(1)..=(row + 1).min(self.rows - 1) {
            let first = self.starts[y * self.columns + left] as usize;
            let last = self.starts[y * self.columns + right + 1] as usize;
            for &q in &self.members[first..last] {
                near(q as usize);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn finds_what_comparing_all_pairs_finds(
            points in prop::collection::vec((-1.0..1.0f64, -0.2..0.2f64), 1..80),
        ) {
            let reach = 0.11;
            let rows: Vec<Row> = points
                .iter()
                .map(|&(x, y)| Row { x: [x, y], ..Row::default() })
                .collect();
            let mut grid = Grid::default();
            grid.fill(&rows, reach);
            let close = |p: usize, q: usize| {
                let d = [rows[p].x[0] - rows[q].x[0], rows[p].x[1] - rows[q].x[1]];
                d[0] * d[0] + d[1] * d[1] < reach * reach
            };
            for p in 0..rows.len() {
                let mut found = Vec::new();
                grid.around(p, |q| if close(p, q) { found.push(q) });
                found.sort_unstable();
                let all: Vec<usize> = (0..rows.len()).filter(|&q| close(p, q)).collect();
                prop_assert_eq!(found, all);
            }
        }
    }
}
