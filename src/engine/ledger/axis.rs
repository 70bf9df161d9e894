//! The degrees of freedom of a particle over one step.

use crate::engine::World;
use crate::engine::motion::{self, Dragged};

/// What the kick that comes next has in common for all particles.
pub(super) struct Coming {
    /// 1, or ½ in the first kick.
    pub(super) part: f64,
    pub(super) drag: Option<Dragged>,
    /// Whether any particle turns or can be made to.
    pub(super) spins: bool,
}

/// One degree of freedom over one step.
pub(super) struct Axis {
    /// Velocity before and after the kick.
    pub(super) v: [f64; 2],
    /// Gain of the kick, zero if prescribed.
    pub(super) gain: f64,
    /// Whether the motion is damped: without, the loss is zero and not rounding.
    pub(super) damped: bool,
    pub(super) force: f64,
    /// Work of a unit force is velocity times this.
    pub(super) lever: f64,
    /// Mass or moment of inertia.
    pub(super) inertia: f64,
}

impl Axis {
    /// Velocity of the boundary: the mean of the two, or that before the first kick.
    pub(super) fn now(&self, first: bool) -> f64 {
        if first {
            self.v[0]
        } else {
            0.5 * (self.v[0] + self.v[1])
        }
    }

    /// Force of the motion's damping.
    pub(super) fn drag(&self) -> f64 {
        if self.gain == 0.0 || !self.damped {
            0.0
        } else {
            self.force - (self.v[1] - self.v[0]) / self.gain
        }
    }
}

impl World {
    /// Work of a force over half the step before (side 0) or after (side 1) this boundary.
    pub(super) fn half_work(&self, force: f64, axis: &Axis, side: usize) -> f64 {
        0.5 * self.dt * force * axis.lever * axis.v[side]
    }

    pub(super) fn coming(&self) -> Coming {
        let part = self.kick_part();
        Coming {
            part,
            drag: Dragged::new(&self.model.damping, part * self.dt),
            spins: self.spins(),
        }
    }

    /// The degrees of freedom of a particle, with the kick they are about to get.
    #[inline(always)]
    pub(super) fn axes(&self, p: usize, coming: &Coming) -> [Axis; 3] {
        let &Coming { part, drag, spins } = coming;
        let (row, mobility) = (&self.particles.row[p], &self.particles.mobility[p]);
        let force = &self.particles.force[p];
        let body = self.particles.body.get(p).copied().unwrap_or([0.0; 2]);
        let axis = |v: f64, gain: f64, force: f64, lever: f64, inertia: f64| {
            let gain = part * gain;
            Axis {
                v: [v, motion::kick(drag, v, gain, force)],
                gain,
                damped: drag.is_some(),
                force,
                lever,
                inertia,
            }
        };
        let (m, inertia) = (self.particles.mass[p], self.particles.inertia[p]);
        let spin = if spins { row.spin } else { 0.0 };
        let turn = if spins { mobility.turn } else { 0.0 };
        [
            axis(row.v[0], mobility.kick[0], force.f[0] + body[0], 1.0, m),
            axis(row.v[1], mobility.kick[1], force.f[1] + body[1], 1.0, m),
            axis(spin, turn, force.tau, row.radius, inertia),
        ]
    }
}
