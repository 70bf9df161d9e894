//! How long a variant takes: the same run again without rows and energies, timed.
//!
//! One run at a time. Short runs are repeated, the variants in turn, so that a machine that slows
//! down slows all of them; the median counts. The clock runs while cycles run: reading the preset,
//! building the world and measuring do not count. The run that was measured before has warmed
//! everything up.

use std::time::{Duration, Instant};

use super::trace::options;
use super::variant::Variant;
use super::watch::{BATCH, Teller};
use crate::language::Command;
use crate::scene::Scene;
use crate::session::{Budget, Progress, RunError, Session};

/// Runs of a variant are repeated until they took so long in all.
const ENOUGH: Duration = Duration::from_millis(500);

/// And at least so often.
const FEWEST: usize = 3;

/// And at most so often.
const MOST: usize = 100;

/// A run that takes so long is timed once: nothing that disturbs it for a moment matters.
const LONG: Duration = Duration::from_secs(5);

/// No row is taken: no run has so many cycles.
const NEVER: u64 = 1 << 53;

/// Wall times of a variant [s].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Timing {
    seconds: Vec<f64>,
}

impl Timing {
    /// Median [s]; NaN without runs.
    pub fn median(&self) -> f64 {
        let sorted = self.sorted();
        match sorted.len() {
            0 => f64::NAN,
            n if n % 2 == 1 => sorted[n / 2],
            n => 0.5 * (sorted[n / 2 - 1] + sorted[n / 2]),
        }
    }

    /// Distance of the quartiles over the median, of few runs the range; NaN for a single run.
    pub fn spread(&self) -> f64 {
        let sorted = self.sorted();
        if sorted.len() < 2 {
            return f64::NAN;
        }
        let quarter = sorted.len() / 4;
        (sorted[sorted.len() - 1 - quarter] - sorted[quarter]) / self.median()
    }

    fn sorted(&self) -> Vec<f64> {
        let mut sorted = self.seconds.clone();
        sorted.sort_by(f64::total_cmp);
        sorted
    }

    /// Number of runs.
    pub fn runs(&self) -> usize {
        self.seconds.len()
    }

    fn add(&mut self, time: Duration) {
        self.seconds.push(time.as_secs_f64());
    }

    fn wants_more(&self) -> bool {
        let sum: f64 = self.seconds.iter().sum();
        let long = self.seconds.iter().any(|s| *s >= LONG.as_secs_f64());
        let short = sum < ENOUGH.as_secs_f64() && self.runs() < MOST;
        !long && (self.runs() < FEWEST || short)
    }
}

/// Times variants in turn; those that are `None` are left out. Ends early when the listener wants
/// no more.
pub(super) fn time(
    variants: &[Option<(&Variant, String)>],
    threads: usize,
    teller: &mut Teller<'_>,
) -> Result<Vec<Timing>, RunError> {
    let mut timings = vec![Timing::default(); variants.len()];
    loop {
        let mut any = false;
        for (timing, variant) in timings.iter_mut().zip(variants) {
            let Some((variant, name)) = variant else {
                continue;
            };
            if !timing.wants_more() {
                continue;
            }
            any = true;
            match timed(variant, name, threads, teller)? {
                Some(time) => timing.add(time),
                None => return Ok(timings),
            }
            if !timing.wants_more() {
                teller.done += 1;
            }
        }
        if !any {
            return Ok(timings);
        }
    }
}

/// The time of one run; none if the listener wants no more.
fn timed(
    variant: &Variant,
    name: &str,
    threads: usize,
    teller: &mut Teller<'_>,
) -> Result<Option<Duration>, RunError> {
    let mut session = Session::open(bare(&variant.scene), options(threads))?;
    let budget = Budget {
        time: Some(BATCH),
        ..Budget::default()
    };
    let mut time = Duration::ZERO;
    loop {
        let start = Instant::now();
        let reached = session.advance(budget, false)?;
        time += start.elapsed();
        if reached == Progress::Finished {
            return Ok(Some(time));
        }
        if !teller.tell(name, &session) {
            return Ok(None);
        }
    }
}

/// A scene that measures nothing; energies are booked only if a condition asks for them.
fn bare(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.expects.clear();
    scene.dump = None;
    scene.history.columns.clear();
    scene.history.every = NEVER;
    for stage in &mut scene.stages {
        let rows = |command: &Command| matches!(command, Command::History(_) | Command::Print(_));
        stage.commands.retain(|command| !rows(command));
    }
    scene.setup.ledger = !scene.booked_for().is_empty();
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    fn timing(seconds: &[f64]) -> Timing {
        Timing {
            seconds: seconds.to_vec(),
        }
    }

    #[test]
    fn the_median_counts() {
        assert!(timing(&[]).median().is_nan());
        assert_eq!(timing(&[3.0, 1.0, 9.0]).median(), 3.0);
        assert_eq!(timing(&[4.0, 1.0, 9.0, 2.0]).median(), 3.0);
        assert!(timing(&[1.0]).spread().is_nan());
        assert_eq!(timing(&[1.0, 2.0, 4.0]).spread(), 1.5);
        // A run that was disturbed does not show.
        assert_eq!(timing(&[9.0, 1.0, 3.0, 2.0, 2.0]).spread(), 0.5);
    }

    #[test]
    fn short_runs_are_repeated_and_long_ones_are_not() {
        assert!(timing(&[]).wants_more());
        assert!(!timing(&[5.0]).wants_more());
        assert!(timing(&[4.0, 4.0]).wants_more());
        assert!(!timing(&[4.0, 4.0, 4.0]).wants_more());
        assert!(timing(&[1e-6; 99]).wants_more());
        assert!(!timing(&[1e-6; 100]).wants_more());
    }

    #[test]
    fn a_bare_scene_books_only_what_its_conditions_read() {
        let scene = Scene::load("rolling-disc", &[]).unwrap();
        assert!(scene.setup.ledger);
        let bare_one = bare(&scene);
        assert!(!bare_one.setup.ledger && bare_one.history.columns.is_empty());
        let until = "stage.roll.until=friction_loss > 1".to_owned();
        let scene = Scene::load("rolling-disc", &[until]).unwrap();
        assert!(bare(&scene).setup.ledger);
    }
}
