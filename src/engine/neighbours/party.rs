//! A search that several threads share: each looks around a stretch of the particles.

use super::found::Found;
use super::near::Near;
use crate::engine::boundary::cell::Image;
use crate::engine::threads::{Threads, share};

/// Who searches, and what was found: the first one's, in the end, is all.
#[derive(Debug, Default)]
pub(super) struct Party(Vec<Searcher>);

/// One who searches.
#[derive(Debug, Default)]
pub(super) struct Searcher {
    /// The particles it looks around.
    pub(super) stretch: std::ops::Range<usize>,
    pub(super) near: Near,
    pub(super) partners: Vec<(u32, Image)>,
    pub(super) found: Found,
}

impl Party {
    /// Looks around so many particles; room is kept for so many pairs. `late`: some particles find
    /// what comes before them.
    pub(super) fn search(
        &mut self,
        particles: usize,
        room: usize,
        [cell, late]: [bool; 2],
        threads: &Threads,
        look: impl Fn(&mut Searcher) + Sync,
    ) {
        let parts = threads.parts(particles);
        if self.0.len() < parts {
            self.0.resize_with(parts, Searcher::default);
        }
        for (part, searcher) in self.0.iter_mut().enumerate().take(parts) {
            searcher.stretch = share(particles, parts, part);
            // Sizes and numbers decide who finds how many; what is not needed is not touched.
            searcher.found.clear(room, cell);
            if late {
                searcher.found.expect_late(room);
            }
        }
        threads.run(&mut self.0[..parts], look);
        if let Some((first, others)) = self.0[..parts].split_first_mut() {
            for other in others {
                first.found.append(&other.found);
            }
            first.found.settle(particles);
        }
    }

    /// What was found.
    pub(super) fn found(&mut self) -> &mut Found {
        if self.0.is_empty() {
            self.0.push(Searcher::default());
        }
        &mut self.0[0].found
    }
}
