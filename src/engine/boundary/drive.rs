//! What the boundary does in a cycle, before the particles move and after.

use super::cell::Cell;
use super::ring::{self, JOIN_EVERY};
use super::straining::{self, NONE, Straining, Tensor, plus, velocity};
use super::{Boundary, Kind};
use crate::engine::World;
use crate::engine::setup::BoundarySetup;

impl World {
    /// What strain and stress are imposed by, if anything.
    pub fn boundary(&self) -> Option<&Boundary> {
        self.boundary.as_ref()
    }

    /// The flow of a continuum besides the boundary, if any was asked for.
    pub fn continuum(&self) -> Option<&Straining> {
        self.continuum.as_ref()
    }

    /// The periodic cell, if there is one.
    pub fn cell(&self) -> Option<&Cell> {
        self.boundary.as_ref().and_then(Boundary::cell)
    }

    /// Strain that the boundary, or else the continuum, has imposed so far, compression positive.
    pub fn imposed_strain(&self) -> Option<Tensor> {
        let boundary = self.boundary.as_ref().map(|boundary| &boundary.straining);
        boundary.or(self.continuum.as_ref()).map(Straining::strain)
    }

    /// Strain rate that the boundary, or else the continuum, imposes [1/s].
    pub fn imposed_rate(&self) -> Option<Tensor> {
        let boundary = self.boundary.as_ref().map(|boundary| &boundary.straining);
        boundary.or(self.continuum.as_ref()).map(Straining::rate)
    }

    /// Strain rate of the flow that carries all particles [1/s], and the point at rest in it.
    pub(in crate::engine) fn flow(&self) -> Option<(Tensor, [f64; 2])> {
        let (rate, centre) = match (&self.boundary, &self.continuum) {
            (Some(boundary), _) if boundary.carries => (boundary.straining.rate(), boundary.centre),
            (Some(boundary), Some(flow)) => (flow.rate(), boundary.centre),
            (None, Some(flow)) => (flow.rate(), [-self.origin[0], -self.origin[1]]),
            (_, None) => return None,
        };
        (rate != NONE).then_some((rate, centre))
    }

    /// Velocity of the flow at a place relative to the origin of the world [m/s].
    pub fn flow_at(&self, x: [f64; 2]) -> [f64; 2] {
        self.flow().map_or([0.0; 2], |(rate, centre)| {
            velocity(&rate, [x[0] - centre[0], x[1] - centre[1]])
        })
    }

    /// Defines a boundary, or none. Particles that the old one held are free again.
    pub fn set_boundary(&mut self, boundary: Option<BoundarySetup>) {
        self.booked(|world| {
            world.keeping_velocities(|world| {
                world.release_ring();
                let origin = world.origin;
                world.model.boundary = boundary;
                world.boundary = boundary.map(|setup| Boundary::new(setup, origin, NONE));
                world.rework();
            });
        });
        self.join_ring();
    }

    /// Imposes a strain rate [1/s], reached over so many cycles. False without a boundary.
    pub fn set_strain_rate(&mut self, rate: Tensor, over: u64) -> bool {
        let cycle = self.cycle;
        let Some(boundary) = &mut self.boundary else {
            return false;
        };
        boundary.straining.set(rate, cycle, over);
        if matches!(boundary.kind, Kind::Walls) {
            self.drive_walls();
            return true;
        }
        if boundary.ring().is_some_and(super::Ring::is_loaded) {
            if let Kind::Ring(ring) = &mut boundary.kind {
                ring.hold();
            }
            self.hold_ring();
        }
        true
    }

    /// Lets the boundary carry all particles along, with whatever strain rate it imposes.
    pub fn carry_along(&mut self) {
        self.continuum = None;
        if let Some(boundary) = &mut self.boundary {
            boundary.carries = true;
        }
    }

    /// Lets all particles drift with a strain rate [1/s], reached over so many cycles; `None`: not any
    /// more.
    pub fn set_continuum(&mut self, rate: Option<Tensor>, over: u64) {
        let cycle = self.cycle;
        if let Some(boundary) = &mut self.boundary {
            boundary.carries = boundary.cell().is_some();
        }
        self.continuum = rate.map(|rate| {
            let mut flow = self.continuum.take().unwrap_or_default();
            flow.set(rate, cycle, over);
            flow
        });
    }

    /// What a servo adds to the strain rate of the boundary [1/s].
    pub fn steer_boundary(&mut self, rate: Tensor) {
        if let Some(boundary) = &mut self.boundary {
            boundary.straining.steer(rate);
            if matches!(boundary.kind, Kind::Walls) {
                self.drive_walls();
            }
        }
    }

