//! What a condition may ask besides columns, and whether it holds.

use crate::engine::World;
use crate::language::{Expression, Term};
use crate::measure::columns::Column;
use crate::measure::reference::Reference;
use crate::measure::region::Region;
use crate::measure::sample::Sample;

/// Cycle, time, and cycles since what the condition belongs to began.
#[derive(Debug, Clone, Copy)]
pub(super) struct Clock {
    cycle: f64,
    time: f64,
    done: f64,
}

impl Clock {
    /// Of a world, so many cycles after that.
    pub(super) fn of(world: &World, done: u64) -> Self {
        Self {
            cycle: world.cycle_number() as f64,
            time: world.time(),
            done: done as f64,
        }
    }

    /// Value of a term; `column` knows those of columns.
    pub(super) fn value(&self, term: &Term, column: impl FnOnce(&Column) -> f64) -> f64 {
        match term {
            Term::Cycle => self.cycle,
            Term::Time => self.time,
            Term::StageCycle => self.done,
            Term::Column(name) => column(name),
        }
    }

    /// Whether a condition holds: what reads no columns is looked at in every cycle, what does every
    /// `check` cycles and at the beginning.
    pub(super) fn holds(
        &self,
        condition: &Expression,
        check: u64,
        world: &mut World,
        (regions, reference): (&[Region], &Reference),
    ) -> bool {
        // Comparisons with NaN are false: what holds without columns holds with them.
        if condition.holds(&mut |term| self.value(term, |_| f64::NAN)) {
            return true;
        }
        let due = self.done == 0.0 || world.cycle_number().is_multiple_of(check.max(1));
        if !condition.needs_sample() || !due {
            return false;
        }
        self.agrees(condition, &Sample::over(world, regions, Some(reference)))
    }

    /// Whether it holds with the columns of a sample.
    pub(super) fn agrees(&self, condition: &Expression, sample: &Sample<'_>) -> bool {
        condition.holds(&mut |term| self.value(term, |column| sample.value(column)))
    }
}
