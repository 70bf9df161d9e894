//! A step with slip: a slip front that moves from the edge inwards.

use super::partial::Partial;
use super::polyline::{Diagram, Node};
use super::sweep::{mean_depth, mean_gap, mean_load};
use crate::engine::contact::slipped::Slipped;

/// Share of a step's slip below which a swept segment is rounding: a zone that goes on slipping.
const ROUNDING: f64 = 1e-12;

/// The front on its way in.
///
/// Height is that over a line of slope ±μ, seen in the direction of slip, δ/k s - μ η. On the
/// polyline it grows inwards; the line drawn from the new end has the height `end` all along, so the
/// front passes the heights from `start` to `end` in proportion to the step done.
struct Front<const BOOK: bool> {
    sign: f64,
    friction: f64,
    hertz: f64,
    start: f64,
    end: f64,
    per_range: f64,
    /// Overlap at the start of the step, and by what it grows [m].
    overlap: [f64; 2],
    /// Where the front is, with its height and the root of the overlap the contact has by then.
    outer: Node,
    outer_height: f64,
    outer_at: f64,
    /// Sum of swept share times mean gap.
    gaps: f64,
    /// Sum of what the forces of swept segments have over those of their displacements, times the
    /// depth of the front [N m].
    bends: f64,
}

/// `BOOK`: losses are asked for.
impl<const BOOK: bool> Front<BOOK> {
    #[inline]
    fn new(law: &Partial, sign: f64, top: Node, root: f64, target: f64) -> Self {
        let friction = law.friction;
        let (from, to) = (top.overlap(), root * root);
        let start = sign * top.shift - friction * from;
        let end = sign * target - friction * to;
        Self {
            sign,
            friction,
            hertz: law.hertz,
            start,
            end,
            per_range: 1.0 / (end - start),
            overlap: [from, to - from],
            outer: top,
            outer_height: start,
            outer_at: top.root,
            gaps: 0.0,
            bends: 0.0,
        }
    }

    #[inline]
    fn height(&self, node: &Node) -> f64 {
        self.sign * node.shift - self.friction * node.overlap()
    }

    /// Sweeps on to a node inside.
    #[inline]
    fn sweep(&mut self, inner: Node, height: f64) {
        if BOOK {
            let way = (height - self.start) * self.per_range;
            let at = (self.overlap[0] + way * self.overlap[1]).sqrt();
            self.lose(&inner, height, at);
            self.outer_at = at;
        }
        (self.outer, self.outer_height) = (inner, height);
    }

    /// Adds what is lost from where the front is to a node inside with its height.
    #[inline]
    fn lose(&mut self, inner: &Node, height: f64, at: f64) {
        let share = (height - self.outer_height) * self.per_range;
        if BOOK && share > ROUNDING {
            let outer = [self.outer.root, self.outer_at];
            let inside = [inner.root, at];
            self.gaps += share * mean_gap(inside, outer);
            self.bends += self.bend(inner) * mean_depth(inside, outer);
        }
    }

    /// What the force of the segment from a node inside to the front has over that of its
    /// displacement [N]. Nothing but in segments that nodes were dropped into: their displacement is
    /// linear in η and their force in N, each with a mean slope of its own.
    #[inline]
    fn bend(&self, inner: &Node) -> f64 {
        let (a, b) = (inner.root, self.outer.root);
        // (N' - N)/(η' - η) without a difference of neighbours.
        let slope = (a * a + a * b + b * b) / (a + b);
        self.outer.force - inner.force - self.hertz * slope * (self.outer.shift - inner.shift)
    }
}

impl Partial {
    /// A step with slip, or one back along the polyline: to √α and δ/k.
    #[inline]
    pub(super) fn slip<const M: usize, const BOOK: bool>(
        &self,
        root: f64,
        target: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        // Where the polyline is at the new overlap says which way the rest has to go.
        let top = memory.top();
        let (here, inside) = if root < top.root {
            memory.shrunk(root)
        } else {
            (top, memory.len())
        };
        if here.shift == target {
            memory.keep(inside);
            return self.stop::<M, BOOK>(here, 0.0, memory);
        }
        let sign = if target > here.shift { 1.0 } else { -1.0 };
        let mut front = Front::<BOOK>::new(self, sign, top, root, target);
        let mut kept = memory.len();
        while kept > 0 {
            let inner = memory.node(kept - 1);
            let height = front.height(&inner);
            if height >= front.end && inner.root >= root {
                // Rounding: the line runs along a slip annulus outside what is left of the contact.
                memory.keep(inside);
                let end = Node {
                    shift: target,
                    ..here
                };
                return self.stop::<M, BOOK>(end, self.slip_work(&front), memory);
            }
            if height >= front.end {
                memory.keep(kept - 1);
                return self.meet(front, [inner, here], root, target, memory);
            }
            front.sweep(inner, height);
            kept -= 1;
        }
        self.slide(&front, root, memory)
    }

    /// The front stops between where it is and the node `inner`, the outermost that is kept; `here` is
    /// where the polyline is at the new overlap of a contact that shrinks.
    #[inline]
    fn meet<const M: usize, const BOOK: bool>(
        &self,
        mut front: Front<BOOK>,
        [inner, here]: [Node; 2],
        root: f64,
        target: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        let (outer, end) = (front.outer, front.end);
        let height = front.height(&inner);
        // Share of the segment, from its inner end, that is left of it.
        let part = (height - end) / (height - front.outer_height);
        let eta = inner.overlap() + part * (outer.overlap() - inner.overlap());
        let met = inner.towards(&outer, eta.sqrt(), part);
        if met.root.is_nan() || met.root >= root {
            // Rounding, as above; not a number where the line is that of the segment to the last bit.
            let end = Node {
                shift: target,
                ..here
            };
            return self.stop::<M, BOOK>(end, self.slip_work(&front), memory);
        }
        front.lose(&met, end, root);
        if met.root > inner.root {
            memory.append(met);
        }
        let rise = self.friction * (self.load(root) - self.load(met.root));
        let end = Node {
            root,
            shift: target,
            force: met.force + front.sign * rise,
            lost: 0.0,
        };
        self.stop::<M, BOOK>(end, self.slip_work(&front), memory)
    }

    /// The front met nothing: the whole contact slides the rest of the way.
    #[inline]
    fn slide<const M: usize, const BOOK: bool>(
        &self,
        front: &Front<BOOK>,
        root: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        let limit = front.sign * self.friction;
        let end = Node {
            root,
            shift: limit * (root * root),
            force: limit * self.load(root),
            lost: 0.0,
        };
        memory.restart(end);
        let gross = if BOOK {
            let surplus = self.compliance * (front.end - front.outer_height);
            let load = self.hertz * mean_load(front.outer_at, root);
            self.friction * load * surplus
        } else {
            0.0
        };
        Slipped {
            force: end.force,
            gross,
            micro: self.slip_work(front),
            sliding: true,
        }
    }

    /// Work of the traction on the slip of the annuli that were swept [J]: as derived for a traction
    /// of one slope D, and s μ k (α - c) dB more where force and displacement of a segment differ by
    /// B = dT - D dN.
    #[inline]
    fn slip_work<const BOOK: bool>(&self, front: &Front<BOOK>) -> f64 {
        if !BOOK {
            return 0.0;
        }
        let range = front.end - front.start;
        let gaps = self.hertz * range * front.gaps;
        self.friction * self.compliance * (gaps + front.sign * front.bends)
    }
}
