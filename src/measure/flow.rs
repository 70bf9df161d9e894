//! How a region flows: the linear field of velocities that its particles follow best, what they do
//! besides, and how fast that is against the stress.

use nalgebra::{Matrix2, Vector2};

use super::affine::Affine;
use super::tensor::{self, ratio};
use crate::engine::World;
use crate::engine::particles::Inertia;

/// Flow of a region; NaN for fewer than three particles that span a triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flow {
    /// Strain rate -∂v_i/∂x_j [1/s], compression positive: the first index belongs to the velocity.
    pub rate: Matrix2<f64>,
    /// Granular temperature [m²/s²]: half the mean square of what velocities differ from the field
    /// by, the mean energy of a direction over mass.
    pub temperature: f64,
    /// Mean diameter of the particles [m].
    diameter: f64,
    /// Mass of the particles over their volume [kg/m³].
    density: f64,
}

impl Flow {
    /// Fits the velocities of the particles marked as inside. Shown velocities are those of the
    /// boundary.
    pub fn of(world: &World, inside: &[bool]) -> Self {
        let particles = world.particles();
        let own = || (0..particles.len()).filter(|&p| inside[p]);
        let at = |p: usize| Vector2::from(particles.row[p].x);
        let moves: Vec<_> = own()
            .map(|p| (at(p), Vector2::from(world.velocity(p).0)))
            .collect();
        let count = moves.len() as f64;
        let radius = |p: usize| particles.row[p].radius;
        // What it weighs at a density of 1.
        let volume = |p: usize| Inertia::of(world.model().body, radius(p), 1.0).mass;
        let diameter = 2.0 * ratio(own().map(radius).sum(), count);
        let mass = own().map(|p| particles.mass[p]).sum();
        let density = ratio(mass, own().map(volume).sum());
        let Some(fit) = Affine::fit(&moves) else {
            return Self {
                rate: Matrix2::from_element(f64::NAN),
                temperature: f64::NAN,
                diameter,
                density,
            };
        };
        let squares = moves.iter().map(|(x, v)| (v - fit.at(x)).norm_squared());
        Self {
            rate: -fit.gradient,
            temperature: 0.5 * squares.sum::<f64>() / count,
            diameter,
            density,
        }
    }

    /// Inertial number I = γ d √(ρ/p) (GDR MiDi 2004) at a mean stress p [Pa]: γ the difference of
    /// the principal strain rates, d the mean diameter, ρ the density of the particles. NaN where
    /// there is no pressure.
    pub fn inertial_number(&self, pressure: f64) -> f64 {
        let rate = tensor::deviator(&self.rate);
        if pressure > 0.0 {
            rate * self.diameter * (self.density / pressure).sqrt()
        } else {
            f64::NAN
        }
    }
}
