//! What came of cycles that ran until something holds.

use super::clock::Clock;
use super::figure::rough;
use super::{By, Session};
use crate::measure::sample::Sample;

/// Most columns of a condition whose values are told.
const MOST_TOLD: usize = 4;

impl Session {
    /// Ends the cycles that somebody asked for, and says whether their condition held, if they had
    /// one, and what its columns have come to.
    pub(super) fn tell_verdict(&mut self, by: By) {
        let Some(errand) = self.course.end_errand(by) else {
            return;
        };
        let Some(condition) = &errand.condition else {
            return;
        };
        let place = match by {
            By::User => String::new(),
            By::Stage => format!("stage {}: ", self.stage_name()),
        };
        let done = self.world.cycle_number() - errand.from;
        let clock = Clock::of(&self.world, done);
        let sample = Sample::over(&mut self.world, &self.scene.regions, Some(&self.reference));
        let holds = clock.agrees(condition, &sample);
        let columns = condition.columns().into_iter().take(MOST_TOLD);
        let values = columns.map(|column| {
            let value = rough(sample.value(&column));
            format!("; {} is {value}", column.name())
        });
        let values: String = values.collect();
        let cycles = match done {
            1 => "1 cycle".to_owned(),
            done => format!("{done} cycles"),
        };
        self.notices.push(if holds {
            format!("{place}`{condition}` held after {cycles}{values}")
        } else {
            format!("{place}ended after max {cycles} before `{condition}` held{values}")
        });
    }
}
