//! Running: stages begin, cycles pass, rows are taken, stages end.
//!
//! What ends, ends at the boundary where it is noticed: [`Session::notice_ends`], and its row is
//! taken there. What begins waits until the run goes on. So every command that is typed at a boundary
//! stands between the two, live and in a replay, wherever the batches are cut.

use std::time::{Duration, Instant};

use super::clock::Clock;
use super::course::Phase;
use super::{By, Refusal, Reply, Request, RunError, Session};
use crate::language::Command;
use crate::measure::sample::Sample;
use crate::record::journal::{Event, EventKind};

/// How long a batch may be.
#[derive(Debug, Clone, Copy, Default)]
pub struct Budget {
    /// No cycle after this one.
    pub until_cycle: Option<u64>,
    /// No cycle begins after so much time.
    pub time: Option<Duration>,
}

/// Why a batch ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Progress {
    /// The budget is used up.
    Budget,
    /// What a command asked for is done.
    ErrandDone,
    /// All stages are done, and no command asks for more.
    Finished,
}

/// Most cycles between looks at the clock.
const BETWEEN_LOOKS: u32 = 16;

/// More time between them is too much: the cycles of a large scene are looked at one by one.
const LOOK_TIME: Duration = Duration::from_micros(200);

impl Session {
    /// Whether the user wants to see every boundary of what runs now.
    pub fn shows_each(&self) -> bool {
        let errand = self.course.user_errand.as_ref();
        errand.is_some_and(|errand| errand.shown)
    }

    /// Runs a batch. When all stages are done it goes on only for what the user asked for, or if
    /// `free` up to the cycle of the budget.
    pub fn advance(&mut self, budget: Budget, free: bool) -> Result<Progress, RunError> {
        self.keep_safe_at_times();
        let start = Instant::now();
        // Cycles since the last look, and how many there may be.
        let (mut looks, mut between, mut looked) = (0, 1, start);
        loop {
            if budget
                .until_cycle
                .is_some_and(|cycle| self.world.cycle_number() >= cycle)
            {
                return Ok(Progress::Budget);
            }
            if looks == between {
                let now = Instant::now();
                if budget.time.is_some_and(|time| now - start >= time) {
                    return Ok(Progress::Budget);
                }
                let few = now - looked < LOOK_TIME;
                between = if few { 2 * between } else { 1 }.min(BETWEEN_LOOKS);
                (looks, looked) = (0, now);
            }
            looks += 1;
            if self.user_turn() {
                return Ok(Progress::ErrandDone);
            }
            if let Some(fault) = self.world.fault().cloned() {
                return Err(self.stopped(fault.into()));
            }
            self.stage_turn()?;
            let more = self.course.user_errand.is_some() || (free && budget.until_cycle.is_some());
            if self.is_finished() && !more {
                return Ok(Progress::Finished);
            }
            self.cycle()?;
        }
    }

    /// One cycle and what belongs to the boundary it arrives at.
    pub(super) fn cycle(&mut self) -> Result<(), RunError> {
        self.first_row()?;
        // That of cycle 0, or one that failed before this run was resumed.
        self.dump(false)?;
        self.steer();
        if let Err(fault) = self.world.cycle() {
            return Err(self.stopped(fault.into()));
        }
        if let Some(follower) = &mut self.follower {
            follower.take(&self.world);
        }
        self.panic_if_asked();
        self.notice_ends()?;
        let cycle = self.world.cycle_number();
        if cycle.is_multiple_of(self.recording.every) {
            self.take_row()?;
        }
        self.dump(false)
    }

    /// Says in the journal that the run cannot go on, and forgets what was still asked for.
    pub(super) fn stopped(&mut self, error: RunError) -> RunError {
        self.course.user_errand = None;
        let left = std::mem::take(&mut self.course.user_lines).len();
        if left > 0 {
            self.notices
                .push(format!("{left} lines of the file are left out"));
        }
        let event = Event {
            cycle: self.world.cycle_number(),
            kind: EventKind::Fault(error.to_string()),
        };
        // Who asks again is told again; once is enough for the journal. A journal that cannot be
        // written matters less than what has happened.
        if self.journal.events.last() != Some(&event) {
            drop(self.note(event.kind));
        }
        error
    }

    /// What the user asked for comes before what stages do at the same boundary. True when all of
    /// it is done.
    fn user_turn(&mut self) -> bool {
        let asked = self.course.user_errand.is_some();
        if asked {
            if !self.errand_done(By::User) {
                return false;
            }
            self.tell_verdict(By::User);
        }
        if self.course.user_lines.is_empty() {
            asked
        } else {
            self.user_line()
        }
    }

    /// Lines of a sourced file, up to one that runs cycles or pauses. True when nothing is left to
    /// run for. A line that is refused ends the file, not the run.
    fn user_line(&mut self) -> bool {
        while let Some(line) = self.course.user_lines.pop_front() {
            let parsed = Command::parse_with(&line, &self.scene.definitions);
            let command = parsed.map_err(Refusal::from);
            match command.and_then(|command| self.execute(&command, By::User)) {
                Ok(reply) => {
                    self.notices.push(line);
                    self.notices.extend(reply.lines);
                    if reply.request == Some(Request::Pause) {
                        return true;
                    }
                }
                Err(refusal) => {
                    let left = self.course.user_lines.len();
                    self.course.user_lines.clear();
                    self.notices.push(format!(
                        "`{line}` was refused, and the {left} lines after it are left out: \
                         {refusal}"
                    ));
                    return true;
                }
            }
            if self.course.user_errand.is_some() {
                return false;
            }
        }
        true
    }

