//! Overlaps that are too large to be called small.

use crate::engine::World;
use crate::engine::neighbours::Status;
use crate::measure::contact_area::ContactArea;

/// Overlap over the smaller of two diameters above which a contact is counted, and damped critically
/// where `damping.overlap_critical` asks for it (Randall 1989, 6.4.3). Not to be confused with the 7 %
/// of contact radius over particle radius in his list of contacts (4.6): that is an overlap of 0.5 %.
pub const LARGE_OVERLAP: f64 = 0.07;

/// Number of touching contacts whose overlap over the smaller of their two diameters is above
/// `damping.overlap_critical`, or [`LARGE_OVERLAP`] where that is not set.
pub fn large_overlaps(world: &World) -> usize {
    let share = world.model().damping.overlap_critical;
    let most = 2.0 * share.unwrap_or(LARGE_OVERLAP);
    let is_large = |k: usize| world.geometry(k).overlap > most * ContactArea::of(world, k).smaller;
    (0..world.contacts().len())
        .filter(|&k| world.contacts().status[k] != Status::Apart && is_large(k))
        .count()
}
