//! What a condition may ask besides columns.

use crate::engine::World;
use crate::language::Term;
use crate::measure::columns::Column;

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
}
