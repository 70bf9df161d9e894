//! `ballast run`: a preset or a journal, from beginning to end or from a checkpoint.

mod conclude;
mod files;
mod prepare;

use std::time::{Duration, Instant};

use super::output::{complain, tell};
use super::progress::Progress;
use super::{BAD_INPUT, FAILED, Run};
use crate::record::error::RecordError;
use crate::record::interrupt::Interrupt;
use crate::session::{Budget, Progress as Reached, RunError};
use conclude::{End, conclude};
use files::Files;
use prepare::{Prepared, prepare};

/// Cycles run for so long between looks at signals, progress and the checkpoint clock.
const BATCH: Duration = Duration::from_millis(50);

/// Rows are handed to their file this often: whoever watches it sees them, and a reader that has
/// gone away is noticed.
const ROWS: Duration = Duration::from_secs(1);

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
    let mut files = match Files::choose(options, &prepared) {
        Ok(files) => files,
        Err(clash) => {
            complain(&clash);
            return BAD_INPUT;
        }
    };
    if options.every.is_some() && files.checkpoint.is_none() {
        tell("--every is without effect: no checkpoint is kept without --checkpoint or --csv FILE");
    }
    match files.open(&mut prepared) {
        Ok(()) => {}
        Err(RunError::Record(RecordError::ClosedPipe { .. })) => return 0,
        Err(error) => {
            complain(&error.to_string());
            let misfit = matches!(error, RunError::Record(RecordError::Resume { .. }));
            return if misfit { BAD_INPUT } else { FAILED };
        }
    }
    let mut progress = Progress::new(&prepared.session, options.cycles, options.quiet);
    let end = drive(
        &mut prepared,
        options,
        &mut files,
        &interrupt,
        &mut progress,
    );
    progress.clear();
    for notice in prepared.session.take_notices() {
        tell(&notice);
    }
    let elapsed = progress.elapsed();
    conclude(&mut prepared.session, options, &mut files, end, elapsed)
}

/// Runs until the end, whatever it is.
fn drive(
    prepared: &mut Prepared,
    options: &Run,
    files: &mut Files,
    interrupt: &Interrupt,
    progress: &mut Progress,
) -> End {
    let Prepared {
        session, replay, ..
    } = prepared;
    let free = session.scene().stages.is_empty();
    // A very small period means a checkpoint at every look.
    let batch = files.period.clamp(Duration::from_millis(1), BATCH);
    let (mut saved, mut handed) = (Instant::now(), Instant::now());
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
        if saved.elapsed() >= files.period {
            if let Err(error) = files.save(session) {
                return End::Failed(error);
            }
            saved = Instant::now();
        }
        if handed.elapsed() >= ROWS {
            if let Err(error) = session.hand_over() {
                return End::Failed(error);
            }
            handed = Instant::now();
        }
        progress.show(session);
    }
}
