//! What others see of a memory diagram: numbers for hashes, shares for pictures, and the diagram
//! that a given force makes.

use super::partial::Partial;
use super::polyline::{Diagram, Node, ORIGIN};

impl<const M: usize> Diagram<M> {
    /// Tangential force of now [N].
    pub fn force(&self) -> f64 {
        self.top().force
    }

    /// Shows every number that the future depends on.
    pub fn numbers(&self, see: &mut dyn FnMut(f64)) {
        for node in self.nodes() {
            for number in [node.root, node.shift, node.force, node.lost] {
                see(number);
            }
        }
        if !self.is_empty() {
            see(self.friction);
        }
    }
}

impl Partial {
    /// Whether a memory made with one serves the other: they differ in friction at most.
    pub fn is_like(&self, other: &Self) -> bool {
        self.hertz == other.hertz && self.compliance == other.compliance
    }

    /// Overlap at the outer end of each segment [m] and the share of μ that its traction takes.
    pub fn shares<const M: usize>(&self, memory: &Diagram<M>) -> Vec<(f64, f64)> {
        let mut inner = ORIGIN;
        let share = |outer: &Node| {
            let span = self.friction * (outer.overlap() - inner.overlap());
            let share = if span > 0.0 {
                (outer.shift - inner.shift) / span
            } else {
                0.0
            };
            inner = *outer;
            (outer.overlap(), share)
        };
        memory.nodes().iter().map(share).collect()
    }

    /// The memory of a contact pressed to `overlap` [m] and then loaded to `force` [N], no more than
    /// μ N, at constant overlap: a stuck inside and one slip annulus (Cattaneo 1938).
    pub fn seed<const M: usize>(&self, overlap: f64, force: f64) -> Diagram<M> {
        let mut memory = Diagram::default();
        if overlap <= 0.0 {
            return memory;
        }
        memory.friction = self.friction;
        let root = overlap.sqrt();
        let limit = self.friction * self.load(root);
        let share = if limit > 0.0 {
            (force.abs() / limit).min(1.0)
        } else {
            0.0
        };
        let inner = Node {
            root: root * libm::cbrt(1.0 - share),
            ..ORIGIN
        };
        if inner.root > 0.0 {
            memory.append(inner);
        }
        if inner.root < root {
            let sign = 1.0_f64.copysign(force);
            memory.append(Node {
                root,
                shift: sign * self.friction * (root * root - inner.overlap()),
                force: sign * share * limit,
                lost: 0.0,
            });
        }
        memory
    }
}
