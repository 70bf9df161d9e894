//! All measures of one region, each taken at most once and only when asked for.

use std::cell::OnceCell;

use super::assembly::Assembly;
use super::changes::Changes;
use super::contact_area;
use super::fabric::Fabric;
use super::flow::Flow;
use super::fourier::Fourier;
use super::fourth::FourthFabric;
use super::obliquity::Obliquity;
use super::redundancy::Redundancy;
use super::reference::Reference;
use super::region::{Content, Shape};
use super::rose::{PETALS, Rose};
use super::strain::Strain;
use super::stress::Stress;
use super::tensor::ratio;
use crate::engine::World;

/// A region of a world at a cycle boundary, measured as far as asked.
pub struct Regional<'a> {
    world: &'a World,
    shape: Shape,
    reference: Option<&'a Reference>,
    members: OnceCell<Vec<bool>>,
    content: OnceCell<Content>,
    assembly: OnceCell<Assembly>,
    stress: OnceCell<Stress>,
    fabric: OnceCell<Fabric>,
    fourth: OnceCell<FourthFabric>,
    fourier: OnceCell<Fourier>,
    obliquity: OnceCell<Obliquity>,
    contact_stress: OnceCell<[f64; 2]>,
    redundancy: OnceCell<Redundancy>,
    flow: OnceCell<Flow>,
    strain: OnceCell<Option<Strain>>,
    changes: OnceCell<Option<Changes>>,
}

impl<'a> Regional<'a> {
    /// Nothing measured yet. Without a reference there are no differences from it.
    pub fn new(world: &'a World, shape: Shape, reference: Option<&'a Reference>) -> Self {
        Self {
            world,
            shape,
            reference,
            members: OnceCell::new(),
            content: OnceCell::new(),
            assembly: OnceCell::new(),
            stress: OnceCell::new(),
            fabric: OnceCell::new(),
            fourth: OnceCell::new(),
            fourier: OnceCell::new(),
            obliquity: OnceCell::new(),
            contact_stress: OnceCell::new(),
            redundancy: OnceCell::new(),
            flow: OnceCell::new(),
            strain: OnceCell::new(),
            changes: OnceCell::new(),
        }
    }

    /// The world it is part of.
    pub fn world(&self) -> &'a World {
        self.world
    }

    /// Where it is.
    pub fn shape(&self) -> Shape {
        self.shape
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

    /// Fabric of fourth order.
    pub fn fourth(&self) -> &FourthFabric {
        self.fourth
            .get_or_init(|| FourthFabric::of(self.world, self.members()))
    }

    /// Fourier coefficients.
    pub fn fourier(&self) -> &Fourier {
        self.fourier
            .get_or_init(|| Fourier::of(self.world, self.members(), &self.fourth().plain))
    }

    /// Obliquities of the contact forces.
    pub fn obliquity(&self) -> &Obliquity {
        self.obliquity
            .get_or_init(|| Obliquity::of(self.world, self.members()))
    }

    /// Mean over contacts of the mean normal stress on each, and the largest [Pa].
    pub fn contact_stress(&self) -> [f64; 2] {
        *self.contact_stress.get_or_init(|| {
            let (mut sum, mut count, mut most) = (0.0, 0.0, f64::NAN);
            for (stress, weight) in contact_area::normal_stresses(self.world, self.members()) {
                sum += weight * stress;
                count += weight;
                most = f64::max(most, stress);
            }
            [ratio(sum, count), most]
        })
    }

    /// Unknown forces against equations.
    pub fn redundancy(&self) -> &Redundancy {
        self.redundancy
            .get_or_init(|| Redundancy::of(self.world, self.members()))
    }

    /// Strain rate and fluctuations.
    pub fn flow(&self) -> &Flow {
        self.flow
            .get_or_init(|| Flow::of(self.world, self.members()))
    }

    /// Strain since the reference, if there is one.
    pub fn strain(&self) -> Option<&Strain> {
        let strain = |reference| Strain::of(self.world, self.shape, reference);
        self.strain
            .get_or_init(|| self.reference.map(strain))
            .as_ref()
    }

    /// Contacts and rotations against the reference, if there is one.
    pub fn changes(&self) -> Option<&Changes> {
        let changes = |reference| Changes::of(self.world, self.members(), reference);
        self.changes
            .get_or_init(|| self.reference.map(changes))
            .as_ref()
    }

    /// The rose, which no column shows: measured anew by each call.
    pub fn rose(&self) -> Rose {
        Rose::of(self.world, self.content(), PETALS)
    }
}
