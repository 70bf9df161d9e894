//! `ballast run --seeds A..B`: each seed with files of its own, and one file about all of them.

use std::path::{Path, PathBuf};
use std::time::Instant;

use super::files::same;
use super::prepare::foresee;
use super::{Ran, Watched, one};
use crate::cli::crowd::Crowd;
use crate::cli::output::{complain, print, speak_as, tell};
use crate::cli::{BAD_INPUT, FAILED, Run};
use crate::engine::threads::processors;
use crate::record::interrupt::{Interrupt, Signal};
use crate::record::whole_file;
use crate::scene::{Scene, Seeds};
use crate::session::Recording;
use crate::study::ensemble::{each, table::table};

/// What is left of a run.
enum Member {
    /// It came to its end and has rows to tell of.
    Told(Recording),
    /// A signal came before its end. Means of rows that only some seeds reached would look like those of
    /// all.
    Stopped,
    /// It failed and said why.
    Failed,
    /// A signal came before it began.
    Skipped,
}

/// Runs all seeds; answers the exit status.
pub(super) fn run(options: &Run, seeds: Seeds, interrupt: &Interrupt) -> u8 {
    if let Some(refusal) = refusal(options, seeds) {
        complain(&refusal);
        return BAD_INPUT;
    }
    let all: Vec<u64> = seeds.all().collect();
    let scene = match foresee(&member(options, all[0])) {
        Ok(scene) => scene,
        Err(status) => return status,
    };
    if let Some(Err(error)) = file(options).map(whole_file::probe) {
        complain(&error.to_string());
        return FAILED;
    }
    let threads = options.threads.map_or_else(processors, usize::from);
    let start = Instant::now();
    let crowd = Crowd::new(&scene.name, all.clone(), options.cycles, options.quiet);
    let members = each(&all, threads, |seed| {
        if interrupt.caught().is_some() {
            return Member::Skipped;
        }
        speak_as(&format!("seed {seed}"));
        let mut options = member(options, seed);
        options.stem = Some(format!("{}-seed{seed}", scene.name));
        let ran = one(&options, interrupt, &mut |watched| match watched {
            Watched::Preparing(session) => crowd.prepare(seed, session),
            Watched::Going(session) => crowd.show(session),
            Watched::Ended => crowd.ended(seed),
        });
        crowd.ended(seed);
        told(ran, interrupt.caught())
    });
    crowd.clear();
    let written = write(options, &scene, &members);
    if !options.quiet {
        let seconds = start.elapsed().as_secs_f64();
        tell(&summary(options, seeds, &all, &members, seconds));
    }
    let failed = members.iter().any(|run| matches!(run, Member::Failed));
    match interrupt.caught() {
        Some(signal) => signal.exit_status(),
        None if failed => FAILED,
        None => written,
    }
}

/// Why these options go together with no ensemble, and what to do instead.
fn refusal(options: &Run, seeds: Seeds) -> Option<String> {
    if options.resume.is_some() {
        return Some(
            "--resume goes on with one run, and --seeds begins many; go on with each seed by \
             itself: ballast run --resume FILE-seedK.ballast --csv FILE-seedK.csv"
                .into(),
        );
    }
    if options.checkpoint.is_some() {
        return Some(format!(
            "--checkpoint names one file, and the seeds {seeds} need one each; leave it out: with \
             --csv FILE.csv each keeps its last checkpoint in FILE-seedK.ballast"
        ));
    }
    let (Some(csv), Some(preset)) = (file(options), &options.preset) else {
        return None;
    };
    same(csv, Path::new(preset)).then(|| {
        format!(
            "{} would be the input and --csv; give another name",
            csv.display()
        )
    })
}

/// The options that one seed would be run with alone.
fn member(options: &Run, seed: u64) -> Run {
    Run {
        preset: options.preset.clone(),
        csv: file(options).map(|csv| own(csv, seed)),
        set: options.set.clone(),
        seed: Some(seed),
        seeds: None,
        threads: Some(1),
        cycles: options.cycles,
        checkpoint: None,
        every: options.every,
        resume: None,
        quiet: options.quiet,
        no_cache: options.no_cache,
        stem: None,
    }
}

