//! A search that several threads share: each looks around a stretch of the particles.
#![allow(
    unsafe_code,
    reason = "enters functions for instructions that the processor was asked for"
)]

use super::found::Found;
use super::near::Near;
use super::partner::Partner;
use super::search::Sought;
#[cfg(target_arch = "x86_64")]
use crate::engine::lanes::{Eight, Four};
use crate::engine::lanes::{Isa, Lanes, Scalars};
use crate::engine::threads::share;

/// Who searches, and what they found: in the end the first one has it all.
#[derive(Debug, Default)]
pub(super) struct Party {
    searchers: Vec<Searcher>,
    spare: Found,
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

fn by_isa(isa: Isa, look: &impl Look, searcher: &mut Searcher) {
    #[cfg(target_arch = "x86_64")]
    if isa > Isa::Baseline && isa.is_here() {
        // SAFETY: the processor has it.
        return unsafe {
            match isa {
                Isa::Avx512 => with_eight(look, searcher),
                _ => with_four(look, searcher),
            }
        };
    }
    look.look::<Scalars>(searcher);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,popcnt")]
fn with_eight(look: &impl Look, searcher: &mut Searcher) {
    look.look::<Eight>(searcher);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,popcnt")]
fn with_four(look: &impl Look, searcher: &mut Searcher) {
    look.look::<Four>(searcher);
}

impl Party {
    /// Looks around so many particles. `late`: some particles find what comes before them.
    pub(super) fn search(
        &mut self,
        particles: usize,
        late: bool,
        Sought {
            room, isa, threads, ..
        }: Sought<'_>,
        look: &impl Look,
    ) {
        let parts = threads.parts(particles);
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
            by_isa(isa, look, searcher);
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
