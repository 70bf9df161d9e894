//! Means that a picture is drawn by, over the whole assembly whatever of it is seen: a bar keeps its
//! width when somebody looks closer.

use super::frame::{Disc, Touch};

/// The means.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Means {
    /// Contact force of the contacts that carry one [N].
    pub force: f64,
    /// Magnitude of the tangential force of those that carry one [N].
    pub tangential: f64,
    /// Radius [m].
    pub radius: f64,
}

impl Means {
    /// Of these discs and contacts.
    pub fn of(discs: &[Disc], touches: &[Touch]) -> Self {
        let mut sums = Sums::default();
        for disc in discs {
            sums.add_disc(disc.radius);
        }
        for touch in touches {
            sums.add_contact(touch.force(), touch.t);
        }
        sums.means()
    }
}

/// What they are worked out from.
#[derive(Debug, Default)]
pub(super) struct Sums {
    force: Sum,
    tangential: Sum,
    radius: Sum,
}

impl Sums {
    /// Takes in a disc of this radius [m].
    pub(super) fn add_disc(&mut self, radius: f64) {
        self.radius.add(radius);
    }

    /// Takes in a contact with this force and this tangential part of it [N].
    pub(super) fn add_contact(&mut self, force: f64, tangential: f64) {
        self.force.add(force);
        self.tangential.add(tangential.abs());
    }

    pub(super) fn means(&self) -> Means {
        Means {
            force: self.force.mean(),
            tangential: self.tangential.mean(),
            radius: self.radius.mean(),
        }
    }
}

/// Sum of what is there.
#[derive(Debug, Default)]
struct Sum {
    value: f64,
    count: u32,
}

impl Sum {
    fn add(&mut self, value: f64) {
        if value.is_finite() && value > 0.0 {
            self.value += value;
            self.count += 1;
        }
    }

    fn mean(&self) -> f64 {
        self.value / f64::from(self.count.max(1))
    }
}
