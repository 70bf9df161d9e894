//! Particles as columns: what the cycle touches stands together, the rest apart.
//!
//! Index order is ascending particle number. Positions are relative to the world's origin.

use serde::{Deserialize, Serialize};

use super::extent::Extent;
use super::keep::only;
use super::rows::Rows;
use super::setup::{Body, ParticleSetup};

/// Whether so many particles are far from the processor, so that passes ask for memory ahead: fewer stay
/// near by themselves.
pub(super) fn are_far(particles: usize) -> bool {
    particles > 8192
}

/// What the contact and motion passes read and write of one particle: one cache line.
#[repr(C, align(64))]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Row {
    /// Velocity at the last half step [m/s].
    pub v: [f64; 2],
    /// Spin at the last half step [rad/s], counter-clockwise.
    pub spin: f64,
    /// Radius [m].
    pub radius: f64,
    /// Centre relative to the origin of the world [m].
    pub x: [f64; 2],
    /// Angle [rad].
    pub angle: f64,
    /// Spin times radius [m/s], kept by whoever changes either.
    #[serde(skip)]
    pub(super) rim: f64,
}

impl Row {
    /// A particle of this radius [m] in a place [m] with velocities [m/s], [rad/s].
    pub fn new(x: [f64; 2], radius: f64, v: [f64; 2], spin: f64) -> Self {
        Self {
            v,
            spin,
            radius,
            x,
            angle: 0.0,
            rim: spin * radius,
        }
    }

    /// Changes the spin [rad/s].
    #[inline(always)]
    pub fn set_spin(&mut self, spin: f64) {
        self.spin = spin;
        self.rim = spin * self.radius;
    }

    /// Changes the radius [m].
    pub fn set_radius(&mut self, radius: f64) {
        self.radius = radius;
        self.rim = self.spin * radius;
    }
}

/// How a particle answers force: zero where its velocity is prescribed.
#[repr(C, align(32))]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Mobility {
    /// dt/m in each direction [s/kg].
    pub kick: [f64; 2],
    /// dt R/I [s/(kg m)]: times the sum of tangential forces gives the change of spin.
    pub turn: f64,
    /// Fills the row.
    #[serde(skip)]
    rest: f64,
}

impl Mobility {
    /// From dt/m in each direction [s/kg] and dt R/I [s/(kg m)].
    pub fn new(kick: [f64; 2], turn: f64) -> Self {
        Self {
            kick,
            turn,
            rest: 0.0,
        }
    }
}

/// Contact force on a particle.
#[repr(C, align(32))]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Sum {
    /// Force [N].
    pub f: [f64; 2],
    /// Moment over radius [N].
    pub tau: f64,
    /// Sum of |f1| + |f2| over the contacts [N]: the scale FRACC is judged by, made anew now and then.
    pub scale: f64,
}

/// All particles.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Particles {
    /// Number shown to users, ascending.
    pub id: Vec<u32>,
    /// Hot state.
    pub row: Rows,
    /// Answer to force in the present time step.
    pub mobility: Vec<Mobility>,
    /// Contact force at the last boundary where it was kept: at this one after [`super::World::settle`].
    pub force: Vec<Sum>,
    /// Constant force [N]: weight and applied force; empty when nothing has any.
    pub body: Vec<[f64; 2]>,
    /// Mass [kg].
    pub mass: Vec<f64>,
    /// Moment of inertia [kg m²].
    pub inertia: Vec<f64>,
    /// Index of the material.
    pub material: Vec<u16>,
    /// Applied force [N]; empty while nothing was given any.
    pub(super) applied: Vec<[f64; 2]>,
    /// Which of v1, v2 and spin are prescribed.
    pub fixed: Vec<[bool; 3]>,
}

impl Particles {
    /// Number of particles.
    pub fn len(&self) -> usize {
        self.id.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.id.is_empty()
    }

    /// Whether there is something of each particle in every column, numbers ascend, and there are so many
    /// materials.
    pub(super) fn fit(&self, materials: usize) -> bool {
        let count = self.id.len();
        let columns = [
            self.row.len(),
            self.mobility.len(),
            self.force.len(),
            self.mass.len(),
            self.inertia.len(),
            self.material.len(),
            self.fixed.len(),
        ];
        let either = [self.body.len(), self.applied.len()];
        columns.iter().all(|&length| length == count)
            && either.iter().all(|&length| length == 0 || length == count)
            && self.id.is_sorted_by(|a, b| a < b)
            && self.material.iter().all(|&m| usize::from(m) < materials)
    }

