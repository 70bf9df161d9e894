//! The exact tangential law as a part of a contact: a memory diagram of at most M nodes.
#![allow(
    unsafe_code,
    reason = "memories of a block by pointer, as the loop hands them over"
)]

use super::card::{Card, FRICTION, POISSON, Slip, YOUNG};
use super::dashpot::Following;
use super::diagram::{Diagram, Partial, PartialLanes};
use super::hertz::{self, Hertz};
use super::inner::Inner;
use super::linear::Frictionless;
use super::memory::{Memory, kept_whole};
use super::numbers::{Numbers, Reading, Writing, Written};
use super::parts::{Tangential, TangentialForce};
use super::pass::ContactPass;
use super::quantities::{Basis, Load, Shear, Touch};
use super::traction::Traction;
use crate::engine::lanes::Lanes;
use crate::engine::plan::Plan;

/// Row in the list.
pub const CARD: Card = Card {
    name: "mindlin-deresiewicz-exact",
    summary: "Hertz with partial slip, the whole history remembered in up to `nodes` numbers",
    parameters: &[YOUNG, POISSON, FRICTION],
    slip: Slip::Partial,
    memory: [0, size_of::<Diagram<FEW_NODES>>()],
    gain: None,
    source: "Mindlin & Deresiewicz 1953; Jäger 1993, Ciavarella 1998",
    pass,
};

/// Room for nodes in the memory of a contact: by default, and at most.
const FEW_NODES: usize = 16;
const MANY_NODES: usize = 64;

fn pass(plan: &Plan) -> Box<dyn ContactPass> {
    // The scene refuses sums of increments here: the memory belongs to the overlap.
    match plan.friction {
        false => plan.hertzian::<Frictionless>(),
        true if plan.nodes <= FEW_NODES => plan.heavy::<Hertz, ExactShear<FEW_NODES>, Following>(),
        true => plan.heavy::<Hertz, ExactShear<MANY_NODES>, Following>(),
    }
}

/// Hertzian contact with partial slip and its whole history.
#[derive(Debug, Clone, Copy)]
pub struct ExactShear<const M: usize> {
    partial: Partial,
    friction: f64,
}

impl<const M: usize> Numbers<f64> for ExactShear<M> {
    const COUNT: usize = Partial::COUNT + 1;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let partial = Partial::take(from);
        Self {
            partial,
            friction: from.column(),
        }
    }
}

impl<const M: usize> Written<f64> for ExactShear<M> {
    fn give(self, mask: bool, to: &mut Writing) {
        self.partial.give(mask, to);
        self.friction.give(mask, to);
    }
}

/// The same in lanes.
#[derive(Debug, Clone, Copy)]
pub struct ExactLanes<V, const M: usize> {
    /// Where the parameters of the block stand.
    from: Reading,
    partial: PartialLanes<V>,
}

impl<V: Lanes, const M: usize> Numbers<V> for ExactLanes<V, M> {
    const COUNT: usize = ExactShear::<M>::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        // Column by column as `Partial` has them.
        let here = *from;
        let mut partial = here;
        let [hertz, _compliance] = <[V; 2]>::take(&mut partial);
        let [per_compliance, friction] = <[V; 2]>::take(&mut partial);
        from.skip(ExactShear::<M>::COUNT);
        Self {
            from: here,
            partial: PartialLanes {
                hertz,
                per_compliance,
                friction,
            },
        }
    }
}

impl<V: Lanes, const M: usize> TangentialForce<V> for ExactLanes<V, M> {
    type Memory = *mut Diagram<M>;
    const ACTIVE: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut *mut Diagram<M>) -> Shear<V> {
        let from = self.from;
        if V::COUNT == 1 || Partial::take(&mut from.further(0)).is_booked() {
            return self.one_by_one(touch, load, *memory);
        }
        // SAFETY: the loop hands over where the memories of the block begin, and nobody else works
        // on them.
        let (force, sliding) = unsafe {
            self.partial.advance(
                V::bits(touch.touching),
                touch.overlap,
                touch.slide * touch.dt,
                *memory,
                |lane| Partial::take(&mut from.further(lane)),
            )
        };
        Shear {
            force,
            loss: [V::all(0.0); 2],
            sliding: V::mask(sliding),
            limit: load.limit(self.partial.friction, V::all(0.0)),
        }
    }

    #[inline(always)]
    fn steepest(&self, overlap: V) -> V {
        let mut stiffness = overlap.numbers();
        for (lane, x) in stiffness.iter_mut().enumerate().take(V::COUNT) {
            *x = ExactShear::<M>::take(&mut self.from.further(lane)).stiffness(*x);
        }
        V::of(&stiffness)
    }
}

