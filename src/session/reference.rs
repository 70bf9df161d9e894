//! The state that displacements are measured from.

use serde::{Deserialize, Serialize};

use crate::engine::World;

/// Positions and angles at some cycle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Reference {
    /// Cycle at which it was taken.
    pub(super) cycle: u64,
    ids: Vec<u32>,
    states: Vec<([f64; 2], f64)>,
}

impl Reference {
    /// The present state.
    pub(super) fn of(world: &World) -> Self {
        let particles = world.particles();
        Self {
            cycle: world.cycle_number(),
            ids: particles.id.clone(),
            states: particles.row.iter().map(|row| (row.x, row.angle)).collect(),
        }
    }

    /// Displacement [m] and rotation [rad] since then; `None` for a particle that is newer.
    pub(super) fn change(&self, world: &World, id: u32) -> Option<([f64; 2], f64)> {
        let then = self.states[self.ids.binary_search(&id).ok()?];
        let now = &world.particles().row[world.particles().index(id)?];
        Some((
            [now.x[0] - then.0[0], now.x[1] - then.0[1]],
            now.angle - then.1,
        ))
    }
}
