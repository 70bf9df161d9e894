//! The step of several contacts at once.
//!
//! Sticking, following a curve, reversals and sliding are worked out in lanes. A way round the end of
//! one curve onto the next, and cube roots that are in doubt (two steps in a thousand of a sheared
//! assembly), are left to [`TwoReversals::advance`]. The formulas are those of this folder, in the
//! same order: so are the bits.

use super::super::slipped::Slipped;
use super::curves::lost;
use super::held::{self, Columns, ReversalLanes};
use super::{NOTHING, Size, TwoReversals};
use crate::engine::lanes::{Lanes, cube_root};

/// What a step answers: forces [N], losses [J], and whether the whole contact slid.
#[derive(Clone, Copy)]
pub struct SlippedLanes<V: Lanes> {
    /// Tangential force at the end of the step [N].
    pub force: V,
    /// Energy lost by slip of the whole contact [J].
    pub gross: V,
    /// Energy lost by slip within the contact [J].
    pub micro: V,
    /// Whether the whole contact slid.
    pub sliding: V::Mask,
}

/// What the way along a curve comes to.
struct Way<V: Lanes> {
    force: V,
    slid: V,
    losses: V,
    /// Lanes that have to go alone.
    alone: V::Mask,
}

/// Numbers of a block some of whose lanes go alone.
struct Aside {
    law: [[f64; 8]; 4],
    step: [[f64; 8]; 2],
    memory: Columns,
    slip: [[f64; 8]; 3],
    sliding: u32,
}

impl Aside {
    /// Advances the lanes whose bits are set.
    #[cold]
    #[inline(never)]
    fn advance(&mut self, bits: u32) {
        for lane in (0..8).filter(|lane| bits >> lane & 1 == 1) {
            let [limit, shear, kappa, friction] = self.law.map(|numbers| numbers[lane]);
            let law = TwoReversals {
                limit,
                shear,
                kappa,
                friction,
            };
            let mut memory = held::lane(&self.memory, lane);
            let [overlap, d] = self.step.map(|numbers| numbers[lane]);
            let slip = law.advance(overlap, d, &mut memory);
            held::set_lane(&mut self.memory, lane, memory);
            self.slip[0][lane] = slip.force;
            self.slip[1][lane] = slip.gross;
            self.slip[2][lane] = slip.micro;
            self.sliding = self.sliding & !(1 << lane) | u32::from(slip.sliding) << lane;
        }
    }
}

/// Not below 0 and not above 1.
#[inline(always)]
fn share<V: Lanes>(x: V) -> V {
    let (zero, one) = (V::all(0.0), V::all(1.0));
    let x = V::pick(zero.above(x), zero, x);
    V::pick(x.above(one), one, x)
}

impl<V: Lanes> ReversalLanes<V> {
    #[inline(always)]
    fn run(&self, size: &Size<V>, rest: V) -> Way<V> {
        let (zero, one) = (V::all(0.0), V::all(1.0));
        let direction = self.direction(rest);
        let (virgin, unloading) = (self.is_virgin(), self.is_unloading());
        let reloading = self.is_reloading();
        let backwards = reloading & zero.above(direction * rest);
        let force = direction * self.force;
        let top = direction * self.unloaded_from;
        let bottom = direction * self.reloaded_from;
        let stretch = V::pick(virgin, one, V::all(2.0));
        let limit = stretch * size.limit;
        let way = V::pick(unloading, top - force, force - bottom);
        let here = share(one - V::pick(virgin, force, way) / limit);
        let whole = V::pick(reloading, top - bottom, top) / V::pick(reloading, limit, size.limit);
        let end = V::pick(virgin, zero, share(one - whole));
        let end = V::pick(backwards, one, end);
        let (theta, certain) = cube_root(here);
        let span = stretch * size.slide;
        let change = rest.abs() / span;
        let square = theta * theta + V::pick(backwards, change, -change);
        let new = square.sqrt();
        let forwards = zero.at_least(square) | end.at_least(square * new);
        let reached = backwards & square.at_least(end) | !backwards & forwards;
        let slides = reached & virgin;
        let way = (here - square * new).abs();
        let along = self.force + (limit * way).copysign(rest);
        let used = span * (theta * theta).abs();
        let used = V::pick(used.above(rest.abs()), rest.abs(), used);
        let left = rest - used.copysign(rest);
        Way {
            force: V::pick(slides, direction * size.limit, along),
            slid: V::pick(slides, left.abs(), zero),
            losses: zero + stretch * (lost(V::pick(slides, zero, new)) - lost(theta)),
            alone: reached & !virgin | !certain,
        }
    }
}

