//! Energy stored in a memory diagram.

use super::partial::Partial;
use super::polyline::{Diagram, ORIGIN, stored};

impl Partial {
    /// Elastic energy of the tangential displacement [J]: ∫ T dδ along the polyline.
    pub fn energy<const M: usize>(&self, memory: &Diagram<M>) -> f64 {
        let (mut inner, mut sum) = (ORIGIN, 0.0);
        for outer in memory.nodes() {
            sum += stored(&inner, outer);
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
