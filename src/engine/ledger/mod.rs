//! Where the energy went.
//!
//! The work of a force at boundary n is `F_n·(dx_{n-½} + dx_{n+½})/2`: half of it is booked when
//! the step before arrives at n, half when the next departs. With the velocity v of the boundary,
//! which is the mean of those of the half steps around it, kinetic energy is m v²/2; what the balance
//! needs for a linear spring to close to rounding is the product of those two velocities, m v₋ v₊/2,
//! which is less by m (v₊ - v₋)²/8, of second order in the step. Sums run over particles, walls and contacts in their
//! order, and pairs apart add nothing, so they do not depend on TOL or threads.

mod axis;
mod booking;

use serde::{Deserialize, Serialize};

use super::World;
use super::keep::only;
use super::neighbours::Status;
use super::setup::Gravity;

/// Cumulative bookings [J].
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Ledger {
    /// Per particle: slip, contact dashpots, damping of motion, work of what moves it.
    accounts: Vec<Account>,
    /// Work of each wall.
    walls: Vec<f64>,
    /// Work of the imposed flow.
    flow: f64,
    /// Energy that commands put in.
    commands: f64,
    /// Sum of |work| booked so far.
    turnover: f64,
    /// Accounts of deleted particles and walls.
    closed: Account,
    /// Energy stored at the start.
    opening: f64,
}

/// What is booked per particle [J]; contact losses go to the lower number.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
struct Account {
    friction: [f64; 2],
    dashpots: f64,
    drag: f64,
    work: f64,
}

/// What the ledger keeps of each particle [bytes].
pub(in crate::engine) const BYTES_PER_PARTICLE: usize = size_of::<Account>();

impl Account {
    fn add(&mut self, other: &Self) {
        for (sum, loss) in self.friction.iter_mut().zip(other.friction) {
            *sum += loss;
        }
        self.dashpots += other.dashpots;
        self.drag += other.drag;
        self.work += other.work;
    }
}

/// Energies at a boundary [J].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Energies {
    /// Translational kinetic energy of what particles do beside an imposed flow, with the velocities
    /// of this boundary.
    pub kinetic: f64,
    /// Rotational kinetic energy, with the spins of this boundary.
    pub rotational: f64,
    /// Normal springs.
    pub elastic_normal: f64,
    /// Tangential springs, and those of rolling resistance.
    pub elastic_tangential: f64,
    /// Gravity, zero at the start.
    pub potential: f64,
    /// What the balance takes off kinetic and rotational energy: of second order in the step.
    pub transit: f64,
}

/// Cumulative losses and work at a boundary [J].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bookings {
    /// Lost with bonds that broke: what their springs held.
    pub bond_loss: f64,
    /// Lost by friction: sliding, slip within contacts, rolling.
    pub friction_loss: f64,
    /// The part of it that was lost by slip within contacts.
    pub slip_loss: f64,
    /// Lost in contact dashpots.
    pub damping_loss: f64,
    /// Lost by global, local and CON1 damping.
    pub global_loss: f64,
    /// Work of walls, driven particles, applied forces and commands.
    pub boundary_work: f64,
    /// Stored now + lost - stored at the start - work, over stored at the start + turnover.
    pub energy_error: f64,
}

impl World {
    /// Energies now. Reads only; sums over particles, then over contacts in list order, in which
    /// pairs apart contribute nothing.
    pub fn energies(&self) -> Energies {
        let mut sum = Energies::default();
        let coming = self.coming();
        for p in 0..self.particles.len() {
            let axes = self.axes(p, &coming);
            let [x, y, turn] = axes.each_ref().map(|axis| {
                let v = axis.now(self.first_kick);
                0.5 * axis.inertia * v * v
            });
            sum.kinetic += x + y;
            sum.rotational += turn;
            for axis in axes {
                let dv = axis.v[1] - axis.v[0];
                // The first kick is that of half a step.
                let halves = if self.first_kick { 4.0 } else { 1.0 };
                sum.transit -= 0.125 * axis.inertia * halves * dv * dv;
            }
        }
        for k in 0..self.contacts.len() {
            if self.contacts.status[k] != Status::Apart {
                let [normal, tangential] = self.pass().energy(k, self.geometry(k).overlap);
                sum.elastic_normal += normal;
                sum.elastic_tangential += tangential;
            }
        }
        sum.potential = self.potential() - self.datum;
        sum
    }

