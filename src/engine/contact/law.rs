//! A law as the loop runs it, put together from its parts at compile time.

use super::inner::Inner;
use super::memory::Memory;
use super::parts::{Normal, Rolling, Tangential, Viscosity};
use super::quantities::{Basis, Load, Reaction, Stiffness, Touch};
use super::traction::Traction;

/// One law with its parameters, as the loop runs it.
pub trait Law: Copy + Send + Sync + 'static {
    /// Memory per contact.
    type Memory: Memory;
    /// Whether tangential forces and spins exist.
    const TANGENTIAL: bool;
    /// Whether rolling is resisted.
    const ROLLING: bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// Force of a touching pair; advances the memory.
    fn react(&self, touch: &Touch, memory: &mut Self::Memory) -> Reaction;
    /// The pair has come apart: forgets, and answers the energy lost by sliding and by slip [J].
    fn part(&self, touch: &Touch, memory: &mut Self::Memory) -> [f64; 2];
    /// Energies in the normal and the tangential spring, the latter with the rolling one [J].
    fn energy(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2];
    /// Forces of the normal and the tangential spring [N].
    fn springs(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2];
    /// Stiffness and viscosity.
    fn stiffness(&self, overlap: f64, memory: &Self::Memory) -> Stiffness;
    /// Memory that carries these spring forces at an overlap, as far as the law lets it.
    fn seed(&self, overlap: f64, forces: [f64; 2]) -> Self::Memory;
    /// The memory that a contact had with parameters `before`, as it is with these.
    fn refit(&self, before: &Self, overlap: f64, memory: &Self::Memory) -> Self::Memory;
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
    /// The traction inside the contact, if the law knows it.
    fn traction(&self, memory: &Self::Memory) -> Option<Traction>;
    /// What the memory holds, for people.
    fn inner(&self, overlap: f64, memory: &Self::Memory) -> Vec<Inner>;
}

/// A law put together from its parts.
#[derive(Debug, Clone, Copy)]
pub struct Contact<N, T, R, D> {
    normal: N,
    tangential: T,
    rolling: R,
    dashpot: D,
}

impl<N: Normal, T: Tangential, R: Rolling, D: Viscosity> Law for Contact<N, T, R, D> {
    type Memory = (N::Memory, T::Memory, R::Memory);
    const TANGENTIAL: bool = T::ACTIVE || R::ACTIVE;
    const ROLLING: bool = R::ACTIVE;

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            normal: N::prepare(basis),
            tangential: T::prepare(basis),
            rolling: R::prepare(basis),
            dashpot: D::prepare(basis),
        }
    }

    #[inline(always)]
    fn react(&self, touch: &Touch, memory: &mut Self::Memory) -> Reaction {
        let (normal_memory, shear_memory, roll_memory) = memory;
        let elastic = self.normal.force(touch, normal_memory);
        let stiffness = self.normal.stiffness(touch.overlap, normal_memory);
        let total = self.dashpot.normal(elastic, stiffness, touch);
        let load = Load {
            elastic,
            total,
            stiffness,
        };
        // A sum of increments may stand at another overlap than the bodies do.
        let touch = &Touch {
            overlap: self.normal.overlap(touch.overlap, normal_memory),
            ..*touch
        };
        let shear = self.tangential.force(touch, &load, shear_memory);
        let roll = self.rolling.moment(touch, &load, roll_memory);
        // No contact carries more than its friction limit, whatever carries it: without friction
        // there is no tangential dashpot either, and none kicks at the first touch.
        let sliding = shear.sliding || shear.force.abs() > shear.limit;
        let (carried, drag) = if sliding || !T::ACTIVE {
            (shear.limit.copysign(shear.force), 0.0)
        } else {
            let k = self.tangential.stiffness(touch.overlap);
            let sum = shear.force + self.dashpot.tangential(k, touch);
            let carried = if sum.abs() > shear.limit {
                shear.limit.copysign(sum)
            } else {
                sum
            };
            (carried, carried - shear.force)
        };
        Reaction {
            normal: total,
            tangential: carried,
            moment: roll.moment,
            damping: [total - elastic, drag],
            excess: if sliding { carried - shear.force } else { 0.0 },
            loss: [shear.loss[0] + roll.loss, shear.loss[1]],
            sliding,
        }
    }

    fn part(&self, touch: &Touch, memory: &mut Self::Memory) -> [f64; 2] {
        let [sliding, slip] = self.tangential.part(touch.slide * touch.dt, &memory.1);
        let rolling = self.rolling.part(touch.roll * touch.dt, &memory.2);
        *memory = Self::Memory::default();
        [sliding + rolling, slip]
    }

    fn energy(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2] {
        [
            self.normal.energy(overlap, &memory.0),
            self.tangential.energy(overlap, &memory.1) + self.rolling.energy(&memory.2),
        ]
    }

    fn springs(&self, overlap: f64, memory: &Self::Memory) -> [f64; 2] {
        [
            self.normal.held(overlap, &memory.0),
            self.tangential.held(&memory.1),
        ]
    }

    fn stiffness(&self, overlap: f64, memory: &Self::Memory) -> Stiffness {
        let normal = self.normal.stiffness(overlap, &memory.0);
        let depth = self.normal.overlap(overlap, &memory.0);
        let k = [normal, self.tangential.stiffness(depth)];
        let [along, across] = self.dashpot.viscosity(k, overlap);
        let shears = self.tangential.is_frictional();
        Stiffness {
            k,
            c: [along, if shears { across } else { 0.0 }],
            rolling: self.rolling.stiffness(normal),
        }
    }

    fn seed(&self, overlap: f64, forces: [f64; 2]) -> Self::Memory {
        (
            self.normal.seed(forces[0]),
            self.tangential.seed(overlap, forces[1]),
            R::Memory::default(),
        )
    }

    fn refit(&self, before: &Self, overlap: f64, memory: &Self::Memory) -> Self::Memory {
        (
            memory.0,
            self.tangential
                .refit(&before.tangential, overlap, &memory.1),
            self.rolling.refit(&before.rolling, &memory.2),
        )
    }

    fn is_frictional(&self) -> bool {
        self.tangential.is_frictional()
    }

    fn traction(&self, memory: &Self::Memory) -> Option<Traction> {
        self.tangential.traction(&memory.1)
    }

    fn inner(&self, overlap: f64, memory: &Self::Memory) -> Vec<Inner> {
        let mut inner = self.normal.inner(overlap, &memory.0);
        inner.extend(self.tangential.inner(overlap, &memory.1));
        inner.extend(self.rolling.inner(overlap, &memory.2));
        inner
    }
}
