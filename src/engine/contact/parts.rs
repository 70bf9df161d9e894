//! The parts a contact is put together from; each law's file implements some of these.
//!
//! Each part has two faces: what the loop asks of it, in lanes ([`NormalForce`], [`TangentialForce`],
//! [`RollingMoment`], [`Dashpots`]), and what is asked now and then of one contact. Where all contacts
//! are plain, in ways that most scenes have in common, there is less to read and to ask, with the same
//! bits.

use super::inner::Inner;
use super::memory::Memory;
use super::numbers::{Numbers, Written};
use super::quantities::{Basis, Load, Roll, Shear, Touch};
use super::traction::Traction;
use crate::engine::lanes::Lanes;

/// What lanes hold of a memory.
pub type Held<M, V> = <M as Memory>::In<V>;

/// Normal part of a law, in lanes.
pub trait NormalForce<V: Lanes>: Numbers<V> {
    /// Memory in lanes.
    type Memory;
    /// Spring force [N].
    fn force(&self, touch: &Touch<V>, memory: &mut Self::Memory) -> V;
    /// Tangent stiffness at this overlap, not below zero, or where the memory stands [N/m].
    fn tangent(&self, overlap: V, memory: &Self::Memory) -> V;
    /// The overlap that the tangential part is to see [m].
    #[inline(always)]
    fn depth(&self, overlap: V, _memory: &Self::Memory) -> V {
        overlap
    }
}

/// Normal part of a law.
pub trait Normal:
    NormalForce<f64, Memory = Self::Memo> + Written<f64> + Send + Sync + 'static
{
    /// Memory per contact.
    type Memo: Memory<Whole = (), In<f64> = Self::Memo>;
    /// In lanes.
    type On<V: Lanes>: NormalForce<V, Memory = Held<Self::Memo, V>>;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Energy in the spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memo) -> f64;
    /// The spring force at this overlap, or the one the memory holds [N]; memory does not advance.
    fn held(&self, overlap: f64, memory: &Self::Memo) -> f64;
    /// Memory that carries a force, as far as it is free to [N].
    fn seed(&self, force: f64) -> Self::Memo;
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memo) -> Vec<Inner> {
        Vec::new()
    }
}

/// Tangential part of a law, in lanes.
pub trait TangentialForce<V: Lanes>: Numbers<V> {
    /// Memory in lanes.
    type Memory;
    /// Whether it can carry a force at all: without it no spin is needed.
    const ACTIVE: bool;
    /// Whether the force is never beyond the limit that it comes with, and at it where it slides.
    const WITHIN: bool = false;
    /// Whether contacts can be bonded: what reads of it is compiled for such laws only.
    const BONDS: bool = false;
    /// Advances the memory by one step and answers.
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut Self::Memory) -> Shear<V>;
    /// Stiffness without slip at this overlap, not below zero: no tangent is stiffer [N/m].
    fn steepest(&self, overlap: V) -> V;
    /// Where a bond holds the bodies together at the end of this step, whether they overlap or not.
    #[inline(always)]
    fn holds(&self, _touch: &Touch<V>, _memory: &Self::Memory) -> V::Mask {
        V::mask(0)
    }
}

/// Tangential part of a law.
pub trait Tangential: Written<f64> + Send + Sync + 'static {
    /// Memory per contact.
    type Memo: Memory;
    /// In lanes.
    type On<V: Lanes>: TangentialForce<V, Memory = Held<Self::Memo, V>>;
    /// In lanes, where all contacts are plain.
    type Plain<V: Lanes>: TangentialForce<V, Memory = Held<Self::Memo, V>>;
    /// Whether all contacts are, told of each number the value that all have, if they have one.
    fn all_plain(_common: &[Option<f64>]) -> bool {
        true
    }
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// The spring force the memory holds [N].
    fn held(&self, memory: &Self::Memo) -> f64;
    /// Stiffness without slip at this overlap: no tangent is stiffer [N/m].
    fn stiffness(&self, overlap: f64) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memo) -> f64;
    /// The contact comes apart over this displacement: the energy lost by sliding of the whole and
    /// by slip within [J].
    fn part(&self, displacement: f64, memory: &Self::Memo) -> [f64; 2];
    /// Memory that carries a force at an overlap [m], as far as the friction limit lets it [N].
    fn seed(&self, overlap: f64, force: f64) -> Self::Memo;
    /// The memory of a contact when its parameters change from `before` to these.
    fn refit(&self, _before: &Self, overlap: f64, memory: &Self::Memo) -> Self::Memo {
        self.seed(overlap, self.held(memory))
    }
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
    /// What the law knows about the traction inside the contact, if anything.
    fn traction(&self, _memory: &Self::Memo) -> Option<Traction> {
        None
    }
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memo) -> Vec<Inner> {
        Vec::new()
    }
}

/// Resistance to rolling, in lanes.
pub trait RollingMoment<V: Lanes>: Numbers<V> {
    /// Memory in lanes.
    type Memory;
    /// Whether there is any.
    const ACTIVE: bool;
    /// Advances the memory by one step and answers.
    fn moment(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut Self::Memory) -> Roll<V>;
}

/// Resistance to rolling.
pub trait Rolling: Written<f64> + Send + Sync + 'static {
    /// Memory per contact.
    type Memo: Memory<Whole = ()>;
    /// In lanes.
    type On<V: Lanes>: RollingMoment<V, Memory = Held<Self::Memo, V>>;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Stiffness beside a normal spring of this tangent stiffness [N m].
    fn stiffness(&self, normal: f64) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, memory: &Self::Memo) -> f64;
    /// The memory of a contact when its parameters change from `before` to these.
    fn refit(&self, _before: &Self, memory: &Self::Memo) -> Self::Memo;
    /// The contact comes apart while the bodies turn by this angle: the energy lost [J].
    fn part(&self, angle: f64, memory: &Self::Memo) -> f64;
    /// What its memory holds, for people; `overlap` [m] as the law is given it.
    fn inner(&self, _overlap: f64, _memory: &Self::Memo) -> Vec<Inner> {
        Vec::new()
    }
}

/// Dashpots of a law, in lanes.
pub trait Dashpots<V: Lanes>: Numbers<V> {
    /// Normal force [N] of a spring of this force and stiffness [N/m] with the dashpot beside it.
    fn normal(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V;
    /// The same where a bond holds, which passes on whatever dashpot and spring pull with.
    fn bonded(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V;
    /// Whether any lane has a tangential dashpot.
    #[inline(always)]
    fn rubs(&self, _touch: &Touch<V>) -> bool {
        false
    }
    /// Tangential dashpot force [N] beside a spring of this stiffness [N/m].
    #[inline(always)]
    fn tangential(&self, _stiffness: V, _touch: &Touch<V>) -> V {
        V::all(0.0)
    }
}

/// Dashpots of a law.
pub trait Viscosity: Written<f64> + Send + Sync + 'static {
    /// In lanes.
    type On<V: Lanes>: Dashpots<V>;
    /// In lanes, where all contacts are plain.
    type Plain<V: Lanes>: Dashpots<V>;
    /// Whether all contacts are, told of each number the value that all have, if they have one.
    fn all_plain(common: &[Option<f64>]) -> bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Viscosities beside springs of these stiffnesses [N s/m].
    fn viscosity(&self, stiffness: [f64; 2], overlap: f64) -> [f64; 2];
}
