//! The pairs of a periodic cell: every particle at home with the images of all others around it.

use super::grid::{Grid, Spot};
use super::near::sort_few;
use super::partner::Partner;
use super::party::{Party, Searcher};
use crate::engine::boundary::cell::{Cell, HERE, Image, whole_below};
use crate::engine::particles::Row;
use crate::engine::threads::Threads;

/// Which particles have left the cell, and which images of them are near it. Buffers are kept between
/// searches.
#[derive(Debug, Default)]
pub(super) struct Tiling {
    /// Particle and shift of each image.
    images: Vec<(u32, Image)>,
    /// Which image of the cell each particle has strayed to.
    strayed: Vec<Image>,
}

impl Tiling {
    /// Bytes per particle.
    pub(super) const BYTES: usize = size_of::<Image>();

    /// Tiles the surroundings of the cell with images, as far as anyone at home within `tol` [m] of
    /// them can be: that depends on the sizes of both.
    fn lay(&mut self, cell: &Cell, rows: &[Row], tol: f64) {
        self.images.clear();
        self.strayed.clear();
        let mut largest = 0.0f64;
        for row in rows {
            largest = largest.max(row.radius);
        }
        let widths = cell.widths();
        for (p, row) in rows.iter().enumerate() {
            let fractions = cell.fractions(row.x);
            let strayed = fractions.map(whole_below);
            self.strayed.push(strayed);
            let fractions = [0, 1].map(|k| fractions[k] - f64::from(strayed[k]));
            let margin = widths.map(|width| (row.radius + largest + tol) / width);
            let reach = |k: usize| {
                let inside = margin[k] <= fractions[k] && fractions[k] <= 1.0 - margin[k];
                if inside { 0 } else { margin[k].ceil() as i16 }
            };
            let [across, along] = [reach(0), reach(1)];
            for n in -across..=across {
                for m in -along..=along {
                    let at = [fractions[0] + f64::from(n), fractions[1] + f64::from(m)];
                    let near = (0..2).all(|k| -margin[k] <= at[k] && at[k] <= 1.0 + margin[k]);
                    if [n, m] == HERE || !near {
                        continue;
                    }
                    self.images.push((p as u32, [n, m]));
                }
            }
        }
    }

    /// Finds each pair nearer than `tol` [m]: ascending particles, ascending partners, each with the
    /// image of the second body that is meant.
    pub(super) fn pairs(
        &mut self,
        grid: &mut Grid,
        (rows, cell): (&[Row], &Cell),
        (tol, room): (f64, usize),
        party: &mut Party,
        threads: &Threads,
    ) {
        self.lay(cell, rows, tol);
        let Self { images, strayed } = self;
        // Particle and shift from home of what is in the boxes.
        let meant = |k: u32| {
            let image = (k as usize).checked_sub(rows.len());
            image.map_or((k, HERE), |image| images[image])
        };
        let spot = |k: usize| {
            let (p, image) = meant(k as u32);
            let Row { x, radius, .. } = rows[p as usize];
            let home = brought_home(cell, x, strayed[p as usize]);
            let shift = cell.shift(image);
            Spot {
                x: [home[0] + shift[0], home[1] + shift[1]],
                radius,
                index: k as u32,
            }
        };
        grid.fill(rows.len() + images.len(), tol, spot);
        let levels = grid.levels.len();
        party.search(rows.len(), room, levels > 1, threads, |searcher| {
            let Searcher {
                stretch,
                near,
                partners,
                found,
            } = searcher;
            for p in stretch.clone() {
                let (a, home) = (spot(p), strayed[p]);
                partners.clear();
                let own = grid.level_of(a.radius);
                for level in own..levels {
                    near.clear();
                    // On the own level the other one looks, too.
                    let least = if level > own { 0 } else { a.index + 1 };
                    grid.gather(level, &a, least, near);
                    for &k in near.indices() {
                        let (j, shift) = meant(k);
                        let away = strayed[j as usize];
                        let image = [0, 1].map(|k| shift[k] - away[k] + home[k]);
                        // A particle and its own image meet in two places that are one contact.
                        if level > own || a.index < j || (a.index == j && image > HERE) {
                            partners.push(Partner::new(j, image));
                        }
                    }
                }
                sort_few(partners);
                for (j, image) in partners.iter().map(|partner| partner.meant()) {
                    if j < a.index {
                        found.late([j, a.index], image.map(|n| -n));
                    } else {
                        found.early([a.index, j], image);
                    }
                }
            }
        });
    }
}

/// The place [m] at home of what has strayed to an image of the cell.
#[inline(always)]
fn brought_home(cell: &Cell, x: [f64; 2], strayed: Image) -> [f64; 2] {
    if strayed == HERE {
        return x;
    }
    let shift = cell.shift(strayed);
    [x[0] - shift[0], x[1] - shift[1]]
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Against all images of all pairs in a wide neighbourhood, for cells that lean, are smaller
        /// than the reach, and particles of very different sizes that have strayed.
        #[test]
        fn finds_what_comparing_all_images_finds(
            points in prop::collection::vec((-3.0..3.0f64, -3.0..3.0f64, 0..4i32), 1..8),
            lean in -0.7..0.7f64,
            height in 0.3..1.5f64,
        ) {
            let cell = Cell { corner: [-0.2, 0.1], edges: [[1.0, 0.0], [lean, height]] };
            let row = |&(x, y, halved): &(f64, f64, i32)| Row {
                x: [x, y],
                radius: libm::ldexp(0.2, -2 * halved),
                ..Row::default()
            };
            let rows: Vec<Row> = points.iter().map(row).collect();
            let mut party = Party::default();
            let (mut tiling, mut grid) = (Tiling::default(), Grid::default());
            for _ in 0..2 {
                let threads = Threads::default();
                tiling.pairs(&mut grid, (&rows, &cell), (0.05, 0), &mut party, &threads);
            }
            let mut all = Vec::new();
            for i in 0..rows.len() {
                for j in i..rows.len() {
                    let reach = rows[i].radius + rows[j].radius + 0.05;
                    for n in -12..=12i16 {
                        for m in -40..=40i16 {
                            let s = cell.shift([n, m]);
                            let d = [0, 1].map(|k| rows[j].x[k] + s[k] - rows[i].x[k]);
                            let near = d[0] * d[0] + d[1] * d[1] < reach * reach;
                            if near && (i < j || [n, m] > HERE) {
                                all.push(([i as u32, j as u32], [n, m]));
                            }
                        }
                    }
                }
            }
            let mut found = Vec::new();
            party.each(|pair| found.push(pair));
            prop_assert_eq!(found, all);
        }
    }
}
