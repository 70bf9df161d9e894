//! Checkpoints of a session: complete, so that a resumed run gives the same bits.

use std::path::Path;
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::course::Course;
use super::{Recording, RunError, Session};
use crate::control::Control;
use crate::engine::World;
use crate::language::{Command, Observable};
use crate::measure::reference::Reference;
use crate::record::checkpoint::{self, AT_ONCE, Aside, CheckpointFault, PutOff};
use crate::record::error::RecordError;
use crate::record::journal::{EventKind, Journal};
use crate::scene::Scene;

/// What a checkpoint holds.
#[derive(Serialize, Deserialize)]
struct Saved {
    journal: Journal,
    averages_only: bool,
    control: Control,
    course: Course,
    recording: Recording,
    reference: Reference,
    dumped: Option<u64>,
    world: World,
}

/// The same, borrowed: postcard writes both alike.
#[derive(Serialize)]
struct Saving<'a> {
    journal: &'a Journal,
    averages_only: bool,
    control: &'a Control,
    course: &'a Course,
    recording: &'a Recording,
    reference: &'a Reference,
    dumped: Option<u64>,
    world: &'a World,
}

/// What a checkpoint holds, for whoever does not go on with its run.
pub(super) struct Held {
    /// The state, whose contact memory is still packed.
    pub(super) world: World,
    /// What was done.
    pub(super) journal: Journal,
    /// What steered its boundary and walls.
    pub(super) control: Control,
    /// Stage that was being run.
    pub(super) stage: usize,
    /// Stages that ended at `max_cycles` although they have a condition.
    pub(super) cut_short: Vec<String>,
}

/// Reads the bytes of a checkpoint.
pub(super) fn held(bytes: &[u8]) -> Result<Held, CheckpointFault> {
    let saved: Saved = checkpoint::decode(bytes)?;
    Ok(Held {
        world: saved.world,
        journal: saved.journal,
        control: saved.control,
        stage: saved.course.stage,
        cut_short: saved.course.cut_short,
    })
}

impl Session {
    /// Writes a checkpoint; changes nothing. Rows are handed to their file first, so that a killed
    /// process leaves no checkpoint behind that is ahead of it.
    pub fn save(&mut self, path: &Path) -> Result<(), RunError> {
        self.hand_over()?;
        self.save_state(path)
    }

    /// Writes a checkpoint whatever becomes of the rows, for instance because their disk is full: the
    /// checkpoint holds them too.
    pub fn save_state(&self, path: &Path) -> Result<(), RunError> {
        Ok(self.saving(|state| checkpoint::write(path, state, AT_ONCE))?)
    }

    /// As [`Session::save`], unless something more urgent comes up meanwhile; whether it is saved.
    pub fn save_unless(&mut self, path: &Path, put_off: PutOff<'_>) -> Result<bool, RunError> {
        self.hand_over()?;
        match self.saving(|state| checkpoint::write(path, state, put_off)) {
            Err(RecordError::Checkpoint {
                fault: CheckpointFault::PutOff,
                ..
            }) => Ok(false),
            saved => Ok(saved.map(|()| true)?),
        }
    }

    /// Good states that are kept at times are put off while this says so.
    pub fn keep_unless(&mut self, urgent: impl Fn() -> bool + Send + 'static) {
        self.urgent = Some(Box::new(urgent));
    }

    pub(super) fn encode(&self) -> Result<Vec<u8>, RunError> {
        self.saving(|state| checkpoint::encode(state))
            .map_err(|fault| RunError::Misfit(fault.to_string()))
    }

