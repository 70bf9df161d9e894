//! Particles by class, that is by material or by size: how much of the contacts each of them has, and
//! how many of it bear nothing (Randall 1989, 4.6).

use super::assembly::degrees;
use super::tensor::ratio;
use crate::engine::World;

/// With more radii than this, sizes are classes of equal width.
const DISTINCT: usize = 12;

/// Number of those classes.
const CLASSES: usize = 10;

/// A class of particles in a region.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Class {
    /// Particles in it.
    pub particles: f64,
    /// Ends of touching contacts at them; a wall contact has one.
    pub ends: f64,
    /// Those among them with no contact or with one.
    pub rattlers: f64,
    /// Ends of touching contacts at all particles of the region.
    pub all_ends: f64,
}

impl Class {
    /// Contacts per particle.
    pub fn coordination(&self) -> f64 {
        ratio(self.ends, self.particles)
    }

    /// Its share of the ends of all contacts.
    pub fn share(&self) -> f64 {
        ratio(self.ends, self.all_ends)
    }

    /// Rattlers over particles.
    pub fn rattler_fraction(&self) -> f64 {
        ratio(self.rattlers, self.particles)
    }
}

/// Radii from the first to the second [m], both included.
pub type Sizes = [f64; 2];

/// A class for each material, in the order of the scene, of the particles marked as inside.
pub fn by_material(world: &World, inside: &[bool]) -> Vec<Class> {
    let material = |p: usize| usize::from(world.particles().material[p]);
    classes(world, inside, world.model().materials.len(), material)
}

/// A class for each radius in the assembly, the smallest first; with many of them, for ten ranges of
/// radii.
pub fn by_size(world: &World, inside: &[bool]) -> Vec<(Sizes, Class)> {
    let sizes = sizes(world);
    let radius = |p: usize| world.particles().row[p].radius;
    // The lower class has the radius between two.
    let of = |p: usize| sizes.partition_point(|[_, to]| *to < radius(p));
    let classes = classes(world, inside, sizes.len(), of);
    sizes.iter().copied().zip(classes).collect()
}

fn sizes(world: &World) -> Vec<Sizes> {
    let rows = world.particles().row.iter();
    let mut radii: Vec<f64> = rows.map(|row| row.radius).collect();
    radii.sort_unstable_by(f64::total_cmp);
    radii.dedup();
    if radii.len() <= DISTINCT {
        return radii.into_iter().map(|radius| [radius; 2]).collect();
    }
    let (least, most) = (radii[0], radii[radii.len() - 1]);
    let edge = |k: usize| {
        // The last edge is the largest radius itself, whatever its rounding.
        let share = k as f64 / CLASSES as f64;
        if k == CLASSES {
            most
        } else {
            least + share * (most - least)
        }
    };
    (0..CLASSES).map(|k| [edge(k), edge(k + 1)]).collect()
}

fn classes(
    world: &World,
    inside: &[bool],
    count: usize,
    of: impl Fn(usize) -> usize,
) -> Vec<Class> {
    let degrees = degrees(world);
    let own = || (0..degrees.len()).filter(|&p| inside[p]);
    let all_ends = own().map(|p| f64::from(degrees[p])).sum();
    let empty = Class {
        all_ends,
        ..Class::default()
    };
    let mut classes = vec![empty; count];
    for p in own() {
        let class = &mut classes[of(p)];
        class.particles += 1.0;
        class.ends += f64::from(degrees[p]);
        class.rattlers += if degrees[p] <= 1 { 1.0 } else { 0.0 };
    }
    classes
}
