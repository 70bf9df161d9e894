//! A world as the start of another scene: what is taken along, and counting from zero.
//!
//! Whatever else belongs to the state of an assembly and not to one run of it has its place in
//! [`World::particles_at_rest`], [`World::walls_at_rest`] and [`World::reopen`], and nowhere else.

use super::World;
use super::auto_step::{Looks, StepChanges};
use super::boundary::Boundary;
use super::fault::Fault;
use super::ledger::Ledger;
use super::setup::{ParticleSetup, Setup, WallSetup};
use super::world::FraccMonitor;

/// What a sample brings to a world besides what a setup can say.
#[derive(Debug, Clone, Default)]
pub struct Brought {
    /// Numbers of the first particles, ascending; the others follow.
    pub numbers: Vec<u32>,
    /// The boundary as it is by now, in the coordinates of the preset.
    pub boundary: Option<Boundary>,
}

/// Number of the particle at place p, where the first ones have these numbers, ascending, and the
/// others follow.
pub(super) fn number(ids: &[u32], p: usize) -> u32 {
    let follows = || ids.last().unwrap_or(&0) + (p - ids.len()) as u32 + 1;
    ids.get(p).copied().unwrap_or_else(follows)
}

impl World {
    /// Builds the world of a setup, particles numbered from 1, and evaluates its first forces.
    pub fn build(setup: Setup, threads: usize) -> Result<Self, Fault> {
        Self::build_from(setup, &Brought::default(), threads)
    }

    /// The particles as they are placed, with their numbers and the indices of their materials here:
    /// at rest, with the forces that were applied to them, and fixed as they were. Those of a ring are
    /// free: whatever holds them now will hold them again.
    pub fn particles_at_rest(&self) -> Vec<(u32, ParticleSetup)> {
        let p = &self.particles;
        let ring = self.boundary.as_ref().and_then(Boundary::ring);
        let held = |id| ring.is_some_and(|ring| ring.members.binary_search(&id).is_ok());
        let particle = |k: usize| ParticleSetup {
            at: self.position(k),
            radius: p.row[k].radius,
            material: usize::from(p.material[k]),
            velocity: [0.0; 2],
            spin: 0.0,
            angle: p.row[k].angle,
            force: if held(p.id[k]) {
                [0.0; 2]
            } else {
                p.applied(k)
            },
            fixed: if held(p.id[k]) {
                [false; 3]
            } else {
                p.fixed[k]
            },
        };
        (0..p.len()).map(|k| (p.id[k], particle(k))).collect()
    }

    /// The boundary where it is, in the coordinates of the preset: nothing is imposed by it.
    pub fn boundary_at_rest(&self) -> Option<Boundary> {
        let mut boundary = self.boundary.as_ref()?.moved(self.origin);
        boundary.rest();
        Some(boundary)
    }

    /// The walls where they are, at rest.
    pub fn walls_at_rest(&self) -> Vec<WallSetup> {
        let outer = |x: [f64; 2]| [x[0] + self.origin[0], x[1] + self.origin[1]];
        let walls = self.walls.iter().map(|wall| WallSetup {
            name: wall.name.clone(),
            material: wall.material,
            point: outer(wall.point),
            direction: wall.direction,
            h1: wall.h1,
            h2: wall.h2,
            velocity: [0.0; 2],
            angular_velocity: 0.0,
            about: outer(wall.about),
        });
        walls.collect()
    }

    /// A world that was read from a checkpoint goes on as the start of another run: nothing of its
    /// state changes, but cycles, time, imposed strain and energies are counted from zero, and ramps
    /// and servos end where they are. What `setup` chooses
    /// otherwise than the world, of damping, gravity, step, rotation and friction, is changed as a
    /// command would. `None` if the memory of its contacts does not fit.
    ///
    /// Law, body and stiffnesses are to be those of the world; with `setup.ledger` it must have
    /// booked energies.
    pub fn reopen(mut self, setup: &Setup, threads: usize) -> Option<Self> {
        if !setup.ledger {
            self.ledger = None;
        }
        self.model.ledger = setup.ledger;
        if !self.unpack(threads) {
            return None;
        }
        // The first row is nobody's change: sums of another run are not compared with.
        self.settle();
        self.cycle = 0;
        self.contacts.made = 0;
        self.since = (0.0, 0);
        self.fracc = FraccMonitor::default();
        self.step_changes = StepChanges::default();
        self.looks = Looks::default();
        if let Some(boundary) = &mut self.boundary {
            boundary.restart();
        }
        if let Some(flow) = &mut self.continuum {
            flow.restart();
        }
        self.bonds_made = self.bonds();
        self.next_id = self.particles.id.last().map_or(1, |id| id + 1);
        self.adopt(setup);
        self.ledger = setup.ledger.then(Ledger::default);
        self.open_ledger();
        Some(self)
    }

    /// Where nothing differs no bit changes.
    fn adopt(&mut self, setup: &Setup) {
        self.adopt_materials(setup);
        let model = &mut self.model;
        model.fracc_every = setup.fracc_every;
        model.overlap_allowed = setup.overlap_allowed;
        if model.damping != setup.damping {
            self.set_damping(setup.damping);
        }
        if self.model.gravity != setup.gravity {
            self.set_gravity(setup.gravity);
        }
        if self.model.rotation != setup.rotation {
            self.set_rotation(setup.rotation);
        }
        if self.model.time_step != setup.time_step {
            self.set_time_step(setup.time_step);
        }
        if self.model.frac != setup.frac && setup.frac_auto.is_none() {
            self.set_frac(setup.frac);
        }
        if self.model.frac_auto != setup.frac_auto {
            self.set_frac_auto(setup.frac_auto);
        }
    }

    /// Friction, cohesion, bonds and rolling friction of materials and pairs by name; materials that only the
    /// setup has come last.
    fn adopt_materials(&mut self, setup: &Setup) {
        let mut materials = self.model.materials.clone();
        for new in &setup.materials {
            match materials.iter_mut().find(|old| old.name == new.name) {
                Some(old) => old.clone_from(new),
                None => materials.push(new.clone()),
            }
        }
        let place = |name: &str| materials.iter().position(|m| m.name == name);
        let mut pairs = setup.pairs.clone();
        for pair in &mut pairs {
            pair.materials = pair.materials.map(|k| {
                let here = place(&setup.materials[k].name);
                here.expect("every material of the setup is in the list now")
            });
        }
        // Those of walls with a friction of their own were made by commands.
        let own = |k: usize| materials[k].name.contains('@');
        let made = self.model.pairs.iter();
        let made = made.filter(|pair| pair.materials.iter().any(|&k| own(k)));
        pairs.extend(made.cloned());
        if materials != self.model.materials || pairs != self.model.pairs {
            self.change_materials(|model| {
                model.materials = materials;
                model.pairs = pairs;
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_kept_and_new_ones_follow() {
        let numbers = |ids: &[u32], n| (0..n).map(|p| number(ids, p)).collect::<Vec<u32>>();
        assert_eq!(numbers(&[], 3), [1, 2, 3]);
        assert_eq!(numbers(&[2, 5], 4), [2, 5, 6, 7]);
    }
}
