//! What becomes of a memory when friction is lowered under load.

use super::partial::{Partial, Slip};
use super::polyline::{Diagram, ORIGIN};

/// `step`, but no further than `most` either way.
fn within(most: f64, step: f64) -> f64 {
    if step.abs() > most {
        most.copysign(step)
    } else {
        step
    }
}

impl Partial {
    /// Lets a memory of higher friction slip to the present one while the bodies stand still.
    ///
    /// Slopes beyond μ become μ; the displacement they no longer carry is taken up further inside,
    /// as in a step, or by slip of the whole contact. No work is done from outside, and the energy is
    /// quadratic in the traction: the work of (q + q')/2 on the slip is what the energy falls by.
    pub(super) fn weaken<const M: usize>(&self, memory: &mut Diagram<M>) -> Slip {
        let (before, old) = (self.energy(memory), *memory);
        memory.friction = self.friction;
        memory.keep(0);
        let (mut from, mut to) = (ORIGIN, ORIGIN);
        for &node in old.nodes() {
            let most = self.friction * (node.overlap() - from.overlap());
            to.shift += within(most, node.shift - from.shift);
            let most = self.friction * (self.load(node.root) - self.load(from.root));
            to.force += within(most, node.force - from.force);
            (to.root, to.lost) = (node.root, node.lost);
            memory.append(to);
            from = node;
        }
        let now = old.top();
        let sliding = !old.is_empty() && self.slip(now.root, now.shift, memory).sliding;
        let lost = before - self.energy(memory);
        Slip {
            force: memory.top().force,
            gross: if sliding { lost } else { 0.0 },
            micro: if sliding { 0.0 } else { lost },
            sliding,
        }
    }
}
