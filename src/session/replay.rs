//! Replaying a journal: the same commands at the same cycles, hence the same bits.
//!
//! A command may have been typed before or after a stage began at the same cycle; the order of the
//! journal tells. How far to run is told by its cycles, not by the commands that asked for them.
//! Checkpoints that were saved and restored on the way stay in memory: a replay writes no files,
//! and needs none that the run has made itself.

use std::collections::{BTreeMap, VecDeque};

use super::{Budget, By, Progress, Refusal, RunError, Session};
use crate::language::command::HistoryChange;
use crate::language::{Command, Definitions};
use crate::record::journal::{Event, EventKind, Journal};
use crate::scene::Scene;

/// A journal being replayed.
#[derive(Debug, Clone)]
pub struct Replay {
    events: VecDeque<Event>,
    /// Checkpoints by the name they were saved under.
    saved: BTreeMap<String, Vec<u8>>,
    /// Columns that the preset makes.
    definitions: Definitions,
}

impl Replay {
    /// Of a journal of this scene.
    pub fn new(journal: &Journal, scene: &Scene) -> Self {
        Self {
            events: journal.events.iter().cloned().collect(),
            saved: BTreeMap::new(),
            definitions: scene.definitions.clone(),
        }
    }

    /// Whether every command of a journal can be read; better known before the first cycle.
    pub fn check(&self) -> Result<(), RunError> {
        for event in &self.events {
            if let EventKind::Typed(line) = &event.kind {
                let parsed = Command::parse_with(line, &self.definitions);
                parsed.map_err(|mistake| refused(event.cycle, line, mistake))?;
            }
        }
        Ok(())
    }

    /// The rest of a journal for a session that was resumed in the middle of replaying it; `None` if
    /// what the session did is not how this journal begins.
    pub fn rest(journal: &Journal, session: &Session) -> Option<Self> {
        let mut rest = Self::new(journal, &session.scene);
        let typed = |event: &Event| matches!(event.kind, EventKind::Typed(_));
        let mut done = session.journal.events.as_slice();
        while let Some(next) = done.iter().position(typed) {
            let same = rest.events.iter().position(typed)?;
            if rest.events[same] != done[next] {
                return None;
            }
            rest.events.drain(..=same);
            done = &done[next + 1..];
        }
        // What stages did since then has been done too. Somebody who wrote a journal by hand may
        // have left it out.
        for event in done {
            if rest.events.front() == Some(event) {
                rest.events.pop_front();
            }
        }
        Some(rest)
    }

    /// Whether the columns of the history change on the way: then rows are known only at the end.
    pub fn changes_columns(&self) -> bool {
        self.events.iter().any(|event| match &event.kind {
            EventKind::Typed(line) => matches!(
                Command::parse_with(line, &self.definitions),
                Ok(Command::History(HistoryChange::Columns(_)))
            ),
            _ => false,
        })
    }

    /// Cycle of its end, if it came to one.
    pub fn end(&self) -> Option<u64> {
        self.events
            .iter()
            .rfind(|event| event.kind == EventKind::End)
            .map(|event| event.cycle)
    }

    /// Whether something later was typed, or the run came to its end.
    fn tells_how_far(&self) -> bool {
        let mut events = self.events.iter();
        events.any(|event| matches!(event.kind, EventKind::Typed(_) | EventKind::End))
    }
}

impl Session {
    /// Advances like [`Session::advance`], executing the commands of the journal on the way.
    pub fn advance_replay(
        &mut self,
        replay: &mut Replay,
        budget: Budget,
    ) -> Result<Progress, RunError> {
        while let Some(event) = replay.events.front() {
            let due = event.cycle;
            let stop = budget.until_cycle.map_or(due, |cycle| cycle.min(due));
            if self.world.cycle_number() < stop {
                let progress = self.advance(
                    Budget {
                        until_cycle: Some(stop),
                        ..budget
                    },
                    true,
                )?;
                if self.world.cycle_number() < stop && progress == Progress::Budget {
                    return Ok(progress);
                }
                continue;
            }
            if self.world.cycle_number() < due {
                return Ok(Progress::Budget);
            }
            if event.kind == EventKind::End {
                return Ok(Progress::Finished);
            }
            if let Some(event) = replay.events.pop_front() {
                self.repeat(event, replay)?;
            }
        }
        self.advance(budget, false)
    }

    fn repeat(&mut self, event: Event, replay: &mut Replay) -> Result<(), RunError> {
        let Event { cycle, kind } = event;
        let line = match kind {
            // The stage issues its commands itself, now if it has not done so yet.
            EventKind::Stage(_) | EventKind::Staged(_) => return self.stage_turn(),
            EventKind::End => return Ok(()),
            EventKind::Typed(line) => line,
        };
        let parsed = Command::parse_with(&line, &self.scene.definitions);
        let command = parsed.map_err(|mistake| refused(cycle, &line, mistake))?;
        match &command {
            // The last thing a run that was killed has been told still holds.
            command if command.runs_cycles() && replay.tells_how_far() => {}
            Command::Pause => {}
            Command::Save(file) => {
                replay.saved.insert(file.clone(), self.encode()?);
            }
            Command::Restore(file) if replay.saved.contains_key(file) => {
                self.restore_from(&replay.saved[file], file)?;
            }
            command => {
                let done = self.execute(command, By::User).map(drop);
                return done.map_err(|refusal| refused(cycle, &line, refusal));
            }
        }
        self.note_at(cycle, EventKind::Typed(line))
    }
}

fn refused(cycle: u64, line: &str, refusal: impl Into<Refusal>) -> RunError {
    RunError::Journal {
        cycle,
        line: line.to_owned(),
        refusal: refusal.into(),
    }
}
