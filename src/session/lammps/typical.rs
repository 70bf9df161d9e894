//! The contact that stands for all of two materials, where LAMMPS takes one number for them.

use crate::engine::World;
use crate::engine::contact::dashpot;
use crate::engine::contact::quantities::BasisOwned;
use crate::engine::contact_report::Other;

/// Overlap over effective radius of a contact that is supposed. The number matters little: what follows
/// from it goes with its fourth root.
const OVERLAP: f64 = 1e-3;

/// Two materials that meet, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Partners {
    /// Of the particle.
    pub(super) a: usize,
    /// Of the other particle, or of the wall.
    pub(super) b: usize,
    /// Whether the second is a wall's.
    pub(super) wall: bool,
}

/// Means over the contacts of two materials, or one of their size where none touches yet: a dashpot left
/// out then would be missing when they do.
#[derive(Debug, Clone, Copy)]
pub(super) struct Typical {
    /// Effective mass [kg].
    pub(super) mass: f64,
    /// Viscosity of the normal dashpot over effective mass and, of Hertz, contact radius
    /// [1/s or 1/(m s)].
    pub(super) gamma: f64,
    /// Whether any touch now.
    pub(super) touches: bool,
}

impl Typical {
    /// Of two materials of a world, under constant springs or those of Hertz.
    pub(super) fn of(world: &World, partners: Partners, linear: bool) -> Self {
        let (mut count, mut mass, mut gamma) = (0.0, 0.0, 0.0);
        for k in 0..world.contacts().len() {
            let (i, other) = world.bodies(k);
            let overlap = -world.gap(i, other);
            if overlap <= 0.0 || !is_of(world, partners, i, other) {
                continue;
            }
            let effective = world.effective(k);
            let c = world.pass().stiffness(k, overlap).c[0];
            let scale = if linear {
                1.0
            } else {
                (effective.radius * overlap).sqrt()
            };
            count += 1.0;
            mass += effective.mass;
            gamma += c / (effective.mass * scale);
        }
        if count > 0.0 {
            return Self {
                mass: mass / count,
                gamma: gamma / count,
                touches: true,
            };
        }
        Self::supposed(world, partners, linear)
    }

    /// Of a contact between particles of mean mass and radius.
    fn supposed(world: &World, Partners { a, b, wall }: Partners, linear: bool) -> Self {
        let pair = world.pair_table().get(a, b, wall);
        let (mut mass, mut radius) = mean(world, a);
        if !wall {
            let (other_mass, other_radius) = mean(world, b);
            mass = mass * other_mass / (mass + other_mass);
            radius = radius * other_radius / (radius + other_radius);
        }
        let (stiffness, scale) = if linear {
            (pair.normal_stiffness, 1.0)
        } else {
            let contact_radius = radius * OVERLAP.sqrt();
            (2.0 * pair.young * contact_radius, contact_radius)
        };
        let basis = BasisOwned {
            pair: *pair,
            m_eff: mass,
            r_eff: radius,
            critical_above: f64::INFINITY,
            nodes: 0,
        };
        let [c, _] = dashpot::viscosity(&basis, [stiffness, 0.0], 0.0);
        Self {
            mass,
            gamma: c / (mass * scale),
            touches: false,
        }
    }
}

/// Whether a listed contact is one of these materials.
fn is_of(world: &World, Partners { a, b, wall }: Partners, i: usize, other: Other) -> bool {
    let material = |q: usize| usize::from(world.particles().material[q]);
    match other {
        Other::Particle(j) => {
            let found = [material(i), material(j)];
            !wall && (found == [a, b] || found == [b, a])
        }
        Other::Wall(w) => wall && material(i) == a && world.walls()[w].material == b,
    }
}

/// Mean mass [kg] and radius [m] of the particles of a material, of which there are some.
fn mean(world: &World, kind: usize) -> (f64, f64) {
    let p = world.particles();
    let (mut count, mut mass, mut radius) = (0.0, 0.0, 0.0);
    for k in (0..p.len()).filter(|&k| usize::from(p.material[k]) == kind) {
        count += 1.0;
        mass += p.mass[k];
        radius += p.row[k].radius;
    }
    (mass / count, radius / count)
}
