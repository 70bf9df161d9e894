//! `ballast verify`: presets against their expectations.

use std::fmt::Write;
use std::time::{Duration, Instant};

use super::output::{coloured, complain, load, print};
use super::progress::Progress;
use super::{BAD_INPUT, FAILED, Verify};
use crate::record::interrupt::Interrupt;
use crate::scene::catalogue::PRESETS;
use crate::session::figure::figure;
use crate::study::verify::{Finding, Outcome, Verdict, verify as measure};

/// Some expectation failed.
const NOT_VERIFIED: u8 = 3;

/// Runs them; answers the exit status.
pub(super) fn verify(options: &Verify) -> u8 {
    let names: Vec<String> = if options.presets.is_empty() || options.all {
        PRESETS
            .iter()
            .map(|preset| preset.name.to_owned())
            .collect()
    } else {
        options.presets.clone()
    };
    let Ok(interrupt) = Interrupt::install() else {
        complain("signals cannot be caught");
        return FAILED;
    };
    // All are read before the first runs.
    let mut scenes = Vec::new();
    for name in &names {
        let Some(scene) = load(name, &options.set) else {
            return BAD_INPUT;
        };
        if scene.expects.is_empty() && !options.presets.is_empty() {
            complain(&format!(
                "{name} has no [[expect]], so there is nothing to verify; say in it what must come out"
            ));
            return BAD_INPUT;
        }
        scenes.push(scene);
    }
    let colour = coloured(&std::io::stdout());
    let (mut good, mut differing, mut bad) = (0, 0, 0);
    for scene in scenes {
        let name = scene.name.clone();
        let start = Instant::now();
        let mut progress: Option<Progress> = None;
        let outcome = measure(scene, usize::from(options.threads), &mut |session| {
            progress
                .get_or_insert_with(|| Progress::new(session, None, false))
                .show(session);
            interrupt.caught().is_none()
        });
        if let Some(progress) = &mut progress {
            progress.clear();
        }
        if let Some(signal) = interrupt.caught() {
            complain(&format!("{} while verifying {name}", signal.name));
            return signal.exit_status();
        }
        let text = match outcome {
            Ok(outcome) => {
                let count = |v: Verdict| outcome.findings.iter().filter(|f| f.verdict == v).count();
                good += count(Verdict::Pass);
                differing += count(Verdict::Differs);
                bad += count(Verdict::Fail) + outcome.cut_short.len();
                table(&outcome, start.elapsed(), colour)
            }
            Err(error) => {
                bad += 1;
                format!("{name}\n  {} {error}\n", shown(Verdict::Fail, colour))
            }
        };
        let printed = print(&(text + "\n"));
        if printed != 0 {
            return printed;
        }
    }
    let printed = print(&format!("{good} PASS, {differing} DIFFERS, {bad} FAIL\n"));
    match (bad, printed) {
        (0, printed) => printed,
        _ => NOT_VERIFIED,
    }
}

/// One line per expectation with its figures, and one with its source.
fn table(outcome: &Outcome, elapsed: Duration, colour: bool) -> String {
    let mut text = format!(
        "{} ({} cycles, {:.2} s)\n",
        outcome.preset,
        outcome.cycles,
        elapsed.as_secs_f64()
    );
    let mut rows = vec![["stage", "value", "expected", "off by", "within"].map(str::to_owned)];
    rows.extend(outcome.findings.iter().map(figures));
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max();
    let widths: Vec<usize> = (0..5).map(|k| width(k).unwrap_or(0)).collect();
    let line = |row: &[String; 5]| {
        let mut line = format!("{:w$}", row[0], w = widths[0]);
        for (cell, w) in row.iter().zip(&widths).skip(1) {
            let _ = write!(line, "  {cell:>w$}");
        }
        line
    };
    let _ = writeln!(text, "  {:7}  {}  what", "verdict", line(&rows[0]));
    for (finding, row) in outcome.findings.iter().zip(&rows[1..]) {
        let verdict = shown(finding.verdict, colour);
        let _ = writeln!(text, "  {verdict}  {}  {}", line(row), finding.what);
        let mut remark = |remark: &str| {
            if !remark.is_empty() {
                let _ = writeln!(text, "  {:7}  {remark}", "");
            }
        };
        if let Err(why) = &finding.value {
            remark(why);
        }
        remark(&finding.source);
        remark(&finding.reason);
    }
    for stage in &outcome.cut_short {
        let verdict = shown(Verdict::Fail, colour);
        let _ = writeln!(
            text,
            "  {verdict}  stage {stage} reached max_cycles before its condition held"
        );
    }
    text
}

fn figures(finding: &Finding) -> [String; 5] {
    let (value, off) = match &finding.value {
        Ok(value) => (figure(*value), figure((value - finding.expected).abs())),
        Err(_) => ("-".into(), "-".into()),
    };
    let stage = match finding.stage.as_str() {
        "" => "(all)".to_owned(),
        stage => stage.to_owned(),
    };
    [
        stage,
        value,
        figure(finding.expected),
        off,
        figure(finding.band),
    ]
}

/// A verdict, seven characters wide, coloured on a terminal.
fn shown(verdict: Verdict, colour: bool) -> String {
    let (word, code) = match verdict {
        Verdict::Pass => ("PASS", 32),
        Verdict::Differs => ("DIFFERS", 33),
        Verdict::Fail => ("FAIL", 31),
    };
    if colour {
        format!("\x1b[{code}m{word:7}\x1b[0m")
    } else {
        format!("{word:7}")
    }
}
