//! The curves at constant normal force, followed exactly.

use super::{Branch, Reversals, Size};
use crate::engine::lanes::Lanes;

/// What happened along the way.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Run {
    /// Displacement by sliding [m], without sign.
    pub(super) slid: f64,
    /// Loss by annular slip over μN · 3μN/(16 G\* a).
    pub(super) losses: f64,
}

/// One curve, seen from where the force is.
struct Curve {
    /// θ³ at the force.
    here: f64,
    /// θ³ where the curve ends.
    end: f64,
    /// How many times the virgin curve this one is stretched: 1 or 2.
    stretch: f64,
}

/// Loss along a virgin curve from its start to θ, over μN · 3μN/(16 G\* a).
///
/// Per displacement an annulus loses its traction times the slip; with c = αθ² and N_c = Nθ³ for
/// the stuck core that sums to μ(N - N_c - N_c' (α - c)) = μN (1 - 3/2 θ + 1/2 θ³).
#[inline(always)]
pub(super) fn lost<V: Lanes>(theta: V) -> V {
    let (one, fifth) = (V::all(1.0), V::all(0.2));
    let square = theta * theta;
    fifth - square + square * theta * (one - fifth * square)
}

impl Reversals {
    fn curve(&self, size: &Size, direction: f64) -> Curve {
        let [force, top, bottom] =
            [self.force, self.unloaded_from, self.reloaded_from].map(|f| direction * f);
        let cube = |way: f64, stretch: f64| (1.0 - way / (stretch * size.limit)).clamp(0.0, 1.0);
        let (here, end, stretch) = match self.branch {
            Branch::Virgin => (cube(force, 1.0), 0.0, 1.0),
            Branch::Unloading => (cube(top - force, 2.0), cube(top, 1.0), 2.0),
            Branch::Reloading => (cube(force - bottom, 2.0), cube(top - bottom, 2.0), 2.0),
        };
        Curve { here, end, stretch }
    }

    /// Whether this force lies before the start of the curve: θ would exceed 1.
    pub(super) fn is_before_start(&self, force: f64, direction: f64) -> bool {
        let way = match self.branch {
            Branch::Virgin => force,
            Branch::Unloading => self.unloaded_from - force,
            Branch::Reloading => force - self.reloaded_from,
        };
        direction * way < 0.0
    }

    /// θ where the force is.
    pub(super) fn theta(&self, size: &Size) -> f64 {
        libm::cbrt(self.curve(size, self.direction(0.0)).here)
    }

    /// Moves by this displacement [m] along the curves.
    pub(super) fn run(&mut self, size: &Size, displacement: f64) -> Run {
        let mut rest = displacement;
        let mut run = Run::default();
        // At most three curves: the rest of a loop, the one it began on, virgin loading.
        for _ in 0..3 {
            let direction = self.direction(rest);
            let backwards = self.branch == Branch::Reloading && direction * rest < 0.0;
            let Curve { here, end, stretch } = self.curve(size, direction);
            let end = if backwards { 1.0 } else { end };
            let theta = libm::cbrt(here);
            // θ² is linear in the displacement.
            let span = stretch * size.slide;
            let change = rest.abs() / span;
            let square = theta * theta + if backwards { change } else { -change };
            let reached = if backwards {
                square >= end
            } else {
                square <= 0.0 || square * square.sqrt() <= end
            };
            if !reached {
                let new = square.sqrt();
                let way = (here - square * new).abs();
                self.force += (stretch * size.limit * way).copysign(rest);
                run.losses += stretch * (lost(new) - lost(theta));
                break;
            }
            let new = libm::cbrt(end);
            run.losses += stretch * (lost(new) - lost(theta));
            let used = span * (theta * theta - new * new).abs();
            rest -= used.min(rest.abs()).copysign(rest);
            match self.branch {
                Branch::Virgin => {
                    self.force = direction * size.limit;
                    run.slid = rest.abs();
                    break;
                }
                Branch::Reloading if backwards => {
                    self.force = self.reloaded_from;
                    self.branch = Branch::Unloading;
                }
                Branch::Unloading => {
                    self.force = -self.unloaded_from;
                    self.forget();
                }
                Branch::Reloading => {
                    self.force = self.unloaded_from;
                    self.forget();
                }
            }
            if rest == 0.0 {
                break;
            }
        }
        run
    }
}
