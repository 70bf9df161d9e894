//! Damping of the motion, and the kick with it.

use crate::engine::lanes::Lanes;
use crate::engine::setup::Damping;

/// Damping of the motion, in lanes.
pub(in crate::engine) trait Drag: Copy + Sync {
    /// New velocities from the old ones, the answers to force and the forces.
    fn kick<V: Lanes>(&self, v: V, gain: V, force: V) -> V;
}

/// None.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Free;

impl Drag for Free {
    #[inline(always)]
    fn kick<V: Lanes>(&self, v: V, gain: V, force: V) -> V {
        v + gain * force
    }
}

/// Global, local and CON1 damping together.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Dragged {
    /// α dt/2.
    half: f64,
    local: f64,
    con1: f64,
}

impl Dragged {
    /// For a step of dt [s]; `None` when nothing damps.
    pub(in crate::engine) fn new(damping: &Damping, dt: f64) -> Option<Self> {
        let drag = Self {
            half: 0.5 * damping.global * dt,
            local: damping.local,
            con1: damping.con1,
        };
        (drag.half != 0.0 || drag.local != 0.0 || drag.con1 != 1.0).then_some(drag)
    }

    /// The velocity before the kick for which the mean of before and after is `mean`.
    fn before(&self, mean: f64, gain: f64, force: f64) -> f64 {
        // At rest in the mean, the half step before it goes against the force.
        let against = if mean == 0.0 { -force } else { mean };
        let force = force - self.local * force.abs() * sign(against);
        let kept = self.con1 * (1.0 - self.half) / (1.0 + self.half);
        (2.0 * mean - self.con1 * gain * force / (1.0 + self.half)) / (1.0 + kept)
    }
}

impl Drag for Dragged {
    #[inline(always)]
    fn kick<V: Lanes>(&self, v: V, gain: V, force: V) -> V {
        let (zero, one) = (V::all(0.0), V::all(1.0));
        let (half, local, con1) = (V::all(self.half), V::all(self.local), V::all(self.con1));
        let against = V::pick(v.above(zero), force.abs(), -force.abs());
        let left = V::pick(v.equals(zero), force, force - local * against);
        let kicked = con1 * ((v * (one - half) + gain * left) / (one + half));
        // A prescribed velocity is not damped.
        V::pick(gain.equals(zero), v, kicked)
    }
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { 1f64.copysign(x) }
}

/// The kick as the pass over the particles gives it, for a single degree of freedom.
pub(in crate::engine) fn kick(drag: Option<Dragged>, v: f64, gain: f64, force: f64) -> f64 {
    match drag {
        None => Free.kick(v, gain, force),
        Some(drag) => drag.kick(v, gain, force),
    }
}

/// The velocity of the half step before a boundary at which the mean of the half steps is `mean`.
pub(in crate::engine) fn before(drag: Option<Dragged>, mean: f64, gain: f64, force: f64) -> f64 {
    match drag {
        Some(drag) if gain != 0.0 => drag.before(mean, gain, force),
        _ => mean - 0.5 * gain * force,
    }
}
