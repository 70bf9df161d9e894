//! How far particles and walls have moved since the list was made: what its halo is there for.

use serde::{Deserialize, Serialize};

use super::blocks::{Blocks, Moved};
use super::halos::Halos;
use crate::engine::extent::Extent;
use crate::engine::lanes::Lanes;
use crate::engine::particles::Row;
use crate::engine::threads::Threads;

/// A list that is measured goes on if less than this share of its one halo is spent. Measuring costs a
/// twentieth of making a list. Where particles use half of what is assumed, as where all fall, each
/// measurement halves what is left: the third, at .875, would cost more than it saves.
const SPENT: f64 = 0.85;

/// Way since the list was made.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(in crate::engine) struct Travel {
    /// Centres then [m].
    reference: Vec<[f64; 2]>,
    /// Three points of the plane then, and where the imposed flow has taken them since.
    frame: [[[f64; 2]; 3]; 2],
    /// No particle has moved further, but for the flow [m].
    furthest: f64,
    /// No two particles can have come nearer to each other by more, but for the flow [m].
    nearing: f64,
    /// No point of a wall near the assembly has moved further [m].
    wall: f64,
    /// No distance has been stretched by a larger share in the flow.
    stretch: f64,
    /// Largest distance of centres in the list [m].
    reach: f64,
    /// How far they may go.
    pub(super) halos: Halos,
    /// Ways of blocks, where halos differ.
    pub(in crate::engine) blocks: Blocks,
}

impl Travel {
    /// Bytes per particle.
    pub(super) const BYTES: usize = size_of::<[f64; 2]>();

    /// A list is made of particles with these centres [m].
    pub(super) fn begin(&mut self, centres: impl Iterator<Item = [f64; 2]>) {
        self.reference.clear();
        self.reference.extend(centres);
        (self.furthest, self.nearing) = (0.0, 0.0);
        self.stretch = 0.0;
    }

    /// Chooses the halo of the new list. With `local`, the extent and the largest and mean radius [m] of the
    /// assembly, halos differ from tile to tile and average `tol` [m]; without, `tol` holds everywhere.
    pub(super) fn lay(&mut self, local: Option<(Extent, [f64; 2])>, tol: f64) {
        self.blocks.learn(&self.halos, self.wall);
        let particles = self.reference.len();
        match &local {
            Some((extent, radii)) => self.halos.lay(extent, (particles, *radii), tol),
            None => self.halos.be_one(tol),
        }
        self.blocks
            .begin(&self.reference, &mut self.halos, self.wall);
        self.wall = 0.0;
    }

    /// After reading a checkpoint. False if it is not that of a list of so many particles.
    #[must_use]
    pub(super) fn unpack(&mut self, particles: usize) -> bool {
        self.reference.len() == particles
            && self.halos.fit()
            && self.blocks.unpack(&self.reference, &self.halos)
    }

    /// All of them are in this box [m], and listed ones not further apart than `reach` [m].
    pub(super) fn within(&mut self, [low, high]: [[f64; 2]; 2], reach: f64) {
        self.frame = [[low, [high[0], low[1]], [low[0], high[1]]]; 2];
        self.reach = reach;
    }

    /// Number of particles.
    pub(super) fn particles(&self) -> usize {
        self.reference.len()
    }

    /// In one more cycle no particle moved further than this [m].
    pub(in crate::engine) fn go_on(&mut self, step: f64) {
        self.furthest += step;
        self.nearing += 2.0 * step;
        self.blocks.come_nearer(2.0 * step);
    }

    /// In one more cycle no wall moved further than this [m].
    pub(in crate::engine) fn wall_goes_on(&mut self, step: f64) {
        self.wall += step;
        self.blocks.come_nearer(step);
    }

    /// Takes the centres that ways are measured from along with an imposed flow, which stretched nothing
    /// by a larger share than this: it is linear, so three points say where all of them are.
    pub(in crate::engine) fn flow_on(
        &mut self,
        stretched: f64,
        moved: impl Fn([f64; 2]) -> [f64; 2],
    ) {
        self.frame[1] = self.frame[1].map(moved);
        self.stretch += stretched;
        self.blocks.lose();
    }

    /// Whether all who can touch are listed for certain.
    pub(in crate::engine) fn lasts(&mut self, rows: &[Row], threads: &Threads) -> bool {
        if !self.blocks.are_there() {
            return self.nearer() < self.halos.mean();
        }
        let moved = Moved::new(rows, &self.reference, threads);
        self.blocks.last(&self.halos, self.wall, moved)
    }

    /// Whether, as far as was measured, nearly all of a halo is spent.
    pub(in crate::engine) fn is_spent(&self) -> bool {
        if self.blocks.are_there() {
            self.blocks.is_spent(&self.halos, self.wall)
        } else {
            self.nearer() >= SPENT * self.halos.mean()
        }
    }

