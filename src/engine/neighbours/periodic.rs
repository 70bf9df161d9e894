//! The pairs of a periodic cell: every particle at home with the images of all others around it.

use super::grid::Grid;
use super::halos::Halos;
use super::near::{by_few, sort_few};
use super::partner::Partner;
use super::party::{Look, Party, Searcher};
use super::search::Sought;
use super::spot::Spot;
use crate::engine::boundary::cell::{Cell, HERE, Image, whole_below};
use crate::engine::lanes::Lanes;
use crate::engine::particles::Row;

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
        sought: Sought<'_>,
        party: &mut Party,
    ) {
        let Sought { halos, threads, .. } = sought;
        self.lay(cell, rows, halos.mean());
        let at = Tiled {
            rows,
            cell,
            tiling: self,
        };
        let count = rows.len() + self.images.len();
        grid.fill(count, halos.mean(), threads, |k| at.spot(k));
        let late = grid.levels.len() > 1;
        party.search(rows.len(), late, sought, &Around { grid, at, halos });
    }
}

/// Particles at home, and behind them the images around.
#[derive(Clone, Copy)]
struct Tiled<'a> {
    rows: &'a [Row],
    cell: &'a Cell,
    tiling: &'a Tiling,
}

impl Tiled<'_> {
    /// Particle and shift from home of what is in the boxes.
    #[inline(always)]
    fn meant(&self, k: u32) -> (u32, Image) {
        let image = (k as usize).checked_sub(self.rows.len());
        image.map_or((k, HERE), |image| self.tiling.images[image])
    }

    #[inline(always)]
    fn spot(&self, k: usize) -> Spot {
        let (p, image) = self.meant(k as u32);
        let Row { x, radius, .. } = self.rows[p as usize];
        let home = brought_home(self.cell, x, self.tiling.strayed[p as usize]);
        let shift = self.cell.shift(image);
        Spot::new([home[0] + shift[0], home[1] + shift[1]], radius)
    }
}

/// Looks around particles at home.
struct Around<'a> {
    grid: &'a Grid,
    at: Tiled<'a>,
    halos: &'a Halos,
}

impl Look for Around<'_> {
    #[inline(always)]
    fn look<V: Lanes>(&self, searcher: &mut Searcher) {
        let strayed = &self.at.tiling.strayed;
        let Searcher {
            stretch,
            near,
            partners,
            found,
        } = searcher;
        for few in by_few(stretch.clone()) {
            self.grid.gather::<V>(few.clone(), self.halos, near);
            for (k, p) in few.enumerate() {
                let (noted, own) = near.of(k);
                let (home, p) = (strayed[p], p as u32);
                partners.clear();
                for (n, &k) in noted.iter().enumerate() {
                    let (j, shift) = self.at.meant(k);
                    let away = strayed[j as usize];
                    let image = [0, 1].map(|k| shift[k] - away[k] + home[k]);
                    // A particle and its own image meet in two places that are one contact.
                    if n >= own || p < j || (p == j && image > HERE) {
                        partners.push(Partner::new(j, image));
                    }
                }
                sort_few(partners, Partner::MOST);
                for (j, image) in partners.iter().map(|partner| partner.meant()) {
                    if j < p {
                        found.late([j, p], image.map(|n| -n));
                    } else {
                        found.early([p, j], image);
                    }
                }
            }
        }
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
    use crate::engine::lanes::Isa;
    use crate::engine::threads::Threads;
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
            let mut party = Party::default();
            let (mut tiling, mut grid) = (Tiling::default(), Grid::default());
            for isa in Isa::ALL.into_iter().filter(|isa| isa.is_here()) {
                let threads = &Threads::default();
                let halos = &Halos::everywhere(0.05);
                let sought = Sought { halos, isa, threads };
                tiling.pairs(&mut grid, (&rows, &cell), sought, &mut party);
                prop_assert_eq!(&party.found().in_order(), &all, "{}", isa);
            }
        }
    }

    /// Sizes of two kinds, some strayed, in shares of several threads: as one alone finds them.
    #[test]
    fn threads_find_what_one_finds() {
        let cell = Cell {
            corner: [0.0; 2],
            edges: [[25.0, 0.0], [3.0, 20.0]],
        };
        let rows: Vec<Row> = (0..500)
            .map(|k| Row {
                x: [
                    f64::from(k % 25) + 25.0 * f64::from(k % 7 == 0),
                    f64::from(k / 25),
                ],
                radius: if k % 10 == 0 { 2.0 } else { 0.51 },
                ..Row::default()
            })
            .collect();
        let found = |threads: usize| {
            let (mut party, mut grid) = (Party::default(), Grid::default());
            let sought = Sought {
                halos: &Halos::everywhere(0.05),
                isa: Isa::default(),
                threads: &Threads::new(threads),
            };
            for _ in 0..2 {
                Tiling::default().pairs(&mut grid, (&rows, &cell), sought, &mut party);
            }
            assert!(grid.levels.len() > 1);
            let all = party.found().in_order();
            assert!(all.is_sorted(), "{threads}");
            all
        };
        let one = found(1);
        let away = one.iter().filter(|(_, image)| *image != HERE).count();
        assert!(one.len() > 1500 && away > 100, "{} {away}", one.len());
        assert_eq!(found(2), one);
        assert_eq!(found(3), one);
    }
}
