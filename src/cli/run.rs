//! `ballast run`: a preset or a journal, from beginning to end or from a checkpoint.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::Run;
use super::output::{complain, load, tell};
use super::progress::Progress;
use super::{BAD_INPUT, FAILED};
use crate::record::history::History;
use crate::record::interrupt::{Interrupt, Signal};
use crate::record::journal::{EventKind, Journal, looks_like_journal};
use crate::scene::Scene;
use crate::session::{Budget, Options, Progress as Reached, Replay, Resumed, RunError, Session};

/// Cycles run for so long between looks at signals, progress and the checkpoint clock.
const BATCH: Duration = Duration::from_millis(50);

/// With `--csv FILE` a checkpoint is kept beside it this often unless `--every` says otherwise.
const USUAL: Duration = Duration::from_secs(60);

/// How the run ended.
enum End {
    Done,
    Signal(Signal),
    Failed(RunError),
}

/// A session ready to run.
struct Prepared {
    session: Session,
    replay: Option<Replay>,
    /// Bytes of the CSV file to keep.
    position: Option<u64>,
    resumed: bool,
}

/// Runs it; answers the exit status.
pub(super) fn run(options: &Run) -> u8 {
    let interrupt = match Interrupt::install() {
        Ok(interrupt) => interrupt,
        Err(error) => {
            complain(&format!("signals cannot be caught: {error}"));
            return FAILED;
        }
    };
    let mut prepared = match prepare(options) {
        Ok(prepared) => prepared,
        Err(status) => return status,
    };
    if let Err(error) = open_files(&mut prepared, options) {
        complain(&error.to_string());
        return FAILED;
    }
    let mut progress = Progress::new(&prepared.session, options.cycles, options.quiet);
    let end = drive(&mut prepared, options, &interrupt, &mut progress);
    progress.clear();
    for notice in prepared.session.take_notices() {
        tell(&notice);
    }
    conclude(&mut prepared.session, options, end, &progress)
}

fn prepare(options: &Run) -> Result<Prepared, u8> {
    let mut set = options.set.clone();
    set.extend(options.seed.map(|seed| format!("model.seed={seed}")));
    if let Some(path) = &options.resume {
        return resume(path, options, &set);
    }
    let name = options.preset.as_deref().unwrap_or_default();
    let (scene, replay) = match journal(name)? {
        None => (load(name, &set).ok_or(BAD_INPUT)?, None),
        Some(journal) => {
            let mut overrides = journal.overrides.clone();
            overrides.extend(set);
            let parsed = Scene::parse(&journal.preset_name, &journal.preset_text, &overrides);
            let scene = parsed.map_err(|rejection| {
                super::output::reject(&rejection);
                BAD_INPUT
            })?;
            (scene, Some(Replay::new(&journal)))
        }
    };
    if scene.stages.is_empty() && options.cycles.is_none() && replay.is_none() {
        complain(&format!(
            "{name} has no [[stage]]; say how far to run with --cycles N"
        ));
        return Err(BAD_INPUT);
    }
    let threads = usize::from(options.threads);
    let opened = Session::open(
        scene,
        Options {
            threads,
            ..Options::default()
        },
    );
    let session = opened.map_err(|error| {
        complain(&error.to_string());
        FAILED
    })?;
    Ok(Prepared {
        session,
        replay,
        position: None,
        resumed: false,
    })
}

/// The journal of this path, if it is one.
fn journal(path: &str) -> Result<Option<Journal>, u8> {
    let Ok(text) = std::fs::read_to_string(path) else {
        return Ok(None);
    };
    if !looks_like_journal(&text) {
        return Ok(None);
    }
    let journal = Journal::parse(&text).map_err(|error| {
        complain(&format!("{path}: {error}"));
        BAD_INPUT
    })?;
    if journal.cut {
        tell(&format!("{path}: the last line is cut off and left out"));
    }
    Ok(Some(journal))
}

fn resume(path: &Path, options: &Run, set: &[String]) -> Result<Prepared, u8> {
    let threads = usize::from(options.threads);
    let Resumed { session, position } = Session::resume(path, threads).map_err(|error| {
        complain(&error.to_string());
        BAD_INPUT
    })?;
    if !set.is_empty() && set != session.scene().overrides {
        complain(&format!(
            "{}: a resumed run keeps its preset; leave --set and --seed out, or start anew",
            path.display()
        ));
        return Err(BAD_INPUT);
    }
    if let Some(name) = &options.preset {
        let scene = load(name, &session.scene().overrides).ok_or(BAD_INPUT)?;
        if scene.text != session.scene().text {
            complain(&format!(
                "{}: it is of preset {}, and {name} is another; leave the preset out",
                path.display(),
                session.scene().name
            ));
            return Err(BAD_INPUT);
        }
    }
    Ok(Prepared {
        session,
        replay: None,
        position,
        resumed: true,
    })
}

/// Creates the CSV and the journal beside it.
fn open_files(prepared: &mut Prepared, options: &Run) -> Result<(), RunError> {
    let Some(csv) = &options.csv else {
        return Ok(());
    };
    let session = &mut prepared.session;
    let names = session.recording().names();
    let history = match prepared.position {
        _ if csv.as_os_str() == "-" => History::to_stdout(&names)?,
        Some(position) if prepared.resumed && csv.exists() => {
            History::resume(csv, &names, position)?
        }
        _ => History::create(csv, &names)?,
    };
    session.write_history(history);
    if csv.as_os_str() != "-" {
        session.write_journal(&csv.with_extension("journal"))?;
    }
    Ok(())
}

