//! The search itself: pairs of particles, and pairs of particle and wall, within TOL.

use super::grid::{Grid, Spot};
use super::near::sort_few;
use super::party::{Party, Searcher};
use crate::engine::boundary::cell::HERE;
use crate::engine::particles::Row;
use crate::engine::threads::Threads;
use crate::engine::wall::Wall;
use crate::engine::wall_contact::{self, WallPair};

/// A particle as the boxes know it.
#[inline(always)]
fn spot(rows: &[Row], p: usize) -> Spot {
    let Row { x, radius, .. } = rows[p];
    Spot {
        x,
        radius,
        index: p as u32,
    }
}

/// Finds each pair nearer than `tol` [m]; leaves the boxes filled.
pub(super) fn pairs(
    grid: &mut Grid,
    rows: &[Row],
    (tol, room): (f64, usize),
    party: &mut Party,
    threads: &Threads,
) {
    grid.fill(rows.len(), tol, |p| spot(rows, p));
    let levels = grid.levels.len();
    party.search(rows.len(), room, levels > 1, threads, |searcher| {
        let Searcher {
            stretch,
            near,
            found,
            ..
        } = searcher;
        for p in stretch.clone() {
            let a = spot(rows, p);
            let own = grid.level_of(a.radius);
            near.clear();
            // On the own level the other one looks, too.
            grid.gather(own, &a, a.index + 1, near);
            if own + 1 < levels {
                let first = near.indices().len();
                for coarser in own + 1..levels {
                    grid.gather(coarser, &a, 0, near);
                }
                near.retain_from(first, |j| {
                    if j < a.index {
                        found.late([j, a.index], HERE);
                    }
                    j > a.index
                });
            }
            sort_few(near.indices_mut());
            let pairs = near.indices().iter().map(|&j| [a.index, j]);
            found.early.extend(pairs);
        }
    });
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
            grid.along(level, line, [wall.h1, wall.h2], margin, |spot| {
                test(spot.index as usize);
            });
        }
    }
    found.sort_unstable_by_key(|pair| [pair.particle, pair.wall]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::setup::WallSetup;
    use proptest::prelude::*;

    /// Sizes over three decades, so that levels differ, in an assembly that fits on a few boxes or
    /// on many.
    fn assembly() -> impl Strategy<Value = Vec<Row>> {
        let row = |(x, y, size): (f64, f64, f64)| Row {
            x: [x, y],
            radius: 1e-3 * libm::pow(1000.0, size),
            ..Row::default()
        };
        prop::collection::vec((-1.0..1.0f64, -0.3..0.3f64, 0.0..1.0f64), 0..120)
            .prop_map(move |rows| rows.into_iter().map(row).collect())
    }

    fn wall(from: [f64; 2], turn: f64, ends: [f64; 2]) -> Wall {
        let setup = WallSetup {
            name: String::new(),
            material: 0,
            point: from,
            direction: [libm::cos(turn), libm::sin(turn)],
            h1: ends[0],
            h2: ends[1],
            velocity: [0.0; 2],
            angular_velocity: 0.0,
            about: from,
        };
        Wall::new(&setup, [0.0; 2])
    }

    proptest! {
        #[test]
        fn finds_what_comparing_all_pairs_finds(
            rows in assembly(),
            equal in any::<bool>(),
            tol in 1e-5..0.05f64,
        ) {
            let mut rows = rows;
            if equal {
                for row in &mut rows {
                    row.radius = 0.05;
                }
            }
            let mut party = Party::default();
            let mut grid = Grid::default();
            // Twice, for what is left in the buffers.
            for threads in [1, 1, 3] {
                pairs(&mut grid, &rows, (tol, 0), &mut party, &Threads::new(threads));
            }
            let mut all = Vec::new();
            for p in 0..rows.len() {
                for q in p + 1..rows.len() {
                    if spot(&rows, p).is_near(&spot(&rows, q), tol) {
                        all.push([p as u32, q as u32]);
                    }
                }
            }
            let mut found = Vec::new();
            party.each(|pair| found.push(pair));
            let here: Vec<_> = all.into_iter().map(|pair| (pair, HERE)).collect();
            prop_assert_eq!(found, here);
            prop_assert!(equal || rows.len() < 40 || grid.levels.len() > 3);
        }

        #[test]
        fn walls_are_met_where_testing_everything_meets_them(
            rows in assembly(),
            walls in prop::collection::vec(
                ((-1.2..1.2f64, -0.5..0.5f64), 0..9u8, (-1.0..0.0f64, 0.0..1.0f64), 0..4u8), 1..6),
            tol in 1e-5..0.05f64,
        ) {
            let walls: Vec<Wall> = walls
                .into_iter()
                .map(|(at, turn, ends, open)| {
                    // Upright, level and slanting, with ends or without.
                    let turn = f64::from(turn) * std::f64::consts::FRAC_PI_8;
                    let h1 = if open & 1 == 0 { ends.0 } else { f64::NEG_INFINITY };
                    let h2 = if open & 2 == 0 { ends.1 } else { f64::INFINITY };
                    let mut wall = wall(at.into(), turn, [h1, h2]);
                    wall.direction = wall.direction.map(|e| if e.abs() < 1e-9 { 0.0 } else { e });
                    wall
                })
                .collect();
            let mut grid = Grid::default();
            let mut party = Party::default();
            pairs(&mut grid, &rows, (tol, 0), &mut party, &Threads::default());
            let [mut by_boxes, mut by_all] = [Vec::new(), Vec::new()];
            wall_pairs(Some(&grid), &rows, &walls, tol, &mut by_boxes);
            wall_pairs(None, &rows, &walls, tol, &mut by_all);
            prop_assert_eq!(by_boxes, by_all);
        }
    }
}
