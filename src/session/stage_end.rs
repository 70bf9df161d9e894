//! Where a stage ends, and what is said there.

use super::Session;
use super::clock::Clock;
use super::course::Phase;
use super::figure::{figure, per_cent};
use crate::language::Expression;
use crate::measure::columns::Column;
use crate::measure::overlap::large_overlaps;

impl Session {
    /// Whether the stage ends here, by its condition or its longest.
    pub(super) fn look_for_stage_end(&mut self) {
        let Some(stage) = self.scene.stages.get(self.course.stage) else {
            return;
        };
        let done = self.stage_cycle();
        let limit = stage.max_cycles.or(stage.until.is_none().then_some(0));
        if self.stage_condition_holds(done) {
            self.course.phase = Phase::Over;
            if done == 0 {
                let stage = &self.scene.stages[self.course.stage];
                let columns = stage.until.as_ref().map(Expression::columns);
                let is_strain = |column: &Column| column.name().contains("strain");
                let hint = if columns.is_some_and(|columns| columns.iter().any(is_strain)) {
                    " (strains count from the start, or from the last `reference`)"
                } else {
                    ""
                };
                let name = self.stage_name();
                self.notices.push(format!(
                    "stage {name} ended at once: its condition held before the first cycle{hint}"
                ));
            }
        } else if limit.is_some_and(|limit| done >= limit) {
            self.course.phase = Phase::Over;
            let stage = &self.scene.stages[self.course.stage];
            if stage.until.is_some() {
                let name = stage.name.clone();
                self.notices.push(format!(
                    "stage {name} ended after max_cycles = {done} before its condition held"
                ));
                self.course.cut_short.push(name);
            }
        }
    }

    /// Whether the condition of this stage holds; false without one.
    fn stage_condition_holds(&mut self, done: u64) -> bool {
        let stage = &self.scene.stages[self.course.stage];
        let Some(condition) = &stage.until else {
            return false;
        };
        let check = stage.check_every.or(self.scene.check_every);
        let check = check.unwrap_or(self.recording.every);
        let against = (&self.scene.regions[..], &self.reference);
        Clock::of(&self.world, done).holds(condition, check, &mut self.world, against)
    }

    /// At the end of a stage: says if the step is longer than what is certainly stable.
    pub(super) fn judge_step(&mut self) {
        if let Some(limit) = self.world.frac_limit_exceeded() {
            let (frac, name) = (self.world.frac(), self.stage_name());
            self.notices.push(format!(
                "at the end of stage {name} frac = {} is above frac_limit = {}, up to which cycles are certainly \
                 stable: what should rest may shake; reduce model.frac, or write frac = \"auto\"",
                figure(frac),
                figure(limit)
            ));
        }
    }

    /// At the end of a stage: says how many contacts are damped critically for their depth.
    pub(super) fn judge_overlaps(&mut self) {
        let Some(share) = self.world.model().damping.overlap_critical else {
            return;
        };
        let count = large_overlaps(&self.world);
        if count > 0 {
            let name = self.stage_name();
            self.notices.push(format!(
                "at the end of stage {name} {count} of the contacts overlap by more than {} of the smaller diameter \
                 and are damped critically: see the column overlap_warnings",
                per_cent(share)
            ));
        }
    }
}
