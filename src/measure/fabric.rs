//! Fabric: which way contacts point, plain and weighted by what they carry.
//!
//! Φ_ij = <n_i n_j> over touching contacts (Randall 1989, (4.48) and (4.54)), those at the edge of
//! a region by half; its trace is 1.

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
    /// Contacts of the region, those at its edge by half.
    pub contacts: f64,
}

impl Fabric {
    /// Sums over the touching contacts of a region; NaN when it has none.
    pub fn of(world: &World, content: &Content) -> Self {
        let (mut plain, mut weighted) = (Matrix2::zeros(), Matrix2::zeros());
        let (mut contacts, mut force) = (0.0, 0.0);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(&content.inside);
            let along = link.e * link.e.transpose();
            plain += weight * along;
            weighted += weight * link.normal * along;
            contacts += weight;
            force += weight * link.normal;
        }
        Self {
            plain: plain.map(|sum| ratio(sum, contacts)),
            weighted: weighted.map(|sum| ratio(sum, force)),
            contacts,
        }
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
