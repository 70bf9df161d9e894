//! Strain of a region since the reference: the linear field of displacements that its particles
//! follow best, by least squares over their centres.
//!
//! Particles belong to it by where they were at the reference, so that it is the strain of the same
//! material all along; those that are newer or gone are left out.

use nalgebra::{Matrix2, Vector2};

use super::affine::Affine;
use super::reference::Reference;
use super::region::Shape;
use super::tensor;
use crate::engine::World;

/// Strain, compression positive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strain {
    /// ε_ij = -∂u_i/∂x_j at the reference: the first index belongs to the displacement. Half of what
    /// ε_12 and ε_21 differ by is the rotation; NaN for fewer than three particles that span a
    /// triangle.
    pub tensor: Matrix2<f64>,
    /// Particles it is fitted to.
    pub particles: usize,
}

impl Strain {
    /// Fits the particles that were in a region at the reference.
    pub fn of(world: &World, shape: Shape, reference: &Reference) -> Self {
        let inner = shape.inner(world);
        let moves = world.particles().id.iter().filter_map(|&id| {
            let (then, _) = reference.state(id)?;
            let (u, _) = reference.change(world, id)?;
            inner
                .contains(then)
                .then(|| (Vector2::from(then), Vector2::from(u)))
        });
        let moves: Vec<_> = moves.collect();
        let fit = Affine::fit(&moves);
        Self {
            tensor: fit.map_or(Matrix2::from_element(f64::NAN), |fit| -fit.gradient),
            particles: moves.len(),
        }
    }

    /// ε1 - ε2, never negative.
    pub fn deviator(&self) -> f64 {
        tensor::deviator(&self.tensor)
    }

    /// ε1 + ε2.
    pub fn volumetric(&self) -> f64 {
        self.tensor.trace()
    }
}
