//! How the time of a worker is shared out: cycles have most of it, frames come often enough.

use std::time::{Duration, Instant};

/// Cycles have so many times what frames take, unless the screen would stand still.
const SHARE: u32 = 4;

/// From frame to frame it takes no longer than this, or than what keeps half of the time for cycles.
const LATE: Duration = Duration::from_millis(195);

/// Cycles are owed no more than this: when frames have become cheap, the screen is not slow for long.
const MOST: Duration = Duration::from_secs(1);

/// When the next frame is due.
#[derive(Debug, Default)]
pub(super) struct Turns {
    /// When the last frame was begun, and when it was done.
    last: Option<(Instant, Instant)>,
    /// What cycles were still to get when it was done.
    owed: Duration,
    /// Whether somebody waits for the next one.
    awaited: bool,
}

impl Turns {
    /// An order was given: its answer is waited for.
    pub(super) fn await_answer(&mut self) {
        self.awaited = true;
    }

    /// Whether it is a frame's turn, rather than that of cycles that take so long.
    pub(super) fn is_due(&self, now: Instant, cycles: Duration) -> bool {
        let Some((begun, done)) = self.last else {
            return true;
        };
        let ran = now.saturating_duration_since(done);
        if ran < done - begun {
            return false;
        }
        self.awaited || ran >= self.owed || now + cycles > begun + LATE
    }

    /// A frame was taken.
    pub(super) fn taken(&mut self, begun: Instant, done: Instant) {
        if let Some((_, before)) = self.last {
            self.owed = self
                .owed
                .saturating_sub(begun.saturating_duration_since(before));
        }
        self.owed = (self.owed + SHARE * (done - begun)).min(MOST);
        self.last = Some((begun, done));
        self.awaited = false;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Frames per second, and the share of the time [%] that they have, where the `k`th takes `frame(k)`
    /// and cycles take so long [ms].
    fn shared(cycle: f64, frame: impl Fn(u32) -> f64) -> (f64, f64) {
        let of = |ms: f64| Duration::from_secs_f64(1e-3 * ms);
        let start = Instant::now();
        let (mut now, mut turns) = (start, Turns::default());
        let (mut frames, mut spent) = (0, Duration::ZERO);
        loop {
            now += of(cycle);
            if !turns.is_due(now, of(cycle)) {
                continue;
            }
            // From frame to frame: what one takes counts with what cycles get after it.
            let all = (now - start).as_secs_f64();
            if all > 50.0 {
                return (f64::from(frames) / all, 100.0 * spent.as_secs_f64() / all);
            }
            let took = of(frame(frames));
            turns.taken(now, now + took);
            now += took;
            frames += 1;
            spent += took;
        }
    }

    #[test]
    fn frames_have_a_fifth_of_the_time_on_average_also_where_a_few_take_long() {
        for (cycle, frame) in [(0.01, 0.2), (1.0, 5.0), (5.0, 20.0), (12.0, 35.0)] {
            let (rate, share) = shared(cycle, |_| frame);
            assert!(
                share <= 20.01 && share > 15.0 && rate > 5.0,
                "{cycle}: {rate} {share}"
            );
        }
        // Every fourth comes with measures.
        let dear = |k: u32| if k.is_multiple_of(4) { 70.0 } else { 10.0 };
        let (rate, share) = shared(12.0, dear);
        assert!(
            share <= 20.5 && share > 15.0 && rate > 5.0,
            "{rate} {share}"
        );
    }

    #[test]
    fn five_frames_come_a_second_unless_cycles_would_lose_half_of_the_time() {
        for (cycle, frame) in [(1.0, 60.0), (12.0, 90.0), (50.0, 90.0), (100.0, 1.0)] {
            let (rate, share) = shared(cycle, |_| frame);
            assert!(rate >= 5.0 && share <= 50.0, "{cycle}: {rate} {share}");
        }
        for (cycle, frame) in [(12.0, 150.0), (12.0, 2000.0), (300.0, 400.0)] {
            let (rate, share) = shared(cycle, |_| frame);
            assert!(share <= 50.0 && share > 30.0, "{cycle}: {rate} {share}");
        }
        // Of cycles that take longer each is shown.
        let (rate, _) = shared(250.0, |_| 20.0);
        assert!((rate - 1e3 / 270.0).abs() < 0.05, "{rate}");
    }

    #[test]
    fn an_answer_waits_for_as_much_as_a_frame_takes_and_no_longer() {
        let start = Instant::now();
        let at = |ms| start + Duration::from_millis(ms);
        let mut turns = Turns::default();
        turns.taken(at(0), at(30));
        turns.await_answer();
        let due = |turns: &Turns, ms| turns.is_due(at(ms), Duration::ZERO);
        assert!(!due(&turns, 59) && due(&turns, 60));
        turns.taken(at(60), at(90));
        // What it came too early by is made up for.
        assert!(!due(&turns, 254) && due(&turns, 256));
    }
}
