//! Changes from outside: what commands do to a world between cycles.
//!
//! Each keeps the bookkeeping right: a sudden change of stored energy is booked as work of the
//! command, changed materials are worked into pairs, contacts and the time step. Positions,
//! velocities and forces of a boundary belong together, so forces are evaluated again at once and
//! velocities stay what they are at the boundary, whatever becomes of step and mass.

use super::World;
use super::contact::quantities::Reaction;
use super::motion::{self, Dragged};
use super::neighbours::{Slot, Status};
use super::particles::Inertia;
use super::setup::{
    Damping, Gravity, Material, PairOverride, ParticleSetup, TimeStepChoice, WallSetup,
};
use super::wall::Wall;

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

/// Which way a particle's motion is meant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Velocity [m/s].
    Velocity([f64; 2]),
    /// Spin [rad/s].
    Spin(f64),
}

impl World {
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
    fn answers(&self, p: usize) -> [(f64, f64); 3] {
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
    fn give(&mut self, p: usize, motion: Motion) {
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
            world.fit_ledger();
            world.rework();
        });
        first
    }

    /// Cycles done and the number that the next particle takes.
    pub fn moment(&self) -> (u64, u32) {
        (self.cycle, self.next_id)
    }

    /// Removes the particle at index p; the others keep their numbers.
    pub fn delete(&mut self, p: usize) {
        self.booked(|world| {
            world.particles.remove(p);
            world.close_account(p);
            let left = world.contacts.forget(p);
            world.see();
            world.keep(&left);
            world.rework();
        });
    }

    /// Adds a wall.
    pub fn create_wall(&mut self, wall: &WallSetup) {
        self.booked(|world| {
            world.walls.push(Wall::new(wall, world.origin));
            world.fit_ledger();
            world.join_walls();
            world.rework();
        });
    }

    /// Removes wall w.
    pub fn delete_wall(&mut self, w: usize) {
        self.booked(|world| {
            world.walls.remove(w);
            world.close_wall(w);
            let left = world.contacts.forget_wall(w);
            world.keep(&left);
            world.join_walls();
            world.rework();
        });
    }

    /// Velocity of wall w [m/s].
    pub fn set_wall_velocity(&mut self, w: usize, velocity: [f64; 2]) {
        self.walls[w].velocity = velocity;
    }

    /// Angular velocity of wall w about its turning point [rad/s].
    pub fn set_wall_spin(&mut self, w: usize, spin: f64) {
        self.walls[w].spin = spin;
    }

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

    /// Sets the friction of every contact with the walls of this name. Such a wall gets a material
    /// of its own if it shares one.
    pub fn set_wall_friction(&mut self, name: &str, friction: f64) {
        self.booked(|world| {
            for w in 0..world.walls.len() {
                if world.walls[w].name == name {
                    let shared = world.walls[w].material;
                    let own = world.own_material(w);
                    world.walls[w].material = own;
                    world.model.materials[own].friction = friction;
                    // Particles may be smoother: pairs say what holds at this wall.
                    for other in 0..own {
                        let pair = world.pair_override([other, shared]);
                        world.model.pairs.push(PairOverride {
                            materials: [other, own],
                            friction: Some(friction),
                            ..pair
                        });
                    }
                }
            }
            world.rework();
        });
    }

    /// What overrides a pair of materials now; nothing if it has no override.
    fn pair_override(&self, [a, b]: [usize; 2]) -> PairOverride {
        let same = |p: &&PairOverride| p.materials == [a, b] || p.materials == [b, a];
        let known = self.model.pairs.iter().rev().find(same).cloned();
        known.unwrap_or(PairOverride {
            materials: [a, b],
            friction: None,
            cohesion: None,
            restitution: None,
            rolling_friction: None,
            normal_stiffness: None,
            shear_stiffness: None,
        })
    }

    fn own_material(&mut self, w: usize) -> usize {
        let shared = self.walls[w].material;
        let name = format!(
            "{}@{}",
            self.model.materials[shared].name, self.walls[w].name
        );
        let known = self.model.materials[shared]
            .name
            .ends_with(&format!("@{}", self.walls[w].name));
        if known {
            return shared;
        }
        self.model.materials.push(Material {
            name,
            ..self.model.materials[shared].clone()
        });
        self.model.materials.len() - 1
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
            world.relist();
            world.replan();
            world.retime();
            let before = world.contacts.status.clone();
            // A centre on a wall has no force: no cycle begins before it is taken away.
            world.misplaced = world.touch(0.0).err();
            // No time has passed: what slid in the last cycle still did.
            for (now, before) in world.contacts.status.iter_mut().zip(before) {
                if *now == Status::Touching && before == Status::Sliding {
                    *now = before;
                }
            }
            // The change is none of the FRACC monitor's business: no comparison with old sums.
            world.pass_over_particles(motion::settle);
            world.settled = true;
        });
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