    /// Looks how far particles really moved, but for the flow. No two can have come nearer by more than
    /// the diagonal of a box around all moves and none, nor than twice the furthest: what falls on what
    /// lies counts its way once.
    pub(in crate::engine) fn measure(&mut self, rows: &[Row], threads: &Threads) {
        if self.blocks.are_there() {
            let moved = Moved::new(rows, &self.reference, threads);
            return self.blocks.measure_all(&self.halos, moved);
        }
        let [old, new] = &self.frame;
        let size = [old[1][0] - old[0][0], old[2][1] - old[0][1]];
        let still = old == new;
        let carried = |x: [f64; 2]| {
            if still {
                return x;
            }
            let share = [0, 1].map(|k| (x[k] - old[0][k]) / size[k]);
            [0, 1].map(|k| {
                let along = [new[1][k] - new[0][k], new[2][k] - new[0][k]];
                new[0][k] + share[0] * along[0] + share[1] * along[1]
            })
        };
        // Square of the furthest move [m²], and the box of all and none [m].
        let none = (0.0, Extent::of([0.0; 2]));
        let moves = |first: usize, reference: &mut [[f64; 2]]| {
            let (mut square, mut all) = none;
            for (row, old) in rows[first..].iter().zip(reference) {
                let old = carried(*old);
                let d = [row.x[0] - old[0], row.x[1] - old[1]];
                square = (d[0] * d[0] + d[1] * d[1]).larger(square);
                all.take_in(d);
            }
            (square, all)
        };
        let both = |a: (f64, Extent), b: (f64, Extent)| (a.0.larger(b.0), a.1.and(b.1));
        let (square, all) = threads.join(&mut self.reference, none, moves, both);
        let [width, height] = all.size();
        let diagonal = (width * width + height * height).sqrt();
        self.furthest = square.sqrt();
        self.nearing = diagonal.smaller(2.0 * self.furthest);
    }

    /// What of the halo is spent, as far as was measured, one particle with another [m].
    pub(super) fn spending(&mut self) -> f64 {
        if self.blocks.are_there() {
            self.blocks.want(&self.halos)
        } else {
            self.nearer()
        }
    }

    /// How much nearer two particles, or a particle and a wall, can have come [m].
    pub(super) fn nearer(&self) -> f64 {
        let at_wall = self.furthest + self.wall;
        self.nearing.max(at_wall) + self.stretch * self.reach
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ways of particles from the origin.
    fn moved(by: &[[f64; 2]]) -> Travel {
        let mut travel = Travel::default();
        travel.begin(by.iter().map(|_| [0.0; 2]));
        travel.within([[-1.0; 2], [1.0; 2]], 2.0);
        let row = |&x: &[f64; 2]| Row {
            x,
            ..Row::default()
        };
        travel.measure(&by.iter().map(row).collect::<Vec<_>>(), &Threads::default());
        travel
    }

    #[test]
    fn what_falls_on_what_lies_comes_nearer_by_its_way() {
        let nearing = |by: &[[f64; 2]]| moved(by).nearing;
        assert_eq!(nearing(&[[0.0, -5.0], [0.0, 0.0]]), 5.0);
        // It counts as well where all fall: something lies still, as a rule, if only a wall.
        assert_eq!(nearing(&[[0.0, -5.0], [0.0, -5.0]]), 5.0);
        assert_eq!(nearing(&[[0.0, -5.0], [0.0, 1.0]]), 6.0);
        assert_eq!(nearing(&[[-3.0, 4.0], [3.0, -4.0]]), 10.0);
        // Not more than twice the furthest: a box has corners where nobody is.
        let cross = [[1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]];
        assert_eq!(nearing(&cross), 2.0);
    }

    #[test]
    fn ways_add_up_until_they_are_measured() {
        let mut travel = moved(&[[0.0, -5.0], [0.0, 1.0]]);
        assert_eq!(travel.nearer(), 6.0);
        travel.go_on(0.25);
        assert_eq!((travel.furthest, travel.nearer()), (5.25, 6.5));
        // A wall may come towards the furthest.
        travel.wall_goes_on(2.0);
        assert_eq!(travel.nearer(), 7.25);
        travel.flow_on(0.5, |x| x);
        assert_eq!(travel.nearer(), 8.25);
    }

    #[test]
    fn a_flow_ends_a_list_whose_halos_differ() {
        let centres = (0..900).map(|k| [f64::from(k % 30), f64::from(k / 30)]);
        let rows: Vec<Row> = (centres.clone())
            .map(|x| Row::new(x, 0.25, [0.0; 2], 0.0))
            .collect();
        let (mut travel, threads) = (Travel::default(), Threads::default());
        travel.begin(centres);
        let extent = Extent {
            low: [0.0; 2],
            high: [29.0; 2],
        };
        travel.lay(Some((extent, [0.25; 2])), 0.1);
        assert!(!travel.halos.is_one() && travel.lasts(&rows, &threads));
        travel.flow_on(0.0, |x| x);
        assert!(!travel.lasts(&rows, &threads));
        travel.measure(&rows, &threads);
        assert!(travel.is_spent());
    }

    #[test]
    fn what_the_flow_carries_along_has_not_moved() {
        let mut travel = moved(&[[0.0; 2]]);
        // To the right by as much as it is up, and up by one.
        travel.flow_on(0.0, |[x, y]| [x + y, y + 1.0]);
        let row = Row {
            x: [0.0, 1.5],
            ..Row::default()
        };
        travel.measure(&[row], &Threads::default());
        assert_eq!(travel.furthest, 0.5);
    }
}