    /// Begins stages that are due and issues their commands, until cycles have to run.
    pub(super) fn stage_turn(&mut self) -> Result<(), RunError> {
        let stages = self.scene.stages.len();
        // Before the first of them: a replay begins stages that follow each other at once in one go.
        if self.course.phase == Phase::Over && !self.is_finished() {
            self.keep_safe();
        }
        loop {
            match self.course.phase {
                _ if stages == 0 => return Ok(()),
                Phase::Ahead => self.begin_stage()?,
                Phase::Issuing if self.course.errand.is_some() => return Ok(()),
                Phase::Issuing => {
                    let line = self.course.lines.pop_front();
                    let done = line.map_or(Ok(()), |line| self.issue(&line));
                    self.notice_ends()?;
                    done?;
                }
                Phase::Running => return Ok(()),
                Phase::Over if self.course.stage + 1 >= stages => return self.last_dump(),
                Phase::Over => {
                    self.last_dump()?;
                    self.course.stage += 1;
                    self.course.phase = Phase::Ahead;
                }
            }
        }
    }

    /// That of the end of a stage, should it have failed before this run was resumed.
    fn last_dump(&mut self) -> Result<(), RunError> {
        if self.course.ended_at == self.world.cycle_number() {
            return self.dump(true);
        }
        Ok(())
    }

    fn begin_stage(&mut self) -> Result<(), RunError> {
        self.course.started_at = self.world.cycle_number();
        self.course.phase = Phase::Issuing;
        let stage = &self.scene.stages[self.course.stage];
        self.course.lines = stage.commands.iter().map(ToString::to_string).collect();
        let name = stage.name.clone();
        self.note(EventKind::Stage(name))
    }

    /// What ends at this boundary: cycles that a stage's command asked for, its commands, the stage.
    fn notice_ends(&mut self) -> Result<(), RunError> {
        if self.course.phase == Phase::Issuing {
            if !self.errand_done(By::Stage) {
                return Ok(());
            }
            self.tell_verdict(By::Stage);
            if !self.course.lines.is_empty() {
                return Ok(());
            }
            self.course.phase = Phase::Running;
        }
        if self.course.phase != Phase::Running {
            return Ok(());
        }
        self.look_for_stage_end();
        if self.course.phase == Phase::Over {
            self.course.ended_at = self.world.cycle_number();
            if self.stage_cycle() > 0 {
                self.judge_step();
                self.judge_overlaps();
            }
            self.take_row()?;
            self.dump(true)?;
        }
        Ok(())
    }

    fn issue(&mut self, line: &str) -> Result<(), RunError> {
        let noted = self.note(EventKind::Staged(line.to_owned()));
        let done = match Command::parse_with(line, &self.scene.definitions) {
            Ok(command) => self.execute(&command, By::Stage),
            Err(mistake) => Err(mistake.into()),
        };
        // What a stage prints is for whoever watches; a change speaks through the run.
        let shown = |reply: Reply| {
            if line.starts_with("print") || line.starts_with("inspect") {
                self.notices.extend(reply.lines);
            }
        };
        if let Err(refusal) = done.map(shown) {
            let stage = self.stage_name().to_owned();
            let line = line.to_owned();
            return Err(self.stopped(RunError::Stage {
                stage,
                line,
                refusal,
            }));
        }
        noted
    }

    /// Whether the cycles that a command of the user or of the stage asked for are done.
    fn errand_done(&mut self, by: By) -> bool {
        let Some(errand) = self.course.errand_of(by) else {
            return true;
        };
        let cycle = self.world.cycle_number();
        if errand.until_cycle.is_some_and(|last| cycle >= last) {
            return true;
        }
        let Some(condition) = &errand.condition else {
            return false;
        };
        let check = self.scene.check_every.unwrap_or(self.recording.every);
        let against = (&self.scene.regions[..], &self.reference);
        Clock::of(&self.world, cycle - errand.from).holds(
            condition,
            check,
            &mut self.world,
            against,
        )
    }

    /// The row of cycle 0, when the first cycle is about to run.
    fn first_row(&mut self) -> Result<(), RunError> {
        if self.recording.rows().is_empty() {
            self.take_row()
        } else {
            Ok(())
        }
    }

    /// Takes the row of this cycle, once.
    pub(super) fn take_row(&mut self) -> Result<(), RunError> {
        let cycle = self.world.cycle_number();
        if self
            .recording
            .rows()
            .last()
            .is_some_and(|row| row.cycle == cycle)
        {
            return Ok(());
        }
        let stage_cycle = self.stage_cycle();
        let sample = Sample::over(&mut self.world, &self.scene.regions, Some(&self.reference));
        self.recording
            .take(&sample, self.course.stage as u32, stage_cycle);
        self.world.take_fracc();
        let name = self.stage_name().to_owned();
        if let (Some(csv), Some(row)) = (&mut self.csv, self.recording.rows().last()) {
            self.recording.write(row, &name, csv)?;
        }
        Ok(())
    }

    /// Ends the run: last row, end of the journal, everything handed to the files.
    pub fn finish(&mut self) -> Result<(), RunError> {
        // Half a cycle is no state to measure.
        if !self.world.is_broken() {
            self.take_row()?;
        }
        self.note(EventKind::End)?;
        self.flush()
    }

    /// Hands the rows so far to the operating system: others see them from there.
    pub fn hand_over(&mut self) -> Result<(), RunError> {
        let csv = self.csv.as_mut();
        Ok(csv.map_or(Ok(()), crate::record::history::History::flush)?)
    }

    /// Hands everything recorded so far to the files, and returns once it would survive a power cut.
    pub fn flush(&mut self) -> Result<(), RunError> {
        if let Some(csv) = &mut self.csv {
            csv.sync()?;
        }
        if let Some(journal) = &mut self.journal_file {
            journal.sync()?;
        }
        Ok(())
    }
}
