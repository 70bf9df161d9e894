//! Cycles per second at most, for whoever wants to watch them.

use std::time::{Duration, Instant};

/// A batch is as long as this at the pace, if that is a cycle at least: often enough to look even.
const EVEN: f64 = 0.02;

/// Later than anybody waits for.
const NEVER: Duration = Duration::from_secs(365 * 24 * 3600);

/// How many cycles may be made when.
#[derive(Debug)]
pub(super) struct Pacing {
    /// Cycles per second; `None`: as many as possible.
    pace: Option<f64>,
    /// No cycle before this.
    next: Instant,
}

impl Pacing {
    /// A pace that counts from now.
    pub(super) fn new(pace: Option<f64>, now: Instant) -> Self {
        Self { pace, next: now }
    }

    /// Cycles of the next batch; `None`: as many as there is time for.
    pub(super) fn cycles(&self) -> Option<u64> {
        let pace = self.pace?;
        Some((pace * EVEN).max(1.0).round() as u64)
    }

    /// How long nothing may be done.
    pub(super) fn wait(&self, now: Instant) -> Duration {
        self.next.saturating_duration_since(now)
    }

    /// So many cycles were made, from this moment on.
    pub(super) fn made(&mut self, cycles: u64, start: Instant) {
        let Some(pace) = self.pace else {
            return;
        };
        let taken = Duration::try_from_secs_f64(cycles as f64 / pace);
        self.next = start + taken.map_or(NEVER, |taken| taken.min(NEVER));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_are_spread_over_time_whatever_the_pace() {
        let start = Instant::now();
        let after = |pace: Option<f64>, cycles: u64| {
            let mut pacing = Pacing::new(pace, start);
            assert_eq!(pacing.wait(start), Duration::ZERO);
            pacing.made(cycles, start);
            (pacing.cycles(), pacing.wait(start))
        };
        assert_eq!(after(None, 7), (None, Duration::ZERO));
        assert_eq!(after(Some(1.0), 1), (Some(1), Duration::from_secs(1)));
        assert_eq!(
            after(Some(500.0), 10),
            (Some(10), Duration::from_millis(20))
        );
        // A batch that was cut short.
        assert_eq!(after(Some(500.0), 5), (Some(10), Duration::from_millis(10)));
        // As good as standing still, and as good as no pace.
        assert_eq!(after(Some(1e-300), 1), (Some(1), NEVER));
        assert_eq!(after(Some(f64::MAX), 9), (Some(u64::MAX), Duration::ZERO));
    }
}
