//! Whether a run stayed stable.
//!
//! A run has not stayed stable if it ended in a fault, or if energy came from nothing: `energy_error`
//! above a tenth, or a stored energy (motion and springs) above one and a half times all that was
//! there at the start, put in by walls and commands and released by gravity. The second part is
//! needed because the leapfrog keeps the ledger of linear springs closed even while they run away:
//! the product of the velocities before and after a boundary turns negative and pays for the growth.
//! Half as much again, because near the limit springs stretch further than they should without
//! running away, by 1/(1 - f²) in energy at the share f of the limit.
//!
//! In a large assembly the energy of a few particles that run away may not show; `frac_limit`, which
//! looks at every particle, is printed beside it.

use crate::engine::ledger::{Bookings, Energies};
use crate::session::figure::{figure, per_cent};

/// Largest `energy_error` of a stable run.
const UNBOOKED: f64 = 0.1;

/// Largest stored energy of a stable run, over all that it can have.
const STORED: f64 = 1.5;

/// Whether a run stayed stable.
#[derive(Debug, Clone, PartialEq)]
pub enum Stability {
    /// It did.
    Stable,
    /// Energy came from nothing: what was seen.
    Gained(String),
    /// It ended in a fault: which.
    Failed(String),
    /// Nobody knows: the study was ended in the middle of it, and so far it was.
    Unfinished,
    /// Nobody knows: the study was ended before.
    NotRun,
}

impl Stability {
    /// Whether it did.
    pub fn is_stable(&self) -> bool {
        *self == Self::Stable
    }

    /// The same of a run that was ended before its end: that it would have stayed so nobody knows.
    #[must_use]
    pub(super) fn so_far(self) -> Self {
        if self.is_stable() {
            Self::Unfinished
        } else {
            self
        }
    }

    /// Why it did not; empty if it did.
    pub fn reason(&self) -> &str {
        match self {
            Self::Stable => "",
            Self::Gained(what) | Self::Failed(what) => what,
            Self::Unfinished => "not finished",
            Self::NotRun => "not run",
        }
    }
}

/// What a run had and was given so far.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Balance {
    /// Stored at the start [J].
    opening: Option<f64>,
    /// Largest magnitude of the work done on it [J].
    work: f64,
    /// Largest magnitude of the potential of gravity [J].
    released: f64,
}

impl Balance {
    /// Looks at the energies of a cycle; says what came from nothing, if anything did.
    pub(super) fn check(
        &mut self,
        energies: &Energies,
        bookings: &Bookings,
        cycle: u64,
    ) -> Option<String> {
        let now = energies.kinetic
            + energies.rotational
            + energies.elastic_normal
            + energies.elastic_tangential;
        let opening = *self.opening.get_or_insert(now);
        self.work = self.work.max(bookings.boundary_work.abs());
        self.released = self.released.max(energies.potential.abs());
        let had = opening + self.work + self.released;
        if bookings.energy_error > UNBOOKED {
            let share = per_cent((1e3 * bookings.energy_error).round() / 1e3);
            return Some(format!(
                "{share} of its energy came from nothing by cycle {cycle}"
            ));
        }
        (now > STORED * had || !now.is_finite()).then(|| {
            format!(
                "it held {} times the energy it was given at cycle {cycle}",
                figure(now / had)
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(balance: &mut Balance, stored: f64, work: f64, error: f64) -> Option<String> {
        let energies = Energies {
            kinetic: 0.25 * stored,
            rotational: 0.25 * stored,
            elastic_normal: 0.25 * stored,
            elastic_tangential: 0.25 * stored,
            ..Energies::default()
        };
        let bookings = Bookings {
            boundary_work: work,
            energy_error: error,
            ..Bookings::default()
        };
        balance.check(&energies, &bookings, 7)
    }

    #[test]
    fn what_was_there_or_put_in_is_no_gain() {
        let mut balance = Balance::default();
        assert_eq!(check(&mut balance, 2.0, 0.0, 0.0), None);
        assert_eq!(check(&mut balance, 2.9, 0.0, 0.09), None);
        assert!(check(&mut balance, 3.1, 0.0, 0.0).is_some());
        // Work of either sign may be given back.
        assert_eq!(check(&mut balance, 8.0, -4.0, 0.0), None);
        assert_eq!(check(&mut balance, 8.0, 0.0, 0.0), None);
        let said = check(&mut balance, 1.0, 0.0, 0.2);
        assert_eq!(
            said.as_deref(),
            Some("20 % of its energy came from nothing by cycle 7")
        );
        // What is lost without a booking is an error, but runs nowhere.
        assert_eq!(check(&mut balance, 1.0, 0.0, -0.5), None);
        assert!(check(&mut balance, f64::NAN, 0.0, 0.0).is_some());
    }

    #[test]
    fn nothing_may_stay_nothing() {
        let mut balance = Balance::default();
        assert_eq!(check(&mut balance, 0.0, 0.0, 0.0), None);
        assert_eq!(check(&mut balance, 0.0, 0.0, 0.0), None);
        assert!(check(&mut balance, 1e-9, 0.0, 0.0).is_some());
    }
}
