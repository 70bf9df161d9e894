//! Saves of a run that somebody watches: beside its journal, at times and at the end, and what became of
//! them.

use std::time::Instant;

use super::run_folder::Keep;
use super::save_clock::SaveClock;
use super::{RunError, Session};
use crate::record::checkpoint::{AT_ONCE, PutOff};

/// Where a run is kept, and how far.
#[derive(Debug)]
pub struct Saves {
    /// Or why nothing is.
    keep: Result<Keep, String>,
    clock: SaveClock,
    /// Cycle and events of the last save.
    last: Option<(u64, usize)>,
    /// Cycle of the state in the checkpoint.
    held: Option<u64>,
    /// Why the last try to save the state failed.
    fault: Option<String>,
    /// Why the journal has no end.
    unended: Option<String>,
}

impl Saves {
    /// In a folder of its own, with the journal begun; where that cannot be, nothing is kept.
    pub fn begin(session: &mut Session) -> Self {
        let keep = Keep::make(&session.scene().name);
        Self::begin_at(keep, session)
    }

    /// The same with files that are known.
    pub fn begin_at(keep: Result<Keep, String>, session: &mut Session) -> Self {
        let keep = keep.and_then(|keep| match session.write_journal(&keep.journal) {
            Ok(()) => Ok(keep),
            Err(error) => Err(error.to_string()),
        });
        if let Ok(keep) = &keep {
            session.write_dumps(&keep.journal);
        }
        Self {
            keep,
            clock: SaveClock::new(Instant::now()),
            last: None,
            held: None,
            fault: None,
            unended: None,
        }
    }

    /// Where the files are, if there are any.
    pub fn keep(&self) -> Option<&Keep> {
        self.keep.as_ref().ok()
    }

    /// What the user should know before anything is lost.
    pub fn warning(&self) -> Option<String> {
        let why = self.keep.as_ref().err()?;
        Some(format!("nothing of this run is kept: {why}"))
    }

    /// Cycle of the state that can be gone on from.
    pub fn held(&self) -> Option<u64> {
        self.held
    }

    /// Why there is no later one, if that failed.
    pub fn fault(&self) -> Option<&str> {
        self.fault.as_deref()
    }

    /// Why a replay of the journal will not know where to end.
    pub fn unended(&self) -> Option<&str> {
        self.unended.as_deref()
    }

    /// Saves the state when it is time. Orders come first, but not for ever.
    pub fn save_if_due(
        &mut self,
        session: &mut Session,
        put_off: PutOff<'_>,
    ) -> Result<(), RunError> {
        let now = Instant::now();
        if !self.clock.is_due(now) {
            return Ok(());
        }
        let late = self.clock.is_late(now);
        let saved = self.save(session, if late { AT_ONCE } else { put_off });
        if let Ok(false) = saved {
            self.clock.put_off(Instant::now(), now.elapsed());
        } else {
            self.clock = SaveClock::new(now);
        }
        saved.map(drop)
    }

    /// Saves the state, then ends the journal: a replay has to know how far the run went, and what goes
    /// on from the checkpoint goes on as if nothing had ended.
    pub fn close(&mut self, session: &mut Session) {
        // Whoever could be told is about to go; `fault` says why there is no later state.
        drop(self.save(session, AT_ONCE));
        self.unended = session.finish().err().map(|error| error.to_string());
    }

    /// After a fault: keeps the last good state and says how to go back to it.
    pub fn way_back(&mut self, session: &mut Session) -> Option<String> {
        let checkpoint = self.keep()?.checkpoint.clone();
        match session.way_back(&checkpoint) {
            Ok(way) => {
                way.as_ref()?;
                self.good(session.safe_cycle());
                way
            }
            Err(error) => {
                self.fault = Some(error.to_string());
                Some(format!("there is no way back: {error}"))
            }
        }
    }

    /// After a fault of the program itself: keeps what can be kept, and says what could not be. The
    /// journal is complete in any case; the last good state is whole.
    pub fn rescue(&mut self, session: &mut Session) -> Vec<String> {
        let Some(checkpoint) = self.keep().map(|keep| keep.checkpoint.clone()) else {
            return Vec::new();
        };
        let mut told = Vec::new();
        told.extend(session.flush().err().map(|error| error.to_string()));
        match session.save_safe(&checkpoint) {
            Ok(None) => {}
            Ok(cycle) => self.good(cycle),
            Err(error) => told.push(error.to_string()),
        }
        told
    }

    fn good(&mut self, cycle: Option<u64>) {
        (self.held, self.last, self.fault) = (cycle, None, None);
    }

    /// Saves the state if anything has happened since; false if it was put off.
    fn save(&mut self, session: &mut Session, put_off: PutOff<'_>) -> Result<bool, RunError> {
        let cycle = session.world().cycle_number();
        let moment = (cycle, session.journal().events.len());
        let Ok(keep) = &self.keep else {
            return Ok(true);
        };
        // Half a cycle must not take the place of the good state that is there.
        if self.last == Some(moment) || cycle == 0 || session.world().is_broken() {
            return Ok(true);
        }
        let saved = session.save_unless(&keep.checkpoint, put_off);
        match &saved {
            Ok(true) => {
                self.good(Some(cycle));
                self.last = Some(moment);
                session.flush()?;
            }
            Ok(false) => {}
            Err(error) => self.fault = Some(error.to_string()),
        }
        saved
    }
}
