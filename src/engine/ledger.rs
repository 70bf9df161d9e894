//! Where the energy went.
//!
//! The work of a force at boundary n is `F_n·(dx_{n-½} + dx_{n+½})/2`: half of it is booked when
//! the step before arrives at n, half when the next departs. Kinetic energy stands at the half
//! step before n, so in the balance at n the first half of the work of all forces at n is added to
//! it; then a linear spring closes to rounding. Sums run over particles and walls in their order,
//! never over the contact list, so they do not depend on TOL or threads.

use serde::{Deserialize, Serialize};

use super::World;
use super::boundary::straining::velocity;
use super::contact_report::Other;
use super::motion::{self, Dragged};
use super::neighbours::{Slot, Status};
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
    /// Potential of gravity at the start.
    datum: f64,
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
pub(super) const BYTES_PER_PARTICLE: usize = size_of::<Account>();

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
    /// Translational kinetic energy, m v²/2 with the velocity of the last half step.
    pub kinetic: f64,
    /// Rotational kinetic energy.
    pub rotational: f64,
    /// Normal springs.
    pub elastic_normal: f64,
    /// Tangential springs, and those of rolling resistance.
    pub elastic_tangential: f64,
    /// Gravity, zero at the start.
    pub potential: f64,
    /// Half the work of the forces of this boundary: brings kinetic energy to its time.
    pub transit: f64,
}

/// Cumulative losses and work at a boundary [J].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bookings {
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

/// One degree of freedom over one step.
struct Axis {
    /// Velocity before and after the kick.
    v: [f64; 2],
    /// Gain of the kick, zero if prescribed.
    gain: f64,
    /// Whether the motion is damped: without, the loss is zero and not rounding.
    damped: bool,
    force: f64,
    /// Work of a unit force is velocity times this.
    lever: f64,
    /// Mass or moment of inertia.
    inertia: f64,
}

impl Axis {
    /// Force of the motion's damping.
    fn drag(&self) -> f64 {
        if self.gain == 0.0 || !self.damped {
            0.0
        } else {
            self.force - (self.v[1] - self.v[0]) / self.gain
        }
    }
}

impl World {
    /// Energies now. Reads only; sums over particles, then over contacts in list order, in which
    /// pairs apart contribute nothing.
    pub fn energies(&self) -> Energies {
        let mut sum = Energies::default();
        for p in 0..self.particles.len() {
            let row = &self.particles.row[p];
            let m = self.particles.mass[p];
            sum.kinetic += 0.5 * m * (row.v[0] * row.v[0] + row.v[1] * row.v[1]);
            if self.spins() {
                sum.rotational += 0.5 * self.particles.inertia[p] * row.spin * row.spin;
            }
            for axis in self.axes(p) {
                let dv = axis.v[1] - axis.v[0];
                // In the first half kick both velocities lie after the boundary's own.
                let mean = if self.first_kick { -dv } else { axis.v[0] };
                sum.transit += 0.5 * axis.inertia * mean * dv;
            }
        }
        for k in 0..self.contacts.len() {
            if self.contacts.status[k] != Status::Apart {
                let [normal, tangential] = self.pass().energy(k, self.geometry(k).overlap);
                sum.elastic_normal += normal;
                sum.elastic_tangential += tangential;
            }
        }
        let datum = self.ledger.as_ref().map_or(0.0, |ledger| ledger.datum);
        sum.potential = self.potential() - datum;
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
        let [sliding, slip] = total.friction;
        let lost = sliding + slip + total.dashpots + total.drag;
        let missing = stored + lost - ledger.opening - work;
        let scale = ledger.opening.abs() + ledger.turnover + e.potential.abs();
        Some(Bookings {
            friction_loss: sliding + slip,
            slip_loss: slip,
            damping_loss: total.dashpots,
            global_loss: total.drag,
            boundary_work: work,
            energy_error: if missing == 0.0 { 0.0 } else { missing / scale },
        })
    }

    /// Starts the ledger at the present state.
    pub(super) fn open_ledger(&mut self) {
        if self.ledger.is_none() {
            return;
        }
        self.settle();
        self.fit_ledger();
        let datum = self.potential();
        if let Some(ledger) = &mut self.ledger {
            ledger.datum = datum;
        }
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
        (0..self.particles.len())
            .flat_map(|p| self.axes(p))
            .map(|axis| self.half_work(axis.drag(), &axis, 0))
            .sum()
    }

    /// What a command may change: energy stored now, and the loss that is not yet booked [J].
    pub(super) fn at_stake(&self) -> f64 {
        self.stored() + self.pending_drag()
    }

    /// Energy stored now [J].
    fn stored(&self) -> f64 {
        let e = self.energies();
        e.kinetic + e.rotational + e.elastic_normal + e.elastic_tangential + e.potential + e.transit
    }

    /// One account per particle and wall.
    pub(super) fn fit_ledger(&mut self) {
        if let Some(ledger) = &mut self.ledger {
            ledger
                .accounts
                .resize(self.particles.len(), Account::default());
            ledger.walls.resize(self.walls.len(), 0.0);
        }
    }

    /// Books a sudden change of what is at stake as work of a command.
    pub(super) fn book_command(&mut self, before: f64) {
        if self.ledger.is_some() {
            let work = self.at_stake() - before;
            if let Some(ledger) = &mut self.ledger {
                ledger.commands += work;
                ledger.turnover += work.abs();
            }
        }
    }

    /// Closes the account of a particle that is deleted.
    pub(super) fn close_account(&mut self, p: usize) {
        if let Some(ledger) = &mut self.ledger {
            let account = ledger.accounts.remove(p);
            ledger.closed.add(&account);
        }
    }

