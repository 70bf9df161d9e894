//! A preset against its `[[expect]]`.

use std::collections::{BTreeMap, BTreeSet};
use std::time::Duration;

use super::ensemble::{self, spread::Spread};
use crate::record::number::Cell;
use crate::scene::{Band, Expect, Scene, Seeds, Stage};
use crate::session::{Budget, Options, Progress, Recording, RunError, Session};

/// How an expectation came out.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Within the band.
    Pass,
    /// Outside the source's band, inside our own, with a reason.
    Differs,
    /// Neither.
    Fail,
}

impl Verdict {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Pass => "PASS",
            Self::Differs => "DIFFERS",
            Self::Fail => "FAIL",
        }
    }
}

/// One expectation, measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Stage it is about; empty: the whole run.
    pub stage: String,
    /// What was measured.
    pub what: String,
    /// What came out, or why nothing did; of an ensemble the mean.
    pub value: Result<f64, String>,
    /// How it varies over an ensemble.
    pub spread: Option<Spread>,
    /// What was expected.
    pub expected: f64,
    /// By how much it may be off.
    pub band: f64,
    /// Who says so.
    pub source: String,
    /// How it came out.
    pub verdict: Verdict,
    /// Why it differs.
    pub reason: String,
}

/// All expectations of a preset.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Name of the preset.
    pub preset: String,
    /// One finding per expectation.
    pub findings: Vec<Finding>,
    /// Stages that ended at `max_cycles` before their condition held.
    pub cut_short: Vec<String>,
    /// Why the run ended before anything could be measured, if it did.
    pub failure: Option<String>,
    /// Cycles that were run.
    pub cycles: u64,
}

impl Outcome {
    /// Whether nothing failed.
    pub fn is_good(&self) -> bool {
        self.count(Verdict::Fail) == 0
    }

    /// How many came out so; a stage that was cut short failed.
    pub fn count(&self, verdict: Verdict) -> usize {
        let found = self.findings.iter().filter(|f| f.verdict == verdict);
        match verdict {
            Verdict::Fail => {
                found.count() + self.cut_short.len() + usize::from(self.failure.is_some())
            }
            _ => found.count(),
        }
    }

    /// A preset whose run failed: nothing could be measured.
    pub fn failed(preset: &str, error: &RunError) -> Self {
        Self {
            preset: preset.to_owned(),
            findings: Vec::new(),
            cut_short: Vec::new(),
            failure: Some(error.to_string()),
            cycles: 0,
        }
    }
}

/// A run that came to its end.
struct Run {
    recording: Recording,
    cut_short: Vec<String>,
    cycles: u64,
}

/// Runs a scene to its end and measures its expectations. `beat` is called between batches; false
/// ends the run early. Where expectations are of an ensemble, `threads` seeds run at a time, each on
/// one thread.
pub fn verify(scene: &Scene, threads: usize, beat: &Beat<'_>) -> Result<Outcome, RunError> {
    let seeds = seeds(scene);
    if seeds == [scene.seed] {
        let run = run(scene.clone(), threads, beat)?;
        return Ok(judge(scene, &BTreeMap::from([(scene.seed, Ok(run))])));
    }
    let runs = ensemble::each(&seeds, threads, |seed| {
        let scene = if seed == scene.seed {
            Ok(scene.clone())
        } else {
            scene.with_seed(seed).map_err(|r| r.to_string())
        };
        scene.and_then(|scene| run(scene, 1, beat).map_err(|error| error.to_string()))
    });
    Ok(judge(scene, &seeds.into_iter().zip(runs).collect()))
}

/// Called between batches of a run, by whatever thread it runs on.
pub type Beat<'a> = dyn Fn(&Session) -> bool + Sync + 'a;

/// The seeds that the expectations of a scene are about, ascending.
pub fn seeds(scene: &Scene) -> Vec<u64> {
    let mut seeds = BTreeSet::new();
    for expect in &scene.expects {
        match expect.seeds {
            Some(range) => seeds.extend(range.all()),
            None => seeds.extend([scene.seed]),
        }
    }
    if seeds.is_empty() {
        seeds.insert(scene.seed);
    }
    seeds.into_iter().collect()
}

fn run(scene: Scene, threads: usize, beat: &Beat<'_>) -> Result<Run, RunError> {
    let options = Options {
        threads,
        ..Options::default()
    };
    let mut session = Session::open_watched(scene, options, &mut |session| beat(session))?;
    let budget = Budget {
        time: Some(Duration::from_millis(100)),
        ..Budget::default()
    };
    while session.advance(budget, false)? != Progress::Finished {
        if !beat(&session) {
            break;
        }
    }
    session.finish()?;
    beat(&session);
    Ok(Run {
        recording: session.recording().clone(),
        cut_short: session.cut_short().to_vec(),
        cycles: session.world().cycle_number(),
    })
}

/// What the runs of all seeds make of the expectations.
fn judge(scene: &Scene, runs: &BTreeMap<u64, Result<Run, String>>) -> Outcome {
    let mut cut_short = Vec::new();
    let mut cycles = 0;
    for (seed, run) in runs {
        let Ok(run) = run else {
            continue;
        };
        cycles += run.cycles;
        cut_short.extend(run.cut_short.iter().map(|stage| match runs.len() {
            1 => stage.clone(),
            _ => format!("{stage} of seed {seed}"),
        }));
    }
    let findings = scene.expects.iter().map(|expect| find(scene, runs, expect));
    Outcome {
        preset: scene.name.clone(),
        findings: findings.collect(),
        cut_short,
        failure: None,
        cycles,
    }
}

