//! The step of several contacts at once, where losses are not asked for.
//!
//! What nearly all steps of an assembly do is worked out in lanes: sticking growth, a slip front that
//! stops on the outermost segment or on the one inside it, and sliding that goes on. Whatever else a
//! contact may do (some hundredths of the steps) is left to [`Partial::advance`]. The formulas are
//! those of `partial.rs` and `slip.rs`, in the same order: so are the bits.

#![allow(
    unsafe_code,
    reason = "memories of a block by pointer, as the loop hands them over"
)]

use super::partial::Partial;
use super::polyline::{Diagram, NEGLIGIBLE, Node};
use crate::engine::lanes::Lanes;

/// Parameters in lanes.
#[derive(Debug, Clone, Copy)]
pub struct PartialLanes<V> {
    /// (4/3) E* √R* [N/m^1.5].
    pub hertz: V,
    /// 1/k [-].
    pub per_compliance: V,
    /// μ [-].
    pub friction: V,
}

/// A node in each lane.
#[derive(Clone, Copy)]
struct Nodes<V> {
    root: V,
    shift: V,
    force: V,
    lost: V,
}

impl<V: Lanes> Nodes<V> {
    /// # Safety
    /// A node must be readable at each of the first `COUNT` places.
    #[inline(always)]
    unsafe fn read(from: &[*const [f64; 4]; 8], inwards: usize) -> Self {
        let mut places = *from;
        for place in &mut places {
            *place = place.wrapping_sub(inwards);
        }
        // SAFETY: the caller's.
        let [root, shift, force, lost] = unsafe { V::read_rows(&places) };
        Self {
            root,
            shift,
            force,
            lost,
        }
    }

    #[inline(always)]
    fn pick(mask: V::Mask, yes: Self, no: Self) -> Self {
        Self {
            root: V::pick(mask, yes.root, no.root),
            shift: V::pick(mask, yes.shift, no.shift),
            force: V::pick(mask, yes.force, no.force),
            lost: V::pick(mask, yes.lost, no.lost),
        }
    }

    #[inline(always)]
    fn overlap(&self) -> V {
        self.root * self.root
    }

    #[inline(always)]
    fn rows(self) -> [Node; 8] {
        let mut rows = [Node::default(); 8];
        let columns = [self.root, self.shift, self.force, self.lost];
        // SAFETY: a node is a row of four numbers, and there are no more than eight lanes.
        unsafe { V::write_rows(columns, rows.as_mut_ptr().cast()) };
        rows
    }
}

/// Area of the triangle that a polyline loses when it skips `b` [m²].
#[inline(always)]
fn triangle<V: Lanes>(a: &Nodes<V>, b: &Nodes<V>, c: &Nodes<V>) -> V {
    let near = [b.overlap() - a.overlap(), b.shift - a.shift];
    let far = [c.overlap() - a.overlap(), c.shift - a.shift];
    V::all(0.5) * (near[0] * far[1] - far[0] * near[1]).abs()
}

#[inline(always)]
fn cube<V: Lanes>(root: V) -> V {
    root * root * root
}

/// What a step comes to.
struct Step<V: Lanes> {
    /// The node where the front stopped, and the end.
    met: Nodes<V>,
    end: Nodes<V>,
    /// Lanes in which the front stopped inside, inside the outermost segment, or not at all.
    meets: V::Mask,
    deeper: V::Mask,
    slides: V::Mask,
    /// Lanes in which the last node before the end is given up at once.
    pops: V::Mask,
    /// Lanes that have to go alone.
    alone: V::Mask,
}

impl<V: Lanes> PartialLanes<V> {
    /// Forces and whether they slid, as bits, of the lanes whose bits are set; memories advance.
    /// `law` gives the parameters of a lane.
    ///
    /// # Safety
    /// The first `COUNT` memories must be there, and nobody else may use them.
    #[inline(always)]
    pub unsafe fn advance<const M: usize>(
        &self,
        touching: u32,
        overlap: V,
        d: V,
        memory: *mut Diagram<M>,
        law: impl Fn(usize) -> Partial,
    ) -> (V, u32) {
        let friction = self.friction.numbers();
        let mut alone = 0;
        let mut tops = [std::ptr::null(); 8];
        let mut lone = 0;
        for (lane, top) in tops.iter_mut().enumerate().take(V::COUNT) {
            // SAFETY: the caller's: a memory for each lane.
            let diagram = unsafe { &*memory.add(lane) };
            let (last, unlike) = diagram.last(friction[lane]);
            *top = last;
            alone |= u32::from(unlike) << lane;
            lone |= u32::from(diagram.len == 1) << lane;
        }
        let root = overlap.sqrt();
        // SAFETY: the last node of a diagram has two more before it, the origin if need be.
        let [top, inner, innermost] = unsafe {
            [
                Nodes::<V>::read(&tops, 0),
                Nodes::<V>::read(&tops, 1),
                Nodes::<V>::read(&tops, 2),
            ]
        };
        let nodes = [&top, &inner, &innermost];
        let step = self.step(nodes, root, d * self.per_compliance, V::mask(lone));
        let alone = (alone | V::bits(step.alone)) & touching;
        let mut force = step.end.force.numbers();
        let mut sliding = V::bits(step.slides);
        let (met, end) = (step.met.rows(), step.end.rows());
        let (meets, deeper) = (V::bits(step.meets), V::bits(step.deeper));
        let pops = V::bits(step.pops);
        for lane in 0..V::COUNT {
            let is = |bits: u32| bits >> lane & 1 == 1;
            if !is(touching) {
                continue;
            }
            // SAFETY: as above.
            let diagram = unsafe { &mut *memory.add(lane) };
            if is(alone) {
                let [overlap, d] = [overlap.numbers()[lane], d.numbers()[lane]];
                let slip = law(lane).advance(overlap, d, diagram);
                force[lane] = slip.force;
                sliding = sliding & !(1 << lane) | u32::from(slip.sliding) << lane;
                continue;
            }
            if is(sliding) {
                diagram.restart(end[lane]);
                continue;
            }
            let gone = (meets | deeper) >> lane & 1;
            diagram.keep(diagram.len - gone as usize - usize::from(is(deeper)));
            if is(pops) {
                if gone == 0 {
                    diagram.keep(diagram.len - 1);
                }
            } else if gone == 1 {
                diagram.append(met[lane]);
            }
            diagram.close(end[lane], law(lane).most(M));
        }
        (V::of(&force), sliding)
    }

