//! `frac auto`: the time step keeps to a share of the stability bound.
//!
//! Every few cycles the bound of the present contacts is worked out. Above it the step is cut at
//! once, a little more than needed so that a slowly growing load does not cut it every time; below
//! it the step grows by a tenth at most. It never exceeds the same share of the base step, which
//! sees contacts coming that do not touch yet. A change keeps the velocities at the boundary, not
//! those of the half step before, and is counted.

use serde::{Deserialize, Serialize};

use super::World;

/// Share of the bound that is kept to if none is named.
pub const USUAL_SHARE: f64 = 0.5;

/// Cycles between two looks at the bound.
const EVERY: u64 = 20;

/// The step grows by this factor at most, and only if it could.
const GROWTH: f64 = 1.1;

/// A cut goes below what is allowed by this factor.
const CUT: f64 = 0.97;

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
        if self.model.frac_auto.is_none() || !self.cycle.is_multiple_of(EVERY) {
            return;
        }
        if self.wanted_step().is_some() {
            self.booked(|world| world.keeping_velocities(Self::fit_step));
        }
    }

    /// The step to change to, if the present one does not fit [s].
    fn wanted_step(&self) -> Option<f64> {
        let most = self.model.frac_auto? * self.stable_step().min(self.base_step);
        if most < self.dt {
            Some(CUT * most)
        } else if most > GROWTH * self.dt {
            Some(GROWTH * self.dt)
        } else {
            None
        }
    }

    fn fit_step(&mut self) {
        if let Some(next) = self.wanted_step() {
            let before = self.dt;
            self.since = (self.time(), self.cycle);
            self.dt = next;
            self.step_changes.note(self.cycle, before, next);
            self.mobilise();
        }
    }
}
