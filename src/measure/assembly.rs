//! Counts and forces of the whole assembly.
//!
//! Over touching contacts (normal force above zero). In the coordination number a contact between
//! particles counts for both, one with a wall once.

use crate::engine::World;
use crate::engine::neighbours::Status;

/// Contact statistics at a cycle boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Assembly {
    /// Touching contacts, wall contacts included.
    pub contacts: u64,
    /// Contacts per particle.
    pub coordination: f64,
    /// Contacts per particle without those that carry nothing: (Σz - N1)/(N - N0 - N1), N0 and N1
    /// the particles with no and with one contact.
    pub coordination_mechanical: f64,
    /// Sliding contacts over contacts with friction.
    pub sliding_fraction: f64,
    /// Mean contact force [N].
    pub mean_force: f64,
    /// Largest contact force [N].
    pub max_force: f64,
    /// Mean out-of-balance force of free particles over mean contact force.
    pub unbalanced: f64,
    /// Largest out-of-balance force of free particles over largest contact force.
    pub unbalanced_max: f64,
}

impl Assembly {
    /// Measures a world whose forces are summed.
    pub fn of(world: &World) -> Self {
        let particles = world.particles();
        let mut degree = vec![0u32; particles.len()];
        let (mut contacts, mut sliding, mut frictional) = (0u64, 0u64, 0u64);
        let (mut sum, mut max_force) = (0.0, 0f64);
        let list = world.contacts();
        for k in 0..list.len() {
            if list.status[k] == Status::Apart {
                continue;
            }
            let reaction = world.reaction(k);
            if reaction.normal <= 0.0 {
                continue;
            }
            contacts += 1;
            match list.pairs.get(k) {
                Some(pair) => pair.iter().for_each(|&p| degree[p as usize] += 1),
                None => degree[list.walls[k - list.pairs.len()].particle as usize] += 1,
            }
            if world.pass().is_frictional(k) {
                frictional += 1;
                sliding += u64::from(reaction.sliding);
            }
            let force = length([reaction.normal, reaction.tangential]);
            sum += force;
            max_force = max_force.max(force);
        }
        let mean_force = ratio(sum, contacts as f64);
        let (mean_rest, max_rest) = out_of_balance(world);
        let ends = f64::from(degree.iter().sum::<u32>());
        let with = |n: u32| degree.iter().filter(|&&d| d == n).count() as f64;
        let (n, n0, n1) = (degree.len() as f64, with(0), with(1));
        Self {
            contacts,
            coordination: ratio(ends, n),
            coordination_mechanical: ratio(ends - n1, n - n0 - n1),
            sliding_fraction: ratio(sliding as f64, frictional as f64),
            mean_force,
            max_force,
            unbalanced: ratio(mean_rest, mean_force),
            unbalanced_max: ratio(max_rest, max_force),
        }
    }
}

/// Mean and largest out-of-balance force over the particles that can move, weight and applied
/// force included, components that are prescribed left out [N].
fn out_of_balance(world: &World) -> (f64, f64) {
    let particles = world.particles();
    let (mut free, mut sum, mut most) = (0.0, 0.0, 0f64);
    for p in 0..particles.len() {
        let fixed = particles.fixed[p];
        if fixed[0] && fixed[1] {
            continue;
        }
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

/// Undefined quotients are NaN, never infinite.
fn ratio(a: f64, b: f64) -> f64 {
    if b == 0.0 { f64::NAN } else { a / b }
}
