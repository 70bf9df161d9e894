//! Replaying a journal: the same commands at the same cycles, hence the same bits.
//!
//! A command may have been typed before or after a stage began at the same cycle; the order of the
//! journal tells. How far to run is told by its cycles, not by the commands that asked for them; where
//! the run could not go on, it cannot now, and what was done about it is done again. States that the
//! run went back to stay in memory once they are met: a replay writes no files, and needs none that
//! the run has made itself.

use std::collections::BTreeMap;
use std::time::Instant;

use super::{Budget, By, Progress, Refusal, RunError, Session};
use crate::language::command::HistoryChange;
use crate::language::{Command, Definitions};
use crate::record::journal::{Event, EventKind, Journal, Moment};
use crate::scene::Scene;

/// A journal being replayed.
#[derive(Debug, Clone)]
pub struct Replay {
    events: Vec<Event>,
    /// How many of them are done.
    done: usize,
    /// States that the journal goes back to later, once they have been met.
    kept: BTreeMap<Moment, Option<Vec<u8>>>,
    /// Columns that the preset makes.
    definitions: Definitions,
}

impl Replay {
    /// Of a journal of this scene.
    pub fn new(journal: &Journal, scene: &Scene) -> Self {
        let back = |event: &Event| match event.kind {
            EventKind::Back { to, .. } => Some((to, None)),
            _ => None,
        };
        Self {
            events: journal.events.clone(),
            done: 0,
            kept: journal.events.iter().filter_map(back).collect(),
            definitions: scene.definitions.clone(),
        }
    }

