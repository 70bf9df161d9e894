//! The pairs that a search finds, brought into order without sorting them as a whole.

use crate::engine::boundary::cell::Image;

/// A pair whose first body was not the one that looked.
type Late = ([u32; 2], Image);

/// Pairs in the order of their bodies. Buffers are kept between searches.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// Pairs, ascending.
    pub(super) pairs: Vec<[u32; 2]>,
    /// Which image of the second body is meant; empty without a periodic cell.
    pub(super) images: Vec<Image>,
    /// What a particle found that comes before it: by second body, ascending.
    late: Vec<Late>,
    sorted: Vec<Late>,
    /// Where those of each first body go.
    places: Vec<u32>,
    /// Whether there is a periodic cell.
    cell: bool,
}

impl Found {
    /// Empties it and makes room for so many pairs.
    pub(super) fn clear(&mut self, room: usize, cell: bool) {
        self.pairs.clear();
        self.images.clear();
        self.late.clear();
        self.cell = cell;
        self.pairs.reserve(room);
        if cell {
            self.images.reserve(room);
        }
    }

    /// Makes room for as many late ones, where there are some to be expected.
    pub(super) fn expect_late(&mut self, room: usize) {
        self.late.reserve(room);
        self.sorted.reserve(room);
    }

    /// Takes what another search found among later particles.
    pub(super) fn append(&mut self, later: &Self) {
        self.pairs.extend_from_slice(&later.pairs);
        self.images.extend_from_slice(&later.images);
        self.late.extend_from_slice(&later.late);
    }

    /// Notes a pair of which the second body did the looking.
    pub(super) fn late(&mut self, pair: [u32; 2], image: Image) {
        self.late.push((pair, image));
    }

    /// Puts the late ones of so many particles where they belong.
    pub(super) fn settle(&mut self, particles: usize) {
        if self.late.is_empty() {
            return;
        }
        self.sort_late(particles);
        let (mut early, mut late) = (self.pairs.len(), self.sorted.len());
        self.pairs.resize(early + late, [0; 2]);
        if self.cell {
            self.images.resize(early + late, Image::default());
        }
        // From the back, until the rest is where it was.
        while late > 0 {
            let last = self.sorted[late - 1];
            let to = early + late - 1;
            let image = |images: &[Image], k: usize| images.get(k).copied().unwrap_or_default();
            let before = early.checked_sub(1);
            let before = before.map(|k| (self.pairs[k], image(&self.images, k)));
            let item = match before.filter(|before| *before > last) {
                Some(before) => {
                    early -= 1;
                    before
                }
                None => {
                    late -= 1;
                    last
                }
            };
            self.pairs[to] = item.0;
            if self.cell {
                self.images[to] = item.1;
            }
        }
    }

    /// By first body: those of one stay in the order in which they came.
    fn sort_late(&mut self, particles: usize) {
        self.places.clear();
        self.places.resize(particles + 1, 0);
        for &([i, _], _) in &self.late {
            self.places[i as usize + 1] += 1;
        }
        for p in 1..self.places.len() {
            self.places[p] += self.places[p - 1];
        }
        self.sorted.clear();
        self.sorted.resize(self.late.len(), Late::default());
        for &late in &self.late {
            let place = &mut self.places[late.0[0] as usize];
            self.sorted[*place as usize] = late;
            *place += 1;
        }
    }
}
