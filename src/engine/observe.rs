//! What is seen of a world from outside, between cycles.

use super::boundary::straining::velocity;
use super::contact::quantities::Reaction;
use super::fault::Fault;
use super::lanes::Isa;
use super::ledger::Ledger;
use super::motion::{self, Dragged};
use super::neighbours::list::ContactList;
use super::neighbours::{Slot, Status};
use super::pair::PairTable;
use super::particles::Particles;
use super::setup::Setup;
use super::wall::Wall;
use super::world::{FraccMonitor, World};

/// A contact as it stands, for people and measures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactState {
    /// Unit vector from the first body to the second.
    pub e: [f64; 2],
    /// Overlap [m].
    pub overlap: f64,
    /// Distance between the centres, or from the centre to the wall [m].
    pub distance: f64,
    /// Ratio by which lever arms are shorter than radii.
    pub arm: f64,
}

impl World {
    /// Vector instructions in use.
    pub fn instructions(&self) -> Isa {
        self.isa
    }

    /// Cycles done.
    pub fn cycle_number(&self) -> u64 {
        self.cycle
    }

    /// Why no cycle can be done, if so.
    pub fn fault(&self) -> Option<&Fault> {
        self.broken.as_ref().or(self.misplaced.as_ref())
    }

    /// Whether the last cycle broke off: forces, positions and bookings no longer belong together, and
    /// nothing but another state can go on.
    pub fn is_broken(&self) -> bool {
        self.broken.is_some()
    }

    /// Cycles done and the number that the next particle takes.
    pub fn moment(&self) -> (u64, u32) {
        (self.cycle, self.next_id)
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.since.0 + (self.cycle - self.since.1) as f64 * self.dt
    }

    /// Time step [s].
    pub fn dt(&self) -> f64 {
        self.dt
    }

    /// The step that FRAC multiplies [s].
    pub fn base_step(&self) -> f64 {
        self.base_step
    }

    /// Materials, law, damping and so on as they are now.
    pub fn model(&self) -> &Setup {
        &self.model
    }

    /// Parameters of all pairs of materials.
    pub fn pair_table(&self) -> &PairTable {
        &self.pairs
    }

    /// Particles; positions are relative to [`World::origin`].
    pub fn particles(&self) -> &Particles {
        &self.particles
    }

    /// Walls; positions are relative to [`World::origin`].
    pub fn walls(&self) -> &[Wall] {
        &self.walls
    }

    /// Contacts.
    pub fn contacts(&self) -> &ContactList {
        &self.contacts
    }

    /// Whether the forces of this boundary are summed: velocities stand at half steps without.
    pub fn is_settled(&self) -> bool {
        self.settled
    }

    /// The energy ledger, if energies are booked.
    pub fn ledger(&self) -> Option<&Ledger> {
        self.ledger.as_ref()
    }

    /// Added to inner coordinates gives those of the preset [m].
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// What the FRACC monitor saw.
    pub fn fracc_monitor(&self) -> &FraccMonitor {
        &self.fracc
    }

    /// Halo within which pairs are listed, or [the mean](Self::tol_is_mean) of it [m].
    pub fn tol(&self) -> f64 {
        self.tol
    }

    /// Whether the halo differs from place to place.
    pub fn tol_is_mean(&self) -> bool {
        self.contacts.has_halos()
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.threads.count()
    }

    /// Geometry of contact k.
    pub fn geometry(&self, k: usize) -> ContactState {
        if let Some(&[i, j]) = self.contacts.pairs.get(k) {
            let (a, b) = (
                &self.particles.row[i as usize],
                &self.particles.row[j as usize],
            );
            let mut d = [b.x[0] - a.x[0], b.x[1] - a.x[1]];
            if let Some(cell) = self.cell() {
                // As the row of an image: shifted first.
                let shift = cell.shift(self.seen.image(k, self.particles.len()));
                d = [0, 1].map(|k| (b.x[k] + shift[k]) - a.x[k]);
            }
            let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
            let reach = a.radius + b.radius;
            return ContactState {
                e: [d[0] / distance, d[1] / distance],
                overlap: reach - distance,
                distance,
                arm: distance / reach,
            };
        }
        let w = k - self.contacts.pairs.len();
        let touch = &self.contacts.touches[w];
        let row = &self.particles.row[self.contacts.walls[w].particle as usize];
        ContactState {
            e: touch.e,
            overlap: row.radius - touch.distance,
            distance: touch.distance,
            arm: 1.0,
        }
    }

