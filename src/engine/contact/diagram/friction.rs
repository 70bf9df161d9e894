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
    /// as in a step, or by slip of the whole contact. No work is done from outside: what the traction
    /// does on its slip, (q + q')/2 times it, is the energy that gets free.
    #[cold]
    pub(super) fn weaken<const M: usize>(&self, memory: &mut Diagram<M>) -> Slip {
        let (before, now) = (self.energy(memory), memory.top());
        memory.friction = self.friction;
        if self.friction == 0.0 {
            memory.forget();
            return Slip {
                gross: before,
                ..Slip::default()
            };
        }
        let old = *memory;
        memory.forget();
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
        let slip = self.slip(now.root, now.shift, memory);
        let lost = before - self.energy(memory);
        let (gross, micro) = if slip.sliding {
            (lost, 0.0)
        } else {
            (0.0, lost)
        };
        Slip {
            gross,
            micro,
            ..slip
        }
    }
}
