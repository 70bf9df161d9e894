//! Randall's tangential law as a part of a contact: partial slip with two reversals remembered.

use super::card::{Card, FRICTION, POISSON, Slip, YOUNG};
use super::each::{Alone, Each, Slipped};
use super::inner::Inner;
use super::memory::{Memory, kept_whole};
use super::numbers::{Numbers, Reading, Writing, Written};
use super::parts::Tangential;
use super::quantities::Basis;
use super::traction::Traction;
use super::two_reversals::{Reversals, TwoReversals, WORST_GAIN};
use crate::engine::lanes::Lanes;

/// Row in the list.
pub const CARD: Card = Card {
    name: "mindlin-deresiewicz",
    summary: "Hertz with partial slip, two reversals remembered: what the program of 1989 ran",
    parameters: &[YOUNG, POISSON, FRICTION],
    slip: Slip::Partial,
    memory: [0, 48],
    gain: Some(WORST_GAIN),
    source: "Mindlin & Deresiewicz 1953; Randall 1989, 4.3, corrected",
    pass: |plan| plan.hertzian::<ReversalShear>(),
};

/// Hertzian contact with partial slip as the program BALL of 1989 had it.
#[derive(Debug, Clone, Copy)]
pub struct ReversalShear {
    law: TwoReversals,
    /// 8 G* √R* [N/m^1.5].
    mindlin: f64,
    friction: f64,
}

impl Numbers<f64> for ReversalShear {
    const COUNT: usize = TwoReversals::COUNT + 2;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let law = TwoReversals::take(from);
        let [mindlin, friction] = <[f64; 2]>::take(from);
        Self {
            law,
            mindlin,
            friction,
        }
    }
}

impl Written<f64> for ReversalShear {
    fn give(self, mask: bool, to: &mut Writing) {
        self.law.give(mask, to);
        [self.mindlin, self.friction].give(mask, to);
    }
}

impl Memory for Reversals {
    kept_whole!();

    fn reduced(&self) -> [f64; 2] {
        [0.0, self.force()]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.numbers(see);
    }
}

impl Alone for ReversalShear {
    #[inline(always)]
    fn advance(&self, overlap: f64, displacement: f64, memory: &mut Reversals) -> Slipped {
        self.law.advance(overlap, displacement, memory)
    }

    #[inline(always)]
    fn friction(&self) -> f64 {
        self.friction
    }
}

impl Tangential for ReversalShear {
    type Memo = Reversals;
    type On<V: Lanes> = Each<Self>;

    fn prepare(basis: &Basis<'_>) -> Self {
        let pair = basis.pair;
        let friction = if pair.shear > 0.0 { pair.friction } else { 0.0 };
        Self {
            law: TwoReversals::new(pair.young, pair.shear, basis.r_eff, friction),
            mindlin: 8.0 * pair.shear * basis.r_eff.sqrt(),
            friction,
        }
    }

    fn held(&self, memory: &Reversals) -> f64 {
        self.law.force(memory)
    }

    fn stiffness(&self, overlap: f64) -> f64 {
        if self.friction > 0.0 {
            self.mindlin * overlap.max(0.0).sqrt()
        } else {
            0.0
        }
    }

    fn energy(&self, _: f64, memory: &Reversals) -> f64 {
        self.law.energy(memory)
    }

    fn part(&self, displacement: f64, memory: &Reversals) -> [f64; 2] {
        let mut memory = *memory;
        [0.0, self.law.part(displacement, &mut memory)]
    }

    fn seed(&self, overlap: f64, force: f64) -> Reversals {
        self.law.seed(overlap, force)
    }

    fn is_frictional(&self) -> bool {
        self.friction > 0.0
    }

    fn traction(&self, memory: &Reversals) -> Option<Traction> {
        let steps = self.law.shares(memory)?;
        Some(Traction {
            steps,
            friction: self.friction,
        })
    }

    fn inner(&self, _: f64, memory: &Reversals) -> Vec<Inner> {
        let mut inner = vec![Inner::word("branch", memory.branch().name())];
        let [first, second] = memory.turning_points();
        let points = [("reversal T*", first), ("reversal T**", second)];
        inner.extend(points.map(|(name, force)| {
            force.map_or(Inner::word(name, "none"), |f| Inner::number(name, f, "N"))
        }));
        let stiffness = self.law.stiffness(memory);
        inner.push(Inner::number("shortfall DD", memory.shortfall(), "m"));
        inner.push(Inner::number("tangent k_t", stiffness, "N/m"));
        inner
    }
}
