//! `frac auto`: the time step keeps to a share of the stability bound.
//!
//! Now and then, and whenever neighbours are listed again, the bound is worked out for the contacts
//! that there will be until the next look, which is the further away the less that matters. Above
//! the bound the step is cut at once, a little more than needed so that a slowly growing load does
//! not cut it every time; below it the step grows by a tenth at most. It never exceeds the same
//! share of the base step. A change keeps the velocities at the boundary, not those of the half step
//! before, and is counted.

use serde::{Deserialize, Serialize};

use super::World;

/// Share of the bound that is kept to if none is named.
pub const USUAL_SHARE: f64 = 0.5;

/// Cycles from one look at the bound to the next, at least and at most. So sheared assemblies of 600 and
/// 20 000 spheres make 4 and 8 % fewer cycles a second than with a fixed step.
const AHEAD: [u64; 2] = [20, 640];

/// After so many looks that changed nothing the next is twice as far away.
const CALM: u8 = 3;

/// The step grows by this factor at most, and only if it could.
const GROWTH: f64 = 1.1;

/// A cut goes below what is allowed by this factor.
const CUT: f64 = 0.97;

/// A step that is cut is found to within this factor.
const CLOSE: f64 = 0.9;

/// Changes of the step so far.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct StepChanges {
    /// How many.
    pub count: u64,
    /// The last one: cycle, step before and after [s].
    pub last: Option<(u64, f64, f64)>,
    /// Smallest and largest step that was used [s].
    pub range: Option<[f64; 2]>,
}

/// When the bound is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Looks {
    /// Cycle of the next look.
    next: u64,
    /// Cycles that a look is good for.
    ahead: u64,
    /// How many have changed nothing since that was chosen.
    calm: u8,
}

impl Default for Looks {
    fn default() -> Self {
        Self {
            next: 0,
            ahead: AHEAD[0],
            calm: 0,
        }
    }
}

impl StepChanges {
    fn note(&mut self, cycle: u64, before: f64, after: f64) {
        self.count += 1;
        self.last = Some((cycle, before, after));
        let [low, high] = self.range.unwrap_or([before; 2]);
        self.range = Some([low.min(after), high.max(after)]);
    }
}

impl World {
    /// Multiple of the base step that is used now.
    pub fn frac(&self) -> f64 {
        match self.model.frac_auto {
            None => self.model.frac,
            Some(_) => self.dt / self.base_step,
        }
    }

    /// Changes of the step by `frac auto`.
    pub fn step_changes(&self) -> &StepChanges {
        &self.step_changes
    }

    /// Share of the stability bound that the step keeps to from now on; `None`: a fixed step.
    pub fn set_frac_auto(&mut self, share: Option<f64>) {
        self.booked(|world| {
            world.model.frac_auto = share;
            world.keeping_velocities(|world| {
                world.retime();
                world.fit_step();
            });
        });
    }

    /// The step that is used after a change of what it depends on [s].
    pub(super) fn step_now(&self) -> f64 {
        match self.model.frac_auto {
            None => self.model.frac * self.base_step,
            Some(share) if self.dt.is_finite() => self.dt.min(share * self.base_step),
            Some(share) => share * self.base_step,
        }
    }

    /// Looks at the bound if it is time to.
    pub(super) fn keep_step(&mut self) {
        let due = self.cycle >= self.looks.next || self.contacts.made == self.cycle;
        if self.model.frac_auto.is_none() || !due {
            return;
        }
        if let Some(next) = self.look_ahead() {
            self.booked(|world| world.keeping_velocities(|world| world.change_step(next)));
        }
    }

    /// Looks at the bound after a change from outside.
    pub(super) fn fit_step(&mut self) {
        self.looks = Looks::default();
        if let Some(next) = self.look_ahead() {
            self.change_step(next);
        }
    }

    /// The step that fits what is there before the first cycle.
    pub(super) fn begin_step(&mut self) {
        if let Some(dt) = self.look_ahead() {
            self.dt = dt;
            self.mobilise();
        }
    }

    fn change_step(&mut self, next: f64) {
        let before = self.dt;
        self.since = (self.time(), self.cycle);
        self.dt = next;
        self.step_changes.note(self.cycle, before, next);
        self.mobilise();
    }

    /// The step to change to, if the present one does not fit [s]; plans the next look.
    fn look_ahead(&mut self) -> Option<f64> {
        let share = self.model.frac_auto?;
        let [least, most] = AHEAD;
        let mut looks = self.looks;
        let mut limit = self.allowed(share, self.dt, looks.ahead);
        // What may come in a long time may never come.
        while limit < self.dt && looks.ahead > least {
            looks.ahead = (looks.ahead / 2).max(least);
            looks.calm = 0;
            limit = self.allowed(share, self.dt, looks.ahead);
        }
        let next = if limit > GROWTH * self.dt {
            Some(GROWTH * self.dt)
        } else if limit >= self.dt || limit <= 0.0 || limit.is_nan() {
            None
        } else {
            Some(CUT * self.step_that_allows_itself(share, limit))
        };
        if next.is_some() {
            looks = Looks::default();
        } else {
            looks.calm += 1;
        }
        if looks.calm == CALM {
            (looks.ahead, looks.calm) = ((2 * looks.ahead).min(most), 0);
        }
        looks.next = self.cycle + looks.ahead;
        self.looks = looks;
        next
    }

    /// Largest step allowed for so many cycles of this step [s].
    fn allowed(&self, share: f64, dt: f64, cycles: u64) -> f64 {
        let bound = self.stable_step_within(cycles as f64 * dt);
        share * bound.min(self.base_step)
    }

    /// A smaller step sees less far ahead, where contacts are less stiff: between one that fits for the
    /// present step [s] and that there is a largest one.
    fn step_that_allows_itself(&self, share: f64, fits: f64) -> f64 {
        let (mut fits, mut exceeds) = (fits, self.dt);
        while fits < CLOSE * exceeds {
            let between = (fits * exceeds).sqrt();
            if self.allowed(share, between, AHEAD[0]) >= between {
                fits = between;
            } else {
                exceeds = between;
            }
        }
        fits
    }
}
