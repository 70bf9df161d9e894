//! What is booked in a cycle: half of the work of the forces at a boundary when a step departs from it,
//! half when one arrives.

use super::Ledger;
use super::axis::{Axis, Coming};
use crate::engine::World;
use crate::engine::boundary::straining::velocity;
use crate::engine::neighbours::Slot;
use crate::engine::neighbours::list::ContactList;
use crate::engine::particles::{Mobility, Sum};

impl Ledger {
    /// Books what each contact lost in the step just done, in the order of the list.
    fn book_contacts(&mut self, contacts: &ContactList, losses: [&[f64]; 3]) {
        let pairs = contacts.pairs.len();
        self.book_losses(&contacts.pairs, |pair| pair[0], losses);
        let at_walls = losses.map(|losses| &losses[pairs..]);
        self.book_losses(&contacts.walls, |wall| wall.particle, at_walls);
    }

    /// The same of some contacts, those of one first body after each other.
    fn book_losses<C>(&mut self, contacts: &[C], first: impl Fn(&C) -> u32, losses: [&[f64]; 3]) {
        let [sliding, slip, dashpots] = losses.map(|losses| &losses[..contacts.len()]);
        let mut k = 0;
        while k < contacts.len() {
            let p = first(&contacts[k]);
            let account = &mut self.accounts[p as usize];
            let ([mut slid, mut slipped], mut dashpot) = (account.friction, account.dashpots);
            while k < contacts.len() && first(&contacts[k]) == p {
                slid += sliding[k];
                slipped += slip[k];
                dashpot += dashpots[k];
                k += 1;
            }
            account.friction = [slid, slipped];
            account.dashpots = dashpot;
        }
    }
}

impl World {
    /// Books the second half of the work at this boundary, before the step.
    pub(in crate::engine) fn depart(&mut self) {
        let Some(mut ledger) = self.ledger.take() else {
            return;
        };
        self.settle();
        let coming = self.coming();
        let damped = coming.drag.is_some();
        for p in 0..self.particles.len() {
            // Nearly all of most scenes: nothing to book, and nothing to work out.
            let driven = self.is_driven(p, &coming);
            if !damped && !driven {
                continue;
            }
            let axes = self.axes(p, &coming);
            for axis in &axes {
                let drag = axis.drag();
                ledger.accounts[p].drag += self.half_work(drag, axis, 1)
                    + if self.first_kick {
                        0.0
                    } else {
                        self.half_work(drag, axis, 0)
                    };
            }
            if driven {
                self.book_driver(&mut ledger, p, &axes, 1);
            }
        }
        self.book_walls(&mut ledger);
        self.book_flow(&mut ledger);
        self.ledger = Some(ledger);
    }

    /// Books what the step just done cost, and the first half of the work at the new boundary.
    pub(in crate::engine) fn arrive(&mut self) {
        let Some(mut ledger) = self.ledger.take() else {
            return;
        };
        self.settle();
        let coming = self.coming();
        ledger.book_contacts(&self.contacts, self.pass().losses());
        for p in 0..self.particles.len() {
            if self.is_driven(p, &coming) {
                let axes = self.axes(p, &coming);
                self.book_driver(&mut ledger, p, &axes, 0);
            }
        }
        self.book_walls(&mut ledger);
        self.book_flow(&mut ledger);
        self.ledger = Some(ledger);
    }

    /// Whether somebody else than its neighbours does work on a particle: a force is applied, or a velocity
    /// prescribed, which leaves no answer to force.
    #[inline(always)]
    fn is_driven(&self, p: usize, coming: &Coming) -> bool {
        let Mobility { kick, turn, .. } = self.particles.mobility[p];
        kick.contains(&0.0) || coming.spins && turn == 0.0 || self.particles.applied(p) != [0.0; 2]
    }

    /// Work of applied forces and of whatever holds prescribed velocities, over half a step.
    fn book_driver(&self, ledger: &mut Ledger, p: usize, axes: &[Axis; 3], side: usize) {
        let applied = self.particles.applied(p);
        let mut work = 0.0;
        for (k, axis) in axes.iter().enumerate() {
            if axis.gain == 0.0 {
                work -= self.half_work(axis.force, axis, side);
            }
            // Against a prescribed velocity too: the holder took it on above.
            work += applied
                .get(k)
                .map_or(0.0, |&f| self.half_work(f, axis, side));
        }
        if work != 0.0 {
            ledger.accounts[p].work += work;
            ledger.turnover += work.abs();
        }
    }

    /// Work of the walls on the particles over half a step at their present velocity.
    fn book_walls(&self, ledger: &mut Ledger) {
        let first = self.contacts.pairs.len();
        for (w, wall) in self.walls.iter().enumerate() {
            if !wall.is_moving() {
                continue;
            }
            let mut work = 0.0;
            for (k, pair) in self.contacts.walls.iter().enumerate() {
                if pair.wall as usize == w {
                    let Slot([fx, fy, _, rolling]) = self.contacts.slots[first + k];
                    let v = wall.velocity_at(self.contacts.touches[k].at);
                    work += 0.5 * self.dt * (fx * v[0] + fy * v[1] - rolling * wall.spin);
                }
            }
            ledger.walls[w] += work;
            ledger.turnover += work.abs();
        }
    }

    /// Work of the imposed flow over half a step: it moves particles against the forces on them.
    fn book_flow(&self, ledger: &mut Ledger) {
        let Some((rate, centre)) = self.flow() else {
            return;
        };
        // Of all contacts together by what they sum to on each particle: F·d of a pair is F·x of either body,
        // as its forces are equal and opposite, but for the way to an image. As seen from one of them, since
        // their sum vanishes only to rounding and the centre of a flow may be far away.
        let near = self.particles.row.first().map_or(centre, |row| row.x);
        let from =
            |x: [f64; 2], point: [f64; 2]| velocity(&rate, [x[0] - point[0], x[1] - point[1]]);
        let mut power = 0.0;
        let particles = &self.particles;
        for (row, Sum { f, .. }) in particles.row.iter().zip(&particles.force) {
            let v = from(row.x, near);
            power -= f[0] * v[0] + f[1] * v[1];
        }
        // Weight only: what whoever applies a force does along the flow, the flow takes back.
        for (p, (row, body)) in particles.row.iter().zip(&particles.body).enumerate() {
            let (v, applied) = (from(row.x, centre), particles.applied(p));
            power -= (body[0] - applied[0]) * v[0] + (body[1] - applied[1]) * v[1];
        }
        // Walls stand outside the flow.
        let v = from(near, centre);
        for Slot([f1, f2, ..]) in &self.contacts.slots[self.contacts.pairs.len()..] {
            power -= f1 * v[0] + f2 * v[1];
        }
        if let Some(cell) = self.cell() {
            for (k, image) in self.contacts.images.beyond() {
                let v = velocity(&rate, cell.shift(image));
                let Slot([f1, f2, ..]) = self.contacts.slots[k];
                power += f1 * v[0] + f2 * v[1];
            }
        }
        let work = 0.5 * self.dt * power;
        ledger.flow += work;
        ledger.turnover += work.abs();
    }

    /// Work that the boundary does besides that of the forces on it [J].
    pub(in crate::engine) fn book_boundary(&mut self, work: f64) {
        if let Some(ledger) = &mut self.ledger {
            ledger.commands += work;
            ledger.turnover += work.abs();
        }
    }
}
