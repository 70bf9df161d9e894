//! How fast cycles run.

use std::time::{Duration, Instant};

/// The rate shown is that of the last so much time.
const WINDOW: Duration = Duration::from_millis(500);

/// Cycles per second of the last moments.
#[derive(Debug, Default)]
pub(super) struct Rate {
    since: Option<(Instant, u64)>,
    value: f64,
}

impl Rate {
    /// After so many cycles [1/s].
    pub(super) fn update(&mut self, cycle: u64, running: bool) -> f64 {
        let now = Instant::now();
        match self.since {
            Some((then, first)) if now - then >= WINDOW => {
                self.value = cycle.saturating_sub(first) as f64 / (now - then).as_secs_f64();
                self.since = Some((now, cycle));
            }
            None => self.since = Some((now, cycle)),
            Some(_) => {}
        }
        if running { self.value } else { 0.0 }
    }
}
