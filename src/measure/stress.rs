//! Stress in a region, and where it comes from.
//!
//! σ = (1 - n)/(ΣV_p) Σ_p Σ_c r ⊗ f over the particles with their centre inside, compression
//! positive (Christoffersen, Mehrabadi & Nemat-Nasser 1981 in the form of Randall 1989, 4.6). It is
//! the sum of what the mean normal force does by the fabric alone, what normal forces add by
//! differing from that mean, and what tangential forces add (Cundall & Strack 1983). Each part is
//! summed from contacts by itself, none is a difference; so is the part of all normal forces, which
//! the first two make up (Barnes 1985 in Randall 1989, 4.2).

use nalgebra::Matrix2;

use super::link::Link;
use super::region::Content;
use super::tensor::{self, Principal, ratio};
use crate::engine::World;

/// Stress of a region [Pa], compression positive: the first index belongs to the branch, the second
/// to the force.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stress {
    /// The whole, from forces as they act.
    pub total: Matrix2<f64>,
    /// What the mean normal force would cause in every contact: fabric.
    pub fabric: Matrix2<f64>,
    /// What differences of the normal forces from their mean cause.
    pub normal_variation: Matrix2<f64>,
    /// What normal forces cause: fabric and variation together.
    pub normal: Matrix2<f64>,
    /// What tangential forces cause.
    pub shear: Matrix2<f64>,
    /// Mean normal force of the region's touching contacts, those at its edge by half [N].
    pub mean_normal: f64,
}

impl Stress {
    /// Sums over the contacts of a region. Contacts that a dashpot pulls at take part: they carry
    /// force, if not the mean one.
    pub fn of(world: &World, content: &Content) -> Self {
        let inside = &content.inside;
        let (mut sum, mut count) = (0.0, 0.0);
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(inside);
            sum += weight * link.normal;
            count += weight;
        }
        let mean = ratio(sum, count);
        let zero = Matrix2::zeros;
        let (mut total, mut fabric, mut variation) = (zero(), zero(), zero());
        let (mut normal, mut shear) = (zero(), zero());
        for link in Link::all(world) {
            let reach = link.reach(inside);
            if reach == 0.0 {
                continue;
            }
            let branch = reach * link.e;
            let along = branch * link.e.transpose();
            total -= branch * link.force.transpose();
            // A contact that a dashpot pulls at has no part in the fabric.
            let share = if link.is_touching() { mean } else { 0.0 };
            fabric += share * along;
            variation += (link.normal - share) * along;
            normal += link.normal * along;
            shear += link.tangential * (branch * link.t.transpose());
        }
        let per_volume = content.per_volume();
        Self {
            total: total * per_volume,
            fabric: fabric * per_volume,
            normal_variation: variation * per_volume,
            normal: normal * per_volume,
            shear: shear * per_volume,
            mean_normal: mean,
        }
    }

    /// Sum of the three parts [Pa].
    pub fn parts(&self) -> Matrix2<f64> {
        self.fabric + self.normal_variation + self.shear
    }

    /// Principal stresses [Pa].
    pub fn principal(&self) -> Principal {
        Principal::of(&self.total)
    }

    /// Mean of the principal stresses [Pa].
    pub fn isotropic(&self) -> f64 {
        0.5 * self.total.trace()
    }

    /// Difference of the principal stresses [Pa].
    pub fn deviator(&self) -> f64 {
        tensor::deviator(&self.total)
    }

    /// Sine of the mobilised angle of friction, (s1 - s2)/(s1 + s2).
    pub fn sin_phi(&self) -> f64 {
        ratio(self.deviator(), self.total.trace())
    }

    /// What a part of the stress adds to `sin_phi`: its deviator on the principal axes of the whole,
    /// over s1 + s2. NaN where the whole has no axes.
    pub fn sin_phi_of(&self, part: &Matrix2<f64>) -> f64 {
        ratio(tensor::projected(part, &self.total), self.total.trace())
    }
}