impl<V: Lanes> TwoReversals<V> {
    /// One step of the touching lanes to this overlap with the tangential displacement d [m].
    #[inline(always)]
    pub fn advance_together(
        &self,
        touching: V::Mask,
        overlap: V,
        d: V,
        memory: &mut ReversalLanes<V>,
    ) -> SlippedLanes<V> {
        if V::COUNT == 1 {
            return self.advance_one(touching, overlap, d, memory);
        }
        let old = *memory;
        let (slip, alone) = self.step(touching, overlap, d, memory);
        let alone = alone & touching;
        if !V::any(alone) {
            return slip;
        }
        let mut aside = Aside {
            law: [
                self.limit.numbers(),
                self.shear.numbers(),
                self.kappa.numbers(),
                self.friction.numbers(),
            ],
            step: [overlap.numbers(), d.numbers()],
            memory: ReversalLanes::pick(alone, &old, memory).numbers(),
            slip: [
                slip.force.numbers(),
                slip.gross.numbers(),
                slip.micro.numbers(),
            ],
            sliding: V::bits(slip.sliding),
        };
        aside.advance(V::bits(alone));
        *memory = ReversalLanes::of(&aside.memory);
        SlippedLanes {
            force: V::of(&aside.slip[0]),
            gross: V::of(&aside.slip[1]),
            micro: V::of(&aside.slip[2]),
            sliding: V::mask(aside.sliding),
        }
    }

    /// A block of one: branches are worth more to it than masks.
    #[inline(always)]
    fn advance_one(
        &self,
        touching: V::Mask,
        overlap: V,
        d: V,
        memory: &mut ReversalLanes<V>,
    ) -> SlippedLanes<V> {
        let mut slip = Slipped::default();
        if V::any(touching) {
            let law = TwoReversals {
                limit: self.limit.numbers()[0],
                shear: self.shear.numbers()[0],
                kappa: self.kappa.numbers()[0],
                friction: self.friction.numbers()[0],
            };
            let mut columns = memory.numbers();
            let mut one = held::lane(&columns, 0);
            slip = law.advance(overlap.numbers()[0], d.numbers()[0], &mut one);
            held::set_lane(&mut columns, 0, one);
            *memory = ReversalLanes::of(&columns);
        }
        SlippedLanes {
            force: V::all(slip.force),
            gross: V::all(slip.gross),
            micro: V::all(slip.micro),
            sliding: V::mask(u32::from(slip.sliding)),
        }
    }

    /// The step, and the lanes that it is none for.
    #[inline(always)]
    fn step(
        &self,
        touching: V::Mask,
        overlap: V,
        d: V,
        memory: &mut ReversalLanes<V>,
    ) -> (SlippedLanes<V>, V::Mask) {
        let zero = V::all(0.0);
        let mut alone = !(overlap.above(zero) & self.friction.above(zero));
        let (before, size) = (self.size(memory.overlap), self.size(overlap));
        memory.overlap = overlap;
        let nothing = V::all(NOTHING) * before.limit;
        let blank = nothing.at_least(memory.force.abs()) & memory.is_virgin();
        memory.shortfall = V::pick(blank, zero, memory.shortfall);
        let back = blank & zero.above(memory.force * d);
        memory.force = V::pick(back, zero, memory.force);
        let direction = memory.direction(d);
        let turns = zero.above(direction * memory.sense() * d);
        memory.turn(turns, direction);
        let direction = memory.direction(d);
        let sense = direction * memory.sense();
        let progress = sense * d;

        let rise = size.limit - before.limit;
        memory.shift(direction * rise);
        let (r, s) = (size.root, before.root);
        let stiffness = self.shear * (r * r + r * s + s * s) / (V::all(1.5) * (r + s));
        let pace = rise / stiffness;
        let missing = pace + memory.shortfall;
        let landed = memory.force + sense * rise;
        let backwards = zero.above(progress) & memory.shortfall.equals(zero);

        let falls = zero.above(rise);
        let (top, bottom) = (memory.unloaded_from, memory.reloaded_from);
        let way = V::pick(memory.is_unloading(), top - landed, landed - bottom);
        let way = V::pick(memory.is_virgin(), landed, way);
        let early = falls & zero.above(direction * way);
        let sticks = !falls & missing.at_least(progress) & !backwards;
        let waits = memory.shortfall.above(zero);
        let left = missing - progress;
        let falling = V::pick(waits, left.positive(), memory.shortfall);
        let rising = V::pick(sticks, left, zero);
        memory.shortfall = V::pick(falls, falling, rising);
        let caught = memory.force + sense * (stiffness * missing);
        let full = memory.force + stiffness * d;
        let full_slope = early | sticks;
        memory.force = V::pick(full_slope, full, V::pick(falls, landed, caught));

        let runs = !full_slope;
        let (mut slid, mut losses) = (zero, zero);
        if V::any(runs & touching) {
            let rest = sense * (progress - V::pick(falls, pace, missing));
            let way = memory.run(&size, rest);
            memory.force = V::pick(runs, way.force, memory.force);
            slid = V::pick(runs, way.slid, zero);
            losses = V::pick(runs, way.losses, zero);
            alone = alone | runs & way.alone;
        }
        let surplus = memory.force.abs() - size.limit;
        let over = surplus.above(zero);
        if V::any(over & touching) {
            memory.force = V::pick(over, size.limit.copysign(memory.force), memory.force);
            slid = V::pick(over, slid + surplus / stiffness, slid);
        }
        memory.settle(!over, direction, progress);
        memory.forget(over);
        let slip = SlippedLanes {
            force: memory.force,
            gross: V::all(0.5) * (before.limit + size.limit) * slid,
            micro: size.limit * size.slide * losses,
            sliding: slid.above(zero),
        };
        (slip, alone)
    }
}
