//! What can be drawn of a region besides the assembly itself, taken at one cycle boundary: as much
//! of it as is wanted. Complete in itself, like the picture: whoever draws it needs no world.

use super::changes::{Bond, Changes, lattice, slid};
use super::contact_area::normal_stresses;
use super::fabric::Fabric;
use super::frame::home;
use super::histogram::Histogram;
use super::link::{Link, normal_forces};
use super::obliquity::Obliquity;
use super::profile::{Profile, RINGS};
use super::reference::Reference;
use super::rose::Rose;
use super::sample::Sample;
use super::strain::Strain;
use super::stress::Stress;
use crate::engine::World;

/// Bars of the histograms that begin at zero.
const BARS: usize = 16;

/// A part of a survey.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Roses and fabric.
    Directions,
    /// Stress, fabric, strain.
    Tensors,
    /// T/(μ N) of the contacts.
    Obliquity,
    /// Mean normal stress on the contact areas.
    ContactStress,
    /// Normal forces.
    NormalForce,
    /// Contacts and rotations against the reference.
    Changes,
    /// Porosity by distance.
    Profile,
}

/// Which parts are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Parts(u8);

impl Parts {
    /// All of them.
    pub const ALL: Self = Self(u8::MAX);

    /// These and another one.
    #[must_use]
    pub const fn with(self, part: Part) -> Self {
        Self(self.0 | 1 << part as u8)
    }

    /// Whether a part is among them.
    pub const fn has(self, part: Part) -> bool {
        self.0 & 1 << part as u8 != 0
    }
}

/// Tensors of a region: what circles of Mohr are drawn of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tensors {
    /// Stress and its parts.
    pub stress: Stress,
    /// Fabric, plain and weighted.
    pub fabric: Fabric,
    /// Strain since the reference, if there is one.
    pub strain: Option<Strain>,
}

/// How far a particle is from where it was at the reference.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Displaced {
    /// Its number.
    pub ball: u32,
    /// Displacement [m].
    pub u: [f64; 2],
    /// Rotation, counter-clockwise [rad].
    pub rotation: f64,
}

/// How far a touching contact has slid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slid {
    /// Where it is [m].
    pub at: [f64; 2],
    /// Unit tangent.
    pub along: [f64; 2],
    /// Way while it slid as a whole, since the reference or first touch [m].
    pub way: f64,
}

/// The whole assembly against the reference.
#[derive(Debug, Clone, PartialEq)]
pub struct Against {
    /// Cycle of the reference.
    pub since: u64,
    /// Counts of the region.
    pub changes: Changes,
    /// The space lattice [m].
    pub lattice: Vec<(Bond, [[f64; 2]; 2])>,
    /// Displacements and rotations of all particles that were there at the reference.
    pub displaced: Vec<Displaced>,
    /// Contacts that have slid; `None` when ways are not booked.
    pub slid: Option<Vec<Slid>>,
}

/// The measures of the default region that were wanted.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Survey {
    /// Contacts by direction, and their fabric.
    pub directions: Option<(Rose, Fabric)>,
    /// Stress, fabric, strain.
    pub tensors: Option<Tensors>,
    /// Points of the scatter diagram, and their histogram.
    pub obliquity: Option<Obliquity>,
    /// Mean normal stress on the contact areas [Pa].
    pub contact_stress: Option<Histogram>,
    /// Normal forces [N].
    pub normal_force: Option<Histogram>,
    /// Contacts and rotations against the reference, if there is one.
    pub against: Option<Against>,
    /// Porosity by distance.
    pub profile: Option<Profile>,
}

impl Survey {
    /// Takes what is wanted.
    pub fn of(sample: &Sample<'_>, parts: Parts) -> Self {
        let (region, world) = (sample.regional(), sample.world());
        let wanted = |part: Part| parts.has(part).then_some(());
        Self {
            directions: wanted(Part::Directions).map(|()| (region.rose(), *region.fabric())),
            tensors: wanted(Part::Tensors).map(|()| Tensors {
                stress: *region.stress(),
                fabric: *region.fabric(),
                strain: region.strain().copied(),
            }),
            obliquity: wanted(Part::Obliquity).map(|()| region.obliquity().clone()),
            contact_stress: wanted(Part::ContactStress)
                .map(|()| Histogram::from_zero(&normal_stresses(world, region.members()), BARS)),
            normal_force: wanted(Part::NormalForce)
                .map(|()| Histogram::from_zero(&normal_forces(world, region.members()), BARS)),
            against: wanted(Part::Changes)
                .and_then(|()| Some(against(sample, sample.reference()?, *region.changes()?))),
            profile: wanted(Part::Profile).map(|()| Profile::of(world, region.shape(), RINGS)),
        }
    }
}

fn against(sample: &Sample<'_>, reference: &Reference, changes: Changes) -> Against {
    let world = sample.world();
    let moved = world.particles().id.iter().filter_map(|&ball| {
        let (u, rotation) = reference.change(world, ball)?;
        Some(Displaced { ball, u, rotation })
    });
    Against {
        since: reference.cycle,
        changes,
        lattice: lattice(world, reference),
        displaced: moved.collect(),
        slid: world.ledger().map(|_| slid_contacts(world)),
    }
}

fn slid_contacts(world: &World) -> Vec<Slid> {
    let touching = Link::all(world).filter(Link::is_touching);
    let found = touching.filter_map(|link| {
        let way = slid(world, link.place).filter(|way| *way > 0.0)?;
        let from = home(world, world.position(link.first));
        Some(Slid {
            at: [0, 1].map(|k| from[k] + link.arms[0] * link.e[k]),
            along: link.t.into(),
            way,
        })
    });
    found.collect()
}
