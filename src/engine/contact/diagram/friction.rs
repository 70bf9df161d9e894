//! What becomes of a memory when friction is lowered under load.

use super::partial::Partial;
use super::polyline::{Diagram, Node, ORIGIN};
use crate::engine::contact::slipped::Slipped;

impl Partial {
    /// Lets a memory of higher friction slip to the present one while the bodies stand still.
    ///
    /// Slopes beyond μ become μ, and the displacement they no longer carry is taken up further inside
    /// as in a step: that is what the annuli of a contact do which was just sheared, or the whole of
    /// it if it has to slide. A load locked in the middle, by growth after shear, would slip there
    /// and nowhere else, which no diagram can tell; taken up elsewhere it would raise the force. Then
    /// the displacement is given up, and if that is not enough all is scaled down to the limit: force
    /// and energy never rise. No work is done from outside: what the energy falls by is lost.
    pub(super) fn weaken<const M: usize>(&self, memory: &mut Diagram<M>) -> Slipped {
        let old = *memory;
        memory.friction = self.friction;
        let steepest = self.steepest(&old);
        if steepest <= self.friction {
            return Slipped::default();
        }
        let (stored, force) = (self.energy(&old), old.top().force.abs());
        let rises =
            |memory: &Diagram<M>| self.energy(memory) > stored || memory.top().force.abs() > force;
        self.limit(&old, memory);
        let limited = *memory;
        let (root, target) = (old.top().root, old.top().shift);
        let mut sliding = self.slip::<M, true>(root, target, memory).sliding;
        if rises(memory) {
            (*memory, sliding) = (limited, false);
        }
        if rises(memory) {
            let share = self.friction / steepest;
            memory.redraw(&old, |_, node| Node {
                shift: share * node.shift,
                force: share * node.force,
                ..node
            });
        }
        let lost = stored - self.energy(memory);
        let (gross, micro) = if sliding { (lost, 0.0) } else { (0.0, lost) };
        Slipped {
            force: memory.top().force,
            gross,
            micro,
            sliding,
        }
    }

    /// The largest slope of a memory, in (η, δ/k) or (N, T).
    fn steepest<const M: usize>(&self, memory: &Diagram<M>) -> f64 {
        let (mut inner, mut most) = (ORIGIN, 0.0_f64);
        for outer in memory.nodes() {
            let by_overlap = (outer.shift - inner.shift) / (outer.overlap() - inner.overlap());
            let load = self.load(outer.root) - self.load(inner.root);
            let by_load = (outer.force - inner.force) / load;
            most = most.max(by_overlap.abs()).max(by_load.abs());
            inner = *outer;
        }
        most
    }

    /// Draws a memory anew with slopes of no more than μ.
    fn limit<const M: usize>(&self, old: &Diagram<M>, memory: &mut Diagram<M>) {
        let within = |most: f64, step: f64| step.clamp(-most, most);
        let mut from = ORIGIN;
        memory.redraw(old, |to, node| {
            let span = self.friction * (node.overlap() - from.overlap());
            let load = self.friction * (self.load(node.root) - self.load(from.root));
            let limited = Node {
                shift: to.shift + within(span, node.shift - from.shift),
                force: to.force + within(load, node.force - from.force),
                ..node
            };
            from = node;
            limited
        });
    }
}
