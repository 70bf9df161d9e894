//! A search that several threads share: each looks around a stretch of the particles.

use super::found::{Found, Meant};
use super::near::Near;
use super::partner::Partner;
use crate::engine::threads::{Threads, share};

/// Who searches, and what they found: the first one has all that was found by second bodies.
#[derive(Debug, Default)]
pub(super) struct Party(Vec<Searcher>);

/// One who searches.
#[derive(Debug, Default)]
pub(super) struct Searcher {
    /// The particles it looks around.
    pub(super) stretch: std::ops::Range<usize>,
    pub(super) near: Near,
    pub(super) partners: Vec<Partner>,
    pub(super) found: Found,
}

impl Party {
    /// Looks around so many particles; room is kept for so many pairs. `late`: some particles find
    /// what comes before them.
    pub(super) fn search(
        &mut self,
        particles: usize,
        room: usize,
        late: bool,
        threads: &Threads,
        look: impl Fn(&mut Searcher) + Sync,
    ) {
        let parts = threads.parts(particles);
        if self.0.len() < parts {
            self.0.resize_with(parts, Searcher::default);
        }
        for searcher in &mut self.0 {
            searcher.found.clear();
        }
        for (part, searcher) in self.0.iter_mut().enumerate().take(parts) {
            searcher.stretch = share(particles, parts, part);
            // Sizes and numbers decide who finds how many; what is not needed is not touched.
            searcher.found.early.reserve(room);
            if late {
                searcher.found.late.reserve(room);
            }
        }
        threads.run(&mut self.0[..parts], look);
        if let Some((first, others)) = self.0.split_first_mut() {
            let all = &mut first.found.late;
            for other in others {
                all.extend_from_slice(&other.found.late);
            }
            all.sort_unstable();
        }
    }

    /// Number of pairs found.
    pub(super) fn count(&self) -> usize {
        let late = self.0.first().map_or(0, |first| first.found.late.len());
        let early = self.0.iter().map(|searcher| searcher.found.early.len());
        early.sum::<usize>() + late
    }

    /// Hands over all pairs, ascending.
    pub(super) fn each(&self, mut take: impl FnMut(Meant)) {
        let late = self.0.first().map_or(&[][..], |first| &first.found.late);
        let mut late = late.iter().copied().peekable();
        for searcher in &self.0 {
            for early in searcher.found.in_order() {
                while let Some(before) = late.next_if(|late| *late < early) {
                    take(before);
                }
                take(early);
            }
        }
        late.for_each(take);
    }
}
