//! One contact with partial slip and its step.

use super::polyline::{Diagram, Node, ORIGIN};
use crate::engine::contact::numbers::{Numbers, Reading, Writing, Written};
use crate::engine::contact::slipped::Slipped;

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
    /// Whether what dropped nodes take from the stored energy is worked out.
    pub(super) booked: bool,
}

/// Counts and flags go as the bits of a number that nobody reckons with.
impl Numbers<f64> for Partial {
    const COUNT: usize = 6;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let (hertz, compliance, per_compliance) = (from.column(), from.column(), from.column());
        let (friction, nodes, booked): (f64, f64, f64) =
            (from.column(), from.column(), from.column());
        Self {
            hertz,
            compliance,
            per_compliance,
            friction,
            nodes: nodes.to_bits() as usize,
            booked: booked.to_bits() != 0,
        }
    }
}

impl Written<f64> for Partial {
    fn give(self, mask: bool, to: &mut Writing) {
        let bits = |bits: u64| f64::from_bits(bits);
        [self.hertz, self.compliance].give(mask, to);
        [self.per_compliance, self.friction].give(mask, to);
        [bits(self.nodes as u64), bits(u64::from(self.booked))].give(mask, to);
    }
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
            booked: true,
        }
    }

    /// Whether losses are asked for. Forces are the same either way.
    #[must_use]
    pub fn booked(self, booked: bool) -> Self {
        Self { booked, ..self }
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
    pub fn advance<const M: usize>(
        &self,
        overlap: f64,
        d: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        if overlap.is_nan() || overlap <= 0.0 {
            let gross = self.part(d, memory);
            return Slipped {
                gross,
                ..Slipped::default()
            };
        }
        if self.friction != memory.friction || self.friction == 0.0 {
            return self.advance_otherwise(overlap, d, memory);
        }
        let (root, shift) = (overlap.sqrt(), d * self.per_compliance);
        if self.booked {
            self.step::<M, true>(root, shift, memory)
        } else {
            self.step::<M, false>(root, shift, memory)
        }
    }

    /// The step when friction is not what it was in the step before, or is nought.
    #[cold]
    fn advance_otherwise<const M: usize>(
        &self,
        overlap: f64,
        d: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        let before = if self.friction < memory.friction {
            self.weaken(memory)
        } else {
            Slipped::default()
        };
        memory.friction = self.friction;
        if self.friction == 0.0 {
            memory.restart(Node {
                root: overlap.sqrt(),
                ..ORIGIN
            });
            return Slipped {
                force: 0.0,
                sliding: false,
                ..before
            };
        }
        let after = self.step::<M, true>(overlap.sqrt(), d * self.per_compliance, memory);
        Slipped {
            gross: before.gross + after.gross,
            micro: before.micro + after.micro,
            sliding: before.sliding || after.sliding,
            force: after.force,
        }
    }

    /// Nodes that a memory with so many places may have.
    #[inline(always)]
    pub(super) fn most(&self, places: usize) -> usize {
        if self.nodes < places {
            self.nodes
        } else {
            places
        }
    }

    /// What lanes hold of it: see [`super::PartialLanes`].
    #[cfg(test)]
    pub(super) fn of_lanes(&self) -> [f64; 3] {
        [self.hertz, self.per_compliance, self.friction]
    }

    /// Whether losses are asked for.
    #[inline(always)]
    pub fn is_booked(&self) -> bool {
        self.booked
    }

    /// One step to √α with the displacement `shift` over k.
    #[inline]
    fn step<const M: usize, const BOOK: bool>(
        &self,
        root: f64,
        shift: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        let top = memory.top();
        let growth = root * root - top.overlap();
        if shift.abs() > self.friction * growth {
            return self.slip::<M, BOOK>(root, top.shift + shift, memory);
        }
        if growth == 0.0 {
            return Slipped {
                force: top.force,
                ..Slipped::default()
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
        self.stop::<M, BOOK>(node, 0.0, memory)
    }

    /// The end of a step in which the inside stuck.
    #[inline(always)]
    pub(super) fn stop<const M: usize, const BOOK: bool>(
        &self,
        end: Node,
        micro: f64,
        memory: &mut Diagram<M>,
    ) -> Slipped {
        let forgotten = memory.finish(end, self.most(M), BOOK);
        Slipped {
            force: end.force,
            micro: micro + self.compliance * forgotten,
            ..Slipped::default()
        }
    }
}
