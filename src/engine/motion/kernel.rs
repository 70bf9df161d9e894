//! The loop over the particles: sums of contact forces, kick, drift, and what is watched.
//!
//! A particle is two rows of four numbers, its force one. What is watched is worked out for four
//! particles at once.
#![allow(
    unsafe_code,
    reason = "rows by pointer and vector instructions; each use says what it relies on"
)]

use super::drag::{Drag, Free};
use super::{Inputs, Stretch, Watch};
#[cfg(target_arch = "x86_64")]
use crate::engine::lanes::Four;
use crate::engine::lanes::{Isa, Plain, Quad};
use crate::engine::particles::{Row, Sum};

/// Signs of force, tangential force and rolling moment on the second body, beside those on the first.
const SECOND: [f64; 4] = [-1.0, -1.0, 1.0, -1.0];

/// Sums the contact forces (unless that was done) and moves every particle of a stretch.
pub(super) fn advance(inputs: &Inputs<'_>, stretch: &mut Stretch<'_>) -> Watch {
    match inputs.drag {
        None => damped(inputs, Free, stretch),
        Some(drag) => damped(inputs, drag, stretch),
    }
}

/// Sums the contact forces only.
pub(super) fn sum(inputs: &Inputs<'_>, stretch: &mut Stretch<'_>) -> Watch {
    chosen::<Free, true, true, false>(inputs, Free, stretch)
}

fn damped<D: Drag>(inputs: &Inputs<'_>, drag: D, stretch: &mut Stretch<'_>) -> Watch {
    match (inputs.settled, inputs.fracc) {
        (true, _) => chosen::<D, false, false, true>(inputs, drag, stretch),
        (false, false) => chosen::<D, true, false, true>(inputs, drag, stretch),
        (false, true) => chosen::<D, true, true, true>(inputs, drag, stretch),
    }
}

fn chosen<D: Drag, const GATHER: bool, const FRACC: bool, const MOVE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    #[cfg(target_arch = "x86_64")]
    if inputs.isa >= Isa::Avx2 && Isa::Avx2.is_here() {
        // SAFETY: the processor has it.
        return unsafe { with_four::<D, GATHER, FRACC, MOVE>(inputs, drag, stretch) };
    }
    run::<Plain, D, GATHER, FRACC, MOVE>(inputs, drag, stretch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_four<D: Drag, const GATHER: bool, const FRACC: bool, const MOVE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    run::<Four, D, GATHER, FRACC, MOVE>(inputs, drag, stretch)
}

/// What one particle leaves to be watched.
#[derive(Clone, Copy)]
struct Seen<Q> {
    /// Velocity and radius before and after.
    before: Q,
    after: Q,
    /// Change of the force, and the sums of its absolute contact forces.
    change: Q,
}

#[inline(always)]
fn run<Q: Quad, D: Drag, const GATHER: bool, const FRACC: bool, const MOVE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    let Stretch { first, rows, force } = stretch;
    let mut watched = Watched::<Q>::new();
    // A particle that is not there: at rest, of radius one, under no force.
    let nobody = Seen {
        before: Q::of_four([0.0, 0.0, 0.0, 1.0]),
        after: Q::of_four([0.0, 0.0, 0.0, 1.0]),
        change: Q::all(0.0),
    };
    let count = rows.len().min(force.len());
    let (mut k, mut p) = (0, *first);
    while k < count {
        let mut seen = [nobody; 4];
        let mut gains = [0.0; 8];
        let block = (count - k).min(4);
        if block == 4 {
            let (rows, force) = (&mut rows[k..k + 4], &mut force[k..k + 4]);
            // One by one, so that what they leave stays in registers.
            seen = [
                one::<Q, D, GATHER, FRACC, MOVE>(inputs, &drag, p, &mut rows[0], &mut force[0]),
                one::<Q, D, GATHER, FRACC, MOVE>(inputs, &drag, p + 1, &mut rows[1], &mut force[1]),
                one::<Q, D, GATHER, FRACC, MOVE>(inputs, &drag, p + 2, &mut rows[2], &mut force[2]),
                one::<Q, D, GATHER, FRACC, MOVE>(inputs, &drag, p + 3, &mut rows[3], &mut force[3]),
            ];
        } else {
            for lane in 0..block {
                let (row, force) = (&mut rows[k + lane], &mut force[k + lane]);
                seen[lane] = one::<Q, D, GATHER, FRACC, MOVE>(inputs, &drag, p + lane, row, force);
            }
        }
        if GATHER && FRACC {
            let [_, _, one, other] = Q::transposed([
                seen[0].change,
                seen[1].change,
                seen[2].change,
                seen[3].change,
            ]);
            let scales = (one + other).numbers();
            for lane in 0..block {
                force[k + lane].scale = scales[lane];
                let [a, b] = inputs.mobility[p + lane].kick;
                gains[lane] = a * b;
            }
        }
        if FRACC && inputs.fracc || MOVE {
            watched.watch::<FRACC, MOVE>(inputs.dt, p, &seen, Q::of(&gains));
        }
        k += block;
        p += block;
    }
    watched.result()
}

