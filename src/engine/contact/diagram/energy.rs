//! Energy stored in a memory diagram.

use super::partial::Partial;
use super::polyline::{Diagram, ORIGIN};

impl Partial {
    /// Elastic energy of the tangential displacement [J]: ∫ T dδ along the polyline.
    pub fn energy<const M: usize>(&self, memory: &Diagram<M>) -> f64 {
        let (mut inner, mut sum) = (ORIGIN, 0.0);
        for outer in memory.nodes() {
            let (a, b) = (inner.root, outer.root);
            // Mean over η of the way in N: 2/5 from the origin, 1/2 across a thin annulus.
            let way = (2.0 * b * b * b + a * (4.0 * b * b + a * (6.0 * b + 3.0 * a)))
                / (5.0 * (a * a + a * b + b * b) * (a + b));
            sum += (outer.shift - inner.shift) * (inner.force + way * (outer.force - inner.force));
            inner = *outer;
        }
        self.compliance * sum
    }

    /// The contact is lost in a step with the displacement `d` [m]: forgets, and answers the energy
    /// lost [J], what was stored and the work of the mean force.
    pub fn part<const M: usize>(&self, d: f64, memory: &mut Diagram<M>) -> f64 {
        let lost = self.energy(memory) + 0.5 * self.force(memory) * d;
        memory.forget();
        lost
    }
}
