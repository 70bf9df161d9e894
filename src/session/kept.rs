//! Measures that a screen shows: taken again when something has changed, but not so often that cycles
//! wait for them.

use std::time::{Duration, Instant};

/// While cycles run, a measure is so many times older than what it took before it is taken again.
const RARE: u32 = 20;

/// A state of a run, and whether that is going on.
#[derive(Debug, Clone, Copy)]
pub(super) struct Moment {
    /// Cycles done.
    pub(super) cycle: u64,
    /// Events in the journal.
    pub(super) events: usize,
    /// Whether cycles are running.
    pub(super) running: bool,
}

/// Something that was measured.
#[derive(Debug)]
pub(super) struct Kept<T> {
    pub(super) value: T,
    /// Cycle that it belongs to.
    pub(super) cycle: u64,
    events: usize,
    at: Instant,
    took: Duration,
}

impl<T> Kept<T> {
    /// What is kept, or what `measure` finds now: where the state is another, and while cycles run not
    /// too often if it took long.
    pub(super) fn get(
        kept: &mut Option<Self>,
        now: Moment,
        suits: impl FnOnce(&T) -> bool,
        measure: impl FnOnce() -> T,
    ) -> &Self {
        let old = kept.take().filter(|old| {
            let same = (old.cycle, old.events) == (now.cycle, now.events);
            let fresh = now.running && old.at.elapsed() < RARE * old.took;
            (same || fresh) && suits(&old.value)
        });
        let start = Instant::now();
        let new = || Self {
            value: measure(),
            cycle: now.cycle,
            events: now.events,
            took: start.elapsed(),
            at: Instant::now(),
        };
        kept.insert(old.unwrap_or_else(new))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_measured_again_when_the_state_is_another_and_never_too_often() {
        let mut kept = None;
        let mut measured = 0;
        let mut get = |cycle, events, running, suits: bool, slow: bool| {
            let now = Moment {
                cycle,
                events,
                running,
            };
            let measure = || {
                if slow {
                    std::thread::sleep(Duration::from_millis(50));
                }
                measured += 1;
                measured
            };
            Kept::get(&mut kept, now, |_| suits, measure).value
        };
        assert_eq!(get(1, 0, false, true, false), 1);
        assert_eq!(get(1, 0, false, true, false), 1);
        assert_eq!(
            get(1, 0, false, false, false),
            2,
            "something else is wanted"
        );
        assert_eq!(get(2, 0, false, true, false), 3, "another cycle");
        assert_eq!(get(2, 1, false, true, true), 4, "a command");
        // It took 50 ms: while cycles run it is good for a second.
        assert_eq!(get(3, 1, true, true, false), 4);
        assert_eq!(get(3, 1, false, true, false), 5, "at rest it is exact");
    }
}
