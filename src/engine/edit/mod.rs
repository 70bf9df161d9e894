//! Changes from outside: what commands do to a world between cycles.
//!
//! Each keeps the bookkeeping right: a sudden change of stored energy is booked as work of the
//! command, changed materials are worked into pairs, contacts and the time step. Positions,
//! velocities and forces of a boundary belong together, so forces are evaluated again at once and
//! velocities stay what they are at the boundary, whatever becomes of step and mass.

mod bodies;
mod bonds;
mod walls;

pub use bodies::Motion;

use super::World;
use super::motion;
use super::neighbours::Status;
use super::particles::Inertia;
use super::setup::{Damping, Gravity, Material, TimeStepChoice};

impl World {
    /// Gravity, or none.
    pub fn set_gravity(&mut self, gravity: Option<Gravity>) {
        self.booked(|world| {
            world.keeping_velocities(|world| {
                world.model.gravity = gravity;
                world.weigh();
            });
        });
    }

    /// Multiple of the base step.
    pub fn set_frac(&mut self, frac: f64) {
        self.booked(|world| {
            world.model.frac = frac;
            world.model.frac_auto = None;
            world.keeping_velocities(Self::retime);
        });
    }

    /// The base step itself.
    pub fn set_time_step(&mut self, choice: TimeStepChoice) {
        self.booked(|world| {
            world.model.time_step = choice;
            world.keeping_velocities(Self::retime);
        });
    }

    /// Damping.
    pub fn set_damping(&mut self, damping: Damping) {
        self.booked(|world| {
            world.keeping_velocities(|world| {
                world.model.damping = damping;
                world.rework();
            });
        });
    }

    /// Whether particles turn.
    pub fn set_rotation(&mut self, rotation: bool) {
        self.booked(|world| {
            world.model.rotation = rotation;
            world.note_spins();
            world.mobilise();
        });
    }

    /// Changes materials or pairs and works the change into masses, contacts and the time step.
    pub fn change_materials(&mut self, change: impl FnOnce(&mut super::setup::Setup)) {
        self.booked(|world| {
            change(&mut world.model);
            for p in 0..world.particles.len() {
                let material: &Material =
                    &world.model.materials[world.particles.material[p] as usize];
                let radius = world.particles.row[p].radius;
                let mass = Inertia::of(world.model.body, radius, material.density);
                (world.particles.mass[p], world.particles.inertia[p]) = (mass.mass, mass.inertia);
            }
            world.rework();
        });
    }

    /// Counts the sliding ways of all contacts from zero again; no energy changes.
    pub fn forget_slid(&mut self) {
        if let Some(pass) = &mut self.place.pass {
            pass.forget_slid();
        }
    }

    /// Starts to count the largest FRACC afresh; answers what it was.
    pub fn take_fracc(&mut self) -> Option<f64> {
        self.settle();
        self.fracc.largest.take()
    }

    /// After a change of particles, walls or materials.
    pub(super) fn rework(&mut self) {
        self.keeping_velocities(|world| {
            world.pairs = super::pair::PairTable::new(&world.model);
            // Contacts stay prepared as they were until their memory is taken over.
            world.make_list(false);
            world.replan();
            world.retime();
            world.touch_again();
        });
    }

    /// Forces of this boundary as contacts are now.
    fn touch_again(&mut self) {
        let before = self.contacts.status.clone();
        // A centre on a wall has no force: no cycle begins before it is taken away.
        self.misplaced = self.touch(0.0).err();
        // No time has passed: what slid in the last cycle still did.
        for (now, before) in self.contacts.status.iter_mut().zip(before) {
            if *now == Status::Touching && before == Status::Sliding {
                *now = before;
            }
        }
        // The change is none of the FRACC monitor's business: no comparison with old sums.
        self.pass_over_particles(motion::settle);
        self.settled = true;
        self.fit_step();
    }

    /// A change of forces, masses or step moves the half step before a boundary, not the velocity
    /// at the boundary.
    pub(super) fn keeping_velocities(&mut self, change: impl FnOnce(&mut Self)) {
        let held: Vec<_> = (0..self.particles.len())
            .map(|p| self.own_velocity(p))
            .collect();
        change(self);
        for (p, &(v, spin)) in held.iter().enumerate() {
            // Where nothing changed the bits stay, too.
            let now = self.own_velocity(p);
            if now.0 != v {
                self.give(p, Motion::Velocity(v));
            }
            if now.1 != spin {
                self.give(p, Motion::Spin(spin));
            }
        }
    }

    /// After a change that only touches effective masses.
    pub(super) fn reprepare(&mut self) {
        let all: Vec<u32> = (0..self.contacts.len() as u32).collect();
        self.keep(&all);
    }

    /// The pass follows the list, whose contacts stood at these places before.
    fn keep(&mut self, places: &[u32]) {
        let mut pass = self.take_pass();
        pass.relist(places, self.contacts.pairs.len(), self.room(), &|k| {
            self.basis(k)
        });
        self.put_pass(pass);
    }

    pub(super) fn booked(&mut self, change: impl FnOnce(&mut Self)) {
        self.settle();
        let before = self.ledger.is_some().then(|| self.at_stake());
        change(self);
        if let Some(before) = before {
            self.book_command(before);
        }
    }
}
