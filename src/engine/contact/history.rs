//! A spring that keeps its force and whose stiffness follows the load: Hertz-Mindlin shear and
//! rolling resistance.
//!
//! The stiffness k depends on the contact radius. While the load grows the force stays and new
//! stiffness acts on new displacement only; while it falls the force is rescaled with k, as the
//! part of the contact that is given up takes its share along. Without the rescaling a closed
//! cycle can gain energy: load at a large contact, unload at a small one.
//!
//! Stored is T²/(2k). What the change of k takes is closed form, too: while the load grows
//! T²(1/k - 1/k')/2, while it falls the share T²(1 - k'/k)/(2k) and the part of the work that the
//! rescaling of the mean force takes. It is slip within the contact.

use crate::engine::lanes::Lanes;

/// Answer of one step.
#[derive(Clone, Copy)]
pub(super) struct Kept<V: Lanes> {
    /// Force, or moment.
    pub(super) force: V,
    /// Energy lost by sliding of the whole, and by slip within [J].
    pub(super) loss: [V; 2],
    /// Whether the limit was reached.
    pub(super) sliding: V::Mask,
}

/// Moves a spring that held `old` at stiffness `before` by `d` to the stiffness `k`; `rescale` whether
/// the force falls with k. With k = 0, where a summed normal force is used up while the bodies still
/// overlap, it lets go of all.
#[inline(always)]
pub(super) fn follow<V: Lanes>(old: V, before: V, k: V, rescale: bool, d: V, limit: V) -> Kept<V> {
    let (zero, half) = (V::all(0.0), V::all(0.5));
    let firm = k.above(zero);
    let start = if rescale {
        V::pick(before.above(k), old * (k / before), old)
    } else {
        V::pick(firm, old, zero)
    };
    let trial = start + k * d;
    let (force, sliding) = clipped(trial, limit);
    let gross = half * (start + force) * ((trial - force) / k);
    let held = V::pick(firm, start * start / k, zero);
    let slip = half * (old - start) * d + half * (old * old / before - held);
    Kept {
        force,
        loss: [
            V::pick(sliding & firm, gross, zero),
            V::pick(old.equals(zero), zero, slip),
        ],
        sliding,
    }
}

/// A force that its limit lets pass, or the limit in its direction; and whether it was beyond. What is not
/// a number stays that: nothing may hide it.
#[inline(always)]
pub(super) fn clipped<V: Lanes>(trial: V, limit: V) -> (V, V::Mask) {
    let size = trial.abs();
    (limit.smaller(size).copysign(trial), size.above(limit))
}

/// Energy stored [J].
pub(super) fn stored(force: f64, k: f64) -> f64 {
    if k > 0.0 {
        0.5 * force * force / k
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forces_keep_their_direction_and_nothing_hides_what_is_not_a_number() {
        assert_eq!(clipped(-3.0, 2.0), (-2.0, true));
        assert_eq!(clipped(3.0, 4.0), (3.0, false));
        assert_eq!(clipped(3.0, 3.0), (3.0, false));
        let (force, sliding) = clipped(f64::NAN, 2.0);
        assert!(force.is_nan() && !sliding);
    }

    /// Work of the mean force = change of the stored energy + losses, whatever the step.
    #[test]
    fn the_books_close() {
        let cases = [
            (3.0, 2.0, 5.0, 0.1, 1e9),
            (3.0, 5.0, 2.0, 0.1, 1e9),
            (3.0, 5.0, 2.0, -0.4, 1e9),
            (3.0, 2.0, 5.0, 0.4, 4.0),
            (-3.0, 5.0, 2.0, -0.8, 2.0),
            (3.0, 5.0, 2.0, 0.0, 0.5),
            (3.0, 5.0, 0.0, 0.2, 1.0),
            (3.0, 5.0, 0.0, -0.2, 0.0),
            (0.0, 0.0, 0.0, 0.3, 0.0),
        ];
        for (old, before, k, d, limit) in cases {
            for rescale in [false, true] {
                let now = follow(old, before, k, rescale, d, limit);
                let work = 0.5 * (old + now.force) * d;
                let gain = stored(now.force, k) - stored(old, before);
                let missing = work - gain - now.loss[0] - now.loss[1];
                assert!(missing.abs() < 1e-14, "{old} {before} {k} {d}: {missing}");
            }
        }
    }

    /// Slip within is half of T (1 - k'/k) (d + T/k) while the load falls and half of T² (1/k - 1/k') while
    /// it grows, so neither is a gain as long as a step does not turn the force round.
    #[test]
    fn only_rescaled_springs_never_gain() {
        let mut gains = [0, 0];
        for (old, before) in [(3.0, 2.0), (3.0, 5.0), (-0.7, 1.0), (0.0, 4.0)] {
            for k in [0.5, 2.0, 3.0, 5.0, 20.0] {
                for share in [-1.0, -0.6, -0.1, 0.0, 0.1, 0.6, 1.0] {
                    for limit in [0.2, 2.0, 1e9] {
                        let d = share * old / f64::max(before, k);
                        for rescale in [false, true] {
                            let now = follow(old, before, k, rescale, d, limit);
                            let gained = now.loss.iter().any(|&loss| loss < -1e-15);
                            gains[usize::from(rescale)] += usize::from(gained);
                        }
                    }
                }
            }
        }
        assert!(gains[0] > 100 && gains[1] == 0, "{gains:?}");
    }
}
