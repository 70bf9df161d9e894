//! Randall's tangential law as a part of a contact: partial slip with two reversals remembered.

use super::card::{Card, FRICTION, POISSON, Slip, YOUNG};
use super::inner::Inner;
use super::memory::{Memory, kept_as_columns};
use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Tangential, TangentialForce};
use super::quantities::{Basis, Load, Shear, Touch};
use super::traction::Traction;
use super::two_reversals::{ReversalLanes, Reversals, TwoReversals, WORST_GAIN};
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
pub struct ReversalShear<V = f64> {
    law: TwoReversals<V>,
    /// 8 G* √R* [N/m^1.5].
    mindlin: V,
    friction: V,
}

numbers!(ReversalShear { law: TwoReversals<V>, mindlin: V, friction: V });

impl Memory for Reversals {
    kept_as_columns!(ReversalLanes);

    fn reduced(&self) -> [f64; 2] {
        [0.0, self.force()]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.numbers(see);
    }
}

impl<V: Lanes> TangentialForce<V> for ReversalShear<V> {
    type Memory = ReversalLanes<V>;
    const ACTIVE: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut ReversalLanes<V>) -> Shear<V> {
        let d = touch.slide * touch.dt;
        let slip = (self.law).advance_together(touch.touching, touch.overlap, d, memory);
        Shear {
            force: slip.force,
            loss: [slip.gross, slip.micro],
            sliding: slip.sliding,
            limit: load.limit(self.friction, V::all(0.0)),
        }
    }

    #[inline(always)]
    fn steepest(&self, overlap: V) -> V {
        let zero = V::all(0.0);
        let stiffness = self.mindlin * overlap.positive().sqrt();
        V::pick(self.friction.above(zero), stiffness, zero)
    }
}

impl Tangential for ReversalShear {
    type Memo = Reversals;
    type On<V: Lanes> = ReversalShear<V>;
    type Plain<V: Lanes> = ReversalShear<V>;

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
        self.steepest(overlap)
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
