//! Replaying a journal: the same commands at the same cycles, hence the same bits.

use super::{Budget, By, Progress, Refusal, RunError, Session};
use crate::language::Command;
use crate::record::journal::{Event, EventKind, Journal};

/// A journal being replayed.
#[derive(Debug, Clone)]
pub struct Replay {
    events: std::collections::VecDeque<Event>,
}

impl Replay {
    /// Of a journal. What stages issued they will issue again.
    pub fn new(journal: &Journal) -> Self {
        let external = |event: &&Event| matches!(event.kind, EventKind::Typed(_) | EventKind::End);
        Self {
            events: journal.events.iter().filter(external).cloned().collect(),
        }
    }

    /// Whether every command of a journal can be read; better known before the first cycle.
    pub fn check(journal: &Journal) -> Result<(), RunError> {
        for event in &journal.events {
            if let EventKind::Typed(line) = &event.kind {
                Command::parse(line).map_err(|mistake| refused(event.cycle, line, mistake))?;
            }
        }
        Ok(())
    }

    /// The rest of a journal for a session that was resumed in the middle of replaying it; `None` if
    /// what the session did is not how this journal begins.
    pub fn rest(journal: &Journal, session: &Session) -> Option<Self> {
        let mut rest = Self::new(journal);
        let repeated = |event: &Event| {
            matches!(&event.kind, EventKind::Typed(line)
                if Command::parse(line).is_ok_and(|command| is_repeated(&command)))
        };
        for done in session
            .journal
            .events
            .iter()
            .filter(|event| repeated(event))
        {
            let next = rest.events.iter().position(repeated)?;
            if rest.events[next] != *done {
                return None;
            }
            rest.events.drain(..=next);
        }
        Some(rest)
    }

    /// Cycle of its end, if it came to one.
    pub fn end(&self) -> Option<u64> {
        self.events
            .iter()
            .rfind(|event| event.kind == EventKind::End)
            .map(|event| event.cycle)
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
            let Some(Event {
                cycle,
                kind: EventKind::Typed(line),
            }) = replay.events.pop_front()
            else {
                return Ok(Progress::Finished);
            };
            self.repeat(cycle, &line)?;
        }
        self.advance(budget, false)
    }

    fn repeat(&mut self, cycle: u64, line: &str) -> Result<(), RunError> {
        let command = Command::parse(line).map_err(|mistake| refused(cycle, line, mistake))?;
        if !is_repeated(&command) {
            return Ok(());
        }
        let done = self.execute(&command, By::User);
        done.map(drop)
            .map_err(|refusal| refused(cycle, line, refusal))
    }
}

fn refused(cycle: u64, line: &str, refusal: impl Into<Refusal>) -> RunError {
    RunError::Journal {
        cycle,
        line: line.to_owned(),
        refusal: refusal.into(),
    }
}

/// How far to run is told by the cycles of the journal itself.
fn is_repeated(command: &Command) -> bool {
    !command.runs_cycles() && !matches!(command, Command::Pause)
}
