//! Everything that can be drawn of a region, taken at one cycle boundary: what panes show besides
//! the assembly itself. Complete in itself, like the picture: whoever draws it needs no world.

use super::changes::{Bond, Changes, lattice};
use super::contact_area::normal_stresses;
use super::fabric::Fabric;
use super::flow::Flow;
use super::fourier::Fourier;
use super::histogram::Histogram;
use super::link::normal_forces;
use super::obliquity::Obliquity;
use super::profile::{Profile, RINGS};
use super::redundancy::Redundancy;
use super::rose::Rose;
use super::sample::Sample;
use super::strain::Strain;
use super::stress::Stress;

/// Bars of the histograms that begin at zero.
const BARS: usize = 16;

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

/// The measures of the default region.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// Stress and its parts; the circle of Mohr is that of its principal values.
    pub stress: Stress,
    /// Fabric, with its own circle.
    pub fabric: Fabric,
    /// Waves over directions.
    pub fourier: Fourier,
    /// Contacts by direction.
    pub rose: Rose,
    /// Points of the scatter diagram, and their histogram.
    pub obliquity: Obliquity,
    /// Mean normal stress on the contact areas [Pa].
    pub contact_stress: Histogram,
    /// Normal forces [N].
    pub normal_force: Histogram,
    /// Unknown forces and equations.
    pub redundancy: Redundancy,
    /// Strain rate and fluctuations.
    pub flow: Flow,
    /// Strain since the reference, if there is one.
    pub strain: Option<Strain>,
    /// Contacts and rotations against the reference, if there is one.
    pub changes: Option<Changes>,
    /// The space lattice of the whole assembly against the reference [m]; empty without one.
    pub lattice: Vec<(Bond, [[f64; 2]; 2])>,
    /// Displacements and rotations of all particles that were there at the reference.
    pub displaced: Vec<Displaced>,
    /// Porosity by distance.
    pub profile: Profile,
}

impl Survey {
    /// Takes all of it.
    pub fn of(sample: &Sample<'_>) -> Self {
        let (region, world) = (sample.regional(), sample.world());
        let inside = region.members();
        let bonds = |reference| lattice(world, reference);
        Self {
            stress: *region.stress(),
            fabric: *region.fabric(),
            fourier: *region.fourier(),
            rose: region.rose(),
            obliquity: region.obliquity().clone(),
            contact_stress: Histogram::from_zero(&normal_stresses(world, inside), BARS),
            normal_force: Histogram::from_zero(&normal_forces(world, inside), BARS),
            redundancy: *region.redundancy(),
            flow: *region.flow(),
            strain: region.strain().copied(),
            changes: region.changes().copied(),
            lattice: sample.reference().map(bonds).unwrap_or_default(),
            displaced: displaced(sample),
            profile: Profile::of(world, region.shape(), RINGS),
        }
    }
}

fn displaced(sample: &Sample<'_>) -> Vec<Displaced> {
    let Some(reference) = sample.reference() else {
        return Vec::new();
    };
    let (world, ids) = (sample.world(), &sample.world().particles().id);
    let moved = ids.iter().filter_map(|&ball| {
        let (u, rotation) = reference.change(world, ball)?;
        Some(Displaced { ball, u, rotation })
    });
    moved.collect()
}
