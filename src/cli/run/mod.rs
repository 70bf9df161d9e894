//! `ballast run`: a preset or a journal, from beginning to end or from a checkpoint.

mod conclude;
mod ensemble;
mod files;
mod prepare;
mod reading;

pub(super) use files::same;

use std::time::{Duration, Instant};

use super::output::{complain, tell};
use super::progress::Progress;
use super::{BAD_INPUT, FAILED, Run};
use crate::record::error::RecordError;
use crate::record::interrupt::{Interrupt, Signal};
use crate::session::{Budget, Progress as Reached, RunError, Session};
use conclude::{End, conclude};
use files::Files;
use prepare::{Prepared, prepare};
use reading::Reading;

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
    if let Some(seeds) = options.seeds {
        return ensemble::run(options, seeds, &interrupt);
    }
    let reading = Reading::begin(&interrupt);
    let mut progress: Option<Progress> = None;
    let mut sample: Option<Progress> = None;
    let mut watch = |watched: Watched<'_>| match watched {
        Watched::Preparing(session) => sample
            .get_or_insert_with(|| Progress::of_sample(session, options.quiet))
            .show(session),
        Watched::Going(session) => {
            if let Some(mut sample) = sample.take() {
                sample.clear();
            }
            progress
                .get_or_insert_with(|| Progress::new(session, options.cycles, options.quiet))
                .show(session);
        }
        Watched::Ended => {
            for shown in [&mut sample, &mut progress].into_iter().flatten() {
                shown.clear();
            }
        }
    };
    let mut watch = |watched: Watched<'_>| {
        reading.end();
        watch(watched);
    };
    one(options, &interrupt, &mut watch).status
}

/// How a run ended.
struct Ran {
    /// Exit status.
    status: u8,
    /// The run, unless it could not begin.
    session: Option<Session>,
}

impl Ran {
    fn never(status: u8) -> Self {
        let session = None;
        Self { status, session }
    }
}

/// One run, from its preset to what is said at its end. `watch` sees it between batches, and its end
/// before anything is said.
fn one(options: &Run, interrupt: &Interrupt, watch: &mut dyn FnMut(Watched<'_>)) -> Ran {
    let mut beat = |session: &Session| {
        watch(Watched::Preparing(session));
        interrupt.caught().is_none()
    };
    let mut prepared = match prepare(options, &mut beat) {
        Ok(prepared) => prepared,
        Err(status) => {
            watch(Watched::Ended);
            let status = interrupt.caught().map_or(status, Signal::exit_status);
            return Ran::never(status);
        }
    };
    let mut files = match Files::choose(options, &prepared) {
        Ok(files) => files,
        Err(clash) => {
            complain(&clash);
            return Ran::never(BAD_INPUT);
        }
    };
    if options.every.is_some() && files.checkpoint.is_none() {
        tell("--every is without effect: no checkpoint is kept without --checkpoint or --csv FILE");
    }
    if options.resume.is_some() && !options.quiet {
        resumed(&prepared, &files);
    }
    match files.open(&mut prepared, options) {
        Ok(()) => {}
        Err(RunError::Record(RecordError::ClosedPipe { .. })) => return Ran::never(0),
        Err(error) => {
            complain(&error.to_string());
            let misfit = matches!(error, RunError::Record(RecordError::Resume { .. }));
            return Ran::never(if misfit { BAD_INPUT } else { FAILED });
        }
    }
    let start = Instant::now();
    let end = drive(&mut prepared, options, &mut files, interrupt, watch);
    watch(Watched::Ended);
    let mut session = prepared.session;
    for notice in session.take_notices() {
        tell(&notice);
    }
    let status = conclude(&mut session, options, &mut files, end, start.elapsed());
    Ran {
        status,
        session: Some(session),
    }
}

/// What whoever goes on with a run might not expect.
fn resumed(prepared: &Prepared, files: &Files) {
    let session = &prepared.session;
    if !files.stdout && files.csv.is_none() && files.checkpoint.is_none() {
        tell(
            "nothing of what follows is kept: --csv FILE.csv keeps rows, journal and state, --checkpoint \
             FILE the state alone",
        );
    }
    if prepared.replay.is_none() && !session.scene().stages.is_empty() && session.is_finished() {
        tell(
            "all stages are done: nothing is left to run; the workbench goes beyond: ballast FILE",
        );
    }
}

/// What whoever shows progress is told.
enum Watched<'a> {
    /// The run that prepares its sample goes on.
    Preparing(&'a Session),
    /// The run goes on.
    Going(&'a Session),
    /// It has ended: messages may follow.
    Ended,
}

/// Runs until the end, whatever it is.
fn drive(
    prepared: &mut Prepared,
    options: &Run,
    files: &mut Files,
    interrupt: &Interrupt,
    watch: &mut dyn FnMut(Watched<'_>),
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
        watch(Watched::Going(session));
    }
}
