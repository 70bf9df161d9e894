//! What the boxes hold, column by column, so that several are compared at once.

use std::ops::Range;

use super::near::Near;
use super::spot::Spot;
use crate::engine::lanes::{Columns, Lanes};

/// Spots, box by box, ascending within a box.
#[derive(Debug, Default)]
pub(super) struct Members(
    /// Centre and radius [m], and which one: a whole number.
    Columns<4>,
);

impl Members {
    /// Bytes of each.
    pub(super) const BYTES: usize = size_of::<[f64; 4]>();

    /// Makes room for so many, to be [put](Self::put) in.
    pub(super) fn make_room(&mut self, count: usize) {
        self.0.resize(count);
    }

    /// Puts the spot of this index in its place.
    #[inline(always)]
    pub(super) fn put(&mut self, at: usize, spot: &Spot, index: u32) {
        let [x, y] = spot.x;
        self.0.put(at, [x, y, spot.radius, f64::from(index)]);
    }

    /// Number of spots.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Which ones stand in these places.
    pub(super) fn indices(&self, places: Range<usize>) -> impl Iterator<Item = usize> + '_ {
        self.0.column(3)[places].iter().map(|index| *index as usize)
    }

    /// Notes those in these places that are nearer to a spot than `tol` [m] and have at least this
    /// index.
    #[inline(always)]
    pub(super) fn near<V: Lanes>(
        &self,
        places: Range<usize>,
        a: &Spot,
        (tol, least): (f64, u32),
        near: &mut Near,
    ) {
        let (x, y) = (V::all(a.x[0]), V::all(a.x[1]));
        let (radius, tol) = (V::all(a.radius), V::all(tol));
        let least = V::all(f64::from(least));
        let mut noted = near.room(places.len());
        let mut at = places.start;
        while at < places.end {
            let [other_x, other_y, other_radius, index] = self.0.read::<V>(at);
            let d = [other_x - x, other_y - y];
            let reach = radius + other_radius + tol;
            let near_by = (reach * reach).above(d[0] * d[0] + d[1] * d[1]);
            let left = V::mask((1 << (places.end - at).min(V::COUNT)) - 1);
            noted += index.pack(near_by & index.at_least(least) & left, near.after(noted));
            at += V::COUNT;
        }
        near.note(noted);
    }
}
