//! All measures of one region, each taken at most once and only when asked for.

use std::cell::OnceCell;

use super::fabric::Fabric;
use super::region::{Content, Shape};
use super::rose::{PETALS, Rose};
use super::stress::Stress;
use crate::engine::World;

/// A region of a world at a cycle boundary, measured as far as asked.
pub struct Regional<'a> {
    world: &'a World,
    shape: Shape,
    content: OnceCell<Content>,
    stress: OnceCell<Stress>,
    fabric: OnceCell<Fabric>,
}

impl<'a> Regional<'a> {
    /// Nothing measured yet.
    pub fn new(world: &'a World, shape: Shape) -> Self {
        Self {
            world,
            shape,
            content: OnceCell::new(),
            stress: OnceCell::new(),
            fabric: OnceCell::new(),
        }
    }

    /// What is in it.
    pub fn content(&self) -> &Content {
        self.content
            .get_or_init(|| Content::of(self.world, self.shape))
    }

    /// Stress and its parts.
    pub fn stress(&self) -> &Stress {
        self.stress
            .get_or_init(|| Stress::of(self.world, self.content()))
    }

    /// Fabric.
    pub fn fabric(&self) -> &Fabric {
        self.fabric
            .get_or_init(|| Fabric::of(self.world, self.content()))
    }

    /// The rose, which no column shows: measured anew by each call.
    pub fn rose(&self) -> Rose {
        Rose::of(self.world, self.content(), PETALS)
    }

    /// Value of a regional column; NaN for a name that is none.
    pub fn value(&self, name: &str) -> f64 {
        match name {
            "porosity" => self.content().porosity(),
            "stress_11" => self.stress().total[(0, 0)],
            "stress_12" => self.stress().total[(0, 1)],
            "stress_21" => self.stress().total[(1, 0)],
            "stress_22" => self.stress().total[(1, 1)],
            "isotropic_stress" => self.stress().isotropic(),
            "deviator_stress" => self.stress().deviator(),
            "sin_phi" => self.stress().sin_phi(),
            "sin_phi_shear" => self.stress().sin_phi_shear(),
            "anisotropy" => self.fabric().anisotropy(),
            "anisotropy_angle" => self.fabric().principal().angle,
            "anisotropy_weighted" => self.fabric().anisotropy_weighted(),
            _ => f64::NAN,
        }
    }
}
