//! Changes of particles: what they do, and which there are.

use crate::engine::World;
use crate::engine::motion::{self, Dragged};
use crate::engine::particles::Inertia;
use crate::engine::setup::ParticleSetup;

/// Which way a particle's motion is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Velocity [m/s].
    Velocity([f64; 2]),
    /// Spin [rad/s].
    Spin(f64),
}

impl World {
    /// Gives particle p a velocity or spin at this boundary; a prescribed one keeps it.
    pub fn set_motion(&mut self, p: usize, motion: Motion) {
        let motion = match motion {
            Motion::Velocity(v) => {
                let flow = self.flow_at(self.particles.row[p].x);
                Motion::Velocity([v[0] - flow[0], v[1] - flow[1]])
            }
            Motion::Spin(_) => motion,
        };
        self.booked(|world| world.give(p, motion));
    }

    /// Stops every particle that is not driven.
    pub fn zero_velocities(&mut self) {
        self.booked(|world| {
            for p in 0..world.particles.len() {
                let [fx, fy, spin] = world.particles.fixed[p];
                let v = world.particles.row[p].v;
                let w = world.particles.row[p].spin;
                let stop = [if fx { v[0] } else { 0.0 }, if fy { v[1] } else { 0.0 }];
                world.give(p, Motion::Velocity(stop));
                world.give(p, Motion::Spin(if spin { w } else { 0.0 }));
            }
        });
    }

    /// What is stored belongs to the half step before the boundary: the mean of the two half steps
    /// is to be what was given.
    pub(super) fn give(&mut self, p: usize, motion: Motion) {
        let drag = Dragged::new(&self.model.damping, self.dt);
        let first = self.first_kick;
        let before = |v: f64, (gain, force): (f64, f64)| {
            if first {
                v
            } else {
                motion::before(drag, v, gain, force)
            }
        };
        let [x, y, turn] = self.answers(p);
        let row = &mut self.particles.row[p];
        match motion {
            Motion::Velocity(v) => row.v = [before(v[0], x), before(v[1], y)],
            Motion::Spin(w) if self.model.rotation => {
                row.set_spin(before(w, turn));
                self.turning |= row.spin != 0.0;
            }
            Motion::Spin(_) => {}
        }
    }

    /// Applies a constant force to particle p [N].
    pub fn set_force(&mut self, p: usize, force: [f64; 2]) {
        self.booked(|world| {
            world.keeping_velocities(|world| {
                world.particles.apply(p, force);
                world.weigh();
            });
        });
    }

    /// Prescribes (or frees) velocity 1, velocity 2 and spin of particle p at their present values.
    pub fn set_fixed(&mut self, p: usize, fixed: [bool; 3]) {
        self.booked(|world| {
            let (v, spin) = world.own_velocity(p);
            world.particles.fixed[p] = fixed;
            world.mobilise();
            world.give(p, Motion::Velocity(v));
            world.give(p, Motion::Spin(spin));
            world.reprepare();
        });
    }

    /// Adds a particle; answers its number.
    pub fn create(&mut self, particle: &ParticleSetup) -> u32 {
        self.create_all(std::slice::from_ref(particle))
    }

    /// Adds particles at once; answers the number of the first.
    pub fn create_all(&mut self, particles: &[ParticleSetup]) -> u32 {
        let first = self.next_id;
        self.booked(|world| {
            for particle in particles {
                let density = world.model.materials[particle.material].density;
                let mass = Inertia::of(world.model.body, particle.radius, density);
                world
                    .particles
                    .push(world.next_id, particle, world.origin, mass);
                world.next_id += 1;
            }
            world.size_up();
            world.fit_ledger();
            world.rework();
        });
        first
    }

    /// Removes the particle at index p; the others keep their numbers.
    pub fn delete(&mut self, p: usize) {
        let stays: Vec<bool> = (0..self.particles.len()).map(|q| q != p).collect();
        self.keep_only(&stays);
    }

    /// Removes the particles that do not stay; the others keep their numbers. `stays` has one for each.
    pub fn keep_only(&mut self, stays: &[bool]) {
        self.booked(|world| {
            world.particles.keep_only(stays);
            world.close_accounts(stays);
            let bonds = world.bonds();
            let left = world.contacts.keep_only(stays);
            world.see();
            world.keep(&left);
            world.bonds_made -= bonds - world.bonds();
            world.rework();
        });
    }

    /// Changes the radius of particle p [m], and its mass with it; overlaps that this makes are work
    /// of the command.
    pub fn set_radius(&mut self, p: usize, radius: f64) {
        self.booked(|world| {
            let material = usize::from(world.particles.material[p]);
            let density = world.model.materials[material].density;
            let mass = Inertia::of(world.model.body, radius, density);
            world.particles.row[p].set_radius(radius);
            (world.particles.mass[p], world.particles.inertia[p]) = (mass.mass, mass.inertia);
            world.rework();
        });
    }
}
