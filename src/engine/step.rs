//! The cycle: forces to motion to forces. Cundall & Strack 1979.
//!
//! At every boundary n the positions `x_n`, the contact forces `F_n(x_n, v_{n-½})` and the
//! velocities `v_{n-½}` belong together.

use super::World;
use super::boundary::{Boundary, straining};
use super::contact::pass::View;
use super::extent::Extent;
use super::fault::Fault;
use super::motion::{self, Dragged, Inputs, Sums, Watch};
use super::neighbours::list::Wanted;
use super::neighbours::{Slot, Status};
use super::particles::{Particles, Row, Sum};
use super::phase::{Phase, passed};
use super::rows::Rows;
use super::setup::Gravity;
use super::threads::Threads;
use super::time_step::FRACC_WARNING;
use super::wall::Wall;
use super::wall_contact;

/// Cycles after which the scale of the forces on a particle is made anew: it is compared with rounding
/// errors, where an order of magnitude is enough.
const SIZE_EVERY: u64 = 64;

/// A list of this age [cycles], and of each power of two beyond, is asked whether it is too wide.
const LOOK_AFTER: u64 = 32;

/// It is, and is made anew, if the best halo would be less than this share of the present one.
const WIDE: f64 = 0.5;

impl World {
    /// One cycle: motion under the present forces, then the forces of the new positions. After a
    /// fault it does nothing but answer it again.
    pub fn cycle(&mut self) -> Result<(), Fault> {
        if let Some(fault) = self.fault() {
            return Err(fault.clone());
        }
        let done = self.step();
        if let Err(fault) = &done {
            self.broken = Some(fault.clone());
        }
        done
    }

    fn step(&mut self) -> Result<(), Fault> {
        self.drive();
        self.depart();
        self.drift();
        passed(&mut self.clock, Phase::Boundary);
        self.motion()?;
        passed(&mut self.clock, Phase::Motion);
        for wall in &mut self.walls {
            wall.advance(self.dt);
        }
        self.spread_load();
        // Weight belongs to the boundary like the contact forces.
        if matches!(self.model.gravity, Some(Gravity::Centripetal { .. })) {
            self.weigh();
        }
        passed(&mut self.clock, Phase::Walls);
        self.touch(self.dt)?;
        self.arrive();
        self.keep_step();
        passed(&mut self.clock, Phase::Rest);
        Ok(())
    }

    fn motion(&mut self) -> Result<(), Fault> {
        let watch = self.pass_over_particles(motion::advance);
        self.seen.have_followed();
        self.note_fracc(&watch);
        self.cycle += 1;
        self.first_kick = false;
        self.settled = false;
        self.contacts.travel.go_on(watch.fastest.sqrt() * self.dt);
        if watch.tame {
            return Ok(());
        }
        self.wild_particle().map_or(Ok(()), Err)
    }

    /// Sums the forces of this boundary, once.
    pub fn settle(&mut self) {
        if !self.settled {
            let watch = self.pass_over_particles(motion::settle);
            self.note_fracc(&watch);
            self.settled = true;
        }
    }