    /// Hands over what a checkpoint holds.
    fn saving<R>(&self, write: impl FnOnce(&Saving<'_>) -> R) -> R {
        write(&Saving {
            journal: &self.journal,
            averages_only: self.averages_only,
            control: &self.control,
            course: &self.course,
            recording: &self.recording,
            reference: &self.reference,
            dumped: self.dumped,
            world: &self.world,
        })
    }

    /// Remembers the state at the start of a stage. Not before something was recorded: then the
    /// preset itself is the way back.
    pub(super) fn keep_safe(&mut self) {
        self.keep_safe_unless(AT_ONCE);
    }

    /// Answers whether it was put off.
    fn keep_safe_unless(&mut self, put_off: PutOff<'_>) -> bool {
        let cycle = self.world.cycle_number();
        if cycle == 0 || self.world.fault().is_some() || self.expendable {
            return false;
        }
        let beside = self.dump_stem.clone();
        let folder = beside.as_deref().and_then(Path::parent);
        // The old one stays until the new one is whole.
        match self.saving(|state| Aside::of(state, folder, put_off)) {
            Ok(state) => self.safe = Some((cycle, state)),
            Err(CheckpointFault::PutOff) => return true,
            Err(fault) => self.tell_once(&fault),
        }
        false
    }

    /// Says that no good state could be kept; a fault that comes back every two seconds is said once.
    fn tell_once(&mut self, fault: &CheckpointFault) {
        if self.safe_fault.as_ref() != Some(fault) {
            let remedy = fault.remedy();
            self.notices.push(format!(
                "no state to go back to after a fault could be kept: {fault}; {remedy}"
            ));
            self.safe_fault = Some(fault.clone());
        }
    }

    /// The same in the middle of a stage, so seldom that it takes no time worth mentioning. Changes
    /// nothing; when it happens shows nowhere but in what a failed run can go back to.
    pub(super) fn keep_safe_at_times(&mut self) {
        if self.safe_due.is_none_or(|due| Instant::now() >= due) {
            let start = Instant::now();
            let urgent = self.urgent.take();
            let put_off = self.keep_safe_unless(urgent.as_deref().map_or(AT_ONCE, |urgent| urgent));
            self.urgent = urgent;
            let seldom = if put_off { 10 } else { 100 };
            let pause = (seldom * start.elapsed()).max(Duration::from_secs(2));
            self.safe_due = Some(Instant::now() + pause);
        }
    }

    /// Cycle of the state that was kept, if one was.
    pub fn safe_cycle(&self) -> Option<u64> {
        self.safe.as_ref().map(|(cycle, _)| *cycle)
    }

    /// After a fault: writes the last good state that was kept, if one was, and answers its cycle.
    pub fn save_safe(&mut self, path: &Path) -> Result<Option<u64>, RunError> {
        let Some((cycle, state)) = &mut self.safe else {
            return Ok(None);
        };
        state.write(path)?;
        Ok(Some(*cycle))
    }

    /// After a fault: writes the last good state to this file and says how to go back to it.
    pub fn way_back(&mut self, path: &Path) -> Result<Option<String>, RunError> {
        if !self.world.is_broken() {
            return Ok(None);
        }
        let command = Command::Restore(path.display().to_string());
        let cycle = self.save_safe(path)?;
        Ok(cycle.map(|cycle| format!("to go back to cycle {cycle}: `{command}`")))
    }

    /// Reads a checkpoint.
    pub fn resume(path: &Path, threads: usize) -> Result<Self, RunError> {
        Self::resume_with(path, |_| threads)
    }

    /// The same with as many threads as are chosen for so many particles.
    pub fn resume_with(
        path: &Path,
        threads: impl FnOnce(usize) -> usize,
    ) -> Result<Self, RunError> {
        let saved: Saved = checkpoint::read(path)?;
        let threads = threads(saved.world.particles().len());
        Self::revive(saved, &path.display().to_string(), threads)
    }

    fn revive(saved: Saved, name: &str, threads: usize) -> Result<Self, RunError> {
        let Saved {
            journal,
            averages_only,
            control,
            course,
            recording,
            reference,
            dumped,
            mut world,
        } = saved;
        let mut scene = Scene::parse(
            &journal.preset_name,
            &journal.preset_text,
            &journal.overrides,
        )
        .map_err(|rejection| {
            RunError::Misfit(format!(
                "{name}: its preset is refused by this version ({}); run it with the version \
                 that wrote it\n{rejection}",
                journal.program
            ))
        })?;
        if !recording.is_sound() || course.stage >= scene.stages.len().max(1) {
            return Err(RunError::Misfit(format!(
                "{name}: its rows or stages do not fit; it was written by version {}",
                journal.program
            )));
        }
        // The world has them.
        drop(scene.take_setup());
        if !world.unpack(threads) {
            return Err(RunError::Misfit(format!(
                "{name}: its contact memory does not fit; it was written by version {}",
                journal.program
            )));
        }
        Ok(Self {
            scene,
            world,
            control,
            course,
            recording,
            journal,
            csv: None,
            dump_stem: None,
            dumped,
            journal_file: None,
            notices: Vec::new(),
            averages_only,
            follower: None,
            reference,
            safe: None,
            safe_due: None,
            safe_fault: None,
            urgent: None,
            expendable: false,
            panic_at: None,
        })
    }

    /// Takes the state of a checkpoint over; files and the journal of this session go on.
    pub(super) fn restore(&mut self, file: &str) -> Result<(), RunError> {
        let saved = checkpoint::read(Path::new(file))?;
        self.take_over(saved, file)
    }

    /// The same from the bytes that [`Session::encode`] gave.
    pub(super) fn restore_from(&mut self, bytes: &[u8], file: &str) -> Result<(), RunError> {
        let saved = checkpoint::decode(bytes)
            .map_err(|fault| RunError::Misfit(format!("{file}: {fault}")))?;
        self.take_over(saved, file)
    }

    fn take_over(&mut self, saved: Saved, name: &str) -> Result<(), RunError> {
        let left = self.world.cycle_number();
        let session = Self::revive(saved, name, self.world.threads())?;
        let same = session.journal.preset_text == self.journal.preset_text
            && session.journal.overrides == self.journal.overrides;
        if !same {
            return Err(RunError::Misfit(format!(
                "{name}: belongs to another preset, {}; open it with ballast run --resume",
                session.journal.preset_name
            )));
        }
        let back = self
            .journal
            .moment_of(&session.journal, session.world.cycle_number());
        // A state of another run is found again in its file only.
        let restore = || EventKind::Typed(Command::Restore(name.to_owned()).to_string());
        let kind = back.map_or_else(restore, |to| {
            let file = name.to_owned();
            EventKind::Back { to, file }
        });
        let shown: Vec<Observable> = self.recording.shown().cloned().collect();
        // What is being executed is what was typed now, not what was being executed then.
        let user_lines = std::mem::take(&mut self.course.user_lines);
        self.course = Course {
            user_lines,
            user_errand: None,
            ..session.course
        };
        self.control = session.control;
        self.world = session.world;
        self.recording = session.recording;
        self.averages_only = session.averages_only;
        self.reference = session.reference;
        self.dumped = session.dumped;
        self.follow_anew();
        let noted = self.note_at(left, kind);
        self.keep_safe();
        let rewritten = self.rewrite_history(&shown);
        // The run is back whatever became of its files.
        for (file, done) in [("journal", noted), ("history", rewritten)] {
            if let Err(error) = done {
                self.notices
                    .push(format!("the {file} does not follow the way back: {error}"));
            }
        }
        Ok(())
    }

    /// The file being written shall hold one row for each cycle number, in the columns it began
    /// with: rows that are no more go out of it again.
    fn rewrite_history(&mut self, shown: &[Observable]) -> Result<(), RunError> {
        let Some(csv) = &mut self.csv else {
            return Ok(());
        };
        self.recording.show(shown);
        if !csv.restart(&self.recording.names())? {
            self.notices.push(
                "rows that were written to standard output cannot be taken back: later ones follow"
                    .into(),
            );
            return Ok(());
        }
        for row in self.recording.rows() {
            let stage = self.scene.stages.get(row.stage as usize);
            let stage = stage.map_or("", |stage| &stage.name);
            self.recording.write(row, stage, csv)?;
        }
        Ok(csv.flush()?)
    }
}