    /// Closes the account of a wall that is deleted.
    pub(super) fn close_wall(&mut self, w: usize) {
        if let Some(ledger) = &mut self.ledger {
            ledger.closed.work += ledger.walls.remove(w);
        }
    }

    /// Books the second half of the work at this boundary, before the step.
    pub(super) fn depart(&mut self) {
        let Some(mut ledger) = self.ledger.take() else {
            return;
        };
        self.settle();
        let damped = Dragged::new(&self.model.damping, self.kick_part() * self.dt).is_some();
        let spins = self.spins();
        for p in 0..self.particles.len() {
            // Nearly all of most scenes: nothing to book, and nothing to work out.
            let driven = self.is_driven(p, spins);
            if !damped && !driven {
                continue;
            }
            let axes = self.axes(p);
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
    pub(super) fn arrive(&mut self) {
        let Some(mut ledger) = self.ledger.take() else {
            return;
        };
        self.settle();
        let spins = self.spins();
        for p in 0..self.particles.len() {
            for (k, second) in self.contacts.of(p) {
                if !second {
                    let book = self.pass().book(k);
                    for (sum, loss) in
                        (ledger.accounts[p].friction.iter_mut()).zip(book.friction_loss)
                    {
                        *sum += loss;
                    }
                    ledger.accounts[p].dashpots += book.damping_loss;
                }
            }
            if self.is_driven(p, spins) {
                let axes = self.axes(p);
                self.book_driver(&mut ledger, p, &axes, 0);
            }
        }
        self.book_walls(&mut ledger);
        self.book_flow(&mut ledger);
        self.ledger = Some(ledger);
    }

    /// Whether somebody else than its neighbours does work on a particle: a force is applied, or a velocity
    /// prescribed.
    fn is_driven(&self, p: usize, spins: bool) -> bool {
        let mobility = &self.particles.mobility[p];
        self.particles.fixed[p] != [false; 3]
            || mobility.kick.contains(&0.0)
            || spins && mobility.turn == 0.0
            || self.particles.applied(p) != [0.0; 2]
    }

    /// Work of applied forces and of whatever holds prescribed velocities, over half a step.
    fn book_driver(&self, ledger: &mut Ledger, p: usize, axes: &[Axis; 3], side: usize) {
        let applied = self.particles.applied(p);
        let mut work = 0.0;
        for (k, axis) in axes.iter().enumerate() {
            if self.particles.fixed[p][k] || axis.gain == 0.0 {
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
                    let Slot([fx, fy, ..]) = self.contacts.slots[first + k];
                    let v = wall.velocity_at(self.contacts.touches[k].at);
                    work += 0.5 * self.dt * (fx * v[0] + fy * v[1]);
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
        let from_centre = |p: usize| {
            let x = self.particles.row[p].x;
            [x[0] - centre[0], x[1] - centre[1]]
        };
        let mut power = 0.0;
        for k in 0..self.contacts.len() {
            if self.contacts.status[k] == Status::Apart {
                continue;
            }
            let Slot([fx, fy, ..]) = self.contacts.slots[k];
            // Of the first body as seen from the second; walls stand outside the flow.
            let d = match self.bodies(k) {
                (_, Other::Particle(_)) => {
                    let g = self.geometry(k);
                    g.e.map(|e| -g.distance * e)
                }
                (p, Other::Wall(_)) => from_centre(p),
            };
            let v = velocity(&rate, d);
            power -= fx * v[0] + fy * v[1];
        }
        for (p, body) in self.particles.body.iter().enumerate() {
            let v = velocity(&rate, from_centre(p));
            power -= body[0] * v[0] + body[1] * v[1];
        }
        let work = 0.5 * self.dt * power;
        ledger.flow += work;
        ledger.turnover += work.abs();
    }

    /// Work that the boundary does besides that of the forces on it [J].
    pub(super) fn book_boundary(&mut self, work: f64) {
        if let Some(ledger) = &mut self.ledger {
            ledger.commands += work;
            ledger.turnover += work.abs();
        }
    }

    /// Work of a force over half the step before (side 0) or after (side 1) this boundary.
    fn half_work(&self, force: f64, axis: &Axis, side: usize) -> f64 {
        0.5 * self.dt * force * axis.lever * axis.v[side]
    }

    /// The degrees of freedom of a particle, with the kick they are about to get.
    fn axes(&self, p: usize) -> [Axis; 3] {
        let part = self.kick_part();
        let drag = Dragged::new(&self.model.damping, part * self.dt);
        let (row, mobility) = (&self.particles.row[p], &self.particles.mobility[p]);
        let force = &self.particles.force[p];
        let body = self.particles.body.get(p).copied().unwrap_or([0.0; 2]);
        let axis = |v: f64, gain: f64, force: f64, lever: f64, inertia: f64| {
            let gain = part * gain;
            Axis {
                v: [v, motion::kick(drag, v, gain, force)],
                gain,
                damped: drag.is_some(),
                force,
                lever,
                inertia,
            }
        };
        let (m, inertia) = (self.particles.mass[p], self.particles.inertia[p]);
        let spin = if self.spins() { row.spin } else { 0.0 };
        let turn = if self.spins() { mobility.turn } else { 0.0 };
        [
            axis(row.v[0], mobility.kick[0], force.f[0] + body[0], 1.0, m),
            axis(row.v[1], mobility.kick[1], force.f[1] + body[1], 1.0, m),
            axis(spin, turn, force.tau, row.radius, inertia),
        ]
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
