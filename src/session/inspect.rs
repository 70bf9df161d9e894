//! INSPECT CONTACT: one contact in full.

use crate::engine::World;
use crate::measure::columns::Partner;

/// The lines of the answer.
pub(super) fn contact(world: &mut World, i: u32, _partner: &Partner) -> Vec<String> {
    world.settle();
    vec![format!("{i}")]
}
