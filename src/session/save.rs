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
    /// Bytes of the CSV file that belong to the state.
    position: Option<u64>,
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
    position: Option<u64>,
    course: &'a Course,
    recording: &'a Recording,
    reference: &'a Reference,
    world: &'a World,
}

/// A session read from a checkpoint.
pub struct Resumed {
    /// The session.
    pub session: Session,
    /// Bytes of the CSV file that belong to it, if one was written.
    pub position: Option<u64>,
}

impl Session {
    /// Writes a checkpoint; changes nothing.
    pub fn save(&mut self, path: &Path) -> Result<(), RunError> {
        let bytes = self.encode()?;
        crate::record::whole_file::write(path, &bytes)?;
        Ok(())
    }

    fn encode(&mut self) -> Result<Vec<u8>, RunError> {
        if let Some(csv) = &mut self.csv {
            csv.flush()?;
        }
        self.world.pack();
        let bytes = checkpoint::encode(&Saving {
            journal: &self.journal,
            averages_only: self.averages_only,
            position: self
                .csv
                .as_ref()
                .map(crate::record::history::History::position),
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
        if self.world.cycle_number() > 0
            && let Ok(bytes) = self.encode()
        {
            self.safe = bytes;
        }
    }

    /// After a fault: writes the state at the start of the stage, if there was one. Answers whether
    /// it did.
    pub fn save_safe(&self, path: &Path) -> Result<bool, RunError> {
        if self.safe.is_empty() {
            return Ok(false);
        }
        crate::record::whole_file::write(path, &self.safe)?;
        Ok(true)
    }

    /// Reads a checkpoint.
    pub fn resume(path: &Path, threads: usize) -> Result<Resumed, RunError> {
        let saved: Saved = checkpoint::read(path)?;
        let Saved {
            journal,
            averages_only,
            position,
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
        let session = Self {
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
            safe: Vec::new(),
            panic_at: None,
        };
        Ok(Resumed { session, position })
    }

    /// Takes the state of a checkpoint over; files and the journal of this session go on.
    pub(super) fn restore(&mut self, path: &Path) -> Result<(), RunError> {
        let threads = self.world.threads();
        let Resumed { session, .. } = Self::resume(path, threads)?;
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
