//! Overlaps that are too large to be called small.

use crate::engine::World;
use crate::engine::neighbours::Status;

/// Overlap over the smallest diameter above which a contact is counted, and damped critically where
/// `damping.overlap_critical` asks for it (Randall 1989, 6.4.3). Not to be confused with the 7 % of
/// contact radius over particle radius in his list of contacts (4.6): that is an overlap of 0.5 %.
pub const LARGE_OVERLAP: f64 = 0.07;

/// Number of touching contacts whose overlap over the smallest diameter of the scene is above
/// `damping.overlap_critical`, or [`LARGE_OVERLAP`] where that is not set.
pub fn large_overlaps(world: &World) -> usize {
    let share = world.model().damping.overlap_critical;
    let most = 2.0 * world.particles().smallest_radius() * share.unwrap_or(LARGE_OVERLAP);
    let touching = |k: &usize| world.contacts().status[*k] != Status::Apart;
    (0..world.contacts().len())
        .filter(touching)
        .filter(|&k| world.geometry(k).overlap > most)
        .count()
}