    /// Index of a particle number.
    pub fn index(&self, id: u32) -> Option<usize> {
        self.id.binary_search(&id).ok()
    }

    /// Makes room for so many more.
    pub(super) fn reserve(&mut self, count: usize) {
        self.id.reserve_exact(count);
        self.row.reserve_exact(count);
        self.mobility.reserve_exact(count);
        self.force.reserve_exact(count);
        self.mass.reserve_exact(count);
        self.inertia.reserve_exact(count);
        self.material.reserve_exact(count);
        self.fixed.reserve_exact(count);
    }

    /// Appends a particle under a number above all others.
    pub fn push(&mut self, id: u32, p: &ParticleSetup, origin: [f64; 2], mass: Inertia) {
        self.id.push(id);
        let x = [p.at[0] - origin[0], p.at[1] - origin[1]];
        self.row.push(Row {
            angle: p.angle,
            ..Row::new(x, p.radius, p.velocity, p.spin)
        });
        self.mobility.push(Mobility::default());
        self.force.push(Sum::default());
        self.mass.push(mass.mass);
        self.inertia.push(mass.inertia);
        self.material.push(p.material as u16);
        self.fixed.push(p.fixed);
        if !self.applied.is_empty() {
            self.applied.push([0.0; 2]);
        }
        self.apply(self.len() - 1, p.force);
        self.body.clear();
    }

    /// Removes those that do not stay; the others keep their numbers.
    pub fn keep_only(&mut self, stays: &[bool]) {
        only(&mut self.id, stays);
        self.row.keep_only(stays);
        only(&mut self.mobility, stays);
        only(&mut self.force, stays);
        only(&mut self.mass, stays);
        only(&mut self.inertia, stays);
        only(&mut self.material, stays);
        if !self.applied.is_empty() {
            only(&mut self.applied, stays);
        }
        only(&mut self.fixed, stays);
        self.body.clear();
    }

    /// Force applied to the particle at an index [N].
    pub fn applied(&self, p: usize) -> [f64; 2] {
        self.applied.get(p).copied().unwrap_or_default()
    }

    /// Whether a force is applied to any.
    pub(super) fn are_pushed(&self) -> bool {
        self.applied.iter().any(|f| *f != [0.0; 2])
    }

    /// Applies a force [N] to the particle at an index in place of the one before.
    pub(super) fn apply(&mut self, p: usize, force: [f64; 2]) {
        if self.applied.is_empty() {
            // To the bit: -0 is a force that was given.
            if force.map(f64::to_bits) == [0; 2] {
                return;
            }
            self.applied.resize(self.len(), [0.0; 2]);
        }
        self.applied[p] = force;
    }

    /// Whether nothing can move the particle at an index.
    pub fn is_driven(&self, p: usize) -> bool {
        self.fixed[p] == [true; 3]
    }

    /// Whether nothing can move its centre, whatever it may turn.
    pub fn is_held(&self, p: usize) -> bool {
        let [x, y, _] = self.fixed[p];
        x && y
    }

    /// Smallest radius [m]; infinite without particles.
    pub fn smallest_radius(&self) -> f64 {
        self.row
            .iter()
            .fold(f64::INFINITY, |least, row| least.min(row.radius))
    }

    /// Bounding box of the centres [m], relative to the origin: lower and upper corner.
    pub fn extent(&self) -> [[f64; 2]; 2] {
        let mut extent = Extent::default();
        for row in &self.row {
            extent.take_in(row.x);
        }
        [extent.low, extent.high]
    }
}

/// Mass and moment of inertia of one particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Inertia {
    /// Mass [kg].
    pub mass: f64,
    /// Moment of inertia [kg m²].
    pub inertia: f64,
}

impl Inertia {
    /// Of a disc of unit length or a sphere, for radius [m] and density [kg/m³].
    pub fn of(body: Body, radius: f64, density: f64) -> Self {
        use std::f64::consts::PI;
        match body {
            Body::Disc => {
                let mass = density * PI * radius * radius;
                Self {
                    mass,
                    inertia: 0.5 * mass * radius * radius,
                }
            }
            Body::Sphere => {
                let mass = 4.0 / 3.0 * PI * radius * radius * radius * density;
                Self {
                    mass,
                    inertia: 0.4 * mass * radius * radius,
                }
            }
        }
    }
}
