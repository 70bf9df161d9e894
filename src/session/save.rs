//! Checkpoints of a session: complete, so that a resumed run gives the same bits.

use std::path::Path;

use serde::{Deserialize, Serialize};

use super::course::Course;
use super::reference::Reference;
use super::{Recording, RunError, Session};
use crate::engine::World;
use crate::record::checkpoint;
use crate::record::journal::{Event, Journal};
use crate::scene::Scene;

/// What a checkpoint holds.
#[derive(Serialize, Deserialize)]
struct Saved {
    journal: Journal,
    averages_only: bool,
    course: Course,
    recording: Recording,
    reference: Reference,
    world: World,
}

/// The same, borrowed: postcard writes both alike.
#[derive(Serialize)]
struct Saving<'a> {
    journal: &'a Journal,
    averages_only: bool,
    course: &'a Course,
    recording: &'a Recording,
    reference: &'a Reference,
    world: &'a World,
}

impl Session {
    /// Writes a checkpoint; changes nothing. Rows are handed to their file first, so that a killed
    /// process leaves no checkpoint behind that is ahead of it.
    pub fn save(&mut self, path: &Path) -> Result<(), RunError> {
        if let Some(csv) = &mut self.csv {
            csv.flush()?;
        }
        self.save_state(path)
    }

    /// Writes a checkpoint whatever becomes of the rows, for instance because their disk is full: the
    /// checkpoint holds them too.
    pub fn save_state(&mut self, path: &Path) -> Result<(), RunError> {
        let bytes = self.encode()?;
        crate::record::whole_file::write(path, &bytes)?;
        Ok(())
    }

    fn encode(&mut self) -> Result<Vec<u8>, RunError> {
        self.world.pack();
        let bytes = checkpoint::encode(&Saving {
            journal: &self.journal,
            averages_only: self.averages_only,
            course: &self.course,
            recording: &self.recording,
            reference: &self.reference,
            world: &self.world,
        });
        self.world.unload();
        bytes.map_err(|fault| RunError::Misfit(fault.to_string()))
    }

    /// Remembers the state at the start of a stage. Not before something was recorded: then the
    /// preset itself is the way back.
    pub(super) fn keep_safe(&mut self) {
        let cycle = self.world.cycle_number();
        if cycle > 0
            && let Ok(bytes) = self.encode()
        {
            self.safe = Some((cycle, bytes));
        }
    }

    /// Cycle at which the stage began, if its state was kept.
    pub fn safe_cycle(&self) -> Option<u64> {
        self.safe.as_ref().map(|(cycle, _)| *cycle)
    }

    /// After a fault: writes the state at the start of the stage, if there was one.
    pub fn save_safe(&self, path: &Path) -> Result<(), RunError> {
        match &self.safe {
            None => Ok(()),
            Some((_, bytes)) => Ok(crate::record::whole_file::write(path, bytes)?),
        }
    }

    /// Reads a checkpoint.
    pub fn resume(path: &Path, threads: usize) -> Result<Self, RunError> {
        let saved: Saved = checkpoint::read(path)?;
        let Saved {
            journal,
            averages_only,
            course,
            recording,
            reference,
            mut world,
        } = saved;
        let scene = Scene::parse(
            &journal.preset_name,
            &journal.preset_text,
            &journal.overrides,
        )
        .map_err(|rejection| {
            RunError::Misfit(format!(
                "{}: its preset is refused by this version ({}); run it with the version \
                     that wrote it\n{rejection}",
                path.display(),
                journal.program
            ))
        })?;
        if !world.unpack(threads.max(1)) {
            return Err(RunError::Misfit(format!(
                "{}: its contact memory does not fit; it was written by version {}",
                path.display(),
                journal.program
            )));
        }
        Ok(Self {
            scene,
            world,
            course,
            recording,
            journal,
            csv: None,
            journal_file: None,
            notices: Vec::new(),
            averages_only,
            reference,
            safe: None,
        })
    }

    /// Takes the state of a checkpoint over; files and the journal of this session go on.
    pub(super) fn restore(&mut self, path: &Path) -> Result<(), RunError> {
        let threads = self.world.threads();
        let session = Self::resume(path, threads)?;
        let events: Vec<Event> = std::mem::take(&mut self.journal.events);
        let same = session.journal.preset_text == self.journal.preset_text
            && session.journal.overrides == self.journal.overrides;
        if !same {
            self.journal.events = events;
            return Err(RunError::Misfit(format!(
                "{}: belongs to another preset, {}; open it with ballast run --resume",
                path.display(),
                session.journal.preset_name
            )));
        }
        self.journal.events = events;
        self.world = session.world;
        self.course = session.course;
        self.recording = session.recording;
        self.averages_only = session.averages_only;
        self.reference = session.reference;
        Ok(())
    }
}
