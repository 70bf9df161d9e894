//! The first cycles of the run, to see how fast they are and whether they go well.

use std::time::{Duration, Instant};

use super::{Report, duration};
use crate::scene::Scene;
use crate::session::figure::figure;
use crate::session::{Budget, Progress, Session};

/// It takes so long.
const TRIAL: Duration = Duration::from_millis(150);

/// What the first cycles showed.
pub(super) struct Trial {
    session: Session,
    /// Time its cycles took [s].
    seconds: f64,
    /// Limit of frac at the start.
    first: f64,
    /// Cycle, frac and limit where frac was nearest to its limit.
    nearest: (u64, f64, f64),
    /// Why it did not go on.
    failure: Option<String>,
}

impl Trial {
    /// Runs it. The limit is looked at after 1, 2, 4, 8 ... cycles: it changes most at the beginning,
    /// and each look costs as much as a cycle.
    pub(super) fn of(session: Session) -> Self {
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
        let (frac, limit) = (world.model().frac, world.frac_limit());
        let (_, old_frac, old_limit) = self.nearest;
        if frac / limit > old_frac / old_limit {
            self.nearest = (world.cycle_number(), frac, limit);
        }
    }

    /// Limit, stages and length.
    pub(super) fn describe(&self, report: &mut Report, scene: &Scene) {
        let world = self.session.world();
        let done = world.cycle_number();
        let (cycle, frac, limit) = self.nearest;
        let first = if self.first.is_finite() {
            format!("{} at the start", figure(self.first))
        } else {
            "not known at the start, nothing touches".into()
        };
        let later = if limit.is_finite() {
            format!("lowest {} at cycle {cycle}", figure(limit))
        } else {
            "nothing touches".into()
        };
        let text = format!("{first}; in the first {} {later}", cycles(done));
        report.line("frac limit", text);
        if frac > limit {
            report.warnings.push(format!(
                "frac = {} is above the limit {} at cycle {cycle}: expect instability, reduce \
                 model.frac",
                figure(frac),
                figure(limit)
            ));
        }
        if let Some((cycle, particle, fracc)) = world.fracc_monitor().worst {
            report.warnings.push(format!(
                "fracc = {} at cycle {cycle} by particle {particle} (above 0.3 in {} of the first \
                 {}): its forces changed faster than the step resolves, or it hardly moved",
                figure(fracc),
                world.fracc_monitor().warnings,
                cycles(done)
            ));
        }
        if let Some(failure) = &self.failure {
            report.warnings.push(format!("the run fails: {failure}"));
        }
        report.line("stages", stages(scene));
        report.line("length", self.length(scene));
    }

    fn length(&self, scene: &Scene) -> String {
        let done = self.session.world().cycle_number();
        let rate = done as f64 / self.seconds.max(1e-9);
        let most: Option<u64> = scene.stages.iter().map(|stage| stage.max_cycles).sum();
        match most {
            Some(most) if most > 0 => {
                let open = scene.stages.iter().any(|stage| stage.until.is_some());
                format!(
                    "{}{} = {} s, {} here ({} cycles/s)",
                    if open { "at most " } else { "" },
                    cycles(most),
                    figure(most as f64 * self.session.world().dt()),
                    duration(most as f64 / rate),
                    figure(rate.round())
                )
            }
            _ => format!("no end given; {} cycles/s here", figure(rate.round())),
        }
    }
}

fn cycles(number: u64) -> String {
    match number {
        1 => "cycle".into(),
        _ => format!("{number} cycles"),
    }
}

fn stages(scene: &Scene) -> String {
    let stages: Vec<String> = scene
        .stages
        .iter()
        .map(|stage| match (&stage.until, stage.max_cycles) {
            (None, None) => stage.name.clone(),
            (None, Some(cycles)) => format!("{} ({cycles} cycles)", stage.name),
            (Some(until), None) => format!("{} (until {until})", stage.name),
            (Some(until), Some(cycles)) => {
                format!("{} (until {until}, at most {cycles} cycles)", stage.name)
            }
        })
        .collect();
    if stages.is_empty() {
        "none".into()
    } else {
        stages.join(", ")
    }
}
