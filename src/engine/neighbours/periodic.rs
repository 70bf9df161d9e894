//! The pairs of a periodic cell: every particle at home with the images of all others around it.

use super::grid::Grid;
use crate::engine::boundary::cell::{Cell, HERE, Image};
use crate::engine::particles::Row;

/// Particles at home and, after them, the images near the cell. Buffers are kept between searches.
#[derive(Debug, Default)]
pub(super) struct Tiling {
    rows: Vec<Row>,
    /// Particle of each row, and its shift from home.
    of: Vec<(u32, Image)>,
    /// Which image of the cell each particle has strayed to.
    strayed: Vec<Image>,
    near: Vec<(u32, Image)>,
}

impl Tiling {
    /// Tiles the surroundings of the cell as far as `reach` [m] with images.
    fn lay(&mut self, cell: &Cell, rows: &[Row], reach: f64) {
        self.rows.clear();
        self.of.clear();
        self.strayed.clear();
        for (p, row) in rows.iter().enumerate() {
            let image = cell.image(row.x);
            let shift = cell.shift(image);
            self.strayed.push(image);
            self.of.push((p as u32, HERE));
            let x = [row.x[0] - shift[0], row.x[1] - shift[1]];
            self.rows.push(Row { x, ..*row });
        }
        let margin = cell.widths().map(|width| reach / width);
        let [across, along] = margin.map(|margin| margin.ceil() as i16);
        for p in 0..rows.len() {
            let home = self.rows[p];
            let fractions = cell.fractions(home.x);
            for n in -across..=across {
                for m in -along..=along {
                    let at = [fractions[0] + f64::from(n), fractions[1] + f64::from(m)];
                    let near = (0..2).all(|k| -margin[k] <= at[k] && at[k] <= 1.0 + margin[k]);
                    if [n, m] == HERE || !near {
                        continue;
                    }
                    let shift = cell.shift([n, m]);
                    let x = [home.x[0] + shift[0], home.x[1] + shift[1]];
                    self.of.push((p as u32, [n, m]));
                    self.rows.push(Row { x, ..home });
                }
            }
        }
    }

    /// Calls `found` with each pair nearer than `tol` [m]: ascending particles, ascending partners,
    /// each with the image of the second body that is meant.
    pub(super) fn pairs(
        &mut self,
        grid: &mut Grid,
        cell: &Cell,
        rows: &[Row],
        [largest, tol]: [f64; 2],
        mut found: impl FnMut([u32; 2], Image),
    ) {
        let reach = 2.0 * largest + tol;
        self.lay(cell, rows, reach);
        grid.fill(&self.rows, reach);
        for (p, a) in rows.iter().enumerate() {
            let near = &mut self.near;
            near.clear();
            let home = self.strayed[p];
            let (all, of, strayed) = (&self.rows, &self.of, &self.strayed);
            grid.around(p, |q| {
                let (j, shift) = of[q];
                let d = [all[q].x[0] - all[p].x[0], all[q].x[1] - all[p].x[1]];
                let within = a.radius + all[q].radius + tol;
                if d[0] * d[0] + d[1] * d[1] >= within * within {
                    return;
                }
                let away = strayed[j as usize];
                let image = [0, 1].map(|k| shift[k] - away[k] + home[k]);
                // A particle and its own image meet in two places that are one contact.
                if (p as u32) < j || (p as u32 == j && image > HERE) {
                    near.push((j, image));
                }
            });
            near.sort_unstable();
            for &(j, image) in &self.near {
                found([p as u32, j], image);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Against all images of all pairs in a wide neighbourhood, for cells that lean, are smaller
        /// than the reach, and particles that have strayed.
        #[test]
        fn finds_what_comparing_all_images_finds(
            points in prop::collection::vec((-3.0..3.0f64, -3.0..3.0f64), 1..8),
            lean in -0.7..0.7f64,
            height in 0.3..1.5f64,
        ) {
            let cell = Cell { corner: [-0.2, 0.1], edges: [[1.0, 0.0], [lean, height]] };
            let row = |&(x, y): &(f64, f64)| Row { x: [x, y], radius: 0.2, ..Row::default() };
            let rows: Vec<Row> = points.iter().map(row).collect();
            let mut pairs = Vec::new();
            let (mut tiling, mut grid) = (Tiling::default(), Grid::default());
            tiling.pairs(&mut grid, &cell, &rows, [0.2, 0.05], |pair, image| {
                pairs.push((pair, image));
            });
            let mut all = Vec::new();
            for i in 0..rows.len() {
                for j in i..rows.len() {
                    for n in -12..=12i16 {
                        for m in -40..=40i16 {
                            let s = cell.shift([n, m]);
                            let d = [0, 1].map(|k| rows[j].x[k] + s[k] - rows[i].x[k]);
                            if d[0] * d[0] + d[1] * d[1] < 0.45 * 0.45 && (i < j || [n, m] > HERE) {
                                all.push(([i as u32, j as u32], [n, m]));
                            }
                        }
                    }
                }
            }
            prop_assert_eq!(pairs, all);
        }
    }
}
