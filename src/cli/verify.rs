//! `ballast verify`: presets against their expectations.

use std::fmt::Write;

use super::Verify;
use super::output::{complain, load, print};
use super::progress::Progress;
use super::{BAD_INPUT, FAILED};
use crate::record::interrupt::Interrupt;
use crate::scene::catalogue::PRESETS;
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
        scenes.push(scene);
    }
    let (mut good, mut differing, mut bad) = (0, 0, 0);
    for scene in scenes {
        let name = scene.name.clone();
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
        match outcome {
            Ok(outcome) => {
                let count = |v: Verdict| outcome.findings.iter().filter(|f| f.verdict == v).count();
                good += count(Verdict::Pass);
                differing += count(Verdict::Differs);
                bad += count(Verdict::Fail) + outcome.cut_short.len();
                print(&table(&outcome));
            }
            Err(error) => {
                bad += 1;
                print(&format!("{name}\n  FAIL     {error}\n"));
            }
        }
    }
    print(&format!("{good} PASS, {differing} DIFFERS, {bad} FAIL\n"));
    if bad == 0 { 0 } else { NOT_VERIFIED }
}

fn table(outcome: &Outcome) -> String {
    let mut text = format!("{} ({} cycles)\n", outcome.preset, outcome.cycles);
    for finding in &outcome.findings {
        let Finding {
            stage,
            what,
            expected,
            band,
            source,
            reason,
            ..
        } = finding;
        let verdict = match finding.verdict {
            Verdict::Pass => "PASS",
            Verdict::Differs => "DIFFERS",
            Verdict::Fail => "FAIL",
        };
        let value = match &finding.value {
            Ok(value) => format!("{value:.9e}"),
            Err(why) => why.clone(),
        };
        let place = if stage.is_empty() {
            String::new()
        } else {
            format!("{stage}: ")
        };
        let _ = writeln!(text, "  {verdict:8} {place}{what} = {value}");
        let _ = writeln!(
            text,
            "           expected {expected:?} ± {band:.3e}; {source}"
        );
        if !reason.is_empty() {
            let _ = writeln!(text, "           {reason}");
        }
    }
    for stage in &outcome.cut_short {
        let _ = writeln!(
            text,
            "  FAIL     stage {stage} reached max_cycles before its condition"
        );
    }
    text
}
