//! `ballast verify`: presets against their expectations.

use std::fmt::Write;
use std::path::Path;
use std::time::{Duration, Instant};

use super::aligned::aligned;
use super::check::duration;
use super::crowd::Crowd;
use super::output::{coloured, complain, load, print, tell, unopened};
use super::{BAD_INPUT, FAILED, Verify};
use crate::record::interrupt::Interrupt;
use crate::record::whole_file;
use crate::scene::Scene;
use crate::scene::catalogue::PRESETS;
use crate::session::figure::figure;
use crate::session::start::{is_ready, is_same, preparation};
use crate::session::{Options, RunError, Session};
use crate::study::trial::Trial;
use crate::study::verify::{Finding, Outcome, Verdict, csv, seeds, verify as measure};

/// Some expectation failed.
const NOT_VERIFIED: u8 = 3;

/// Without names, presets are run that take less than this in all [s].
const BARE: f64 = 600.0;

/// What the presets marked `quick` take of it, all together [s]: the tests hold them to that.
const QUICK: f64 = 90.0;

/// Runs them; answers the exit status.
pub(super) fn verify(options: &Verify) -> u8 {
    let Ok(interrupt) = Interrupt::install() else {
        complain("signals cannot be caught");
        return FAILED;
    };
    if let Some(Err(error)) = table_file(options).map(whole_file::probe) {
        complain(&error.to_string());
        return FAILED;
    }
    // All are read before the first runs.
    let Some(scenes) = chosen(options) else {
        return BAD_INPUT;
    };
    let to_stdout = options.csv.as_deref() == Some(Path::new("-"));
    let colour = coloured(&std::io::stdout());
    let mut outcomes = Vec::new();
    let mut signal = None;
    for scene in scenes {
        let name = scene.name.clone();
        let start = Instant::now();
        let crowd = Crowd::new(&name, seeds(&scene), None, false);
        let outcome = measure(&scene, usize::from(options.threads), &|session| {
            if session.scene().name == name {
                crowd.show(session);
            } else {
                crowd.prepare(session.scene().seed, session);
            }
            interrupt.caught().is_none()
        });
        crowd.clear();
        signal = interrupt.caught();
        if let Some(signal) = signal {
            complain(&format!("{} while verifying {name}", signal.name));
            break;
        }
        let outcome = match outcome {
            Ok(outcome) => outcome,
            Err(error @ RunError::Rejected(_)) => return unopened(&error),
            Err(error) => Outcome::failed(&name, &error),
        };
        if !to_stdout {
            let printed = print(&(table(&outcome, start.elapsed(), colour) + "\n"));
            if printed != 0 {
                return printed;
            }
        }
        outcomes.push(outcome);
    }
    let concluded = conclude(&outcomes, options);
    signal.map_or(concluded, crate::record::interrupt::Signal::exit_status)
}

/// The presets to run; `None` after saying what is wrong with one.
fn chosen(options: &Verify) -> Option<Vec<Scene>> {
    let bare = options.presets.is_empty();
    let names: Vec<&str> = if bare || options.all {
        PRESETS.iter().map(|preset| preset.name).collect()
    } else {
        options.presets.iter().map(String::as_str).collect()
    };
    let mut scenes = Vec::new();
    for name in names {
        let scene = load(name, &options.set)?;
        if scene.expects.is_empty() && !bare {
            complain(&format!(
                "{name} has no [[expect]], so there is nothing to verify; say in it what must come \
                 out"
            ));
            return None;
        }
        scenes.push(scene);
    }
    if bare && !options.all {
        scenes = affordable(scenes, usize::from(options.threads));
    }
    Some(scenes)
}

/// Those that take less than ten minutes in all; says which are left out.
fn affordable(scenes: Vec<Scene>, threads: usize) -> Vec<Scene> {
    let mut left = BARE - QUICK;
    let (mut kept, mut prepared) = (Vec::new(), Vec::new());
    for scene in scenes {
        if scene.about.quick {
            kept.push(scene);
            continue;
        }
        let runs = seeds(&scene).len();
        let rounds = runs.div_ceil(threads.clamp(1, runs)) as f64;
        let estimate = estimate(&scene, runs, &prepared);
        let seconds = estimate.as_ref().map(|(seconds, _)| rounds * seconds);
        match (seconds, estimate) {
            (Some(seconds), Some((_, sample))) if seconds <= left => {
                left -= seconds;
                prepared.extend(sample);
                kept.push(scene);
            }
            _ => {
                let long = seconds.map_or("nobody knows how long".into(), duration);
                let name = &scene.name;
                tell(&format!(
                    "left out: {name} ({long}); `ballast verify {name}` and --all run it"
                ));
            }
        }
    }
    kept
}

/// Time that a run takes [s], with that of its sample where neither the cache has it for every seed nor a
/// run before this one prepares it; and the run that prepares it then. None if nobody knows: then
/// nothing is prepared to find out.
fn estimate(scene: &Scene, runs: usize, prepared: &[Scene]) -> Option<(f64, Option<Scene>)> {
    let options = Options::default();
    let sample = preparation(scene).ok()?;
    let Some(sample) = sample.filter(|_| runs > 1 || !is_ready(scene, &options)) else {
        let trial = Trial::of(Session::open(scene.clone(), options).ok()?);
        return Some((trial.estimate()?, None));
    };
    if !is_ready(&sample, &options) {
        return None;
    }
    let trial = Trial::of(Session::open(sample.clone(), options).ok()?);
    let own: Option<u64> = scene.stages.iter().map(|stage| stage.max_cycles).sum();
    let own = own? as f64 / trial.rate();
    let shared = |other: &Scene| runs == 1 && is_same(other, &sample, &options);
    if prepared.iter().any(shared) {
        return Some((own, None));
    }
    Some((trial.estimate()? + own, Some(sample)))
}

