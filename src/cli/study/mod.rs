//! `ballast study`: speed against error.

mod limits;
mod progress;
mod report;

use std::path::{Path, PathBuf};

use super::output::{complain, load, print, reject, tell};
use super::sample::with_sample;
use super::{BAD_INPUT, FAILED, Study};
use crate::record::interrupt::Interrupt;
use crate::record::whole_file;
use crate::scene::{Scene, elements};
use crate::study::outcome::Outcome;
use crate::study::plan::{NoPlan, Plan};
use crate::study::{picture, table};
use progress::Progress;

/// Carries a study out; answers the exit status.
pub(super) fn study(options: &Study) -> u8 {
    let Some(scene) = load(&options.preset, &overrides(options)) else {
        return BAD_INPUT;
    };
    // Before signals are caught: nothing is lost while it is prepared.
    let scene = match with_sample(scene, usize::from(options.threads), options.quiet) {
        Ok(scene) => scene,
        Err(status) => return status,
    };
    let Ok(interrupt) = Interrupt::install() else {
        complain("signals cannot be caught");
        return FAILED;
    };
    if options.stability {
        return limits::limits(options, &scene, &interrupt);
    }
    let stem = stem(options, &scene);
    let mut files = files(&stem);
    for path in &files {
        if let Err(error) = whole_file::probe(path) {
            complain(&error.to_string());
            return FAILED;
        }
    }
    let plan = match Plan::of(scene) {
        Ok(plan) => plan,
        Err(why) => return refused(&why),
    };
    let mut progress = Progress::new(options.quiet);
    let threads = usize::from(options.threads);
    let outcome = Outcome::of(plan, threads, &mut |beat| {
        progress.show(&beat);
        interrupt.caught().is_none()
    });
    progress.clear();
    let outcome = match outcome {
        Ok(outcome) => outcome,
        Err(error) => {
            complain(&error.to_string());
            return FAILED;
        }
    };
    let signal = interrupt.caught();
    if let Some(signal) = signal {
        tell(&format!("{}: what was not run is left out", signal.name));
        // A whole study is worth more than a part of one.
        if files.iter().any(|path| path.exists()) {
            files = self::files(&with_more(&stem, "-partial"));
        }
    }
    let printed = print(&report::report(&outcome));
    let [csv, svg] = &files;
    let written = write(&outcome, csv, svg, options.quiet);
    match signal {
        Some(signal) => signal.exit_status(),
        None if printed != 0 => printed,
        None if outcome.has_reference => written,
        None => FAILED,
    }
}

/// Options of the command line as keys of the preset, where they are checked.
fn overrides(options: &Study) -> Vec<String> {
    let quoted = |text: &str| toml::Value::from(text).to_string();
    let list = |key: &str, values: Vec<String>| {
        let set = !values.is_empty();
        set.then(|| format!("study.{key}=[{}]", values.join(", ")))
    };
    let numbers = |values: &[f64]| values.iter().map(|x| format!("{x:?}")).collect();
    let texts = |values: &[String]| values.iter().map(|text| quoted(text)).collect();
    let questions = options.questions.iter().flat_map(|text| elements(text));
    let mut all = options.set.clone();
    all.extend(list("frac", numbers(&options.frac)));
    all.extend(list("law", texts(&options.law)));
    all.extend(list("sweep", texts(&options.sweep)));
    all.extend(list("for", questions.map(quoted).collect()));
    let reference = options.reference.as_deref();
    all.extend(reference.map(|run| format!("study.reference={}", quoted(run))));
    all.extend(
        options
            .within
            .map(|bound| format!("study.within={bound:?}")),
    );
    all
}

/// The files' path without its ending.
fn stem(options: &Study, scene: &Scene) -> PathBuf {
    let Some(given) = &options.output else {
        return PathBuf::from(format!("{}-study", scene.name));
    };
    match given.extension().and_then(|ending| ending.to_str()) {
        Some("csv" | "svg") => given.with_extension(""),
        _ => given.clone(),
    }
}

/// Table and picture.
fn files(stem: &Path) -> [PathBuf; 2] {
    [".csv", ".svg"].map(|ending| with_more(stem, ending))
}

/// Names may hold full stops: `sphere-0.3` is no `sphere-0` with an ending.
fn with_more(stem: &Path, more: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(more);
    PathBuf::from(name)
}

/// Says why there is nothing to run; answers the exit status.
fn refused(why: &NoPlan) -> u8 {
    match why {
        NoPlan::Rejected(rejection) => {
            reject(rejection);
            BAD_INPUT
        }
        NoPlan::Refused(why) => {
            complain(why);
            BAD_INPUT
        }
        NoPlan::Failed(error) => {
            complain(&error.to_string());
            FAILED
        }
    }
}

/// Writes the files; answers the exit status.
fn write(outcome: &Outcome, csv: &Path, svg: &Path, quiet: bool) -> u8 {
    let (picture, left_out) = match picture::svg(outcome) {
        Ok(drawn) => drawn,
        Err(error) => {
            complain(&format!("{}: cannot be drawn: {error}", svg.display()));
            return FAILED;
        }
    };
    let files = [(csv, table::csv(outcome)), (svg, picture.into_bytes())];
    for (path, bytes) in files {
        if let Err(error) = whole_file::write(path, &bytes) {
            complain(&error.to_string());
            return FAILED;
        }
    }
    if !quiet {
        let missing = match left_out {
            0 => String::new(),
            1 => " (without one variant that has no error above 0)".into(),
            n => format!(" (without {n} variants that have no error above 0)"),
        };
        tell(&format!(
            "wrote {} and {}{missing}",
            csv.display(),
            svg.display()
        ));
    }
    0
}
