//! A preset against its `[[expect]]`.

use crate::record::number::Cell;
use crate::scene::{Band, Expect, Scene};
use crate::session::{Budget, Options, Progress, RunError, Session};

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
    /// What came out, or why nothing did.
    pub value: Result<f64, String>,
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

/// Runs a scene to its end and measures its expectations. `beat` is called between batches; false
/// ends the run early.
pub fn verify(
    scene: Scene,
    threads: usize,
    beat: &mut dyn FnMut(&Session) -> bool,
) -> Result<Outcome, RunError> {
    let mut session = Session::open(
        scene,
        Options {
            threads,
            ..Options::default()
        },
    )?;
    let budget = Budget {
        time: Some(std::time::Duration::from_millis(100)),
        ..Budget::default()
    };
    while session.advance(budget, false)? != Progress::Finished {
        if !beat(&session) {
            break;
        }
    }
    session.finish()?;
    let findings = session
        .scene()
        .expects
        .iter()
        .map(|expect| find(&session, expect))
        .collect();
    Ok(Outcome {
        preset: session.scene().name.clone(),
        findings,
        cut_short: session.cut_short().to_vec(),
        failure: None,
        cycles: session.world().cycle_number(),
    })
}

fn find(session: &Session, expect: &Expect) -> Finding {
    let recording = session.recording();
    let stages = &session.scene().stages;
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
    let value = expect
        .what
        .value(rows.len(), &mut |row, term| recording.term(rows[row], term));
    let inside =
        |value: f64, middle: f64, band: Band| (value - middle).abs() <= width(band, middle);
    let (verdict, reason) = match (&value, &expect.differs) {
        (Ok(value), None) if inside(*value, expect.value, expect.within) => {
            (Verdict::Pass, String::new())
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
        what: expect.text.clone(),
        value,
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
    let mut write = |cells: [&str; 9]| {
        // A Vec takes every row.
        drop(writer.write_record(cells));
    };
    write([
        "preset", "stage", "what", "value", "expected", "within", "verdict", "source", "remark",
    ]);
    for outcome in outcomes {
        let preset = outcome.preset.as_str();
        for finding in &outcome.findings {
            let real = |number: f64| Cell::Real(number).text().into_owned();
            let (value, remark) = match &finding.value {
                Ok(value) => (*value, &finding.reason),
                Err(why) => (f64::NAN, why),
            };
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
            ]);
        }
        let mut fail = |stage: &str, what: &str, remark: &str| {
            let verdict = Verdict::Fail.word();
            write([
                preset, stage, what, "nan", "nan", "nan", verdict, "", remark,
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
