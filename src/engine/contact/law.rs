//! A law as the loop runs it, put together from its parts at compile time.

use super::inner::Inner;
use super::memory::Memory;
use super::numbers::{Numbers, Reading, Writing, Written};
use super::parts::{
    Dashpots, Held, Normal, NormalForce, Rolling, RollingMoment, Tangential, TangentialForce,
    Viscosity,
};
use super::quantities::{Basis, Load, Reaction, Stiffness, Touch};
use super::traction::Traction;
use crate::engine::lanes::Lanes;

/// A law in lanes.
pub trait React<V: Lanes>: Numbers<V> {
    /// Memory in lanes.
    type Memory;
    /// Whether tangential forces and spins exist.
    const TANGENTIAL: bool;
    /// Whether rolling is resisted.
    const ROLLING: bool;
    /// Whether contacts can be bonded.
    const BONDS: bool;
    /// Where a bond holds the bodies together at the end of this step, whether they overlap or not.
    fn holds(&self, touch: &Touch<V>, memory: &Self::Memory) -> V::Mask;
    /// Force of touching pairs; advances the memory.
    fn react(&self, touch: &Touch<V>, memory: &mut Self::Memory) -> Reaction<V>;
}

/// One law with its parameters.
pub trait Law: Written<f64> + Send + Sync + 'static {
    /// Memory per contact.
    type Memo: Memory;
    /// In lanes.
    type On<V: Lanes>: React<V, Memory = Held<Self::Memo, V>>;
    /// In lanes, where all contacts are plain.
    type Plain<V: Lanes>: React<V, Memory = Held<Self::Memo, V>>;
    /// Whether all contacts are, told of each number the value that all have, if they have one.
    fn all_plain(common: &[Option<f64>]) -> bool;
    /// From the parameters of the pair.
    fn prepare(basis: &Basis<'_>) -> Self;
    /// The pair has come apart: the energy lost by sliding, and by slip or with a bond [J].
    fn part(&self, touch: &Touch, memory: &Self::Memo) -> [f64; 2];
    /// Energies in the normal and the tangential spring, the latter with the rolling one [J].
    fn energy(&self, overlap: f64, memory: &Self::Memo) -> [f64; 2];
    /// Forces of the normal and the tangential spring [N].
    fn springs(&self, overlap: f64, memory: &Self::Memo) -> [f64; 2];
    /// Stiffness and viscosity.
    fn stiffness(&self, overlap: f64, memory: &Self::Memo) -> Stiffness;
    /// Memory that carries these spring forces at an overlap, as far as the law lets it.
    fn seed(&self, overlap: f64, forces: [f64; 2]) -> Self::Memo;
    /// The memory that a contact had with parameters `before`, as it is with these.
    fn refit(&self, before: &Self, overlap: f64, memory: &Self::Memo) -> Self::Memo;
    /// Whether a friction limit applies.
    fn is_frictional(&self) -> bool;
    /// The traction inside the contact, if the law knows it.
    fn traction(&self, memory: &Self::Memo) -> Option<Traction>;
    /// What the memory holds, for people.
    fn inner(&self, overlap: f64, memory: &Self::Memo) -> Vec<Inner>;
}

/// A law put together from its parts.
#[derive(Debug, Clone, Copy)]
pub struct Contact<N, T, R, D> {
    normal: N,
    tangential: T,
    rolling: R,
    dashpot: D,
}

impl<V, N, T, R, D> Numbers<V> for Contact<N, T, R, D>
where
    V: Lanes,
    N: Numbers<V>,
    T: Numbers<V>,
    R: Numbers<V>,
    D: Numbers<V>,
{
    const COUNT: usize = N::COUNT + T::COUNT + R::COUNT + D::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let normal = N::take(from);
        let tangential = T::take(from);
        let rolling = R::take(from);
        let dashpot = D::take(from);
        Self {
            normal,
            tangential,
            rolling,
            dashpot,
        }
    }
}

impl<V, N, T, R, D> Written<V> for Contact<N, T, R, D>
where
    V: Lanes,
    N: Written<V>,
    T: Written<V>,
    R: Written<V>,
    D: Written<V>,
{
    fn give(self, mask: V::Mask, to: &mut Writing) {
        self.normal.give(mask, to);
        self.tangential.give(mask, to);
        self.rolling.give(mask, to);
        self.dashpot.give(mask, to);
    }
}

