//! Which image of its second body each pair means.

use std::cmp::Ordering;

use serde::{Deserialize, Serialize};

use crate::engine::boundary::cell::{HERE, Image};

/// Those of a list of pairs: kept only where it is not the body itself, which is where a pair reaches
/// over an edge of a cell.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(in crate::engine) struct Images(Vec<(u32, Image)>);

impl Images {
    /// Without pairs.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }

    /// Notes that of pair k; pairs come in ascending order.
    pub(super) fn push(&mut self, k: usize, image: Image) {
        if image != HERE {
            self.0.push((k as u32, image));
        }
    }

    /// Those of pair 0, pair 1 and so on without end.
    pub(in crate::engine) fn each(&self) -> impl Iterator<Item = Image> + '_ {
        let mut ahead = self.ahead(0);
        (0..).map(move |k| ahead.at(k))
    }

    /// Those of pairs from pair k on that are asked for in ascending order.
    pub(super) fn ahead(&self, k: usize) -> Ahead<'_> {
        Ahead(&self.0[self.0.partition_point(|item| (item.0 as usize) < k)..])
    }

    /// That of pair k, in any order.
    pub(super) fn of(&self, k: usize) -> Image {
        let at = self.0.binary_search_by_key(&k, |item| item.0 as usize);
        at.map_or(HERE, |at| self.0[at].1)
    }

    /// Turns the order round: they were noted from the last to the first.
    pub(super) fn turn_round(&mut self) {
        self.0.reverse();
    }

    /// Names them anew. False if that would leave pairs of the same two bodies in another order: then
    /// nothing has changed.
    pub(in crate::engine) fn rename(
        &mut self,
        pairs: &[[u32; 2]],
        name: impl Fn(Image) -> Image,
    ) -> bool {
        let renamed = |k: usize| name(self.of(k));
        // Two images of a body are both here only where one of them is beyond an edge.
        let meets_twice =
            |k: usize, other: usize| pairs.get(k).is_some() && pairs.get(k) == pairs.get(other);
        let out_of_order = self.beyond().any(|(k, _)| {
            meets_twice(k, k + 1) && renamed(k) >= renamed(k + 1)
                || k > 0 && meets_twice(k - 1, k) && renamed(k - 1) >= renamed(k)
        });
        if !out_of_order {
            self.0
                .iter_mut()
                .for_each(|(_, image)| *image = name(*image));
        }
        !out_of_order
    }

    /// Adds those of further pairs, the first of which is pair k.
    pub(super) fn append(&mut self, k: usize, others: &Self) {
        let moved = others
            .0
            .iter()
            .map(|&(pair, image)| (pair + k as u32, image));
        self.0.extend(moved);
    }

    /// Pairs that reach over an edge, ascending, and the image of each.
    pub(in crate::engine) fn beyond(&self) -> impl Iterator<Item = (usize, Image)> + '_ {
        self.0.iter().map(|&(k, image)| (k as usize, image))
    }

    /// Of the pairs that are kept, numbered anew.
    pub(super) fn chosen(&self, keep: &[bool]) -> Self {
        let mut chosen = Self::default();
        let kept = keep.iter().zip(self.each()).filter(|(keep, _)| **keep);
        for (k, (_, image)) in kept.enumerate() {
            chosen.push(k, image);
        }
        chosen
    }

    /// Whether they are those of so many pairs.
    pub(super) fn fit(&self, pairs: usize) -> bool {
        self.0.is_sorted_by(|a, b| a.0 < b.0) && self.0.iter().all(|(k, _)| (*k as usize) < pairs)
    }
}

/// The images of pairs that have not been passed.
pub(super) struct Ahead<'a>(&'a [(u32, Image)]);

impl Ahead<'_> {
    /// That of pair k, which is not before the last one asked for.
    #[inline(always)]
    pub(super) fn at(&mut self, k: usize) -> Image {
        while let Some((&(pair, image), others)) = self.0.split_first() {
            match (pair as usize).cmp(&k) {
                Ordering::Less => self.0 = others,
                Ordering::Equal => return image,
                Ordering::Greater => break,
            }
        }
        HERE
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_left_out_is_here(
            all in prop::collection::vec((any::<bool>(), -1..2i16), 0..20),
        ) {
            let (keep, all): (Vec<bool>, Vec<Image>) =
                all.into_iter().map(|(keep, n)| (keep, [n, 0])).unzip();
            let mut images = Images::default();
            all.iter().enumerate().for_each(|(k, &image)| images.push(k, image));
            prop_assert_eq!(images.each().take(all.len()).collect::<Vec<_>>(), all.clone());
            let kept = all.iter().zip(&keep).filter(|(_, keep)| **keep);
            let kept: Vec<Image> = kept.map(|(image, _)| *image).collect();
            let chosen = images.chosen(&keep).each().take(kept.len()).collect::<Vec<_>>();
            prop_assert_eq!(chosen, kept);
            let last = all.iter().rposition(|&image| image != HERE);
            prop_assert!(images.fit(last.map_or(0, |last| last + 1)));
            prop_assert!(last.is_none_or(|last| !images.fit(last)));
            // Asked for in order, some twice and some not at all.
            let half = all.len() / 2;
            prop_assert!(half == all.len() || images.ahead(half).at(half) == all[half]);
            let mut ahead = images.ahead(0);
            for k in (0..all.len()).flat_map(|k| std::iter::repeat_n(k, k % 3)) {
                prop_assert_eq!(ahead.at(k), all[k]);
            }
            let mut turned = Images::default();
            for k in (0..all.len()).rev() {
                turned.push(k, images.of(k));
            }
            turned.turn_round();
            prop_assert_eq!(&turned, &images);
            // In two parts, put together.
            let [mut first, mut second] = [Images::default(), Images::default()];
            all[..half].iter().enumerate().for_each(|(k, &image)| first.push(k, image));
            all[half..].iter().enumerate().for_each(|(k, &image)| second.push(k, image));
            first.append(half, &second);
            prop_assert_eq!(first, images);
        }
    }
}