/// One particle.
#[inline(always)]
fn one<Q: Quad, D: Drag, const GATHER: bool, const FRACC: bool, const MOVE: bool>(
    inputs: &Inputs<'_>,
    drag: &D,
    p: usize,
    row: &mut Row,
    force: &mut Sum,
) -> Seen<Q> {
    let contacts = inputs.contacts;
    // SAFETY: rows, forces and mobilities are two and one times four numbers, and the list of a
    // particle's entries names slots there are.
    unsafe {
        let state = std::ptr::from_mut(row).cast::<f64>();
        let sum = std::ptr::from_mut(force).cast::<f64>();
        let before = Q::read(state);
        let mut total = Q::read(sum);
        let mut change = Q::all(0.0);
        if GATHER {
            let (mut new, mut size) = (Q::all(0.0), Q::all(0.0));
            let slots = contacts.slots.as_ptr().cast::<[f64; 4]>();
            let whose = contacts.whose();
            let signs = Q::of_four(SECOND);
            for &k in whose.second(p) {
                let slot = Q::read(slots.add(k as usize).cast());
                new = new + signs * slot;
                if FRACC {
                    size = size + slot.abs();
                }
            }
            for contacts in whose.first(p) {
                for k in contacts {
                    let slot = Q::read(slots.add(k).cast());
                    new = new + slot;
                    if FRACC {
                        size = size + slot.abs();
                    }
                }
            }
            if contacts.rolls {
                let mut sums = [0.0; 4];
                new.write(sums.as_mut_ptr());
                sums[2] -= sums[3] / *state.add(3);
                new = Q::read(sums.as_ptr());
            }
            if FRACC {
                change = (new - total).joined(size);
            }
            new = new.with_last(Q::all(0.0));
            new.write(sum);
            total = new;
        }
        if !MOVE {
            return Seen {
                before,
                after: before,
                change,
            };
        }
        if let Some(body) = inputs.body.get(p) {
            total = total + Q::read_two(body.as_ptr());
        }
        let mobility = std::ptr::from_ref(&inputs.mobility[p]).cast();
        let gain = Q::all(inputs.part) * Q::read(mobility);
        let dt = Q::all(inputs.dt);
        let kicked = drag.kick(before, gain, total).with_last(before);
        let place = Q::read(state.add(4));
        let moved = place + kicked * dt;
        if inputs.spin {
            kicked.write(state);
            // Spin times radius, where contacts look for it.
            let [_, _, spin, radius, ..] = kicked.numbers();
            moved.with_last(Q::all(spin * radius)).write(state.add(4));
        } else {
            state.cast::<[f64; 2]>().write(kicked.first_two());
            state.add(4).cast::<[f64; 2]>().write(moved.first_two());
        }
        Seen {
            before,
            after: kicked,
            change,
        }
    }
}

/// The largest of what was watched, in four lanes.
struct Watched<Q: Quad> {
    fastest: Q,
    tame: bool,
    fracc: Q,
    /// Index of the particle of the largest FRACC⁴.
    index: Q,
}

impl<Q: Quad> Watched<Q> {
    #[inline(always)]
    fn new() -> Self {
        Self {
            fastest: Q::all(0.0),
            tame: true,
            fracc: Q::all(0.0),
            index: Q::all(0.0),
        }
    }

    #[inline(always)]
    fn watch<const FRACC: bool, const MOVE: bool>(
        &mut self,
        dt: f64,
        first: usize,
        seen: &[Seen<Q>; 4],
        gain: Q,
    ) {
        let dt2 = Q::all(dt * dt);
        if MOVE {
            let [a, b, c, d] = seen;
            let [v1, v2, _, radius] = Q::transposed([a.after, b.after, c.after, d.after]);
            let speed = v1 * v1 + v2 * v2;
            // Written so that what is not a number fails it.
            self.tame &= Q::bits((radius * radius).above(speed * dt2)) == 0b1111;
            self.fastest = Q::pick(speed.above(self.fastest), speed, self.fastest);
        }
        if FRACC {
            let fracc = fracc4(dt2, seen, gain);
            let larger = fracc.above(self.fracc);
            let first = first as f64;
            let index = Q::of_four([first, first + 1.0, first + 2.0, first + 3.0]);
            self.fracc = Q::pick(larger, fracc, self.fracc);
            self.index = Q::pick(larger, index, self.index);
        }
    }

    #[inline(always)]
    fn result(self) -> Watch {
        let [fastest, fracc, index] = [
            self.fastest.numbers(),
            self.fracc.numbers(),
            self.index.numbers(),
        ];
        let mut watch = Watch {
            wild: !self.tame,
            ..Watch::NOTHING
        };
        for lane in 0..4 {
            watch.fastest = watch.fastest.max(fastest[lane]);
            let (most, which) = watch.fracc;
            let earlier = fracc[lane] == most && (index[lane] as usize) < which;
            if fracc[lane] > most || earlier && most > 0.0 {
                watch.fracc = (fracc[lane], index[lane] as usize);
            }
        }
        watch
    }
}

/// FRACC⁴ of four particles, (4.35) to (4.40) with the vector difference of the force sums:
/// dt⁴ |ΔΣF|²/(16 m² |Δx|²). Zero where it says nothing: neither place nor force changed beyond
/// rounding, or the velocity is prescribed.
#[inline(always)]
fn fracc4<Q: Quad>(dt2: Q, [a, b, c, d]: &[Seen<Q>; 4], gain: Q) -> Q {
    let [v1, v2, _, radius] = Q::transposed([a.before, b.before, c.before, d.before]);
    let [d1, d2, size1, size2] = Q::transposed([a.change, b.change, c.change, d.change]);
    let change = d1 * d1 + d2 * d2;
    let speed = v1 * v1 + v2 * v2;
    let noise = Q::all(1e-12) * (size1 + size2);
    let rest = Q::all(1e-15) * radius;
    let says = change.above(noise * noise) & (speed * dt2).above(rest * rest);
    let fracc = gain * change / (Q::all(16.0) * speed);
    Q::pick(says, fracc, Q::all(0.0))
}
