//! One run of a variant for what it gives: rows, limits, energies.

use super::pace::Pace;
use super::stability::Stability;
use super::variant::Variant;
use super::watch::Watch;
use crate::language::{Observable, Term};
use crate::measure::columns::Column;
use crate::session::{Options, Recording, RunError, Session};

/// What a run gave.
pub struct Trace {
    recording: Recording,
    pace: Pace,
    stages: Vec<String>,
    /// Cycles that were run.
    pub cycles: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Particles at the end.
    pub particles: usize,
    /// Touching contacts, mean over the cycles.
    pub contacts: f64,
    /// Smallest `frac_limit` that was seen.
    pub frac_limit: f64,
    /// Largest magnitude of `energy_error` that was seen.
    pub energy_error: f64,
    /// Whether it stayed stable.
    pub stability: Stability,
    /// Stages that ended at `max_cycles` before their condition held.
    pub cut_short: Vec<String>,
    /// Whether it ended by itself.
    pub complete: bool,
}

impl Trace {
    /// Runs a variant to its end and records the columns. `beat` is called between batches; false
    /// ends the run early.
    pub fn of(
        variant: &Variant,
        columns: Vec<Column>,
        threads: usize,
        beat: &mut dyn FnMut(&Session) -> bool,
    ) -> Result<Self, RunError> {
        let mut session = opened(variant, columns, threads)?;
        let mut watch = Watch::default();
        let complete = watch.run(&mut session, &mut |_, session| beat(session))?;
        if complete {
            session.finish()?;
        }
        let stages = session.scene().stages.iter();
        let world = session.world();
        Ok(Self {
            stages: stages.map(|stage| stage.name.clone()).collect(),
            pace: variant.pace,
            cycles: world.cycle_number(),
            time: world.time(),
            particles: world.particles().len(),
            contacts: watch.touching() as f64 / world.cycle_number() as f64,
            frac_limit: watch.frac_limit(),
            energy_error: watch.energy_error(),
            stability: if complete {
                watch.verdict()
            } else {
                watch.verdict().so_far()
            },
            cut_short: session.cut_short().to_vec(),
            recording: session.recording().clone(),
            complete,
        })
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.recording.rows().len()
    }

    /// Simulated time of a row [s].
    pub fn time_of(&self, row: usize) -> f64 {
        self.recording.rows()[row].time
    }

    /// The rows of a stage by name, or all.
    pub fn rows_of(&self, stage: Option<&str>) -> Vec<usize> {
        let stage = stage.map(|name| self.stages.iter().position(|known| known == name));
        let rows = self.recording.rows().iter().enumerate();
        rows.filter(|(_, row)| stage.is_none_or(|stage| stage == Some(row.stage as usize)))
            .map(|(k, _)| k)
            .collect()
    }

    /// Names of the stages.
    pub fn stages(&self) -> &[String] {
        &self.stages
    }

    /// Value of a term in a row; cycles count as those of the preset.
    pub fn term(&self, row: usize, term: &Term) -> f64 {
        let value = self.recording.term(row, term);
        match term {
            Term::Cycle | Term::StageCycle => self.pace.preset_cycles(value),
            Term::Time | Term::Column(_) => value,
        }
    }
}

/// A session of a variant that records these columns and books energies.
pub(super) fn opened(
    variant: &Variant,
    columns: Vec<Column>,
    threads: usize,
) -> Result<Session, RunError> {
    let mut scene = variant.scene.clone();
    scene.expects.clear();
    scene.setup.ledger = true;
    scene.dump = None;
    scene.history.columns = columns.into_iter().map(Observable::Column).collect();
    Session::open(scene, options(threads))
}

/// How the runs of a study are started.
pub(super) fn options(threads: usize) -> Options {
    Options {
        threads,
        expendable: true,
        ..Options::default()
    }
}
