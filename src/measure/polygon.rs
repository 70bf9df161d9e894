//! The polygon of the forces on one particle: head to tail, in the order of their contacts round it.
//! At rest it closes; what is missing is the out-of-balance force (Randall 1989, 4.1: BALL of 1978).

use super::link::Link;
use super::tensor::within;
use crate::engine::World;
use crate::engine::contact_report::Other;

/// A side of the polygon.
#[derive(Debug, Clone, PartialEq)]
pub struct Side {
    /// What presses: `7`, or the name of a wall.
    pub by: String,
    /// Direction of the contact from the centre, counter-clockwise from direction 1, 0 to 360
    /// [degrees].
    pub direction: f64,
    /// Force on the particle [N].
    pub force: [f64; 2],
}

impl Side {
    /// Magnitude of the force [N].
    pub fn size(&self) -> f64 {
        magnitude(self.force)
    }
}

fn magnitude([x, y]: [f64; 2]) -> f64 {
    (x * x + y * y).sqrt()
}

/// The polygon of a particle.
#[derive(Debug, Clone, PartialEq)]
pub struct ForcePolygon {
    /// Number of the particle.
    pub particle: u32,
    /// A side for each contact that carries anything, by direction.
    pub sides: Vec<Side>,
    /// Weight and applied force [N]: the last side.
    pub body: [f64; 2],
}

impl ForcePolygon {
    /// Of the particle at an index.
    pub fn of(world: &World, p: usize) -> Self {
        let particles = world.particles();
        let mut sides = Vec::new();
        for link in Link::all(world) {
            let (by, sign) = match link.other {
                Other::Particle(j) if link.first == p => (particles.id[j].to_string(), 1.0),
                Other::Particle(j) if j == p => (particles.id[link.first].to_string(), -1.0),
                Other::Wall(w) if link.first == p => (world.walls()[w].name.clone(), 1.0),
                _ => continue,
            };
            let e = sign * link.e;
            let force = sign * link.force;
            if force[0] == 0.0 && force[1] == 0.0 {
                continue;
            }
            sides.push(Side {
                by,
                direction: within(libm::atan2(e[1], e[0]).to_degrees(), 360.0),
                force: force.into(),
            });
        }
        sides.sort_by(|a, b| a.direction.total_cmp(&b.direction));
        Self {
            particle: particles.id[p],
            sides,
            body: particles.body.get(p).copied().unwrap_or([0.0; 2]),
        }
    }

    /// Whether nothing acts on the particle.
    pub fn is_empty(&self) -> bool {
        self.sides.is_empty() && self.body == [0.0; 2]
    }

    /// Corners [N]: the first at zero, then the end of each side, the last that of the body force.
    pub fn corners(&self) -> Vec<[f64; 2]> {
        let forces = self.sides.iter().map(|side| side.force);
        let mut corners = vec![[0.0; 2]];
        let mut at = [0.0; 2];
        for force in forces.chain([self.body]) {
            at = [at[0] + force[0], at[1] + force[1]];
            corners.push(at);
        }
        corners
    }

    /// Magnitude of weight and applied force [N].
    pub fn body_size(&self) -> f64 {
        magnitude(self.body)
    }

    /// Magnitude of the out-of-balance force [N].
    pub fn residual(&self) -> f64 {
        magnitude(self.gap())
    }

    /// Lower and upper corner of a box around it [N].
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let corners = self.corners();
        let all = |pick: fn(f64, f64) -> f64| {
            let join = |a: [f64; 2], b: &[f64; 2]| [pick(a[0], b[0]), pick(a[1], b[1])];
            // The first corner is zero.
            corners.iter().fold([0.0; 2], join)
        };
        [all(f64::min), all(f64::max)]
    }

    /// Out-of-balance force [N]: from the first corner to the last.
    pub fn gap(&self) -> [f64; 2] {
        self.corners().last().copied().unwrap_or_default()
    }
}
