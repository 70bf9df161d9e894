//! What a servo has to know at each of its looks: one pass over the contacts, where [`super::stress`]
//! makes two and takes the stress apart.

use nalgebra::Matrix2;

use super::branch::Branch;
use super::region::Content;
use crate::engine::World;

/// Stress of a region, and how stiffly its contacts answer a strain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bearing {
    /// Stress [Pa], with the bits of [`super::stress::Stress::total`].
    pub stress: Matrix2<f64>,
    /// Stress per isotropic strain if all particles followed the strain [Pa].
    pub modulus: f64,
}

impl Bearing {
    /// Of the contacts of a region. Those that only a dashpot pulls at carry stress, and stiffen nothing.
    pub fn of(world: &World, content: &Content) -> Self {
        let (mut stress, mut stiffness) = (Matrix2::zeros(), 0.0);
        for branch in Branch::all(world) {
            let reach = branch.reach(&content.inside);
            if reach == 0.0 {
                continue;
            }
            stress -= reach * branch.e * branch.force.transpose();
            if branch.normal() > 0.0 || world.is_bonded(branch.place) {
                let k = world.pass().stiffness(branch.place, branch.overlap).k[0];
                stiffness += k * reach * (branch.arms[0] + branch.arms[1]);
            }
        }
        let per_volume = content.per_volume();
        Self {
            stress: stress * per_volume,
            modulus: 0.5 * per_volume * stiffness,
        }
    }
}
