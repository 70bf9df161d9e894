//! Fabric: which way contacts point, plain and weighted by what they carry.
//!
//! Φ_ij = <n_i n_j> over touching contacts (Randall 1989, (4.48) and (4.54)), those at the edge of
//! a region by half; its trace is 1. Every contact counts once, whichever of its two normals is
//! taken. How many there are says the trace F = 2 M R/V of the fabric tensor F Φ_ij (Oda,
//! Nemat-Nasser & Mehrabadi 1982; Randall 1989, (4.45), (4.46)).

use nalgebra::Matrix2;

use super::link::Link;
use super::region::Content;
use super::tensor::{self, Principal, ratio};
use crate::engine::World;

/// Fabric of a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fabric {
    /// Mean of n ⊗ n.
    pub plain: Matrix2<f64>,
    /// The same weighted by normal force.
    pub weighted: Matrix2<f64>,
    /// The same weighted by the size of the tangential force: with signs the weights of an assembly
    /// at rest would nearly cancel. NaN where no contact carries any.
    pub by_tangential: Matrix2<f64>,
    /// Contacts of the region, those at its edge by half.
    pub contacts: f64,
}

impl Fabric {
    /// Sums over the touching contacts of a region; NaN when it has none.
    pub fn of(world: &World, content: &Content) -> Self {
        let zero = Matrix2::zeros;
        let (mut plain, mut weighted, mut by_tangential) = (zero(), zero(), zero());
        let (mut contacts, mut force, mut shear) = (0.0, 0.0, 0.0);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(&content.inside);
            let along = link.e * link.e.transpose();
            plain += weight * along;
            weighted += weight * link.normal * along;
            by_tangential += weight * link.tangential.abs() * along;
            contacts += weight;
            force += weight * link.normal;
            shear += weight * link.tangential.abs();
        }
        Self {
            plain: plain.map(|sum| ratio(sum, contacts)),
            weighted: weighted.map(|sum| ratio(sum, force)),
            by_tangential: by_tangential.map(|sum| ratio(sum, shear)),
            contacts,
        }
    }

    /// Trace of the fabric tensor, 2 M R/V [1/m²]: M contacts, R the mean radius of the particles
    /// inside, V the volume of the region.
    pub fn trace(&self, world: &World, content: &Content) -> f64 {
        let rows = world.particles().row.iter().zip(&content.inside);
        let own = rows.filter(|(_, inside)| **inside);
        let radii: f64 = own.map(|(row, _)| row.radius).sum();
        let mean = ratio(radii, content.particles() as f64);
        2.0 * self.contacts * mean / (content.area * content.thickness)
    }

    /// Principal values.
    pub fn principal(&self) -> Principal {
        Principal::of(&self.plain)
    }

    /// Φ1 - Φ2.
    pub fn anisotropy(&self) -> f64 {
        tensor::deviator(&self.plain)
    }

    /// Φ1 - Φ2 weighted by normal force.
    pub fn anisotropy_weighted(&self) -> f64 {
        tensor::deviator(&self.weighted)
    }
}
