//! Counts and forces of an assembly, or of the part of it in a region.
//!
//! Over touching contacts (normal force above zero). In the coordination number a contact between
//! particles counts for both, one with a wall once; elsewhere a contact counts whole, and by half
//! where it leads out of the region.

use super::link::Link;
use super::tensor::ratio;
use crate::engine::World;

/// Contact statistics at a cycle boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assembly {
    /// Touching contacts, wall contacts included.
    pub contacts: f64,
    /// Contacts per particle.
    pub coordination: f64,
    /// Contacts per particle without those that carry nothing: (Σz - N1)/(N - N0 - N1), N0 and N1
    /// the particles with no and with one contact.
    pub coordination_mechanical: f64,
    /// Particles with no contact or with one, N0 + N1.
    pub rattlers: f64,
    /// Rattlers over particles.
    pub rattler_fraction: f64,
    /// Sliding contacts over contacts with friction.
    pub sliding_fraction: f64,
    /// Mean contact force [N].
    pub mean_force: f64,
    /// Largest contact force [N].
    pub max_force: f64,
    /// Mean out-of-balance force of free particles over their mean contact force.
    pub unbalanced: f64,
    /// Largest out-of-balance force of free particles over their largest contact force.
    pub unbalanced_max: f64,
}

impl Assembly {
    /// Measures a world whose forces are summed.
    pub fn of(world: &World) -> Self {
        Self::within(world, &vec![true; world.particles().len()])
    }

    /// The same for the particles marked as inside.
    pub fn within(world: &World, inside: &[bool]) -> Self {
        let (mut contacts, mut sliding, mut frictional) = (0.0, 0.0, 0.0);
        let (mut sum, mut max_force) = (0.0, 0f64);
        // Particles of a ring overlap each other by any amount: what they press with balances nothing.
        let (mut carried, mut carrying, mut max_carried) = (0.0, 0.0, 0f64);
        let held = |p: usize| world.particles().is_held(p);
        let mut degrees = vec![0u32; world.particles().len()];
        for link in Link::all(world).filter(Link::is_touching) {
            count_ends(&link, &mut degrees);
            let weight = link.weight(inside);
            if weight == 0.0 {
                continue;
            }
            contacts += weight;
            if link.frictional {
                frictional += weight;
                sliding += if link.sliding { weight } else { 0.0 };
            }
            let force = length([link.normal, link.tangential]);
            sum += weight * force;
            max_force = max_force.max(force);
            if !held(link.first) || link.second().is_some_and(|second| !held(second)) {
                carried += weight * force;
                carrying += weight;
                max_carried = max_carried.max(force);
            }
        }
        let mean_force = ratio(sum, contacts);
        let (mean_rest, max_rest) = out_of_balance(world, inside);
        // Particles, those with no contact and with one, and ends of contacts.
        let mut counts = [0u64; 4];
        for (&degree, &inside) in degrees.iter().zip(inside) {
            let of = [
                1,
                u64::from(degree == 0),
                u64::from(degree == 1),
                u64::from(degree),
            ];
            counts = std::array::from_fn(|k| counts[k] + u64::from(inside) * of[k]);
        }
        let [n, n0, n1, ends] = counts.map(|count| count as f64);
        Self {
            contacts,
            coordination: ratio(ends, n),
            coordination_mechanical: ratio(ends - n1, n - n0 - n1),
            rattlers: n0 + n1,
            rattler_fraction: ratio(n0 + n1, n),
            sliding_fraction: ratio(sliding, frictional),
            mean_force,
            max_force,
            unbalanced: ratio(mean_rest, ratio(carried, carrying)),
            unbalanced_max: ratio(max_rest, max_carried),
        }
    }
}

/// Number of touching contacts of each particle.
pub fn degrees(world: &World) -> Vec<u32> {
    let mut degrees = vec![0; world.particles().len()];
    for link in Link::all(world).filter(Link::is_touching) {
        count_ends(&link, &mut degrees);
    }
    degrees
}

fn count_ends(link: &Link, degrees: &mut [u32]) {
    degrees[link.first] += 1;
    if let Some(second) = link.second() {
        degrees[second] += 1;
    }
}

/// Mean and largest out-of-balance force over the particles inside that can move, weight and
/// applied force included, components that are prescribed left out [N].
fn out_of_balance(world: &World, inside: &[bool]) -> (f64, f64) {
    let particles = world.particles();
    let (mut free, mut sum, mut most) = (0.0, 0.0, 0f64);
    for p in (0..particles.len()).filter(|&p| inside[p]) {
        if particles.is_held(p) {
            continue;
        }
        let fixed = particles.fixed[p];
        let body = particles.body.get(p).copied().unwrap_or([0.0; 2]);
        let rest = [0, 1].map(|k| {
            if fixed[k] {
                0.0
            } else {
                particles.force[p].f[k] + body[k]
            }
        });
        free += 1.0;
        sum += length(rest);
        most = most.max(length(rest));
    }
    (ratio(sum, free), most)
}

fn length(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}