    /// Normal force [N] at the square root of an overlap [√m].
    #[inline(always)]
    fn load(&self, root: V) -> V {
        self.hertz * root * root * root
    }

    #[inline(always)]
    fn step(
        &self,
        [top, inner, innermost]: [&Nodes<V>; 3],
        root: V,
        shift: V,
        lone: V::Mask,
    ) -> Step<V> {
        let (zero, one) = (V::all(0.0), V::all(1.0));
        let friction = self.friction;
        let eta = root * root;
        let growth = eta - top.overlap();
        let slips = shift.abs().above(friction * growth);
        let target = top.shift + shift;
        // Sticking growth.
        let (a, b) = (top.root, root);
        let slope = self.hertz * (a * a + a * b + b * b) / (a + b);
        let grown = Nodes {
            root,
            shift: target,
            force: top.force + shift * slope,
            lost: zero,
        };
        let mut alone = !slips & growth.equals(zero);
        // Where the polyline is at the new overlap.
        let shrinks = top.root.above(root);
        let part = (eta - inner.overlap()) / (top.overlap() - inner.overlap());
        let back = inner.shift + part * (top.shift - inner.shift);
        let here = V::pick(shrinks, back, top.shift);
        alone = alone | slips & (shrinks & inner.root.at_least(root) | here.equals(target));
        let sign = V::pick(target.above(here), one, -one);
        let start = sign * top.shift - friction * top.overlap();
        let end = sign * target - friction * eta;
        let height = sign * inner.shift - friction * inner.overlap();
        let below = sign * innermost.shift - friction * innermost.overlap();
        let first = height.at_least(end);
        let second = below.at_least(end);
        alone = alone | slips & first & inner.root.at_least(root);
        // One segment further in: unless there is none.
        let meets = slips & first;
        let slides = slips & !first & lone;
        let deeper = slips & !first & !lone & second;
        alone = alone | slips & !first & !lone & (!second | innermost.root.at_least(root));
        // The front stops on a segment.
        let from = Nodes::pick(first, *inner, *innermost);
        let to = Nodes::pick(first, *top, *inner);
        let (low, high) = (V::pick(first, height, below), V::pick(first, start, height));
        let part = (low - end) / (low - high);
        let met_eta = from.overlap() + part * (to.overlap() - from.overlap());
        let met_root = met_eta.sqrt();
        let innermost_cube = cube(from.root);
        let slope = (to.force - from.force) / (cube(to.root) - innermost_cube);
        let met = Nodes {
            root: met_root,
            shift: from.shift + part * (to.shift - from.shift),
            force: from.force + slope * (cube(met_root) - innermost_cube),
            lost: to.lost,
        };
        let stops = meets | deeper;
        // Not a number where the line is that of the segment to the last bit.
        alone = alone | stops & !(root.above(met_root) & met_root.above(from.root));
        let rise = friction * (self.load(root) - self.load(met_root));
        let stopped = Nodes {
            root,
            shift: target,
            force: met.force + sign * rise,
            lost: zero,
        };
        // Or passes all of it.
        let limit = sign * friction;
        let slid = Nodes {
            root,
            shift: limit * eta,
            force: limit * self.load(root),
            lost: zero,
        };
        let end = Nodes::pick(stops, stopped, Nodes::pick(slides, slid, grown));
        // What is given up at once, as in `finish`.
        let negligible = V::all(NEGLIGIBLE) * friction * eta * eta;
        let last = Nodes::pick(stops, met, *top);
        let before = Nodes::pick(stops, from, *inner);
        let lost = triangle(&before, &last, &end) + last.lost + zero;
        let pops = !slides & !lost.at_least(negligible);
        let bared = Nodes { lost, ..end };
        let next = triangle(innermost, &before, &bared) + before.lost + bared.lost;
        // Two at once, or nothing known of what lies further in: alone. The origin is no node.
        let more = !next.at_least(negligible) & before.root.above(zero);
        alone = alone | pops & (deeper & before.root.above(zero) | more);
        Step {
            met,
            end: Nodes::pick(pops, bared, end),
            meets,
            deeper,
            slides,
            pops,
            alone,
        }
    }
}
