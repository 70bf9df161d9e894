//! How fast a servo may act: stiff assemblies need little strain for much stress, and nothing moves
//! faster through them than a wave.

use crate::engine::World;
use crate::measure::link::Link;
use crate::measure::region::Content;

/// Largest inertial number that a servo may cause (GDR MiDi 2004): far below where flow begins to
/// depend on rate.
const INERTIAL: f64 = 1e-3;

/// Time constant of a servo with gain 1, in times that a wave needs across the assembly.
const CROSSINGS: f64 = 4.0;

/// What an assembly answers, and how soon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pace {
    /// Stress per isotropic strain if all particles followed the strain: above the true modulus [Pa].
    pub(super) modulus: f64,
    /// Time constant of a servo with gain 1 [s].
    pub(super) time: f64,
    /// Largest strain rate [1/s].
    pub(super) fastest: f64,
}

impl Pace {
    /// Of a region that shall come under a stress [Pa].
    pub(super) fn of(world: &World, content: &Content, stress: f64) -> Self {
        let mut sum = 0.0;
        for link in Link::all(world).filter(Link::is_touching) {
            let reach = link.reach(&content.inside);
            let k = world
                .pass()
                .stiffness(link.place, world.geometry(link.place).overlap);
            sum += k.k[0] * reach * (link.arms[0] + link.arms[1]);
        }
        let modulus = 0.5 * content.per_volume() * sum;
        let particles = world.particles();
        let (mut mass, mut volume, mut radius) = (0.0, 0.0, 0.0);
        for (row, m) in particles.row.iter().zip(&particles.mass) {
            mass += m;
            volume += std::f64::consts::PI * row.radius * row.radius;
            radius += row.radius;
        }
        let density = mass / (volume * content.thickness);
        let size = content.area.sqrt();
        let diameter = 2.0 * radius / particles.len() as f64;
        Self {
            modulus,
            time: CROSSINGS * size * (density / modulus).sqrt(),
            fastest: INERTIAL / diameter * (stress.abs() / density).sqrt(),
        }
    }
}
