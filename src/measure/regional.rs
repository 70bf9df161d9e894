//! All measures of one region, each taken at most once and only when asked for.

use std::cell::OnceCell;

use super::assembly::Assembly;
use super::fabric::Fabric;
use super::region::{Content, Shape};
use super::rose::{PETALS, Rose};
use super::stress::Stress;
use crate::engine::World;

/// A region of a world at a cycle boundary, measured as far as asked.
pub struct Regional<'a> {
    world: &'a World,
    shape: Shape,
    members: OnceCell<Vec<bool>>,
    content: OnceCell<Content>,
    assembly: OnceCell<Assembly>,
    stress: OnceCell<Stress>,
    fabric: OnceCell<Fabric>,
}

impl<'a> Regional<'a> {
    /// Nothing measured yet.
    pub fn new(world: &'a World, shape: Shape) -> Self {
        Self {
            world,
            shape,
            members: OnceCell::new(),
            content: OnceCell::new(),
            assembly: OnceCell::new(),
            stress: OnceCell::new(),
            fabric: OnceCell::new(),
        }
    }

    /// For each particle, whether its centre is inside.
    pub fn members(&self) -> &[bool] {
        self.members.get_or_init(|| self.shape.members(self.world))
    }

    /// What is in it.
    pub fn content(&self) -> &Content {
        self.content
            .get_or_init(|| Content::of(self.world, self.shape))
    }

    /// Counts and forces.
    pub fn assembly(&self) -> &Assembly {
        self.assembly
            .get_or_init(|| Assembly::within(self.world, self.members()))
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
}
