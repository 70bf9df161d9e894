//! When the worker of a workbench saves the state: every minute while cycles run, but a large state takes
//! seconds, and orders come first.

use std::time::{Duration, Instant};

/// The state is saved this often.
const SAVE: Duration = Duration::from_secs(60);

/// No order puts a save off any more when the last one is so old.
const LATEST: Duration = Duration::from_secs(300);

/// A save that was put off is tried again when so many times what it took has passed.
const AGAIN: u32 = 10;

/// When it was saved, and when it will be.
#[derive(Debug)]
pub(super) struct SaveClock {
    last: Instant,
    next: Instant,
}

impl SaveClock {
    /// From now on.
    pub(super) fn new(now: Instant) -> Self {
        let next = now + SAVE;
        Self { last: now, next }
    }

    /// Whether it is time.
    pub(super) fn is_due(&self, now: Instant) -> bool {
        now >= self.next
    }

    /// Whether orders have to wait for it.
    pub(super) fn is_late(&self, now: Instant) -> bool {
        now >= self.last + LATEST
    }

    /// An order came between after so long.
    pub(super) fn put_off(&mut self, now: Instant, took: Duration) {
        self.next = now + AGAIN * took;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_save_that_is_put_off_is_tried_again_and_not_for_ever() {
        let start = Instant::now();
        let at = |seconds| start + Duration::from_secs(seconds);
        let mut clock = SaveClock::new(start);
        assert_eq!([59, 60].map(|t| clock.is_due(at(t))), [false, true]);
        clock.put_off(at(62), Duration::from_secs(2));
        assert_eq!([81, 82].map(|t| clock.is_due(at(t))), [false, true]);
        assert_eq!([299, 300].map(|t| clock.is_late(at(t))), [false, true]);
    }
}