/// The value that one run gives.
fn value(stages: &[Stage], recording: &Recording, expect: &Expect) -> Result<f64, String> {
    let stage = expect
        .stage
        .as_ref()
        .map(|name| stages.iter().position(|s| s.name == *name));
    let rows: Vec<usize> = (0..recording.rows().len())
        .filter(|&row| match stage {
            None => true,
            Some(stage) => stage == Some(recording.rows()[row].stage as usize),
        })
        .collect();
    expect
        .what
        .value(rows.len(), &mut |row, term| recording.term(rows[row], term))
}

/// The mean over these seeds and its spread; or what is wrong with the first that gives none.
fn mean(
    seeds: Seeds,
    value: impl Fn(u64) -> Result<f64, String>,
) -> (Result<f64, String>, Option<Spread>) {
    let mut values = Vec::with_capacity(seeds.count());
    for seed in seeds.all() {
        match value(seed) {
            // Left out, it would make a mean over fewer seeds than were asked for.
            Ok(value) if value.is_nan() => return (Err(format!("seed {seed} gives nan")), None),
            Ok(value) => values.push(value),
            Err(why) => return (Err(format!("seed {seed}: {why}")), None),
        }
    }
    let spread = Spread::of(values.into_iter());
    (Ok(spread.mean), Some(spread))
}

fn find(scene: &Scene, runs: &BTreeMap<u64, Result<Run, String>>, expect: &Expect) -> Finding {
    let of = |seed: u64| match runs.get(&seed) {
        Some(Ok(run)) => value(&scene.stages, &run.recording, expect),
        Some(Err(why)) => Err(why.clone()),
        None => Err("it was not run".into()),
    };
    let (value, spread) = match expect.seeds {
        None => (of(scene.seed), None),
        Some(seeds) => mean(seeds, of),
    };
    let what = match expect.seeds {
        None => expect.text.clone(),
        Some(seeds) => format!("mean over seeds {seeds} of {}", expect.text),
    };
    let inside =
        |value: f64, middle: f64, band: Band| (value - middle).abs() <= width(band, middle);
    let (verdict, reason) = match (&value, &expect.differs) {
        // What the source says, also where we had not hoped for it.
        (Ok(value), differs) if inside(*value, expect.value, expect.within) => {
            let gone = differs
                .as_ref()
                .map(|_| "the difference that is explained is not there");
            (Verdict::Pass, gone.unwrap_or_default().to_owned())
        }
        (Ok(value), Some(differs)) if inside(*value, differs.ours, differs.within) => (
            Verdict::Differs,
            format!("ours {:?}: {}", differs.ours, differs.reason),
        ),
        (Err(_), _) | (Ok(_), None) => (Verdict::Fail, String::new()),
        (Ok(_), Some(differs)) => (
            Verdict::Fail,
            format!(
                "nor our own {:?} ± {:?}",
                differs.ours,
                width(differs.within, differs.ours)
            ),
        ),
    };
    Finding {
        stage: expect.stage.clone().unwrap_or_default(),
        what,
        value,
        spread,
        expected: expect.value,
        band: width(expect.within, expect.value),
        source: expect.source.clone(),
        verdict,
        reason,
    }
}

fn width(band: Band, middle: f64) -> f64 {
    match band {
        Band::Absolute(width) => width,
        Band::Relative(part) => part * middle.abs(),
    }
}

/// The findings as CSV, in the units of what is measured.
pub fn csv(outcomes: &[Outcome]) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let mut write = |cells: [&str; 13]| {
        // A Vec takes every row.
        drop(writer.write_record(cells));
    };
    write([
        "preset", "stage", "what", "value", "expected", "within", "verdict", "source", "remark",
        "seeds", "sd", "min", "max",
    ]);
    for outcome in outcomes {
        let preset = outcome.preset.as_str();
        for finding in &outcome.findings {
            let real = |number: f64| Cell::Real(number).text().into_owned();
            let (value, remark) = match &finding.value {
                Ok(value) => (*value, &finding.reason),
                Err(why) => (f64::NAN, why),
            };
            let [sd, min, max] = finding
                .spread
                .map_or([f64::NAN; 3], |s| [s.sd, s.min, s.max])
                .map(real);
            write([
                preset,
                &finding.stage,
                &finding.what,
                &real(value),
                &real(finding.expected),
                &real(finding.band),
                finding.verdict.word(),
                &finding.source,
                remark,
                &finding.spread.map_or(1, |s| s.n).to_string(),
                &sd,
                &min,
                &max,
            ]);
        }
        let mut fail = |stage: &str, what: &str, remark: &str| {
            let verdict = Verdict::Fail.word();
            write([
                preset, stage, what, "nan", "nan", "nan", verdict, "", remark, "nan", "nan", "nan",
                "nan",
            ]);
        };
        for stage in &outcome.cut_short {
            fail(
                stage,
                "its condition",
                "it held in no cycle before max_cycles",
            );
        }
        if let Some(failure) = &outcome.failure {
            fail("", "the run", failure);
        }
    }
    writer.into_inner().unwrap_or_default()
}