impl<V, N, T, R, D> React<V> for Contact<N, T, R, D>
where
    V: Lanes,
    N: NormalForce<V>,
    T: TangentialForce<V>,
    R: RollingMoment<V>,
    D: Dashpots<V>,
{
    type Memory = (N::Memory, T::Memory, R::Memory);
    const TANGENTIAL: bool = T::ACTIVE || R::ACTIVE;
    const ROLLING: bool = R::ACTIVE;
    const BONDS: bool = T::BONDS;

    #[inline(always)]
    fn holds(&self, touch: &Touch<V>, memory: &Self::Memory) -> V::Mask {
        self.tangential.holds(touch, &memory.1)
    }

    #[inline(always)]
    fn react(&self, touch: &Touch<V>, memory: &mut Self::Memory) -> Reaction<V> {
        let (normal_memory, shear_memory, roll_memory) = memory;
        let zero = V::all(0.0);
        let elastic = self.normal.force(touch, normal_memory);
        let stiffness = self.normal.tangent(touch.overlap, normal_memory);
        let mut total = self.dashpot.normal(elastic, stiffness, touch);
        if T::BONDS {
            let pulls = self.dashpot.bonded(elastic, stiffness, touch);
            let held = self.tangential.holds(touch, shear_memory);
            total = V::pick(held, pulls, total);
        }
        let load = Load {
            elastic,
            total,
            stiffness,
        };
        // A sum of increments may stand at another overlap than the bodies do.
        let touch = &Touch {
            overlap: self.normal.depth(touch.overlap, normal_memory),
            ..*touch
        };
        let shear = self.tangential.force(touch, &load, shear_memory);
        let roll = self.rolling.moment(touch, &load, roll_memory);
        // No contact carries more than its friction limit, whatever carries it: without friction
        // there is no tangential dashpot either, and none kicks at the first touch.
        let (sliding, limit) = if T::WITHIN {
            (shear.sliding, shear.force)
        } else {
            let beyond = shear.force.abs().above(shear.limit);
            (shear.sliding | beyond, shear.limit.copysign(shear.force))
        };
        let (carried, drag) = if !T::ACTIVE {
            (limit, zero)
        } else if self.dashpot.rubs(touch) {
            let k = self.tangential.steepest(touch.overlap);
            let sum = shear.force + self.dashpot.tangential(k, touch);
            let most = shear.limit.copysign(sum);
            let stuck = V::pick(sum.abs().above(shear.limit), most, sum);
            (
                V::pick(sliding, limit, stuck),
                V::pick(sliding, zero, stuck - shear.force),
            )
        } else {
            (V::pick(sliding, limit, shear.force), zero)
        };
        Reaction {
            normal: total,
            tangential: carried,
            moment: roll.moment,
            damping: [total - elastic, drag],
            excess: V::pick(sliding, carried - shear.force, zero),
            loss: [shear.loss[0] + roll.loss, shear.loss[1]],
            sliding,
        }
    }
}

impl<N: Normal, T: Tangential, R: Rolling, D: Viscosity> Law for Contact<N, T, R, D> {
    type Memo = (N::Memo, T::Memo, R::Memo);
    type On<V: Lanes> = Contact<N::On<V>, T::On<V>, R::On<V>, D::On<V>>;
    type Plain<V: Lanes> = Contact<N::On<V>, T::Plain<V>, R::On<V>, D::Plain<V>>;

    fn all_plain(common: &[Option<f64>]) -> bool {
        let (tangential, dashpot) = (<T as Numbers<f64>>::COUNT, <D as Numbers<f64>>::COUNT);
        let tangential = &common[<N as Numbers<f64>>::COUNT..][..tangential];
        T::all_plain(tangential) && D::all_plain(&common[common.len() - dashpot..])
    }

    fn prepare(basis: &Basis<'_>) -> Self {
        Self {
            normal: N::prepare(basis),
            tangential: T::prepare(basis),
            rolling: R::prepare(basis),
            dashpot: D::prepare(basis),
        }
    }

    fn part(&self, touch: &Touch, memory: &Self::Memo) -> [f64; 2] {
        let [sliding, slip] = self.tangential.part(touch.slide * touch.dt, &memory.1);
        let rolling = self.rolling.part(touch.roll * touch.dt, &memory.2);
        if !memory.1.is_bonded() {
            return [sliding + rolling, slip];
        }
        // A bond lets go of a normal force, too: the spring as it was when the step began, and its share
        // of the work of this one.
        let way = touch.approach * touch.dt;
        let (overlap, memory) = (touch.overlap - way, &memory.0);
        let stored = self.normal.energy(overlap, memory);
        let pulled = 0.5 * self.normal.held(overlap, memory) * way;
        [rolling, sliding + slip + stored + pulled]
    }

    fn energy(&self, overlap: f64, memory: &Self::Memo) -> [f64; 2] {
        [
            self.normal.energy(overlap, &memory.0),
            self.tangential.energy(overlap, &memory.1) + self.rolling.energy(&memory.2),
        ]
    }

    fn springs(&self, overlap: f64, memory: &Self::Memo) -> [f64; 2] {
        [
            self.normal.held(overlap, &memory.0),
            self.tangential.held(&memory.1),
        ]
    }

    fn stiffness(&self, overlap: f64, memory: &Self::Memo) -> Stiffness {
        let normal = self.normal.tangent(overlap.max(0.0), &memory.0);
        let depth = self.normal.depth(overlap, &memory.0);
        let k = [normal, self.tangential.stiffness(depth)];
        let [along, across] = self.dashpot.viscosity(k, overlap);
        let shears = self.tangential.is_frictional();
        Stiffness {
            k,
            c: [along, if shears { across } else { 0.0 }],
            rolling: self.rolling.stiffness(normal),
        }
    }

    fn seed(&self, overlap: f64, forces: [f64; 2]) -> Self::Memo {
        (
            self.normal.seed(forces[0]),
            self.tangential.seed(overlap, forces[1]),
            R::Memo::default(),
        )
    }

    fn refit(&self, before: &Self, overlap: f64, memory: &Self::Memo) -> Self::Memo {
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

    fn traction(&self, memory: &Self::Memo) -> Option<Traction> {
        self.tangential.traction(&memory.1)
    }

    fn inner(&self, overlap: f64, memory: &Self::Memo) -> Vec<Inner> {
        let mut inner = self.normal.inner(overlap, &memory.0);
        inner.extend(self.tangential.inner(overlap, &memory.1));
        inner.extend(self.rolling.inner(overlap, &memory.2));
        inner
    }
}