    pub(super) fn pass_over_particles(
        &mut self,
        work: impl Fn(Inputs<'_>, &mut Rows, &mut [Sum], &mut [Extent], &Threads) -> Watch,
    ) -> Watch {
        let mut ways = self.contacts.travel.blocks.take();
        let part = self.kick_part();
        let flow = self.flow();
        // Before the first step nothing has changed yet.
        let fracc = !self.first_kick && self.fracc_due_at(self.cycle);
        let sums = if self.settled {
            Sums::Done
        } else if self.cycle.is_multiple_of(SIZE_EVERY) {
            Sums::Sized
        } else if fracc || self.fracc_due_at(self.cycle + 1) {
            Sums::Kept
        } else {
            Sums::Used
        };
        let Self {
            particles,
            contacts,
            model,
            threads,
            boundary,
            seen,
            ..
        } = self;
        let cell = boundary.as_ref().and_then(Boundary::cell);
        let inputs = Inputs {
            contacts,
            mobility: &particles.mobility,
            body: &particles.body,
            dt: self.dt,
            part,
            sums,
            fracc,
            limit: 0.7 * contacts.smallest / self.dt,
            flow,
            drag: Dragged::new(&model.damping, part * self.dt),
            beyond: cell.map(|cell| seen.ahead(cell)),
            isa: self.isa,
        };
        let Particles { row, force, .. } = particles;
        let watch = work(inputs, row, force, &mut ways, threads);
        contacts.travel.blocks.give_back(ways);
        watch
    }

    /// Whether any particle turns or can be made to.
    pub(super) fn spins(&self) -> bool {
        self.model.rotation && (self.pass().tangential() || self.turning)
    }

    fn fracc_due_at(&self, cycle: u64) -> bool {
        cycle.is_multiple_of(u64::from(self.model.fracc_every))
    }

    /// The first kick is half a step.
    pub(super) fn kick_part(&self) -> f64 {
        if self.first_kick { 0.5 } else { 1.0 }
    }

    fn note_fracc(&mut self, watch: &Watch) {
        if self.settled || self.first_kick || !self.fracc_due_at(self.cycle) {
            return;
        }
        let (fourth, index) = watch.fracc;
        let fracc = motion::fracc(fourth);
        let monitor = &mut self.fracc;
        monitor.largest = Some(monitor.largest.map_or(fracc, |before| before.max(fracc)));
        if fracc > FRACC_WARNING {
            let seen = (self.cycle, self.particles.id[index], fracc);
            monitor.warnings += 1;
            monitor.last = Some(seen);
            if monitor.worst.is_none_or(|worst| fracc > worst.2) {
                monitor.worst = Some(seen);
            }
        }
    }

    /// Finds the neighbours if need be and evaluates all contacts over a step of `dt` [s]; 0 only
    /// evaluates.
    pub(super) fn touch(&mut self, dt: f64) -> Result<(), Fault> {
        self.find_neighbours()?;
        passed(&mut self.clock, Phase::Neighbours);
        self.locate_walls()?;
        passed(&mut self.clock, Phase::Walls);
        let mut pass = self.take_pass();
        let flow = self.flow();
        let contacts = &mut self.contacts;
        let mut pairs = &contacts.pairs;
        if let Some(cell) = self.boundary.as_ref().and_then(Boundary::cell) {
            self.seen.look(&mut self.particles.row, cell);
            pairs = &self.seen.pairs;
        }
        passed(&mut self.clock, Phase::Boundary);
        let view = View {
            rows: self.particles.row.seen(),
            pairs,
            flow,
            wall_pairs: &contacts.walls,
            wall_touches: &contacts.touches,
            dt,
            isa: self.isa,
        };
        pass.evaluate(
            view,
            &mut contacts.slots,
            &mut contacts.status,
            &self.threads,
        );
        passed(&mut self.clock, Phase::Contacts);
        self.put_pass(pass);
        self.settled = false;
        Ok(())
    }

    /// Makes the list again when something may have come nearer by TOL since it was made.
    fn find_neighbours(&mut self) -> Result<(), Fault> {
        let moved = self
            .walls
            .iter()
            .map(|wall| self.reach_of(wall))
            .fold(0.0, f64::max);
        let drifted = self.drift_past_walls();
        if moved * self.dt > self.contacts.smallest && self.contacts.rebuilds > 0 {
            return Err(self.wall_that_ran_away());
        }
        let reach = self.bond_reach();
        let contacts = &mut self.contacts;
        contacts.travel.wall_goes_on((moved + drifted) * self.dt);
        if contacts.rebuilds == 0 {
            self.lost_particle()?;
            self.relist();
            return Ok(());
        }
        let chosen = self.model.tol.is_none();
        let age = self.cycle.saturating_sub(contacts.made);
        let due = chosen && age >= LOOK_AFTER && age.is_power_of_two();
        let rows = &self.particles.row;
        if contacts.travel.lasts(rows, &self.threads) && !due {
            return Ok(());
        }
        // The sum of largest speeds overestimates: look before searching.
        contacts.travel.measure(rows, &self.threads);
        let usage = contacts.usage(self.cycle);
        let wide = due && usage.best().max(reach) < WIDE * usage.tol;
        if !contacts.travel.is_spent() && !wide {
            return Ok(());
        }
        self.lost_particle()?;
        if chosen {
            self.tol = usage.next();
        }
        self.make_list(false);
        Ok(())
    }

    /// Makes the list and carries the memory over; every contact is prepared again.
    pub(super) fn relist(&mut self) {
        self.make_list(true);
    }

    /// Makes the list; `again`: every contact is prepared again, not only new ones.
    pub(super) fn make_list(&mut self, again: bool) {
        let mut pass = self.take_pass();
        let mut contacts = std::mem::take(&mut self.contacts);
        // A pair whose bond holds is listed, however far apart; where halos differ, some are narrower.
        let reach = self.bond_reach();
        let wanted = Wanted {
            tol: self.tol.max(reach),
            local: self.model.tol.is_none() && self.flow().is_none() && reach == 0.0,
            isa: self.isa,
            threads: &self.threads,
        };
        let old = contacts.rebuild(&self.particles, &self.walls, self.cell(), wanted);
        contacts.made = self.cycle;
        self.tol = contacts.halo();
        self.contacts = contacts;
        self.see();
        let (pairs, room) = (self.contacts.pairs.len(), self.room());
        let basis = &|k: usize| self.basis(k);
        if again {
            pass.relist(&old, pairs, room, basis);
        } else {
            pass.follow(&old, pairs, room, basis);
        }
        self.contacts.give_back(old);
        self.put_pass(pass);
    }

    /// Rows and pairs as the contacts read them, where there is a cell.
    pub(super) fn see(&mut self) {
        if self.cell().is_some() {
            let contacts = &self.contacts;
            let rows = &mut self.particles.row;
            self.seen.relist(rows, &contacts.pairs, &contacts.images);
        } else {
            self.particles.row.show(0);
        }
    }

    fn wall_that_ran_away(&self) -> Fault {
        let by_speed = |a: &&Wall, b: &&Wall| self.reach_of(a).total_cmp(&self.reach_of(b));
        let fastest = self.walls.iter().max_by(by_speed);
        Fault::WallRunaway {
            cycle: self.cycle,
            wall: fastest.map_or_else(String::new, |wall| wall.name.clone()),
            distance: fastest.map_or(0.0, |wall| self.reach_of(wall) * self.dt),
        }
    }

    /// Largest speed with which the flow carries any particle past resting walls [m/s].
    fn drift_past_walls(&self) -> f64 {
        let Some((rate, centre)) = self.flow().filter(|_| !self.walls.is_empty()) else {
            return 0.0;
        };
        let [low, high] = self.contacts.span;
        let far = [0, 1].map(|k| (centre[k] - low[k]).abs().max((high[k] - centre[k]).abs()));
        straining::size(&rate) * (far[0] * far[0] + far[1] * far[1]).sqrt()
    }

    /// Largest speed of any point of a wall that a particle can meet [m/s].
    fn reach_of(&self, wall: &Wall) -> f64 {
        let speed = |v: [f64; 2]| (v[0] * v[0] + v[1] * v[1]).sqrt();
        if wall.spin == 0.0 {
            return speed(wall.velocity);
        }
        let [low, high] = self.contacts.span;
        let far = [0, 1].map(|k| {
            let about = wall.about[k];
            (about - low[k]).abs().max((high[k] - about).abs())
        });
        speed(wall.velocity) + wall.spin.abs() * speed(far)
    }

    fn locate_walls(&mut self) -> Result<(), Fault> {
        let share = self.joint(self.contacts.smallest);
        let first = self.contacts.pairs.len();
        for w in 0..self.contacts.walls.len() {
            let pair = &mut self.contacts.walls[w];
            let row: &Row = &self.particles.row[pair.particle as usize];
            match wall_contact::locate(&self.walls, pair, row, share) {
                Ok((touch, taker)) => {
                    self.contacts.touches[w] = touch;
                    if let Some(taker) = taker {
                        self.hand_over(first, w, taker);
                    }
                }
                Err(wall_contact::Through) => {
                    return Err(Fault::ThroughWall {
                        cycle: self.cycle,
                        particle: self.particles.id[pair.particle as usize],
                        wall: self.walls[pair.wall as usize].name.clone(),
                    });
                }
            }
        }
        Ok(())
    }

    /// A particle that rolls over a joint keeps its contact memory.
    fn hand_over(&mut self, first: usize, from: usize, taker: u32) {
        if self.contacts.status[first + from] == Status::Apart {
            return;
        }
        let particle = self.contacts.walls[from].particle;
        let to = self
            .contacts
            .walls
            .binary_search_by_key(&(particle, taker), |pair| (pair.particle, pair.wall));
        if let Ok(to) = to
            && self.contacts.status[first + to] == Status::Apart
        {
            let mut pass = self.take_pass();
            pass.hand_over(first + from, first + to);
            self.put_pass(pass);
            let contacts = &mut self.contacts;
            contacts.status.swap(first + from, first + to);
            contacts.slots[first + from] = Slot::default();
        }
    }
}
