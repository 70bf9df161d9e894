//! Fabric to fourth order, Φ_ijkl = <n_i n_j n_k n_l> over touching contacts (Barnes 1985 in Randall
//! 1989, 4.2): what two directions that contacts prefer look like, where the second order only has
//! one axis.

use super::link::Link;
use super::tensor::ratio;
use crate::engine::World;

/// A symmetric tensor of fourth order in the plane. It has five components: order of the indices
/// does not matter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fourth(pub [f64; 5]);

impl Fourth {
    /// n ⊗ n ⊗ n ⊗ n of a unit vector.
    fn of(n: [f64; 2]) -> Self {
        let [c, s] = [n[0] * n[0], n[1] * n[1]];
        let cs = n[0] * n[1];
        Self([c * c, c * cs, c * s, cs * s, s * s])
    }

    /// The component with so many indices 2: Φ_1111 for 0, Φ_1112 for 1 and so on.
    ///
    /// # Panics
    /// Above 4.
    pub fn component(&self, twos: usize) -> f64 {
        self.0[twos]
    }

    /// Sum over one pair of equal indices: the tensor of second order it contains, as 11, 12, 22.
    pub fn contracted(&self) -> [f64; 3] {
        let [a, b, c, d, e] = self.0;
        [a + c, b + d, c + e]
    }

    /// What turns with four times the angle: means of cos 4θ and sin 4θ.
    pub fn fourfold(&self) -> [f64; 2] {
        let [a, b, c, d, e] = self.0;
        [a - 6.0 * c + e, 4.0 * (b - d)]
    }
}

/// Fabric of fourth order of a region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FourthFabric {
    /// Mean over contacts.
    pub plain: Fourth,
    /// The same weighted by normal force.
    pub weighted: Fourth,
    /// The same weighted by the size of the tangential force.
    pub by_tangential: Fourth,
}

impl FourthFabric {
    /// Sums over the touching contacts of the particles marked as inside; NaN when there are none.
    pub fn of(world: &World, inside: &[bool]) -> Self {
        let mut sums = [[0.0; 5]; 3];
        let mut totals = [0.0; 3];
        for link in Link::all(world).filter(Link::is_touching) {
            let weight = link.weight(inside);
            let Fourth(of) = Fourth::of(link.e.into());
            let shares = [1.0, link.normal, link.tangential.abs()];
            for ((sums, total), share) in sums.iter_mut().zip(&mut totals).zip(shares) {
                *total += weight * share;
                for (sum, component) in sums.iter_mut().zip(of) {
                    *sum += weight * share * component;
                }
            }
        }
        let mean = |k: usize| Fourth(sums[k].map(|sum| ratio(sum, totals[k])));
        Self {
            plain: mean(0),
            weighted: mean(1),
            by_tangential: mean(2),
        }
    }
}
