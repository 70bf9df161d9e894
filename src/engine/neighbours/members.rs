//! What the boxes hold, column by column, so that several are compared at once.
#![allow(
    unsafe_code,
    reason = "columns by pointer; each use says what it relies on"
)]

use std::ops::Range;

use super::near::Near;
use super::spot::Spot;
use crate::engine::lanes::Lanes;

/// So many more can be read than there are, and noted than are near.
pub(super) const SPARE: usize = 8;

/// Spots, box by box, ascending within a box.
#[derive(Debug, Default)]
pub(super) struct Members {
    x: [Vec<f64>; 2],
    radius: Vec<f64>,
    /// Which one; whole numbers all.
    index: Vec<f64>,
}

impl Members {
    /// Bytes of each.
    pub(super) const BYTES: usize = size_of::<[f64; 4]>();

    /// Makes room for so many, to be [put](Self::put) in.
    pub(super) fn make_room(&mut self, count: usize) {
        let [x, y] = &mut self.x;
        for column in [x, y, &mut self.radius, &mut self.index] {
            column.resize(count + SPARE, 0.0);
        }
    }

    /// Puts the spot of this index in its place.
    #[inline(always)]
    pub(super) fn put(&mut self, at: usize, spot: &Spot, index: u32) {
        self.x[0][at] = spot.x[0];
        self.x[1][at] = spot.x[1];
        self.radius[at] = spot.radius;
        self.index[at] = f64::from(index);
    }

    /// Number of spots.
    pub(super) fn len(&self) -> usize {
        self.index.len().saturating_sub(SPARE)
    }

    /// Which ones stand in these places.
    pub(super) fn indices(&self, places: Range<usize>) -> impl Iterator<Item = usize> + '_ {
        self.index[places].iter().map(|index| *index as usize)
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
        const { assert!(V::COUNT <= SPARE) };
        assert!(places.end <= self.len());
        let [x, y] = a.x.map(V::all);
        let (radius, tol) = (V::all(a.radius), V::all(tol));
        let least = V::all(f64::from(least));
        let mut noted = near.room(places.len());
        let mut at = places.start;
        while at < places.end {
            // SAFETY: columns are longer than the last place by more than there are lanes.
            let [other_x, other_y, other_radius, index] = unsafe {
                [
                    V::read(self.x[0].as_ptr().add(at)),
                    V::read(self.x[1].as_ptr().add(at)),
                    V::read(self.radius.as_ptr().add(at)),
                    V::read(self.index.as_ptr().add(at)),
                ]
            };
            let d = [other_x - x, other_y - y];
            let reach = radius + other_radius + tol;
            let meant = (reach * reach).above(d[0] * d[0] + d[1] * d[1]);
            let left = V::mask((1 << (places.end - at).min(V::COUNT)) - 1);
            // SAFETY: there is room for as many as are looked at, and for as many lanes more.
            noted += unsafe { index.pack(meant & index.at_least(least) & left, near.after(noted)) };
            at += V::COUNT;
        }
        near.note(noted);
    }
}
