//! One contact for people: read only, no memory advances.

use super::World;
use super::boundary::straining::velocity;
use super::pair::Pair;
use super::wall_contact;

/// What a particle touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Other {
    /// The particle at this index.
    Particle(usize),
    /// The wall at this index.
    Wall(usize),
}

/// Motion of the first body's surface relative to the second's, at the half step that the present
/// forces belong to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// Approach along the normal [m/s].
    pub approach: f64,
    /// Along t [m/s].
    pub slide: f64,
}

/// What two bodies make of a contact together.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effective {
    /// R* = R1 R2/(R1 + R2); the particle's own at a wall [m].
    pub radius: f64,
    /// M* = m1 m2/(m1 + m2); the particle's own at a wall [kg].
    pub mass: f64,
    /// E*; zero where the law has no modulus [Pa].
    pub young: f64,
    /// G*; zero where the law has no modulus [Pa].
    pub shear: f64,
}

impl World {
    /// Effective radius, mass and moduli of listed contact k.
    pub fn effective(&self, k: usize) -> Effective {
        let basis = self.basis(k);
        Effective {
            radius: basis.r_eff,
            mass: basis.m_eff,
            young: basis.pair.young,
            shear: basis.pair.shear,
        }
    }

    /// The two bodies of listed contact k: index of the first particle, and the other.
    pub fn bodies(&self, k: usize) -> (usize, Other) {
        if let Some(&[i, j]) = self.contacts.pairs.get(k) {
            return (i as usize, Other::Particle(j as usize));
        }
        let wall = &self.contacts.walls[k - self.contacts.pairs.len()];
        (wall.particle as usize, Other::Wall(wall.wall as usize))
    }

    /// Parameters of listed contact k.
    pub fn pair_of(&self, k: usize) -> &Pair {
        let material = |p: usize| self.particles.material[p] as usize;
        match self.bodies(k) {
            (i, Other::Particle(j)) => self.pairs.get(material(i), material(j), false),
            (i, Other::Wall(w)) => self.pairs.get(material(i), self.walls[w].material, true),
        }
    }

    /// Relative velocities of listed contact k, as its law saw them.
    pub fn meeting(&self, k: usize) -> Meeting {
        let g = self.geometry(k);
        let (i, other) = self.bodies(k);
        let a = &self.particles.row[i];
        let (u, turn) = match other {
            Other::Particle(j) => {
                let b = &self.particles.row[j];
                let turn = (a.spin * a.radius + b.spin * b.radius) * g.arm;
                (b.v, turn)
            }
            Other::Wall(_) => {
                let touch = &self.contacts.touches[k - self.contacts.pairs.len()];
                (touch.v, a.spin * a.radius)
            }
        };
        let mut v = [a.v[0] - u[0], a.v[1] - u[1]];
        if let Some((rate, centre)) = self.flow() {
            // Of the first body as seen from the second; walls stand outside the flow.
            let d = match other {
                Other::Particle(_) => g.e.map(|e| -g.distance * e),
                Other::Wall(_) => [a.x[0] - centre[0], a.x[1] - centre[1]],
            };
            let flow = velocity(&rate, d);
            v = [v[0] + flow[0], v[1] + flow[1]];
        }
        let turn = if self.pass().tangential() { turn } else { 0.0 };
        Meeting {
            approach: v[0] * g.e[0] + v[1] * g.e[1],
            slide: v[0] * g.e[1] - v[1] * g.e[0] - turn,
        }
    }

    /// Normal and tangential spring force of listed contact k [N].
    pub fn springs(&self, k: usize) -> [f64; 2] {
        self.pass().springs(k, self.geometry(k).overlap)
    }

    /// Distance between the surfaces of particle i and another body [m]; negative where they
    /// overlap.
    pub fn gap(&self, i: usize, other: Other) -> f64 {
        let a = &self.particles.row[i];
        match other {
            Other::Particle(j) => {
                let b = &self.particles.row[j];
                let mut d = [b.x[0] - a.x[0], b.x[1] - a.x[1]];
                if let Some(cell) = self.cell() {
                    d = cell.nearest(d);
                }
                (d[0] * d[0] + d[1] * d[1]).sqrt() - (a.radius + b.radius)
            }
            Other::Wall(w) => wall_contact::distance(&self.walls[w], a.x) - a.radius,
        }
    }
}
