//! One contact with partial slip and its step.

use super::polyline::{Diagram, Node, ORIGIN};
use super::sweep::{mean_gap, mean_load};

/// Share of a step's slip below which a swept segment is rounding: a zone that goes on slipping.
const ROUNDING: f64 = 1e-12;

/// Parameters of one contact, prepared once per pair and rebuild.
#[derive(Debug, Clone, Copy)]
pub struct Partial {
    /// (4/3) E* √R* [N/m^1.5].
    pub(super) hertz: f64,
    /// k = E*/(4 G*) [-].
    pub(super) compliance: f64,
    /// 1/k [-].
    per_compliance: f64,
    /// μ [-].
    pub(super) friction: f64,
    /// Nodes a memory may have.
    nodes: usize,
}

/// What a step answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slip {
    /// Tangential force T [N].
    pub force: f64,
    /// Energy lost by slip of the whole contact [J].
    pub gross: f64,
    /// Energy lost by slip of outer annuli while the inside sticks [J].
    pub micro: f64,
    /// Whether the whole contact slid.
    pub sliding: bool,
}

impl Partial {
    /// From (4/3) E* √R* [N/m^1.5], E*/(4 G*) [-], the friction coefficient [-] and the number of
    /// nodes to remember (at least 1, at most what the memory holds).
    pub fn new(hertz: f64, compliance: f64, friction: f64, nodes: usize) -> Self {
        Self {
            hertz,
            compliance,
            per_compliance: 1.0 / compliance,
            friction,
            nodes: nodes.max(1),
        }
    }

    /// The force a memory holds [N].
    #[inline]
    pub fn force<const M: usize>(&self, memory: &Diagram<M>) -> f64 {
        memory.top().force
    }

    /// Tangent stiffness of a contact that sticks [N/m]: N'/k = 8 G* a, the most it can have.
    pub fn stiffness(&self, overlap: f64) -> f64 {
        1.5 * self.hertz * overlap.sqrt() * self.per_compliance
    }

    /// Normal force [N] at the square root of an overlap [√m].
    #[inline]
    pub(super) fn load(&self, root: f64) -> f64 {
        self.hertz * root * root * root
    }

    /// Advances by one step to `overlap` > 0 [m] with the tangential displacement `d` [m].
    ///
    /// Lower friction than in the step before lets the memory slip first. Without an overlap the
    /// contact is lost as in [`Partial::part`].
    #[inline]
    pub fn advance<const M: usize>(&self, overlap: f64, d: f64, memory: &mut Diagram<M>) -> Slip {
        if !(overlap > 0.0) {
            let gross = self.part(d, memory);
            return Slip {
                gross,
                ..Slip::default()
            };
        }
        if self.friction != memory.friction || self.friction == 0.0 {
            return self.advance_otherwise(overlap, d, memory);
        }
        self.step(overlap.sqrt(), d * self.per_compliance, memory)
    }

    /// The step when friction is not what it was in the step before, or is nought.
    #[cold]
    fn advance_otherwise<const M: usize>(
        &self,
        overlap: f64,
        d: f64,
        memory: &mut Diagram<M>,
    ) -> Slip {
        let before = if self.friction < memory.friction {
            self.weaken(memory)
        } else {
            Slip::default()
        };
        memory.friction = self.friction;
        if self.friction == 0.0 {
            memory.restart(Node {
                root: overlap.sqrt(),
                ..ORIGIN
            });
            return before;
        }
        let after = self.step(overlap.sqrt(), d * self.per_compliance, memory);
        Slip {
            gross: before.gross + after.gross,
            micro: before.micro + after.micro,
            ..after
        }
    }

