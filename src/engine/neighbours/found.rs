//! What one of those who search finds.

use super::images::Images;
use crate::engine::boundary::cell::Image;

/// A pair, and which image of its second body is meant.
pub(super) type Meant = ([u32; 2], Image);

/// Pairs by who looked. Buffers are kept between searches.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// Pairs whose first body looked, ascending.
    pub(super) early: Vec<[u32; 2]>,
    /// Which images those mean.
    pub(super) images: Images,
    /// Pairs whose second body looked.
    pub(super) late: Vec<Meant>,
}

impl Found {
    /// Empties it.
    pub(super) fn clear(&mut self) {
        self.early.clear();
        self.images.clear();
        self.late.clear();
    }

    /// Notes a pair whose first body did the looking.
    pub(super) fn early(&mut self, pair: [u32; 2], image: Image) {
        self.images.push(self.early.len(), image);
        self.early.push(pair);
    }

    /// Notes a pair whose second body did.
    pub(super) fn late(&mut self, pair: [u32; 2], image: Image) {
        self.late.push((pair, image));
    }

    /// Takes in what somebody found behind it.
    pub(super) fn append(&mut self, other: &mut Self) {
        self.images.append(self.early.len(), &other.images);
        self.early.extend_from_slice(&other.early);
        self.late.append(&mut other.late);
    }

    /// Those of the first kind.
    #[cfg(test)]
    pub(super) fn in_order(&self) -> Vec<Meant> {
        self.early.iter().copied().zip(self.images.each()).collect()
    }

    /// Pairs whose second body looked take their places among the others, ascending: from the back,
    /// so that no second list is needed. `spare` is a buffer.
    pub(super) fn sort_in(&mut self, spare: &mut Images) {
        if self.late.is_empty() {
            return;
        }
        self.late.sort_unstable();
        let mut left = self.early.len();
        let mut to = left + self.late.len();
        self.early.resize(to, [0; 2]);
        spare.clear();
        for late in self.late.iter().rev() {
            while left > 0 {
                let early = (self.early[left - 1], self.images.of(left - 1));
                if early < *late {
                    break;
                }
                (left, to) = (left - 1, to - 1);
                self.early[to] = early.0;
                spare.push(to, early.1);
            }
            to -= 1;
            self.early[to] = late.0;
            spare.push(to, late.1);
        }
        for k in (0..left).rev() {
            spare.push(k, self.images.of(k));
        }
        spare.turn_round();
        std::mem::swap(&mut self.images, spare);
        self.late.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::boundary::cell::HERE;

    #[test]
    fn what_several_found_becomes_one_ascending_list() {
        let [mut first, mut second] = std::array::from_fn(|_| Found::default());
        let mut spare = Images::default();
        let images = [HERE, [1, 0], [-1, 2]];
        for _ in 0..2 {
            first.clear();
            second.clear();
            first.early([0, 3], images[1]);
            first.early([1, 2], images[0]);
            first.late([0, 1], images[2]);
            second.early([4, 5], images[2]);
            second.late([0, 3], images[2]);
            second.late([4, 6], images[0]);
            first.append(&mut second);
            first.sort_in(&mut spare);
            let expected = [
                ([0, 1], images[2]),
                ([0, 3], images[2]),
                ([0, 3], images[1]),
                ([1, 2], images[0]),
                ([4, 5], images[2]),
                ([4, 6], images[0]),
            ];
            assert_eq!(first.in_order(), expected);
        }
    }
}