    /// Whether every event of a journal can take effect where it stands; better known before the first
    /// cycle.
    pub fn check(&self) -> Result<(), RunError> {
        // Cycle that the run is at when an event is due, as far as the journal tells.
        let mut reached = 0;
        for (k, event) in self.events.iter().enumerate() {
            let refuse = |message: &str, remedy: &str| {
                let refusal = Refusal::new(message, remedy);
                Err(refused(event, refusal))
            };
            if event.cycle < reached {
                return refuse(
                    &format!("the run is at cycle {reached} already"),
                    "put the events in the order of their cycles",
                );
            }
            reached = event.cycle;
            match &event.kind {
                EventKind::Typed(line) => match Command::parse_with(line, &self.definitions) {
                    Ok(Command::Restore(_)) => reached = 0,
                    Ok(_) => {}
                    Err(mistake) => return Err(refused(event, mistake)),
                },
                EventKind::Back { to, .. } => {
                    let past = to.events <= k && self.events[to.events].cycle >= to.cycle;
                    if !past {
                        return refuse(
                            "the run was never there",
                            "after `back` come a cycle and the number of events before it: count \
                             anew where events were put in or taken out",
                        );
                    }
                    reached = to.cycle;
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The rest of a journal for a session that was resumed in the middle of replaying it; `None` if
    /// what the session did is not how this journal begins.
    pub fn rest(journal: &Journal, session: &Session) -> Option<Self> {
        let mut rest = Self::new(journal, &session.scene);
        let mut done = session.journal.events.as_slice();
        while let Some(next) = done.iter().position(is_told) {
            let same = rest.ahead().iter().position(is_told)?;
            if !is_same(&rest.ahead()[same], &done[next]) {
                return None;
            }
            rest.done += same + 1;
            done = &done[next + 1..];
        }
        // What stages did since then has been done too. Somebody who wrote a journal by hand may
        // have left it out.
        for event in done {
            if rest.ahead().first() == Some(event) {
                rest.done += 1;
            }
        }
        Some(rest)
    }

    /// For a session resumed at this cycle: the first event that goes back to before it, and to which
    /// cycle.
    pub fn goes_back_before(&self, cycle: u64) -> Option<(u64, u64)> {
        let events = self.done;
        self.ahead().iter().find_map(|event| match event.kind {
            EventKind::Back { to, .. } if to < (Moment { events, cycle }) => {
                Some((event.cycle, to.cycle))
            }
            _ => None,
        })
    }

    /// Whether the columns of the history change on the way: then rows are known only at the end.
    pub fn changes_columns(&self) -> bool {
        self.ahead().iter().any(|event| match &event.kind {
            EventKind::Typed(line) => matches!(
                Command::parse_with(line, &self.definitions),
                Ok(Command::History(HistoryChange::Columns(_)))
            ),
            _ => false,
        })
    }

    /// Cycle of its end, if it came to one.
    pub fn end(&self) -> Option<u64> {
        let ends = |event: &&Event| matches!(event.kind, EventKind::End | EventKind::Fault(_));
        self.ahead().last().filter(ends).map(|event| event.cycle)
    }

    fn ahead(&self) -> &[Event] {
        &self.events[self.done..]
    }

    /// Whether it is told how far to run after the event that is being repeated: something later was
    /// done, or the run came to its end.
    fn tells_how_far(&self) -> bool {
        let mut later = self.ahead().iter().skip(1);
        !later.all(is_by_stage)
    }

    /// The cycle to run to from this one: that of the next event, or of a state to be kept before it.
    fn next_stop(&self, cycle: u64) -> Option<u64> {
        let due = self.ahead().first()?.cycle;
        let events = self.done;
        let kept = self.kept.range(Moment { events, cycle }..);
        let mut kept = kept.take_while(|(moment, _)| moment.events == events);
        let unmet = kept.find(|(_, state)| state.is_none());
        Some(unmet.map_or(due, |(moment, _)| due.min(moment.cycle)))
    }

    /// Whether the run went on although it could not at this cycle; then that is behind us.
    fn outlives_fault(&mut self, cycle: u64) -> bool {
        let mut rest = self.ahead().iter();
        let skipped = rest.clone().take_while(|event| is_by_stage(event)).count();
        let fault = rest.nth(skipped);
        if !fault.is_some_and(|e| e.cycle == cycle && matches!(e.kind, EventKind::Fault(_))) {
            return false;
        }
        let went_on = match rest.next() {
            Some(event) => event.kind != EventKind::End || event.cycle > cycle,
            None => false,
        };
        if went_on {
            self.done += skipped + 1;
        }
        went_on
    }
}

/// Whether the preset did it.
fn is_by_stage(event: &Event) -> bool {
    matches!(event.kind, EventKind::Stage(_) | EventKind::Staged(_))
}

/// Whether somebody did it.
fn is_told(event: &Event) -> bool {
    matches!(event.kind, EventKind::Typed(_) | EventKind::Back { .. })
}

/// The same but for the number of events, which a journal written by hand may have fewer of.
fn is_same(a: &Event, b: &Event) -> bool {
    match (&a.kind, &b.kind) {
        (EventKind::Back { to, file }, EventKind::Back { to: t, file: f }) => {
            (a.cycle, to.cycle, file) == (b.cycle, t.cycle, f)
        }
        _ => a == b,
    }
}

impl Session {
    /// Advances like [`Session::advance`], doing on the way what the journal tells.
    pub fn advance_replay(
        &mut self,
        replay: &mut Replay,
        budget: Budget,
    ) -> Result<Progress, RunError> {
        loop {
            match self.go_along(replay, budget) {
                Err(error) if replay.outlives_fault(self.world.cycle_number()) => {
                    let notice = format!("{error}; the journal tells how it went on");
                    self.notices.push(notice);
                }
                done => return done,
            }
        }
    }

    fn go_along(&mut self, replay: &mut Replay, budget: Budget) -> Result<Progress, RunError> {
        let start = Instant::now();
        loop {
            let cycle = self.world.cycle_number();
            let events = replay.done;
            if let Some(wanted @ None) = replay.kept.get_mut(&Moment { events, cycle }) {
                *wanted = Some(self.encode()?);
            }
            let Some(stop) = replay.next_stop(cycle) else {
                return self.advance(budget, false);
            };
            if cycle < stop {
                if budget.until_cycle.is_some_and(|last| cycle >= last) {
                    return Ok(Progress::Budget);
                }
                let stop = budget.until_cycle.map_or(stop, |last| last.min(stop));
                let until_cycle = Some(stop);
                let progress = self.advance(
                    Budget {
                        until_cycle,
                        ..budget
                    },
                    true,
                )?;
                if self.world.cycle_number() < stop && progress == Progress::Budget {
                    return Ok(progress);
                }
                continue;
            }
            let event = replay.events[replay.done].clone();
            if event.kind == EventKind::End {
                let fault = self.world.fault().filter(|_| self.world.is_broken());
                return fault.map_or(Ok(Progress::Finished), |fault| Err(fault.clone().into()));
            }
            if cycle > event.cycle {
                let refusal = Refusal::new(
                    format!("the run is at cycle {cycle} already"),
                    "put the events in the order of their cycles",
                );
                return Err(refused(&event, refusal));
            }
            self.repeat(&event, replay)?;
            replay.done += 1;
            if budget.time.is_some_and(|time| start.elapsed() >= time) {
                return Ok(Progress::Budget);
            }
        }
    }

    fn repeat(&mut self, event: &Event, replay: &Replay) -> Result<(), RunError> {
        let refuse = |refusal: Refusal| Err(refused(event, refusal));
        match &event.kind {
            // The stage issues its commands itself, now if it has not done so yet.
            EventKind::Stage(_) | EventKind::Staged(_) => self.stage_turn(),
            EventKind::Typed(line) => match Command::parse_with(line, &self.scene.definitions) {
                Ok(command) if is_only_noted(&command, replay) => self.note(event.kind.clone()),
                Ok(command) => match self.execute(&command, By::User) {
                    Ok(_) => Ok(()),
                    Err(refusal) => refuse(refusal),
                },
                Err(mistake) => refuse(mistake.into()),
            },
            EventKind::Back { to, file } => match replay.kept.get(to) {
                Some(Some(state)) => self.restore_from(state, file),
                _ => refuse(Refusal::new(
                    "the replay did not come by there",
                    "replay the journal from its beginning, with the settings it was made with",
                )),
            },
            // Somebody tried to go on where nothing had changed.
            EventKind::Fault(_) => match self.world.fault().cloned() {
                Some(fault) => Err(self.stopped(fault.into())),
                None => Ok(()),
            },
            EventKind::End => Ok(()),
        }
    }
}

/// Whether there is nothing to do: a replay writes no checkpoints, and knows how far to run. But the
/// last thing a run that was killed has been told still holds.
fn is_only_noted(command: &Command, replay: &Replay) -> bool {
    match command {
        Command::Save(_) | Command::Pause => true,
        command => command.runs_cycles() && replay.tells_how_far(),
    }
}

fn refused(event: &Event, refusal: impl Into<Refusal>) -> RunError {
    let text = event.to_string();
    let line = text.split_once(' ').map_or("", |(_, line)| line);
    RunError::Journal {
        cycle: event.cycle,
        line: line.to_owned(),
        refusal: refusal.into(),
    }
}
