//! What one particle found, in the order of its partners. Neither noting nor sorting branches on what
//! cannot be foretold: half of all that is looked at is near.

use super::grid::Spot;

/// Those near a particle. The buffer is kept between particles.
#[derive(Debug, Default)]
pub(super) struct Near {
    /// The first `len` count.
    items: Vec<u32>,
    len: usize,
}

impl Near {
    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    /// Notes those that are near.
    #[inline(always)]
    pub(super) fn take(&mut self, spots: &[Spot], is_near: impl Fn(&Spot) -> bool) {
        let most = self.len + spots.len();
        if self.items.len() < most {
            self.items.resize(2 * most.max(LEAST), 0);
        }
        let items = &mut self.items[self.len..most];
        let mut noted = 0;
        for spot in spots {
            items[noted] = spot.index;
            noted += usize::from(is_near(spot));
        }
        self.len += noted;
    }

    /// The indices noted.
    pub(super) fn indices(&self) -> &[u32] {
        &self.items[..self.len]
    }

    /// Keeps only some of those noted after the first few.
    pub(super) fn retain_from(&mut self, first: usize, mut keep: impl FnMut(u32) -> bool) {
        let mut kept = first;
        for k in first..self.len {
            let item = self.items[k];
            self.items[kept] = item;
            kept += usize::from(keep(item));
        }
        self.len = kept;
    }

    /// The same, to be sorted.
    pub(super) fn indices_mut(&mut self) -> &mut [u32] {
        &mut self.items[..self.len]
    }
}

/// Room from the beginning.
const LEAST: usize = 64;

/// Up to so many are sorted by counting how many are less.
const FEW: usize = 12;

/// Sorts what differs, ascending.
#[inline(always)]
pub(super) fn sort_few<T: Ord + Copy + Default>(items: &mut [T]) {
    if items.len() > FEW {
        return items.sort_unstable();
    }
    let mut sorted = [T::default(); FEW];
    for item in items.iter() {
        let less: usize = items.iter().map(|other| usize::from(other < item)).sum();
        sorted[less] = *item;
    }
    items.copy_from_slice(&sorted[..items.len()]);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn few_and_many_are_sorted(items in prop::collection::hash_set(0..1000u32, 0..30)) {
            let mut items: Vec<u32> = items.into_iter().collect();
            let mut sorted = items.clone();
            sorted.sort_unstable();
            sort_few(&mut items);
            prop_assert_eq!(items, sorted);
        }
    }
}