    /// Lets the ring carry a stress [Pa], reached over so many cycles. False without a ring.
    pub fn load_boundary(&mut self, stress: Tensor, over: u64) -> bool {
        let cycle = self.cycle;
        let Some(Boundary {
            kind: Kind::Ring(ring),
            straining,
            centre,
            ..
        }) = &mut self.boundary
        else {
            return false;
        };
        let members: Vec<(u32, [f64; 2])> = (ring.members.iter())
            .filter_map(|&id| Some((id, self.particles.row[self.particles.index(id)?].x)))
            .collect();
        let seen = |x: [f64; 2]| [x[0] - centre[0], x[1] - centre[1]];
        let points: Vec<[f64; 2]> = members.iter().map(|(_, x)| seen(*x)).collect();
        let chain = ring::around(&points).into_iter().map(|k| members[k].0);
        ring.carry(stress, cycle, over, chain.collect());
        straining.set(NONE, cycle, 0);
        straining.steer(NONE);
        let turning = ring.turning;
        self.fix_ring([false, false, !turning]);
        self.booked(|world| world.keeping_velocities(Self::spread_load));
        true
    }

    /// Before a step: the boundary moves on, and what it holds gets its velocity.
    pub(in crate::engine) fn drive(&mut self) {
        if self.boundary.is_none() && self.continuum.is_none() {
            return;
        }
        if self.cycle.is_multiple_of(JOIN_EVERY) {
            self.join_ring();
        }
        let (cycle, dt) = (self.cycle, self.dt);
        // Walls that no strain moves may move as they are told.
        let moves = self
            .boundary
            .as_ref()
            .is_some_and(|b| !b.straining.is_still());
        for straining in [
            self.boundary
                .as_mut()
                .map(|boundary| &mut boundary.straining),
            self.continuum.as_mut(),
        ]
        .into_iter()
        .flatten()
        {
            straining.advance(cycle, dt);
        }
        match self.boundary.as_ref().map(|boundary| &boundary.kind) {
            Some(Kind::Ring(ring)) if !ring.is_loaded() => self.drive_ring(),
            Some(Kind::Walls) if moves => self.drive_walls(),
            _ => {}
        }
    }

    /// The part of a step that is the flow's, but for the particles: the cell, the curve of the ring,
    /// and what their travel is measured from.
    pub(in crate::engine) fn drift(&mut self) {
        let dt = self.dt;
        if let Some(Boundary {
            kind,
            centre,
            straining,
            ..
        }) = &mut self.boundary
        {
            let rate = straining.rate();
            match kind {
                Kind::Cell(cell) => cell.deform(&rate, *centre, dt),
                Kind::Ring(ring) => ring.deform(&rate, dt),
                Kind::Walls => {}
            }
        }
        if self.flow().is_some() {
            self.stand_up();
        }
        let Some((rate, centre)) = self.flow() else {
            return;
        };
        let moved = |x: [f64; 2]| {
            let v = velocity(&rate, [x[0] - centre[0], x[1] - centre[1]]);
            [x[0] + v[0] * dt, x[1] + v[1] * dt]
        };
        // Neighbours come nearer by no more than this share of their distance.
        let stretched = straining::size(&rate) * dt;
        self.contacts.travel.flow_on(stretched, moved);
    }

    /// Takes edges of the cell that lean less, once they lean too much: the same particles and images, under
    /// other names.
    fn stand_up(&mut self) {
        let Some(turn) = self.cell().and_then(Cell::upright) else {
            return;
        };
        let contacts = &mut self.contacts;
        if !contacts
            .images
            .rename(&contacts.pairs, |image| turn.image(image))
        {
            return;
        }
        if let Some(Boundary {
            kind: Kind::Cell(cell),
            ..
        }) = &mut self.boundary
        {
            cell.set_upright(turn);
        }
        self.see();
    }

    /// After a step: a loaded ring takes its share of the stress where it is now.
    pub(in crate::engine) fn spread_load(&mut self) {
        let stress = match &mut self.boundary {
            Some(Boundary {
                kind: Kind::Ring(ring),
                ..
            }) => ring.stress_at(self.cycle),
            _ => None,
        };
        let Some(stress) = stress else { return };
        let thickness = self.thickness();
        let Some(Boundary {
            kind: Kind::Ring(ring),
            ..
        }) = &self.boundary
        else {
            return;
        };
        let particles = &mut self.particles;
        let chain = ring.chain();
        let place = |k: usize| particles.index(chain[k % chain.len()]);
        // Particles that were deleted leave a gap that the next one closes.
        let found = |mut ks: std::ops::Range<usize>| ks.find_map(place);
        for k in 0..chain.len() {
            let n = chain.len();
            let before = (1..n).find_map(|back| place(k + n - back));
            let (Some(p), Some(before), Some(after)) = (place(k), before, found(k + 1..k + n))
            else {
                continue;
            };
            let rows = &particles.row;
            self.loads.push((
                p,
                ring::corner_force(rows[before].x, rows[after].x, &stress, thickness),
            ));
        }
        for (p, force) in self.loads.drain(..) {
            particles.apply(p, force);
        }
        self.weigh();
    }