/// Runs until the end, whatever it is.
fn drive(
    prepared: &mut Prepared,
    options: &Run,
    interrupt: &Interrupt,
    progress: &mut Progress,
) -> End {
    let Prepared {
        session, replay, ..
    } = prepared;
    let (keep, period) = checkpoint(options);
    let mut last = Instant::now();
    let free = session.scene().stages.is_empty();
    let mut batch = if period.is_some_and(|period| period < BATCH) {
        period.unwrap_or(BATCH)
    } else {
        BATCH
    };
    // A very small period means a checkpoint at every look.
    batch = batch.max(Duration::from_millis(1));
    loop {
        if let Some(signal) = interrupt.caught() {
            return End::Signal(signal);
        }
        let budget = Budget {
            until_cycle: options.cycles,
            time: Some(batch),
        };
        let reached = match replay {
            Some(replay) => session.advance_replay(replay, budget),
            None => session.advance(budget, free),
        };
        match reached {
            Err(error) => return End::Failed(error),
            Ok(Reached::Finished) => return End::Done,
            Ok(Reached::Budget | Reached::ErrandDone) => {}
        }
        if options
            .cycles
            .is_some_and(|cycles| session.world().cycle_number() >= cycles)
        {
            return End::Done;
        }
        if let (Some(keep), Some(period)) = (&keep, period)
            && last.elapsed() >= period
        {
            if let Err(error) = session.save(keep) {
                return End::Failed(error);
            }
            last = Instant::now();
        }
        progress.show(session);
    }
}

/// Where checkpoints are kept, and how often they are written.
fn checkpoint(options: &Run) -> (Option<PathBuf>, Option<Duration>) {
    let beside = options
        .csv
        .as_ref()
        .filter(|csv| csv.as_os_str() != "-")
        .map(|csv| csv.with_extension("ballast"));
    let keep = options.checkpoint.clone().or(beside);
    let period = options.every.map(Duration::from_secs_f64).unwrap_or(USUAL);
    (keep.clone(), keep.map(|_| period))
}

/// Saves what there is to save and says how it went.
fn conclude(session: &mut Session, options: &Run, end: End, progress: &Progress) -> u8 {
    let (keep, _) = checkpoint(options);
    match end {
        End::Done => {
            let kept = keep.map_or(Ok(()), |keep| session.save(&keep));
            match kept.and_then(|()| session.finish()) {
                Ok(()) => {
                    if !options.quiet {
                        tell(&summary(session, progress.elapsed()));
                    }
                    0
                }
                Err(error) => failed(session, options, &error),
            }
        }
        End::Signal(signal) => {
            let path = keep.unwrap_or_else(|| home(session, "ballast"));
            let saved = session.flush().and_then(|()| session.save(&path));
            match saved.and_then(|()| keep_journal(session, options)) {
                Ok(()) => {
                    let cycle = session.world().cycle_number();
                    tell(&format!(
                        "{} at cycle {cycle}: everything is saved; go on with\n  {}",
                        signal.name,
                        resume_line(&path, options)
                    ));
                    signal.exit_status()
                }
                Err(error) => {
                    complain(&error.to_string());
                    signal.exit_status()
                }
            }
        }
        End::Failed(error) => failed(session, options, &error),
    }
}

/// The run cannot go on: keeps everything recorded and the last good state.
fn failed(session: &mut Session, options: &Run, error: &RunError) -> u8 {
    if let RunError::Record(record) = error
        && record.is_closed_pipe()
    {
        // Whoever read the rows has had enough of them.
        return 0;
    }
    complain(&error.to_string());
    let path = checkpoint(options)
        .0
        .unwrap_or_else(|| home(session, "ballast"));
    let state = match error {
        RunError::Fault(_) => session.save_safe(&path),
        _ => session.save(&path).map(|()| true),
    };
    let told = state.and_then(|kept| {
        keep_journal(session, options)?;
        session.flush()?;
        Ok(kept)
    });
    match told {
        Ok(true) => tell(&format!(
            "rows so far are kept; {} holds the last good state, go on with\n  {}",
            path.display(),
            resume_line(&path, options)
        )),
        Ok(false) => tell("rows so far are kept; the run failed in its first stage, so start anew"),
        Err(error) => complain(&error.to_string()),
    }
    FAILED
}

/// The journal is beside the CSV already; without one it goes to the current folder.
fn keep_journal(session: &mut Session, options: &Run) -> Result<(), RunError> {
    if options
        .csv
        .as_ref()
        .is_none_or(|csv| csv.as_os_str() == "-")
    {
        session.write_journal(&home(session, "journal"))?;
    }
    Ok(())
}

fn home(session: &Session, ending: &str) -> PathBuf {
    PathBuf::from(format!("{}.{ending}", session.scene().name))
}

fn resume_line(path: &Path, options: &Run) -> String {
    let csv = options
        .csv
        .as_ref()
        .map_or_else(String::new, |csv| format!(" --csv {}", csv.display()));
    format!("ballast run --resume {}{csv}", path.display())
}

fn summary(session: &Session, elapsed: Duration) -> String {
    let world = session.world();
    let rows = session.recording().rows().len();
    let mut text = format!(
        "{} cycles, {:.6e} s simulated, {rows} rows, {:.2} s",
        world.cycle_number(),
        world.time(),
        elapsed.as_secs_f64()
    );
    let monitor = world.fracc_monitor();
    if let Some((cycle, particle, fracc)) = monitor.worst {
        text.push_str(&format!(
            "\nFRACC above 0.3 in {} cycles, worst {fracc:.3} at cycle {cycle} by particle \
             {particle}; consider a smaller frac",
            monitor.warnings
        ));
    }
    let commands = session.journal().events.iter();
    let stages = commands
        .filter(|event| matches!(event.kind, EventKind::Stage(_)))
        .count();
    if stages > 0 {
        text.push_str(&format!("\n{stages} stages done"));
    }
    text
}
