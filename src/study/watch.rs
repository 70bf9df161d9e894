//! A run looked at while it goes: contacts that touch, the stability bound, energy from nothing.

use std::time::{Duration, Instant};

use super::Beat;
use super::stability::{Balance, Stability};
use crate::engine::neighbours::Status;
use crate::session::{Budget, Progress, RunError, Session};

/// Between looks at the progress.
pub(super) const BATCH: Duration = Duration::from_millis(50);

/// Bound and energies are looked at with every row, and besides so often that the number of cycles
/// between looks doubles after so many: rows may be far between, and a look costs as much as a
/// cycle.
const LOOKS: u32 = 64;

/// What was seen of a run.
#[derive(Default)]
pub(super) struct Watch {
    touching: u64,
    rows: usize,
    /// Cycle of the next look, cycles between looks, looks at this distance.
    next: u64,
    distance: u64,
    looks: u32,
    frac_limit: Option<f64>,
    energy_error: f64,
    balance: Balance,
    gained: Option<String>,
    failed: Option<String>,
}

/// Told between batches what was seen so far; answers whether to go on.
pub(super) type Listener<'a> = dyn FnMut(&Watch, &Session) -> bool + 'a;

impl Watch {
    /// Runs to the end, cycle by cycle. Answers whether the run ended by itself.
    pub(super) fn run(
        &mut self,
        session: &mut Session,
        listener: &mut Listener<'_>,
    ) -> Result<bool, RunError> {
        let mut told = Instant::now();
        self.look(session);
        loop {
            let budget = Budget {
                until_cycle: Some(session.world().cycle_number() + 1),
                time: None,
            };
            match session.advance(budget, false) {
                Ok(Progress::Finished) => {
                    self.look(session);
                    return Ok(true);
                }
                Ok(Progress::Budget | Progress::ErrandDone) => {}
                Err(RunError::Fault(fault)) => {
                    self.failed = Some(fault.to_string());
                    return Ok(false);
                }
                Err(other) => return Err(other),
            }
            let status = session.world().contacts().status.iter();
            let touching = status.filter(|status| **status != Status::Apart);
            self.touching += touching.count() as u64;
            self.look_if_due(session);
            if told.elapsed() >= BATCH {
                if !listener(self, session) {
                    return Ok(false);
                }
                told = Instant::now();
            }
        }
    }

    fn look_if_due(&mut self, session: &mut Session) {
        let rows = session.recording().rows().len();
        if session.world().cycle_number() < self.next && rows == self.rows {
            return;
        }
        self.rows = rows;
        self.look(session);
        self.looks += 1;
        if self.looks >= LOOKS {
            self.looks = 0;
            self.distance *= 2;
        }
        self.distance = self.distance.max(1);
        self.next = session.world().cycle_number() + self.distance;
    }

    fn look(&mut self, session: &mut Session) {
        session.world_mut().settle();
        let world = session.world();
        let limit = world.frac_limit();
        self.frac_limit = Some(self.frac_limit.map_or(limit, |least| least.min(limit)));
        let Some(bookings) = world.bookings() else {
            return;
        };
        let error = bookings.energy_error.abs();
        // The first number that is none stays.
        if !self.energy_error.is_nan() {
            self.energy_error = if error.is_nan() {
                error
            } else {
                self.energy_error.max(error)
            };
        }
        let cycle = world.cycle_number();
        let gain = self.balance.check(&world.energies(), &bookings, cycle);
        self.gained = self.gained.take().or(gain);
    }

    /// Touching contacts, summed over the cycles.
    pub(super) fn touching(&self) -> u64 {
        self.touching
    }

    /// Smallest `frac_limit`.
    pub(super) fn frac_limit(&self) -> f64 {
        self.frac_limit.unwrap_or(f64::INFINITY)
    }

    /// Largest magnitude of `energy_error`.
    pub(super) fn energy_error(&self) -> f64 {
        self.energy_error
    }

    /// Whether energy has come from nothing so far.
    pub(super) fn has_gained(&self) -> bool {
        self.gained.is_some()
    }

    pub(super) fn verdict(&self) -> Stability {
        match (&self.failed, &self.gained) {
            (Some(fault), _) => Stability::Failed(fault.clone()),
            (None, Some(what)) => Stability::Gained(what.clone()),
            (None, None) => Stability::Stable,
        }
    }
}

/// Runs that have been done, and who is told of the next.
pub(super) struct Teller<'a> {
    pub(super) done: usize,
    pub(super) of: usize,
    pub(super) listen: &'a mut dyn FnMut(Beat<'_>) -> bool,
    /// Whether the listener wants no more.
    pub(super) stopped: bool,
}

impl Teller<'_> {
    /// Tells of a run; answers whether to go on.
    pub(super) fn tell(&mut self, name: &str, session: &Session) -> bool {
        let beat = Beat {
            name,
            done: self.done,
            of: self.of,
            session,
        };
        self.stopped |= !(self.listen)(beat);
        !self.stopped
    }
}