    /// Losses and work so far; `None` when energies are not booked.
    pub fn bookings(&self) -> Option<Bookings> {
        let ledger = self.ledger.as_ref()?;
        let mut total = ledger.closed;
        for account in &ledger.accounts {
            total.add(account);
        }
        total.drag += self.pending_drag();
        let work = total.work + ledger.walls.iter().sum::<f64>() + ledger.flow + ledger.commands;
        let e = self.energies();
        let stored = e.kinetic
            + e.rotational
            + e.elastic_normal
            + e.elastic_tangential
            + e.potential
            + e.transit;
        let [sliding, within] = total.friction;
        // A law that bonds has no slip within a contact: what breaks is booked in its place.
        let (slip, bond) = if self.model.law.has_bonds() {
            (0.0, within)
        } else {
            (within, 0.0)
        };
        let lost = sliding + within + total.dashpots + total.drag;
        let missing = stored + lost - ledger.opening - work;
        let scale = ledger.opening.abs() + ledger.turnover + e.potential.abs();
        Some(Bookings {
            bond_loss: bond,
            friction_loss: sliding + slip,
            slip_loss: slip,
            damping_loss: total.dashpots,
            global_loss: total.drag,
            boundary_work: work,
            energy_error: if missing == 0.0 { 0.0 } else { missing / scale },
        })
    }

    /// Starts the ledger, and the potential, at the present state.
    pub(in crate::engine) fn open_ledger(&mut self) {
        self.datum = self.potential();
        if self.ledger.is_none() {
            return;
        }
        self.settle();
        self.fit_ledger();
        let opening = self.stored();
        if let Some(ledger) = &mut self.ledger {
            ledger.opening = opening;
        }
    }

    /// The drag of this boundary has acted over the step before already, but is booked when the
    /// next step departs [J].
    fn pending_drag(&self) -> f64 {
        if self.first_kick {
            return 0.0;
        }
        let coming = self.coming();
        (0..self.particles.len())
            .flat_map(|p| self.axes(p, &coming))
            .map(|axis| self.half_work(axis.drag(), &axis, 0))
            .sum()
    }

    /// What a command may change: energy stored now, and the loss that is not yet booked [J].
    pub(in crate::engine) fn at_stake(&self) -> f64 {
        self.stored() + self.pending_drag()
    }

    /// Energy stored now [J].
    fn stored(&self) -> f64 {
        let e = self.energies();
        e.kinetic + e.rotational + e.elastic_normal + e.elastic_tangential + e.potential + e.transit
    }

    /// One account per particle and wall.
    pub(in crate::engine) fn fit_ledger(&mut self) {
        if let Some(ledger) = &mut self.ledger {
            ledger
                .accounts
                .resize(self.particles.len(), Account::default());
            ledger.walls.resize(self.walls.len(), 0.0);
        }
    }

    /// Books a sudden change of what is at stake as work of a command.
    pub(in crate::engine) fn book_command(&mut self, before: f64) {
        if self.ledger.is_some() {
            let work = self.at_stake() - before;
            if let Some(ledger) = &mut self.ledger {
                ledger.commands += work;
                ledger.turnover += work.abs();
            }
        }
    }

    /// Closes the accounts of particles that do not stay.
    pub(in crate::engine) fn close_accounts(&mut self, stays: &[bool]) {
        if let Some(ledger) = &mut self.ledger {
            for (account, stays) in ledger.accounts.iter().zip(stays) {
                if !stays {
                    ledger.closed.add(account);
                }
            }
            only(&mut ledger.accounts, stays);
        }
    }

    /// Closes the account of a wall that is deleted.
    pub(in crate::engine) fn close_wall(&mut self, w: usize) {
        if let Some(ledger) = &mut self.ledger {
            ledger.closed.work += ledger.walls.remove(w);
        }
    }

    /// Potential of gravity, zero at the origin of the world or at the point it acts towards [J].
    fn potential(&self) -> f64 {
        let Some(gravity) = self.model.gravity else {
            return 0.0;
        };
        let rows = self.particles.row.iter().zip(&self.particles.mass);
        match gravity {
            Gravity::Uniform(g) => rows
                .map(|(row, m)| -m * (g[0] * row.x[0] + g[1] * row.x[1]))
                .sum(),
            Gravity::Centripetal { towards, g } => rows
                .map(|(row, m)| {
                    let d = [
                        towards[0] - self.origin[0] - row.x[0],
                        towards[1] - self.origin[1] - row.x[1],
                    ];
                    m * g * (d[0] * d[0] + d[1] * d[1]).sqrt()
                })
                .sum(),
        }
    }
}
