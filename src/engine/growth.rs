//! All particles larger or smaller at once.

use super::World;
use super::particles::Inertia;

impl World {
    /// Multiplies all radii. Masses follow, velocities stay; what that takes is work of the command.
    pub fn scale_radii(&mut self, by: f64) {
        self.booked(|world| {
            world.keeping_velocities(|world| {
                for p in 0..world.particles.len() {
                    let material = usize::from(world.particles.material[p]);
                    let density = world.model.materials[material].density;
                    let radius = world.particles.row[p].radius * by;
                    let mass = Inertia::of(world.model.body, radius, density);
                    world.particles.row[p].set_radius(radius);
                    (world.particles.mass[p], world.particles.inertia[p]) =
                        (mass.mass, mass.inertia);
                }
                world.rework();
            });
        });
    }
}
