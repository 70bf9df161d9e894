//! The first cycles of a run, to see how fast they are and whether they go well.

use std::time::{Duration, Instant};

use crate::session::{Budget, Progress, Session};

/// It takes so long.
const TRIAL: Duration = Duration::from_millis(150);

/// What the first cycles showed.
pub struct Trial {
    /// The run.
    pub session: Session,
    /// Time its cycles took [s].
    pub seconds: f64,
    /// `frac_limit` at the start.
    pub first: f64,
    /// Cycle, FRAC and `frac_limit` where FRAC was nearest to its limit.
    pub nearest: (u64, f64, f64),
    /// Why it did not go on.
    pub failure: Option<String>,
}

impl Trial {
    /// Runs it. The limit is looked at after 1, 2, 4, 8 ... cycles: it changes most at the beginning,
    /// and each look costs as much as a cycle.
    pub fn of(session: Session) -> Self {
        let mut trial = Self {
            first: session.world().frac_limit(),
            nearest: (0, 0.0, f64::INFINITY),
            session,
            seconds: 0.0,
            failure: None,
        };
        trial.look();
        let free = trial.session.scene().stages.is_empty();
        let mut until = 1;
        while trial.seconds < TRIAL.as_secs_f64() && trial.failure.is_none() {
            let start = Instant::now();
            let budget = Budget {
                until_cycle: Some(until),
                time: Some(TRIAL),
            };
            let reached = trial.session.advance(budget, free);
            trial.seconds += start.elapsed().as_secs_f64();
            match reached {
                Ok(Progress::Finished) => {
                    trial.look();
                    break;
                }
                Ok(_) => trial.look(),
                Err(error) => trial.failure = Some(error.to_string()),
            }
            until *= 2;
        }
        trial
    }

    fn look(&mut self) {
        let world = self.session.world();
        let (frac, limit) = (world.frac(), world.frac_limit());
        let (_, old_frac, old_limit) = self.nearest;
        if frac / limit > old_frac / old_limit {
            self.nearest = (world.cycle_number(), frac, limit);
        }
    }

    /// Cycles per second.
    pub fn rate(&self) -> f64 {
        self.session.world().cycle_number() as f64 / self.seconds.max(1e-9)
    }

    /// Cycles that the stages take at most; none if nothing limits one of them.
    pub fn most(&self) -> Option<u64> {
        let stages = self.session.scene().stages.iter();
        stages.map(|stage| stage.max_cycles).sum()
    }

    /// Time that the whole run takes at most [s]; none if nothing limits it.
    pub fn estimate(&self) -> Option<f64> {
        if self.session.is_finished() {
            return Some(self.seconds);
        }
        Some(self.most()? as f64 / self.rate())
    }
}
