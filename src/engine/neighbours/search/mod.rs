//! The search itself: pairs of particles, and pairs of particle and wall, within TOL.

use super::grid::Grid;
use super::halos::Halos;
use super::near::{by_few, sort_few};
use super::party::{Look, Party, Searcher};
use super::spot::Spot;
use crate::engine::boundary::cell::HERE;
use crate::engine::lanes::{Isa, Lanes};
use crate::engine::particles::Row;
use crate::engine::threads::Threads;
use crate::engine::wall::Wall;
use crate::engine::wall_contact::{self, WallPair};

/// What is sought, and by whom.
#[derive(Clone, Copy)]
pub(super) struct Sought<'a> {
    /// Whoever is nearer than the halo of the one who looks.
    pub(super) halos: &'a Halos,
    pub(super) isa: Isa,
    pub(super) threads: &'a Threads,
}

/// Finds each pair that is sought; leaves the boxes filled.
pub(super) fn pairs(grid: &mut Grid, rows: &[Row], sought: Sought<'_>, party: &mut Party) {
    let Sought { halos, threads, .. } = sought;
    let spot = |p: usize| {
        let Row { x, radius, .. } = rows[p];
        Spot {
            x,
            radius,
            tile: halos.tile(x),
            home: 0,
        }
    };
    grid.fill(rows.len(), halos.mean(), threads, spot);
    let late = grid.levels.len() > 1;
    party.search(rows.len(), late, sought, &Around { grid, halos });
}

/// Looks around particles where there is no cell.
struct Around<'a> {
    grid: &'a Grid,
    halos: &'a Halos,
}

impl Look for Around<'_> {
    #[inline(always)]
    fn look<V: Lanes>(&self, searcher: &mut Searcher) {
        let Searcher {
            stretch,
            near,
            found,
            ..
        } = searcher;
        for few in by_few(stretch.clone()) {
            self.grid.gather::<V>(few.clone(), self.halos, near);
            for (k, p) in few.enumerate() {
                let (noted, own) = near.of(k);
                let p = p as u32;
                let mut after = own;
                for other in own..noted.len() {
                    if noted[other] < p {
                        found.late([noted[other], p], HERE);
                    } else {
                        noted[after] = noted[other];
                        after += 1;
                    }
                }
                let partners = &mut noted[..after];
                sort_few(partners, u32::MAX);
                found.early.extend(partners.iter().map(|&j| [p, j]));
            }
        }
    }
}

/// Finds each particle nearer to a wall than `tol` [m]: ascending particles, ascending walls. The
/// boxes must be those of [`pairs`], or `None` where centres are not where the boxes have them.
pub(super) fn wall_pairs(
    grid: Option<&Grid>,
    rows: &[Row],
    walls: &[Wall],
    tol: f64,
    found: &mut Vec<WallPair>,
) {
    for (w, wall) in walls.iter().enumerate() {
        let mut test = |p: usize| {
            let row = &rows[p];
            if wall_contact::distance(wall, row.x) < row.radius + tol {
                found.push(WallPair {
                    particle: p as u32,
                    wall: w as u32,
                    side: wall_contact::side(wall, row.x),
                });
            }
        };
        let Some(grid) = grid else {
            (0..rows.len()).for_each(test);
            continue;
        };
        let line = [wall.point, wall.direction];
        for level in &grid.levels {
            let margin = level.largest + tol;
            grid.along(level, line, [wall.h1, wall.h2], margin, &mut test);
        }
    }
    found.sort_unstable_by_key(|pair| [pair.particle, pair.wall]);
}

#[cfg(test)]
mod tests;
