//! How wide the halo of neighbours should be: wide enough that the list lasts, and tight enough that
//! few pairs are looked at in vain. Both follow from what was counted, never from a clock.

/// Making the list costs as much per particle as looking so many times at a pair out of touch: 103 ns
/// and 4.3 ns were measured with 600 spheres in a cell.
const SEARCH: f64 = 25.0;

/// Pairs per particle in a halo of one radius, equal particles lying densely: 2 φ with φ = 0.85.
const DENSE: f64 = 1.7;

/// A thin crowd counts as one with at least this share of them; a dense one has more, but those that
/// all but touch are listed in any halo.
const THIN: f64 = 0.1;

/// Where halos differ, most pairs out of touch are in wide ones, and these grow with the square of their width.
const STEEP: f64 = 2.0;

/// Bounds, in radii. In a slowly sheared assembly a few thousandths are best. Where 100 000 discs rain, and
/// compared with one radius, three quarters are 1 to 3 % faster, a half up to 9 % slower, one and a half
/// 20 % slower.
const BOUNDS: [f64; 2] = [0.001, 0.75];

/// Not more than these factors down and up at once. Up in small steps, as motion comes in bursts; down in
/// large ones, as each is another list to make.
const STEPS: [f64; 2] = [8.0, 2.0];

/// What the halo is chosen from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::engine) struct Use {
    /// Whether halos differ; those below are means then.
    pub(in crate::engine) local: bool,
    /// Halo of the present list [m].
    pub(in crate::engine) tol: f64,
    /// How much nearer two particles came, at most, since it was made [m].
    pub(in crate::engine) nearer: f64,
    /// In so many cycles.
    pub(in crate::engine) cycles: u64,
    /// Listed pairs that do not touch.
    pub(in crate::engine) apart: usize,
    /// Particles.
    pub(in crate::engine) particles: usize,
    /// Mean radius [m]: a single large one shall not widen the halo of all the small ones.
    pub(in crate::engine) radius: f64,
}

impl Use {
    /// The halo [m] at which making the list, every tol/u cycles, and looking at s tol pairs per
    /// particle, every cycle, cost least together: √(C u/s).
    pub(in crate::engine) fn best(&self) -> f64 {
        let per_cycle = self.nearer / self.cycles.max(1) as f64;
        if !(self.radius > 0.0 && self.radius.is_finite()) {
            return self.tol;
        }
        let dense = DENSE / self.radius;
        let counted = self.apart as f64 / (self.particles.max(1) as f64 * self.tol);
        let slope = if self.local {
            STEEP * counted.max(THIN * dense)
        } else {
            counted.clamp(THIN * dense, dense)
        };
        let [least, most] = BOUNDS.map(|bound| bound * self.radius);
        let best = (SEARCH * per_cycle / slope).sqrt().clamp(least, most);
        if best.is_finite() { best } else { self.tol }
    }

    /// The next halo [m].
    pub(in crate::engine) fn next(&self) -> f64 {
        let [down, up] = STEPS;
        self.best().clamp(self.tol / down, self.tol * up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEADY: Use = Use {
        local: false,
        tol: 0.1,
        nearer: 0.1,
        cycles: 100,
        apart: 17,
        particles: 100,
        radius: 1.0,
    };

    /// Cost of a cycle per particle, in looks at a pair.
    fn cost(tol: f64) -> f64 {
        let per_cycle = STEADY.nearer / STEADY.cycles as f64;
        let slope = STEADY.apart as f64 / (STEADY.particles as f64 * STEADY.tol);
        SEARCH * per_cycle / tol + slope * tol
    }

    #[test]
    fn the_best_halo_costs_least() {
        let best = STEADY.best();
        assert!(
            cost(best) < cost(1.02 * best) && cost(best) < cost(best / 1.02),
            "{best}"
        );
    }

    #[test]
    fn the_next_halo_goes_there_in_steps_and_stays_in_bounds() {
        let fast = Use {
            cycles: 1,
            ..STEADY
        };
        assert_eq!(fast.next(), STEPS[1] * fast.tol);
        let still = Use {
            nearer: 0.0,
            ..STEADY
        };
        assert_eq!(still.next(), still.tol / STEPS[0]);
        assert_eq!(still.best(), BOUNDS[0]);
        let torn = Use {
            nearer: f64::NAN,
            ..STEADY
        };
        assert_eq!(torn.next(), torn.tol);
        let empty = Use {
            particles: 0,
            radius: f64::NAN,
            ..STEADY
        };
        assert_eq!(empty.next(), empty.tol);
    }
}
