//! Changes of walls, and of their friction.

use crate::engine::World;
use crate::engine::setup::{Material, PairOverride, WallSetup};
use crate::engine::wall::Wall;

impl World {
    /// Adds a wall.
    pub fn create_wall(&mut self, wall: &WallSetup) {
        self.booked(|world| {
            world.walls.push(Wall::new(wall, world.origin));
            world.fit_ledger();
            world.join_walls();
            world.rework();
        });
    }

    /// Removes wall w.
    pub fn delete_wall(&mut self, w: usize) {
        self.booked(|world| {
            world.walls.remove(w);
            world.close_wall(w);
            let left = world.contacts.forget_wall(w);
            world.keep(&left);
            world.join_walls();
            world.rework();
        });
    }

    /// Velocity of wall w [m/s].
    pub fn set_wall_velocity(&mut self, w: usize, velocity: [f64; 2]) {
        self.walls[w].velocity = velocity;
    }

    /// Angular velocity of wall w about its turning point [rad/s].
    pub fn set_wall_spin(&mut self, w: usize, spin: f64) {
        self.walls[w].spin = spin;
    }

    /// Sets the friction of every contact with the walls of this name. Such a wall gets a material
    /// of its own if it shares one.
    pub fn set_wall_friction(&mut self, name: &str, friction: f64) {
        self.booked(|world| {
            for w in 0..world.walls.len() {
                if world.walls[w].name == name {
                    let shared = world.walls[w].material;
                    let own = world.own_material(w);
                    world.walls[w].material = own;
                    world.model.materials[own].friction = friction;
                    // Particles may be smoother: pairs say what holds at this wall.
                    let all = 0..world.model.materials.len();
                    for other in all.filter(|&other| other != own) {
                        let pair = world.pair_override([other, shared]);
                        let own_pair = [[other, own], [own, other]];
                        let pairs = &mut world.model.pairs;
                        pairs.retain(|pair| !own_pair.contains(&pair.materials));
                        pairs.push(PairOverride {
                            materials: [other, own],
                            friction: Some(friction),
                            ..pair
                        });
                    }
                }
            }
            world.rework();
        });
    }

    /// What overrides a pair of materials now; nothing if it has no override.
    fn pair_override(&self, [a, b]: [usize; 2]) -> PairOverride {
        self.model.pair([a, b]).cloned().unwrap_or(PairOverride {
            materials: [a, b],
            friction: None,
            cohesion: None,
            bond_tension: None,
            bond_shear: None,
            restitution: None,
            rolling_friction: None,
            normal_stiffness: None,
            shear_stiffness: None,
        })
    }

    fn own_material(&mut self, w: usize) -> usize {
        let shared = self.walls[w].material;
        let name = format!(
            "{}@{}",
            self.model.materials[shared].name, self.walls[w].name
        );
        let known = self.model.materials[shared]
            .name
            .ends_with(&format!("@{}", self.walls[w].name));
        if known {
            return shared;
        }
        self.model.materials.push(Material {
            name,
            ..self.model.materials[shared].clone()
        });
        self.model.materials.len() - 1
    }
}