    /// How fast the bodies of contact k come nearer along its normal [m/s], by their velocities of the
    /// last half step.
    pub(super) fn approach(&self, k: usize, at: &ContactState) -> f64 {
        let rows = &self.particles.row;
        let flow = self.flow();
        let (first, second) = match self.contacts.pairs.get(k) {
            Some(&[i, j]) => {
                let far = at.e.map(|e| e * at.distance);
                let flow = flow.map_or([0.0; 2], |(rate, _)| velocity(&rate, far));
                let v = rows[j as usize].v;
                (rows[i as usize].v, [v[0] + flow[0], v[1] + flow[1]])
            }
            None => {
                let w = k - self.contacts.pairs.len();
                let pair = &self.contacts.walls[w];
                let row = &rows[pair.particle as usize];
                let flow = self.flow_at(row.x);
                let wall = &self.walls[pair.wall as usize];
                let v = [row.v[0] + flow[0], row.v[1] + flow[1]];
                (v, wall.velocity_at(self.contacts.touches[w].at))
            }
        };
        (first[0] - second[0]) * at.e[0] + (first[1] - second[1]) * at.e[1]
    }

    /// Normal and tangential force of contact k as it acts, dashpots included.
    pub fn reaction(&self, k: usize) -> Reaction {
        self.reaction_along(k, self.geometry(k).e)
    }

    /// The same where its normal is known.
    pub fn reaction_along(&self, k: usize, e: [f64; 2]) -> Reaction {
        let Slot([fx, fy, ..]) = self.contacts.slots[k];
        if self.contacts.status[k] == Status::Apart {
            return Reaction::default();
        }
        Reaction {
            // Adding zero turns a negative one into the plain one that people expect.
            normal: 0.0 - (fx * e[0] + fy * e[1]),
            // Without friction the projection would show rounding.
            tangential: if self.pass().is_frictional(k) {
                0.0 - (fx * e[1] - fy * e[0])
            } else {
                0.0
            },
            sliding: self.contacts.status[k] == Status::Sliding,
            ..Reaction::default()
        }
    }

    /// Velocity [m/s] and spin [rad/s] of particle p at this boundary: the mean of the two half
    /// steps around it, and what an imposed flow adds. Needs [`World::settle`] before.
    pub fn velocity(&self, p: usize) -> ([f64; 2], f64) {
        let (own, spin) = self.own_velocity(p);
        let flow = self.flow_at(self.particles.row[p].x);
        ([own[0] + flow[0], own[1] + flow[1]], spin)
    }

    /// The same beside the imposed flow.
    pub fn own_velocity(&self, p: usize) -> ([f64; 2], f64) {
        let row = &self.particles.row[p];
        if self.first_kick {
            return (row.v, row.spin);
        }
        let drag = Dragged::new(&self.model.damping, self.dt);
        let mean =
            |v: f64, (gain, force): (f64, f64)| 0.5 * (v + motion::kick(drag, v, gain, force));
        let [x, y, turn] = self.answers(p);
        let spin = if self.spins() {
            mean(row.spin, turn)
        } else {
            row.spin
        };
        ([mean(row.v[0], x), mean(row.v[1], y)], spin)
    }

    /// Gain of the kick and force on the three degrees of freedom of particle p.
    pub(super) fn answers(&self, p: usize) -> [(f64, f64); 3] {
        let (m, f) = (&self.particles.mobility[p], &self.particles.force[p]);
        let body = self.particles.body.get(p).copied().unwrap_or([0.0; 2]);
        [
            (m.kick[0], f.f[0] + body[0]),
            (m.kick[1], f.f[1] + body[1]),
            (m.turn, f.tau),
        ]
    }

    /// Centre of particle p in the coordinates of the preset [m].
    pub fn position(&self, p: usize) -> [f64; 2] {
        let x = self.particles.row[p].x;
        [x[0] + self.origin[0], x[1] + self.origin[1]]
    }
}
