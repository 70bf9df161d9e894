//! Contact laws: pure functions of named quantities, one file each, put together at compile time.
//!
//! A law sees a [`Touch`] and its own memory; it knows no world, no wall, no particle. A
//! [`Contact`] is a normal, a tangential and a dashpot part; [`pass`] runs one kind of contact over
//! the list in one monomorphised loop. Each part declares its memory as an associated type, so a
//! scene without friction stores none.

pub mod dashpot;
pub mod laws;
pub mod linear;
pub mod memory;
pub mod pass;

use super::pair::Pair;
use memory::Memory;

/// What a law is told about a touching pair.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Touch {
    /// Overlap α > 0 [m].
    pub overlap: f64,
    /// Approach velocity along the normal [m/s].
    pub approach: f64,
    /// Velocity of the first body's surface relative to the second's, along t [m/s].
    pub slide: f64,
    /// Time step [s].
    pub dt: f64,
}

/// Normal load that the tangential part is given.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Load {
    /// Spring force [N].
    pub elastic: f64,
    /// Spring and dashpot together [N]: the base of the Coulomb limit.
    pub total: f64,
}

/// What the tangential part answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shear {
    /// Spring force [N].
    pub force: f64,
    /// Energy lost by slip in this step [J]: mean force times slip.
    pub loss: f64,
    /// Whether the whole contact slid.
    pub sliding: bool,
    /// Friction limit: what spring and dashpot together may reach [N].
    pub limit: f64,
}

/// What a contact does to its first body: force -n e - T t.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Reaction {
    /// Normal force [N], compression positive.
    pub normal: f64,
    /// Tangential force [N].
    pub tangential: f64,
    /// The dashpots' share of the two [N].
    pub damping: [f64; 2],
    /// Energy lost by slip in this step [J].
    pub loss: f64,
    /// Whether the contact slid.
    pub sliding: bool,
}

/// Stiffness and viscosity of a contact as it stands, for the stability bound.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Stiffness {
    /// Normal and tangential stiffness [N/m].
    pub k: [f64; 2],
    /// Normal and tangential viscosity [N s/m].
    pub c: [f64; 2],
}

/// What a part of a contact is prepared from, once per pair and rebuild.
#[derive(Debug, Clone, Copy)]
pub struct Basis<'a> {
    /// Parameters of the two materials.
    pub pair: &'a Pair,
    /// Effective mass m1 m2/(m1 + m2) [kg]; a wall or driven partner has infinite mass.
    pub m_eff: f64,
}

/// Normal part of a law.
pub trait Normal: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Spring force [N].
    fn force(&self, touch: &Touch, memory: &mut Self::Memory) -> f64;
    /// Tangent stiffness [N/m].
    fn stiffness(&self, overlap: f64) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memory) -> f64;
    /// The spring force at this overlap, or the one the memory holds [N]; memory does not advance.
    fn held(&self, overlap: f64, memory: &Self::Memory) -> f64;
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
    /// Tangent stiffness [N/m].
    fn stiffness(&self) -> f64;
    /// Energy in the spring [J].
    fn energy(&self, memory: &Self::Memory) -> f64;
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
}

/// Dashpots of a law.
pub trait Viscosity: Copy + Send + Sync + 'static {
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Normal dashpot force [N].
    fn normal(&self, approach: f64) -> f64;
    /// Tangential dashpot force [N].
    fn tangential(&self, slide: f64) -> f64;
    /// The least the total normal force may be [N].
    fn floor(&self) -> f64;
    /// Viscosities [N s/m].
    fn viscosity(&self) -> [f64; 2];
}

/// One law with its parameters, as the loop runs it.
pub trait Law: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// Whether tangential forces and spins exist.
    const TANGENTIAL: bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Force of a touching pair; advances the memory.
    fn react(&self, touch: &Touch, memory: &mut Self::Memory) -> Reaction;
    /// The pair has come apart: forgets, and answers the energy lost by slip [J].
    fn part(&self, touch: &Touch, memory: &mut Self::Memory) -> f64;
    /// Energies in the normal and the tangential spring [J].
    fn energy(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2];
    /// Forces of the normal and the tangential spring [N].
    fn springs(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2];
    /// Stiffness and viscosity.
    fn stiffness(&self, overlap: f64) -> Stiffness;
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
}

/// A law put together from its three parts.
#[derive(Debug, Clone, Copy)]
pub struct Contact<N, T, D> {
    normal: N,
    tangential: T,
    dashpot: D,
}

impl<N: Normal, T: Tangential, D: Viscosity> Law for Contact<N, T, D> {
    type Memory = (N::Memory, T::Memory);
    const TANGENTIAL: bool = T::ACTIVE;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            normal: N::prepare(basis),
            tangential: T::prepare(basis),
            dashpot: D::prepare(basis),
        }
    }

    #[inline(always)]
    fn react(&self, touch: &Touch, memory: &mut Self::Memory) -> Reaction {
        let elastic = self.normal.force(touch, &mut memory.0);
        let sum = elastic + self.dashpot.normal(touch.approach);
        let floor = self.dashpot.floor();
        let total = if sum > floor { sum } else { floor };
        let shear = self
            .tangential
            .force(touch, &Load { elastic, total }, &mut memory.1);
        let drag = if shear.sliding || !T::ACTIVE {
            0.0
        } else {
            self.dashpot.tangential(touch.slide)
        };
        // No contact carries more than its friction limit, whatever carries it: without friction
        // there is no tangential dashpot either, and none kicks at the first touch.
        let tangential = shear.force + drag;
        let (tangential, drag) = if tangential.abs() > shear.limit {
            let most = shear.limit.copysign(tangential);
            (most, most - shear.force)
        } else {
            (tangential, drag)
        };
        Reaction {
            normal: total,
            tangential,
            damping: [total - elastic, drag],
            loss: shear.loss,
            sliding: shear.sliding,
        }
    }

    fn part(&self, touch: &Touch, memory: &mut Self::Memory) -> f64 {
        // A step to zero load: the spring gives its energy and the rest of the path to slip.
        let held = self.tangential.held(&memory.1);
        let loss = self.tangential.energy(&memory.1) + 0.5 * held * touch.slide * touch.dt;
        *memory = Self::Memory::default();
        loss
    }

    fn energy(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2] {
        [
            self.normal.energy(overlap, &memory.0),
            self.tangential.energy(&memory.1),
        ]
    }

    fn springs(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2] {
        [
            self.normal.held(overlap, &memory.0),
            self.tangential.held(&memory.1),
        ]
    }

    fn stiffness(&self, overlap: f64) -> Stiffness {
        let k = [self.normal.stiffness(overlap), self.tangential.stiffness()];
        let [normal, tangential] = self.dashpot.viscosity();
        let shears = self.tangential.is_frictional();
        Stiffness {
            k,
            c: [normal, if shears { tangential } else { 0.0 }],
        }
    }

    fn is_frictional(&self) -> bool {
        self.tangential.is_frictional()
    }
}