    /// Velocities of boundary particles, as the strain rate says. What that takes is work of the
    /// boundary.
    fn drive_ring(&mut self) {
        let Some(Boundary {
            kind: Kind::Ring(ring),
            centre,
            straining,
            carries,
        }) = &self.boundary
        else {
            return;
        };
        // The flow carries the ring along; only what it lacks is the ring's own.
        let rate = match &self.continuum {
            _ if *carries => NONE,
            Some(flow) => plus(straining.rate(), flow.rate(), -1.0),
            None => straining.rate(),
        };
        let mut work = 0.0;
        for &id in &ring.members {
            let Some(p) = self.particles.index(id) else {
                continue;
            };
            let (row, m) = (&mut self.particles.row[p], self.particles.mass[p]);
            let v = velocity(&rate, [row.x[0] - centre[0], row.x[1] - centre[1]]);
            let gain = v[0] * v[0] + v[1] * v[1] - row.v[0] * row.v[0] - row.v[1] * row.v[1];
            work += 0.5 * m * gain;
            row.v = v;
        }
        self.book_boundary(work);
    }

    /// Walls move and turn as lines of the strained plane do, without getting longer.
    fn drive_walls(&mut self) {
        let Some(Boundary {
            centre, straining, ..
        }) = &self.boundary
        else {
            return;
        };
        let rate = straining.rate();
        for wall in &mut self.walls {
            let [e1, e2] = wall.direction;
            let turn = velocity(&rate, [e1, e2]);
            wall.spin = e1 * turn[1] - e2 * turn[0];
            let middle = wall.middle();
            let v = velocity(&rate, [middle[0] - centre[0], middle[1] - centre[1]]);
            let arm = [wall.about[0] - middle[0], wall.about[1] - middle[1]];
            wall.velocity = [v[0] - wall.spin * arm[1], v[1] + wall.spin * arm[0]];
        }
    }

    /// Free particles more than half outside the curve join the ring.
    pub(in crate::engine) fn join_ring(&mut self) {
        if self.enlist() {
            self.hold_ring();
        }
    }

    /// Adds the free particles more than half outside the curve to the ring. Whether there were any.
    fn enlist(&mut self) -> bool {
        let Some(Boundary {
            kind: Kind::Ring(ring),
            centre,
            ..
        }) = &mut self.boundary
        else {
            return false;
        };
        if ring.is_loaded() {
            return false;
        }
        let particles = &self.particles;
        let mut new = Vec::new();
        for p in 0..particles.len() {
            let (x, id) = (particles.row[p].x, particles.id[p]);
            if particles.fixed[p] == [false; 3]
                && ring.is_outside([x[0] - centre[0], x[1] - centre[1]])
                && ring.members.binary_search(&id).is_err()
            {
                new.push(id);
            }
        }
        ring.members.extend(&new);
        ring.members.sort_unstable();
        !new.is_empty()
    }

    /// The first ring of a world that has no forces yet.
    pub(in crate::engine) fn found_ring(&mut self) {
        self.enlist();
        let Some(ring) = self.boundary.as_ref().and_then(Boundary::ring) else {
            return;
        };
        let fixed = [true, true, !ring.turning];
        for id in ring.members.clone() {
            if let Some(p) = self.particles.index(id) {
                self.particles.fixed[p] = fixed;
                self.particles.row[p].v = [0.0; 2];
                self.particles.row[p].set_spin(0.0);
            }
        }
    }

    /// Velocities of boundary particles are prescribed, those of the present strain rate.
    fn hold_ring(&mut self) {
        let turning = self.boundary.as_ref().and_then(Boundary::ring);
        let Some(turning) = turning.map(|ring| ring.turning) else {
            return;
        };
        self.fix_ring([true, true, !turning]);
        self.drive_ring();
    }

    fn fix_ring(&mut self, fixed: [bool; 3]) {
        let Some(ring) = self.boundary.as_ref().and_then(Boundary::ring) else {
            return;
        };
        let members = ring.members.clone();
        self.booked(|world| {
            world.keeping_velocities(|world| {
                for id in members {
                    let Some(p) = world.particles.index(id) else {
                        continue;
                    };
                    world.particles.fixed[p] = fixed;
                    world.particles.apply(p, [0.0; 2]);
                    if fixed[2] {
                        world.particles.row[p].set_spin(0.0);
                    }
                }
                world.weigh();
                world.mobilise();
                world.reprepare();
            });
        });
    }

    fn release_ring(&mut self) {
        if self.boundary.as_ref().is_some_and(|b| b.ring().is_some()) {
            self.fix_ring([false; 3]);
        }
    }
}
