//! What came of cycles that ran until something holds.

use super::Session;
use super::clock::Clock;
use super::course::Errand;
use super::figure::rough;
use crate::language::Expression;
use crate::measure::sample::Sample;

/// Most columns of a condition whose values are told.
const MOST_TOLD: usize = 4;

impl Session {
    /// Says of an errand that has ended whether its condition held, and what its columns have come
    /// to; nothing of one without a condition. `place` is what it belongs to.
    pub(super) fn tell_verdict(&mut self, errand: &Errand, place: &str) {
        let condition = errand.condition.as_deref().map(Expression::parse_condition);
        let (Some(text), Some(Ok(condition))) = (&errand.condition, condition) else {
            return;
        };
        let done = self.world.cycle_number() - errand.from;
        let clock = Clock::of(&self.world, done);
        let sample = Sample::over(&mut self.world, &self.scene.regions, Some(&self.reference));
        let holds = condition.holds(&mut |term| clock.value(term, |column| sample.value(column)));
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
            format!("{place}`{text}` held after {cycles}{values}")
        } else {
            format!("{place}ended after max {cycles} before `{text}` held{values}")
        });
    }
}
