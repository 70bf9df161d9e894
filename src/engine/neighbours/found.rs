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

    /// Those of the first kind.
    pub(super) fn in_order(&self) -> impl Iterator<Item = Meant> + '_ {
        self.early.iter().copied().zip(self.images.each())
    }
}