impl<V: Lanes, const M: usize> ExactLanes<V, M> {
    /// Contact by contact within the block: what is booked branches too much for lanes.
    #[inline(always)]
    fn one_by_one(&self, touch: &Touch<V>, load: &Load<V>, memory: *mut Diagram<M>) -> Shear<V> {
        let touching = V::bits(touch.touching);
        let (overlap, d) = (touch.overlap.numbers(), (touch.slide * touch.dt).numbers());
        let [mut force, mut gross, mut micro] = [[0.0; 8]; 3];
        let mut sliding = 0;
        for lane in (0..V::COUNT).filter(|lane| touching >> lane & 1 == 1) {
            let partial = Partial::take(&mut self.from.further(lane));
            // SAFETY: the loop hands over where the memories of the block begin, and nobody else
            // works on them.
            let memory = unsafe { &mut *memory.add(lane) };
            let slip = partial.advance(overlap[lane], d[lane], memory);
            (force[lane], gross[lane], micro[lane]) = (slip.force, slip.gross, slip.micro);
            sliding |= u32::from(slip.sliding) << lane;
        }
        Shear {
            force: V::of(&force),
            loss: [V::of(&gross), V::of(&micro)],
            sliding: V::mask(sliding),
            limit: load.limit(self.partial.friction, V::all(0.0)),
        }
    }
}

impl<const M: usize> Memory for Diagram<M> {
    kept_whole!();

    fn reduced(&self) -> [f64; 2] {
        [0.0, self.force()]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.numbers(see);
    }
}

impl<const M: usize> Tangential for ExactShear<M> {
    type Memo = Diagram<M>;
    type On<V: Lanes> = ExactLanes<V, M>;
    type Plain<V: Lanes> = ExactLanes<V, M>;

    fn prepare(basis: &Basis<'_>) -> Self {
        let pair = basis.pair;
        let hertz = hertz::coefficient(pair.young, basis.r_eff);
        // Two bodies that cannot shear against each other have no shear modulus and no friction.
        let compliance = if pair.shear > 0.0 {
            pair.young / (4.0 * pair.shear)
        } else {
            1.0
        };
        let friction = if pair.shear > 0.0 { pair.friction } else { 0.0 };
        Self {
            partial: Partial::new(hertz, compliance, friction, basis.nodes).booked(basis.booked),
            friction,
        }
    }

    fn held(&self, memory: &Diagram<M>) -> f64 {
        self.partial.force(memory)
    }

    fn stiffness(&self, overlap: f64) -> f64 {
        if self.friction > 0.0 {
            self.partial.stiffness(overlap.max(0.0))
        } else {
            0.0
        }
    }

    fn energy(&self, _: f64, memory: &Diagram<M>) -> f64 {
        self.partial.energy(memory)
    }

    fn part(&self, displacement: f64, memory: &Diagram<M>) -> [f64; 2] {
        let mut memory = *memory;
        [0.0, self.partial.part(displacement, &mut memory)]
    }

    fn seed(&self, overlap: f64, force: f64) -> Diagram<M> {
        self.partial.seed(overlap, force)
    }

    fn refit(&self, before: &Self, overlap: f64, memory: &Diagram<M>) -> Diagram<M> {
        if self.partial.is_like(&before.partial) {
            *memory
        } else {
            self.seed(overlap, self.held(memory))
        }
    }

    fn is_frictional(&self) -> bool {
        self.friction > 0.0
    }

    fn traction(&self, memory: &Diagram<M>) -> Option<Traction> {
        Some(Traction {
            steps: self.partial.shares(memory),
            friction: self.friction,
        })
    }

    fn inner(&self, _: f64, memory: &Diagram<M>) -> Vec<Inner> {
        vec![Inner::number("nodes", memory.len() as f64, "-")]
    }
}
