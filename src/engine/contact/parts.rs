//! The parts a contact is put together from; each law's file implements some of these.

use super::inner::Inner;
use super::memory::Memory;
use super::quantities::{Basis, Load, Roll, Shear, Touch};
use super::traction::Traction;

/// Normal part of a law.
pub trait Normal: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Spring force [N].
    fn force(&self, touch: &Touch, memory: &mut Self::Memory) -> f64;
    /// Tangent stiffness at this overlap, or where the memory stands [N/m].
    fn stiffness(&self, overlap: f64, memory: &Self::Memory) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memory) -> f64;
    /// The spring force at this overlap, or the one the memory holds [N]; memory does not advance.
    fn held(&self, overlap: f64, memory: &Self::Memory) -> f64;
    /// The overlap that the tangential part is to see [m].
    #[inline(always)]
    fn overlap(&self, overlap: f64, _memory: &Self::Memory) -> f64 {
        overlap
    }
    /// Memory that carries a force, as far as it is free to [N].
    fn seed(&self, force: f64) -> Self::Memory;
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memory) -> Vec<Inner> {
        Vec::new()
    }
}

/// Tangential part of a law.
pub trait Tangential: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// Whether it can carry a force at all: without it no spin is needed.
    const ACTIVE: bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Advances the memory by one step and answers.
    fn force(&self, touch: &Touch, load: &Load, memory: &mut Self::Memory) -> Shear;
    /// The spring force the memory holds [N].
    fn held(&self, memory: &Self::Memory) -> f64;
    /// Stiffness without slip at this overlap: no tangent is stiffer [N/m].
    fn stiffness(&self, overlap: f64) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memory) -> f64;
    /// The contact comes apart over this displacement: the energy lost by sliding of the whole and
    /// by slip within [J].
    fn part(&self, displacement: f64, memory: &Self::Memory) -> [f64; 2];
    /// Memory that carries a force at an overlap [m], as far as the friction limit lets it [N].
    fn seed(&self, overlap: f64, force: f64) -> Self::Memory;
    /// The memory of a contact when its parameters change from `before` to these.
    fn refit(&self, _before: &Self, overlap: f64, memory: &Self::Memory) -> Self::Memory {
        self.seed(overlap, self.held(memory))
    }
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
    /// What the law knows about the traction inside the contact, if anything.
    fn traction(&self, _memory: &Self::Memory) -> Option<Traction> {
        None
    }
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memory) -> Vec<Inner> {
        Vec::new()
    }
}

/// Resistance to rolling.
pub trait Rolling: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// Whether there is any.
    const ACTIVE: bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Advances the memory by one step and answers.
    fn moment(&self, touch: &Touch, load: &Load, memory: &mut Self::Memory) -> Roll;
    /// Stiffness beside a normal spring of this tangent stiffness [N m].
    fn stiffness(&self, normal: f64) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, memory: &Self::Memory) -> f64;
    /// The memory of a contact when its parameters change from `before` to these.
    fn refit(&self, _before: &Self, memory: &Self::Memory) -> Self::Memory;
    /// The contact comes apart while the bodies turn by this angle: the energy lost [J].
    fn part(&self, angle: f64, memory: &Self::Memory) -> f64;
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memory) -> Vec<Inner> {
        Vec::new()
    }
}

/// Dashpots of a law.
pub trait Viscosity: Copy + Send + Sync + 'static {
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Normal force [N] of a spring of this force and stiffness [N/m] with the dashpot beside it.
    fn normal(&self, elastic: f64, stiffness: f64, touch: &Touch) -> f64;
    /// Tangential dashpot force [N] beside a spring of this stiffness [N/m].
    fn tangential(&self, stiffness: f64, touch: &Touch) -> f64;
    /// Viscosities beside springs of these stiffnesses [N s/m].
    fn viscosity(&self, stiffness: [f64; 2], overlap: f64) -> [f64; 2];
}
