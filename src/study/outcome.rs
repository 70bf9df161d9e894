//! A study carried out.

use super::Beat;
use super::front::{first_within, front};
use super::plan::Plan;
use super::question::Asked;
use super::replies::Replies;
use super::stability::Stability;
use super::timing::{Timing, time};
use super::trace::Trace;
use super::variant::Variant;
use super::watch::Teller;
use crate::session::RunError;
use crate::session::figure::figure;

/// What came out of a study.
pub struct Outcome {
    /// What was run.
    pub plan: Plan,
    /// One per variant, in the order of the plan.
    pub runs: Vec<Run>,
    /// One per question, in the order of the plan.
    pub replies: Vec<Replies>,
    /// The fastest variant whose error is within what the study calls good enough.
    pub fastest: Option<usize>,
    /// Whether the run that the others are compared with was finished.
    pub has_reference: bool,
    /// What the user should know about it.
    pub notes: Vec<String>,
}

/// A variant's run.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    /// Name of the variant.
    pub name: String,
    /// Cycles.
    pub cycles: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Wall times.
    pub timing: Timing,
    /// Particles times cycles over wall time [1/s].
    pub particle_steps: f64,
    /// Touching contacts times cycles over wall time [1/s].
    pub contact_updates: f64,
    /// Smallest `frac_limit` that was seen.
    pub frac_limit: f64,
    /// Whether it stayed stable.
    pub stability: Stability,
    /// Largest magnitude of the ledger's error that was seen.
    pub energy_error: f64,
    /// Largest error of all questions; NaN for the reference if a question is compared with it.
    pub error: f64,
    /// Whether it is stable and no other stable variant is both faster and more exact.
    pub on_front: bool,
}

impl Run {
    /// Whether it was begun before the study was ended.
    pub fn was_run(&self) -> bool {
        self.stability != Stability::NotRun
    }
}