/// `FILE-seedK.csv` beside `FILE.csv`.
fn own(csv: &Path, seed: u64) -> PathBuf {
    let mut name = csv.file_stem().unwrap_or_default().to_owned();
    name.push(format!("-seed{seed}."));
    name.push(csv.extension().unwrap_or("csv".as_ref()));
    csv.with_file_name(name)
}

/// The file about all of them, if there is one.
fn file(options: &Run) -> Option<&Path> {
    let csv = options.csv.as_deref();
    csv.filter(|csv| csv.as_os_str() != "-")
}

fn told(ran: Ran, signal: Option<Signal>) -> Member {
    let stopped = signal.is_some_and(|signal| signal.exit_status() == ran.status);
    match ran.session {
        Some(session) if ran.status == 0 => Member::Told(session.into_recording()),
        Some(_) if stopped => Member::Stopped,
        // Its sample was still being prepared.
        None if stopped => Member::Skipped,
        _ => Member::Failed,
    }
}

/// Writes what there is to tell of all of them; answers the exit status.
fn write(options: &Run, scene: &Scene, members: &[Member]) -> u8 {
    let runs = recordings(members);
    if options.csv.is_none() || runs.is_empty() {
        return 0;
    }
    let stages: Vec<String> = scene
        .stages
        .iter()
        .map(|stage| stage.name.clone())
        .collect();
    let table = table(&stages, &runs);
    match file(options) {
        None => print(&String::from_utf8_lossy(table.bytes())),
        Some(path) => match whole_file::write(path, table.bytes()) {
            Ok(()) => 0,
            Err(error) => {
                complain(&error.to_string());
                FAILED
            }
        },
    }
}

fn recordings(members: &[Member]) -> Vec<&Recording> {
    let told = members.iter().filter_map(|run| match run {
        Member::Told(recording) => Some(recording),
        Member::Stopped | Member::Failed | Member::Skipped => None,
    });
    told.collect()
}

/// How it went, in a few lines.
fn summary(options: &Run, seeds: Seeds, all: &[u64], members: &[Member], seconds: f64) -> String {
    let runs = recordings(members);
    let mut text = format!(
        "seeds {seeds}: {} of {} runs counted",
        runs.len(),
        all.len()
    );
    let named = |wanted: fn(&Member) -> bool| {
        let found = all.iter().zip(members).filter(|(_, run)| wanted(run));
        let names: Vec<String> = found.map(|(seed, _)| seed.to_string()).collect();
        names.join(", ")
    };
    for (what, names) in [
        ("failed", named(|run| matches!(run, Member::Failed))),
        ("stopped", named(|run| matches!(run, Member::Stopped))),
        ("not begun", named(|run| matches!(run, Member::Skipped))),
    ] {
        if !names.is_empty() {
            text += &format!(", {what}: {names}");
        }
    }
    text += &format!(", {seconds:.2} s");
    if let Some(csv) = file(options).filter(|_| !runs.is_empty()) {
        text += &format!(
            "\n{} holds mean, standard deviation, minimum and maximum; each seed is in {}",
            csv.display(),
            own(csv, all[0])
                .display()
                .to_string()
                .replace(&format!("-seed{}.", all[0]), "-seedK.")
        );
    }
    if let Some(csv) = file(options).filter(|csv| runs.is_empty() && csv.exists()) {
        text += &format!("\n{} is left as it was", csv.display());
    }
    if runs.len() > 1 && runs.iter().all(|run| run.rows() == runs[0].rows()) {
        text += "\nall seeds gave the same rows: nothing in this preset is random";
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_seed_has_a_name_of_its_own() {
        for (csv, expected) in [
            ("a.csv", "a-seed7.csv"),
            ("out/a.b.csv", "out/a.b-seed7.csv"),
            ("a", "a-seed7.csv"),
            ("a.txt", "a-seed7.txt"),
        ] {
            assert_eq!(own(Path::new(csv), 7), Path::new(expected));
        }
    }
}
