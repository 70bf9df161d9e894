//! Work that is done in the lanes of whichever instructions were chosen.

#[cfg(target_arch = "x86_64")]
use super::{Eight, Four};
use super::{Isa, Lanes, Scalars};

/// Work that can be done in lanes of any width. All that it calls must be inlined, closures, too: only
/// one function has the instructions.
pub trait InLanes {
    /// Does it in lanes of this kind.
    fn run<V: Lanes>(self);
}

impl Isa {
    /// Does some work with these instructions, or as the baseline does where the processor lacks them.
    pub fn run(self, work: impl InLanes) {
        #[cfg(target_arch = "x86_64")]
        if self > Self::Baseline && self.is_here() {
            // SAFETY: the processor has them.
            return unsafe {
                match self {
                    Self::Avx512 => with_eight(work),
                    _ => with_four(work),
                }
            };
        }
        work.run::<Scalars>();
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2,popcnt")]
fn with_eight(work: impl InLanes) {
    work.run::<Eight>();
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,popcnt")]
fn with_four(work: impl InLanes) {
    work.run::<Four>();
}
