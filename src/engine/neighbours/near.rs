//! What a few particles found. Noting and sorting hardly branch on what cannot be foretold, and
//! sorting waits until all of them have noted: a wrong guess then costs no search.

use std::ops::Range;

/// So many are noted at once, at most: as many as the widest lanes pack.
const SPARE: usize = 8;

/// So many particles look one after another.
const FEW: usize = 32;

/// Those near some particles. The buffer is kept between them.
#[derive(Debug, Default)]
pub(super) struct Near {
    /// The first `len` count.
    items: Vec<u32>,
    len: usize,
    /// Where those of each particle end: those on its own level, and all.
    ends: [[u32; 2]; FEW],
}

impl Near {
    /// The first of a few begins to look.
    #[inline(always)]
    pub(super) fn begin(&mut self) {
        self.len = 0;
    }

    /// The k-th of them has looked on its own level, and so far nowhere else.
    #[inline(always)]
    pub(super) fn own_done(&mut self, k: usize) {
        self.ends[k] = [self.len as u32; 2];
    }

    /// It has looked everywhere.
    #[inline(always)]
    pub(super) fn all_done(&mut self, k: usize) {
        self.ends[k][1] = self.len as u32;
    }

    /// What the k-th found, and how many of it on its own level.
    #[inline(always)]
    pub(super) fn of(&mut self, k: usize) -> (&mut [u32], usize) {
        let from = if k == 0 { 0 } else { self.ends[k - 1][1] } as usize;
        let [own, end] = self.ends[k].map(|end| end as usize);
        (&mut self.items[from..end], own - from)
    }

    /// Makes room for so many more, and for as many beyond as are noted at once. Answers how many are
    /// noted.
    #[inline(always)]
    pub(super) fn room(&mut self, more: usize) -> usize {
        let most = self.len + more + SPARE;
        if self.items.len() < most {
            self.items.resize(2 * most.max(LEAST), 0);
        }
        self.len
    }

    /// Where the next ones are noted when so many are.
    #[inline(always)]
    pub(super) fn after(&mut self, noted: usize) -> &mut [u32; SPARE] {
        let free = self.items[noted..].first_chunk_mut();
        free.expect("room was made")
    }

    /// So many are noted now.
    #[inline(always)]
    pub(super) fn note(&mut self, noted: usize) {
        self.len = noted;
    }
}

/// A stretch a few at a time.
pub(super) fn by_few(stretch: Range<usize>) -> impl Iterator<Item = Range<usize>> {
    let end = stretch.end;
    stretch
        .step_by(FEW)
        .map(move |from| from..end.min(from + FEW))
}

/// Room from the beginning.
const LEAST: usize = 64;

/// Exchanges that sort four and eight numbers, whatever they are.
const OF_FOUR: [[usize; 2]; 5] = [[0, 1], [2, 3], [0, 2], [1, 3], [1, 2]];
const OF_EIGHT: [[usize; 2]; 19] = [
    [0, 2],
    [1, 3],
    [4, 6],
    [5, 7],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
    [0, 1],
    [2, 3],
    [4, 5],
    [6, 7],
    [2, 4],
    [3, 5],
    [1, 4],
    [3, 6],
    [1, 2],
    [3, 4],
    [5, 6],
];

/// Sorts what differs, ascending; nothing is above `most`.
#[inline(always)]
pub(super) fn sort_few<T: Ord + Copy>(items: &mut [T], most: T) {
    match items.len() {
        0 | 1 => {}
        2..=4 => exchange(items, [most; 4], &OF_FOUR),
        5..=8 => exchange(items, [most; 8], &OF_EIGHT),
        _ => items.sort_unstable(),
    }
}

#[inline(always)]
fn exchange<T: Ord + Copy, const N: usize>(items: &mut [T], mut few: [T; N], by: &[[usize; 2]]) {
    few[..items.len()].copy_from_slice(items);
    for &[low, high] in by {
        (few[low], few[high]) = (few[low].min(few[high]), few[low].max(few[high]));
    }
    items.copy_from_slice(&few[..items.len()]);
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
            sort_few(&mut items, u32::MAX);
            prop_assert_eq!(items, sorted);
        }
    }

    #[test]
    fn everyone_gets_what_it_found_itself() {
        let mut near = Near::default();
        let note = |near: &mut Near, items: &[u32]| {
            let noted = near.room(items.len());
            near.items[noted..noted + items.len()].copy_from_slice(items);
            near.note(noted + items.len());
        };
        for _ in 0..2 {
            near.begin();
            for (k, [own, others]) in [[&[1, 2][..], &[3]], [&[], &[4]], [&[], &[]], [&[5], &[]]]
                .into_iter()
                .enumerate()
            {
                note(&mut near, own);
                near.own_done(k);
                note(&mut near, others);
                near.all_done(k);
            }
            let found = [0, 1, 2, 3].map(|k| {
                let (all, own) = near.of(k);
                (all.to_vec(), own)
            });
            let expected = [(vec![1, 2, 3], 2), (vec![4], 0), (vec![], 0), (vec![5], 1)];
            assert_eq!(found, expected);
        }
    }

    #[test]
    fn a_few_at_a_time_are_all() {
        let all: Vec<_> = by_few(5..5 + 2 * FEW + 3).collect();
        assert_eq!(all, [5..37, 37..69, 69..72]);
        assert_eq!(by_few(7..7).count(), 0);
    }
}
