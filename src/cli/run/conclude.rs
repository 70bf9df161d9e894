//! How a run ended: what is saved, what is said, which exit status.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::files::Files;
use crate::cli::output::{complain, tell};
use crate::cli::{FAILED, Run};
use crate::record::error::RecordError;
use crate::record::interrupt::Signal;
use crate::record::shell_word::shell_word;
use crate::session::{RunError, Session};

/// How the run ended.
pub(super) enum End {
    Done,
    Signal(Signal),
    Failed(RunError),
}

/// Saves what there is to save and says how it went; answers the exit status.
pub(super) fn conclude(
    session: &mut Session,
    options: &Run,
    files: &mut Files,
    end: End,
    elapsed: Duration,
) -> u8 {
    match end {
        End::Done => match finish(session, files) {
            Ok(()) => {
                if !options.quiet {
                    tell(&summary(session, elapsed));
                }
                0
            }
            Err(error) => failed(session, options, files, &error),
        },
        End::Signal(signal) => interrupted(session, options, files, signal),
        End::Failed(error) => failed(session, options, files, &error),
    }
}

/// The checkpoint comes before the last row: a run that goes on from it has no such row there.
fn finish(session: &mut Session, files: &mut Files) -> Result<(), RunError> {
    files.save(session)?;
    session.finish()?;
    files.write_late(session)
}

fn interrupted(session: &mut Session, options: &Run, files: &Files, signal: Signal) -> u8 {
    let path = checkpoint(session, options, files);
    let rows = session.flush().and_then(|()| files.write_late(session));
    let saved = session
        .save_state(&path)
        .and_then(|()| keep_journal(session, options, files));
    if let Err(error) = saved {
        complain(&format!("{} could not be answered in full", signal.name));
        complain(&error.to_string());
        return FAILED;
    }
    // The checkpoint holds the rows too.
    if let Err(error) = rows
        && !is_closed_pipe(&error)
    {
        complain(&error.to_string());
    }
    let cycle = session.world().cycle_number();
    tell(&format!(
        "{} at cycle {cycle}: everything is saved; go on with\n  {}",
        signal.name,
        resume_line(&path, options)
    ));
    signal.exit_status()
}

/// The run cannot go on: keeps everything recorded and the last good state.
fn failed(session: &mut Session, options: &Run, files: &Files, error: &RunError) -> u8 {
    if is_closed_pipe(error) {
        // Whoever read the rows has had enough of them.
        return 0;
    }
    let mut said = vec![error.to_string()];
    complain(&said[0]);
    // What is so of one file twice is said once.
    let mut say = |error: RunError| {
        let text = error.to_string();
        if !said.contains(&text) {
            complain(&text);
            said.push(text);
        }
    };
    let path = checkpoint(session, options, files);
    let kept = match error {
        RunError::Fault(_) => before_fault(session, files, &path),
        _ => {
            let cycle = session.world().cycle_number();
            session.save_state(&path).map(|()| Some(cycle))
        }
    };
    let good = kept.unwrap_or_else(|error| {
        say(error);
        // A checkpoint that cannot be replaced stays what it was.
        files.saved
    });
    // Each on its own: the journal may fit where the rows do not.
    let (journal, rows) = (keep_journal(session, options, files), session.flush());
    for outcome in [journal, rows] {
        outcome.err().into_iter().for_each(&mut say);
    }
    if let Some(cycle) = good {
        let path = path.display().to_string();
        let way = match error {
            // Alone it would come to the same end.
            RunError::Fault(_) => format!(
                "open it and change by a command what led to this:\n  ballast {}",
                shell_word(&path)
            ),
            _ => format!(
                "go on from there with\n  {}",
                resume_line(Path::new(&path), options)
            ),
        };
        tell(&format!(
            "what was recorded is kept; {path} holds cycle {cycle}, {way}"
        ));
    } else {
        tell("what was recorded is kept; there is no state to go on from, so start anew");
    }
    FAILED
}

/// Cycle of the latest state before a fault, now in `path`: the start of the stage or a checkpoint
/// made since.
fn before_fault(
    session: &mut Session,
    files: &Files,
    path: &Path,
) -> Result<Option<u64>, RunError> {
    let safe = session.safe_cycle();
    if files.saved >= safe {
        return Ok(files.saved);
    }
    session.save_safe(path)
}

fn is_closed_pipe(error: &RunError) -> bool {
    matches!(error, RunError::Record(record) if RecordError::is_closed_pipe(record))
}

/// The journal is beside the CSV already; without one it goes to the current folder.
fn keep_journal(session: &mut Session, options: &Run, files: &Files) -> Result<(), RunError> {
    if files.csv.is_none() {
        session.write_journal(&home(session, options, "journal"))?;
    }
    Ok(())
}

fn checkpoint(session: &Session, options: &Run, files: &Files) -> PathBuf {
    let home = || home(session, options, "ballast");
    files.checkpoint.clone().unwrap_or_else(home)
}

/// Where files go that no option names: to the current folder.
pub(super) fn home(session: &Session, options: &Run, ending: &str) -> PathBuf {
    let stem = options.stem.as_ref().unwrap_or(&session.scene().name);
    PathBuf::from(format!("{stem}.{ending}"))
}

/// The command that goes on as this run would have.
fn resume_line(path: &Path, options: &Run) -> String {
    let mut line = "ballast run".to_owned();
    let mut word = |text: &str| {
        line.push(' ');
        line.push_str(&shell_word(text));
    };
    if let Some(preset) = &options.preset
        && Path::new(preset)
            .extension()
            .is_some_and(|ending| ending == "journal")
    {
        word(preset);
    }
    word("--resume");
    word(&path.to_string_lossy());
    for (option, value) in [
        ("--csv", &options.csv),
        ("--checkpoint", &options.checkpoint),
    ] {
        if let Some(value) = value {
            word(option);
            word(&value.to_string_lossy());
        }
    }
    let threads = options.threads.filter(|&threads| threads > 1);
    let threads = threads.map(|threads| threads.to_string());
    for (option, value) in [
        ("--every", options.every.map(|seconds| seconds.to_string())),
        ("--cycles", options.cycles.map(|cycles| cycles.to_string())),
        ("--threads", threads),
    ] {
        if let Some(value) = value {
            word(option);
            word(&value);
        }
    }
    line
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
        // A String takes every line.
        let _ = write!(
            text,
            "\nFRACC above 0.3 in {} cycles, worst {fracc:.3} at cycle {cycle} by particle \
             {particle}; a smaller frac would resolve such changes of force better, unless that \
             particle hardly moved",
            monitor.warnings
        );
    }
    let (done, (_, all)) = (session.stages_done(), session.stage_number());
    if all > 0 {
        let of_all = if done < all {
            format!(" of {all}")
        } else {
            String::new()
        };
        let plural = if all == 1 { "" } else { "s" };
        let _ = write!(text, "\n{done}{of_all} stage{plural} done");
    }
    text
}
