//! A search that several threads share: each looks around a stretch of the particles.

use super::found::Found;
use super::images::Images;
use super::near::Near;
use super::partner::Partner;
use super::room;
use super::search::Sought;
use crate::engine::lanes::{InLanes, Lanes};
use crate::engine::threads::share;

/// Who searches, and what they found: in the end the first one has it all.
#[derive(Debug, Default)]
pub(super) struct Party {
    searchers: Vec<Searcher>,
    spare: Images,
}

/// One who searches.
#[derive(Debug, Default)]
pub(super) struct Searcher {
    /// The particles it looks around.
    pub(super) stretch: std::ops::Range<usize>,
    pub(super) near: Near,
    pub(super) partners: Vec<Partner>,
    pub(super) found: Found,
}

/// How to look around the particles of a stretch.
pub(super) trait Look: Sync {
    /// In lanes of this kind.
    fn look<V: Lanes>(&self, searcher: &mut Searcher);
}

/// One who looks so.
struct Looking<'a, L>(&'a L, &'a mut Searcher);

impl<L: Look> InLanes for Looking<'_, L> {
    #[inline(always)]
    fn run<V: Lanes>(self) {
        self.0.look::<V>(self.1);
    }
}

impl Party {
    /// Looks around so many particles. `late`: some particles find what comes before them.
    pub(super) fn search(
        &mut self,
        particles: usize,
        late: bool,
        Sought { isa, threads, .. }: Sought<'_>,
        look: &impl Look,
    ) {
        let ([room, _], parts) = (room(particles), threads.parts(particles));
        if self.searchers.len() < parts {
            self.searchers.resize_with(parts, Searcher::default);
        }
        for searcher in &mut self.searchers {
            searcher.found.clear();
        }
        for (part, searcher) in self.searchers.iter_mut().enumerate().take(parts) {
            searcher.stretch = share(particles, parts, part);
            // Sizes and numbers decide who finds how many; what is not needed is not touched.
            searcher.found.early.reserve(room);
            if late {
                searcher.found.late.reserve(room);
            }
        }
        threads.run(&mut self.searchers[..parts], |searcher| {
            isa.run(Looking(look, searcher));
        });
        if let Some((first, others)) = self.searchers.split_first_mut() {
            for other in others {
                first.found.append(&mut other.found);
            }
            first.found.sort_in(&mut self.spare);
        }
    }

    /// All that was found: pairs, ascending, and their images.
    pub(super) fn found(&mut self) -> &mut Found {
        if self.searchers.is_empty() {
            self.searchers.push(Searcher::default());
        }
        &mut self.searchers[0].found
    }
}