impl Outcome {
    /// Carries a plan out. `listen` hears of every batch; false ends the study early with what it
    /// has. Only a run that cannot even be set up fails it.
    pub fn of(
        plan: Plan,
        threads: usize,
        listen: &mut dyn FnMut(Beat<'_>) -> bool,
    ) -> Result<Self, RunError> {
        let names: Vec<String> = (0..plan.variants.len()).map(|k| plan.name(k)).collect();
        let mut teller = Teller {
            done: 0,
            of: 2 * names.len(),
            listen,
            stopped: false,
        };
        let traces = traces(&plan, &names, threads, &mut teller)?;
        let timed: Vec<Option<(&Variant, String)>> = (plan.variants.iter().zip(&names))
            .zip(&traces)
            .map(|((variant, name), trace)| {
                let complete = trace.as_ref().is_some_and(|trace| trace.complete);
                complete.then(|| (variant, name.clone()))
            })
            .collect();
        teller.of = teller.done + timed.iter().flatten().count();
        let timings = if teller.stopped {
            vec![Timing::default(); names.len()]
        } else {
            time(&timed, threads, &mut teller)?
        };
        Ok(Self::judged(plan, names, &traces, timings))
    }

    fn judged(
        plan: Plan,
        names: Vec<String>,
        traces: &[Option<Trace>],
        timings: Vec<Timing>,
    ) -> Self {
        let reference = traces[plan.reference]
            .as_ref()
            .filter(|trace| trace.complete);
        let replies: Vec<Replies> = plan
            .questions
            .iter()
            .map(|asked| Replies::of(&plan, asked, traces, reference))
            .collect();
        let mut runs: Vec<Run> = names
            .into_iter()
            .zip(timings)
            .enumerate()
            .map(|(k, (name, timing))| run(name, timing, traces[k].as_ref(), &replies, k))
            .collect();
        // A run that gained energy is no candidate, however right it looks.
        let points: Vec<[f64; 2]> = runs
            .iter()
            .map(|run| match run.stability {
                Stability::Stable => [run.timing.median(), run.error],
                _ => [f64::NAN; 2],
            })
            .collect();
        for (run, on) in runs.iter_mut().zip(front(&points)) {
            run.on_front = on;
        }
        let within = plan.scene.study.within;
        let mut outcome = Self {
            fastest: within.and_then(|bound| first_within(&points, bound)),
            has_reference: reference.is_some(),
            notes: plan.notes.clone(),
            plan,
            runs,
            replies,
        };
        outcome.note(traces);
        outcome
    }

    fn note(&mut self, traces: &[Option<Trace>]) {
        let mut notes = Vec::new();
        for (run, trace) in self.runs.iter().zip(traces) {
            let Some(trace) = trace else { continue };
            if !run.stability.is_stable() {
                notes.push(format!("{}: {}", run.name, run.stability.reason()));
            }
            for stage in &trace.cut_short {
                notes.push(format!(
                    "{}: stage {stage} reached max_cycles before its condition held",
                    run.name
                ));
            }
        }
        let compared = self.plan.questions.iter().any(|asked| !asked.is_known());
        if compared && !self.has_reference {
            notes.push(format!(
                "the reference run {} was not finished; name another with --reference LAW@FRAC",
                self.runs[self.plan.reference].name
            ));
        }
        for (asked, replies) in self.plan.questions.iter().zip(&self.replies) {
            notes.extend(self.stuck(asked, replies));
        }
        if let (Some(within), None) = (self.plan.scene.study.within, self.fastest) {
            notes.push(format!(
                "no stable variant has an error within {}",
                figure(within)
            ));
        }
        self.notes.extend(notes);
    }

    /// Series whose two finest runs agree with each other ten times better than with the right
    /// answer: a smaller step will not help them.
    fn stuck(&self, asked: &Asked, replies: &Replies) -> Vec<String> {
        let mut notes = Vec::new();
        for (k, series) in self.plan.series.iter().enumerate() {
            let own_law = self.plan.variants[self.plan.reference].series == k;
            if !asked.is_known() && own_law {
                continue;
            }
            let mut finest = (0..self.runs.len())
                .rev()
                .filter(|&v| self.plan.variants[v].series == k);
            let (Some(a), Some(b)) = (finest.next(), finest.next()) else {
                continue;
            };
            let [a, b] = [a, b].map(|v| &replies.judgements[v]);
            // Rounding is no disagreement.
            if a.error > 1e-12 && (a.error - b.error).abs() < 0.1 * a.error {
                let than = if asked.is_known() {
                    "the answer given"
                } else {
                    "the reference run"
                };
                notes.push(format!(
                    "{}: {} differs from {than} by {}, and the step has no part in that: a smaller \
                     one will not help",
                    series.name(),
                    asked.title(),
                    figure(a.error)
                ));
            }
        }
        notes
    }
}

/// Runs the reference first, so that a study that is ended early has something to compare with; then
/// the others.
fn traces(
    plan: &Plan,
    names: &[String],
    threads: usize,
    teller: &mut Teller<'_>,
) -> Result<Vec<Option<Trace>>, RunError> {
    let mut columns = Vec::new();
    for column in plan.questions.iter().flat_map(Asked::columns) {
        if !columns.contains(&column) {
            columns.push(column);
        }
    }
    let mut traces: Vec<Option<Trace>> = names.iter().map(|_| None).collect();
    let others = (0..names.len()).filter(|k| *k != plan.reference);
    for k in std::iter::once(plan.reference).chain(others) {
        if teller.stopped {
            break;
        }
        let variant = &plan.variants[k];
        let mut beat = |session: &crate::session::Session| teller.tell(&names[k], session);
        traces[k] = Some(Trace::of(variant, columns.clone(), threads, &mut beat)?);
        teller.done += 1;
    }
    Ok(traces)
}

fn run(name: String, timing: Timing, trace: Option<&Trace>, replies: &[Replies], k: usize) -> Run {
    let wall = timing.median();
    let rate = |number: f64| {
        let cycles = trace.map_or(f64::NAN, |trace| trace.cycles as f64);
        number * cycles / wall
    };
    let errors = replies.iter().map(|replies| replies.judgements[k].error);
    let number = |value: fn(&Trace) -> f64| trace.map_or(f64::NAN, value);
    Run {
        name,
        cycles: trace.map_or(0, |trace| trace.cycles),
        time: number(|trace| trace.time),
        particle_steps: rate(number(|trace| trace.particles as f64)),
        contact_updates: rate(number(|trace| trace.contacts)),
        frac_limit: number(|trace| trace.frac_limit),
        stability: trace.map_or(Stability::NotRun, |trace| trace.stability.clone()),
        energy_error: number(|trace| trace.energy_error),
        // One that is not known makes the whole unknown.
        error: errors.fold(0.0, |most: f64, error| {
            if error.is_nan() || most.is_nan() {
                f64::NAN
            } else {
                most.max(error)
            }
        }),
        on_front: false,
        timing,
    }
}
