//! What a contact tells the energy ledger.

use serde::{Deserialize, Serialize};

/// What one contact contributes to the energy ledger.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Book {
    /// Dashpot forces at the last boundary [N].
    pub damping: [f64; 2],
    /// Friction beyond the spring's own at the last boundary [N].
    pub excess: f64,
    /// Energy lost in the last step by sliding of the whole contact, rolling included, and by slip
    /// within it [J].
    pub friction_loss: [f64; 2],
    /// Energy lost in the dashpots in the last step [J].
    pub damping_loss: f64,
    /// Tangential displacement since first touch [m].
    pub delta: f64,
    /// Energy lost since first touch: sliding, slip within, dashpots [J].
    pub lost: [f64; 3],
    /// Tangential way, without sign, over the cycles in which the whole contact slid, since first
    /// touch or since it was forgotten [m]. The step in which sliding begins or turns counts whole:
    /// its elastic part is in it.
    pub slid: f64,
}

/// A step of a contact.
pub(super) struct Step {
    /// Along the normal and across it [m].
    pub(super) way: [f64; 2],
    /// Whether the whole contact slid.
    pub(super) sliding: bool,
}

impl Book {
    /// Books a step of the contact.
    pub(super) fn book(&mut self, loss: [f64; 2], damping: [f64; 2], excess: f64, step: &Step) {
        let way = step.way;
        // Both are those of the ends of the step.
        let mean = |old: f64, new: f64, step: f64| 0.5 * (old + new) * step;
        self.friction_loss = [loss[0] + mean(self.excess, excess, way[1]), loss[1]];
        self.damping_loss =
            mean(self.damping[0], damping[0], way[0]) + mean(self.damping[1], damping[1], way[1]);
        self.damping = damping;
        self.excess = excess;
        self.delta += way[1];
        if step.sliding {
            self.slid += way[1].abs();
        }
        for (lost, now) in self.lost.iter_mut().zip([
            self.friction_loss[0],
            self.friction_loss[1],
            self.damping_loss,
        ]) {
            *lost += now;
        }
    }
}
