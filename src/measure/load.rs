//! What acts on a particle.

use crate::engine::World;

/// Force [N] and moment [N m] on particle p: contacts, weight and applied force.
pub fn load(world: &World, p: usize) -> ([f64; 2], f64) {
    let particles = world.particles();
    let sum = particles.force[p];
    let body = particles.body.get(p).copied().unwrap_or([0.0; 2]);
    (
        [sum.f[0] + body[0], sum.f[1] + body[1]],
        sum.tau * particles.row[p].radius,
    )
}