/// Counts, the file, the exit status.
fn conclude(outcomes: &[Outcome], options: &Verify) -> u8 {
    let count = |verdict| -> usize { outcomes.iter().map(|o| o.count(verdict)).sum() };
    let [good, differing, bad] = [Verdict::Pass, Verdict::Differs, Verdict::Fail].map(count);
    let printed = match options.csv.as_deref() {
        Some(path) if path == Path::new("-") => print(&String::from_utf8_lossy(&csv(outcomes))),
        _ => print(&format!("{good} PASS, {differing} DIFFERS, {bad} FAIL\n")),
    };
    if let Some(path) = table_file(options)
        && let Err(error) = whole_file::write(path, &csv(outcomes))
    {
        complain(&error.to_string());
        return FAILED;
    }
    match (bad, printed) {
        (0, printed) => printed,
        _ => NOT_VERIFIED,
    }
}

/// The file that gets the table as CSV, if one does.
fn table_file(options: &Verify) -> Option<&Path> {
    options
        .csv
        .as_deref()
        .filter(|path| *path != Path::new("-"))
}

/// One line per expectation with its figures, and one with its source.
fn table(outcome: &Outcome, elapsed: Duration, colour: bool) -> String {
    let mut text = format!(
        "{} ({} cycles, {:.2} s)\n",
        outcome.preset,
        outcome.cycles,
        elapsed.as_secs_f64()
    );
    let head = ["stage", "value", "expected", "off by", "within", "what"];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    rows.extend(outcome.findings.iter().map(figures));
    if let Some(failure) = &outcome.failure {
        let _ = writeln!(text, "  {}  {failure}", shown(Verdict::Fail, colour));
        return text;
    }
    let lines = aligned(&rows, 1, 5);
    let _ = writeln!(text, "  {:7}  {}", "verdict", lines[0]);
    for (finding, line) in outcome.findings.iter().zip(&lines[1..]) {
        let _ = writeln!(text, "  {}  {line}", shown(finding.verdict, colour));
        let mut remark = |remark: &str| {
            if !remark.is_empty() {
                let _ = writeln!(text, "  {:7}  {remark}", "");
            }
        };
        if let Err(why) = &finding.value {
            remark(why);
        }
        if let Some(spread) = &finding.spread {
            remark(&format!(
                "{} seeds: standard deviation {}, from {} to {}",
                spread.n,
                figure(spread.sd),
                figure(spread.min),
                figure(spread.max)
            ));
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

fn figures(finding: &Finding) -> Vec<String> {
    let (value, off) = match &finding.value {
        Ok(value) => (figure(*value), figure((value - finding.expected).abs())),
        Err(_) => ("-".into(), "-".into()),
    };
    let stage = match finding.stage.as_str() {
        "" => "(all)".to_owned(),
        stage => stage.to_owned(),
    };
    vec![
        stage,
        value,
        figure(finding.expected),
        off,
        figure(finding.band),
        finding.what.clone(),
    ]
}

/// A verdict, seven characters wide, coloured on a terminal.
fn shown(verdict: Verdict, colour: bool) -> String {
    let word = verdict.word();
    let code = match verdict {
        Verdict::Pass => 32,
        Verdict::Differs => 33,
        Verdict::Fail => 31,
    };
    if colour {
        format!("\x1b[{code}m{word:7}\x1b[0m")
    } else {
        format!("{word:7}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_presets_are_left_to_those_who_ask_for_them() {
        let kept = |set: &[&str]| {
            let set: Vec<String> = set.iter().map(|option| (*option).to_owned()).collect();
            let scene = Scene::load("square-lattice", &set).unwrap();
            affordable(vec![scene], 1).len()
        };
        // Ten thousand million cycles take hours on any machine.
        let long = "stage.nudge.max_cycles=10_000_000_000";
        assert_eq!(kept(&[]), 1);
        assert_eq!(kept(&["about.quick=false"]), 1);
        assert_eq!(kept(&["about.quick=false", long]), 0);
        // A mark is a promise that the tests hold.
        assert_eq!(kept(&[long]), 1);
        let text = Scene::load("square-lattice", &[]).unwrap().text;
        let text = text.replace("max_cycles = 5000", "until = \"kinetic > 1\"");
        let scene = Scene::parse("endless", &text, &["about.quick=false".to_owned()]).unwrap();
        assert!(affordable(vec![scene], 1).is_empty());
    }

    #[test]
    fn a_sample_counts_once_for_all_who_start_from_it() {
        let scene = |seed: u64| {
            // Nobody else prepares this one, so the cache does not have it.
            let set = [
                "stage.shear.max_cycles=1000".into(),
                format!("model.seed={seed}"),
            ];
            Scene::load("constant-mean-stress", &set).expect("it is embedded")
        };
        let (first, sample) = estimate(&scene(918_273), 1, &[]).expect("its stages end");
        let prepared = [sample.expect("it has to be prepared")];
        // A thousand cycles of its own, against at most nine hundred thousand of the sample.
        let (second, sample) = estimate(&scene(918_273), 1, &prepared).expect("its stages end");
        assert!(sample.is_none() && second < 0.1 * first, "{second} {first}");
        // Another seed is another sample, and so are several.
        let (other, sample) = estimate(&scene(918_274), 1, &prepared).expect("its stages end");
        assert!(sample.is_some() && second < 0.1 * other, "{second} {other}");
        let (several, sample) = estimate(&scene(918_273), 2, &prepared).expect("its stages end");
        assert!(
            sample.is_some() && second < 0.1 * several,
            "{second} {several}"
        );
    }
}