    /// One step to √α with the displacement `shift` over k.
    #[inline]
    fn step<const M: usize>(&self, root: f64, shift: f64, memory: &mut Diagram<M>) -> Slip {
        let top = memory.top();
        let growth = root * root - top.overlap();
        if shift.abs() > self.friction * growth {
            return self.slip(root, top.shift + shift, memory);
        }
        if growth == 0.0 {
            return Slip {
                force: top.force,
                ..Slip::default()
            };
        }
        // (N' - N)/(α' - α) without a difference of neighbours.
        let (a, b) = (top.root, root);
        let slope = self.hertz * (a * a + a * b + b * b) / (a + b);
        let node = Node {
            root,
            shift: top.shift + shift,
            force: top.force + shift * slope,
            lost: 0.0,
        };
        self.stop(node, 0.0, memory)
    }

    /// A step with slip, or one back along the polyline: to √α and δ/k.
    #[inline]
    pub(super) fn slip<const M: usize>(
        &self,
        root: f64,
        target: f64,
        memory: &mut Diagram<M>,
    ) -> Slip {
        // Where the polyline is at the new overlap says which way the rest has to go.
        let top = memory.top();
        let (here, kept) = if root < top.root {
            memory.shrunk(root)
        } else {
            (top, memory.len())
        };
        if here.shift == target {
            memory.keep(kept);
            return self.stop(Node { root, ..here }, 0.0, memory);
        }
        let sign = if target > here.shift { 1.0 } else { -1.0 };
        // Height over a line of slope μ, seen in the direction of slip: it grows inwards. The line
        // drawn from the new end has the height `end`.
        let height = |node: &Node| sign * node.shift - self.friction * node.overlap();
        let (from, to) = (top.overlap(), root * root);
        let (start, end) = (height(&top), sign * target - self.friction * to);
        let per_range = 1.0 / (end - start);
        let scale = self.friction * self.compliance * self.hertz;

        let (mut k, mut micro) = (memory.len(), 0.0);
        let (mut outer, mut outer_height, mut outer_at) = (top, start, top.root);
        while k > 0 {
            let inner = memory.from_origin(k - 1);
            let inner_height = height(&inner);
            if inner_height >= end {
                break;
            }
            // Overlap of the contact when the front is here.
            let way = (inner_height - start) * per_range;
            let at = (from + way * (to - from)).sqrt();
            let share = (inner_height - outer_height) * per_range;
            if share > ROUNDING {
                micro += share * mean_gap([inner.root, at], [outer.root, outer_at]);
            }
            (outer, outer_height, outer_at) = (inner, inner_height, at);
            k -= 1;
        }
        let work = scale * (end - start);
        if k == 0 {
            let force = sign * self.friction * self.load(root);
            memory.restart(Node {
                root,
                shift: sign * self.friction * to,
                force,
                lost: 0.0,
            });
            return Slip {
                force,
                gross: scale * (end - outer_height) * mean_load(outer_at, root),
                micro: work * micro,
                sliding: true,
            };
        }
        let inner = memory.from_origin(k - 1);
        let inner_height = height(&inner);
        let part = (inner_height - end) / (inner_height - outer_height);
        let eta = inner.overlap() + part * (outer.overlap() - inner.overlap());
        let front = eta.sqrt();
        memory.keep(k - 1);
        if front >= root {
            // Rounding: the line meets the polyline at its end.
            let here = inner.towards(&outer, root);
            return self.stop(
                Node {
                    shift: target,
                    ..here
                },
                work * micro,
                memory,
            );
        }
        let front = if front > inner.root {
            let front = inner.towards(&outer, front);
            memory.append(front);
            front
        } else {
            inner
        };
        let share = (end - outer_height) * per_range;
        if share > ROUNDING {
            micro += share * mean_gap([front.root, root], [outer.root, outer_at]);
        }
        let force = front.force + sign * self.friction * (self.load(root) - self.load(front.root));
        let end = Node {
            root,
            shift: target,
            force,
            lost: 0.0,
        };
        self.stop(end, work * micro, memory)
    }

    /// The end of a step in which the inside stuck.
    #[inline]
    fn stop<const M: usize>(&self, end: Node, micro: f64, memory: &mut Diagram<M>) -> Slip {
        memory.finish(end, if self.nodes < M { self.nodes } else { M });
        Slip {
            force: end.force,
            micro,
            ..Slip::default()
        }
    }
}
