//! The loop over the particles: sums of contact forces, kick, drift, and what is watched.
//!
//! A particle is two rows of four numbers, its force one. What is watched is worked out for four
//! particles at once.
#![allow(
    unsafe_code,
    reason = "rows by pointer and vector instructions; each use says what it relies on"
)]

use super::drag::{Drag, Free};
use super::gather::{Gather, Total};
use super::{Inputs, Stretch, Sums, Watch};
#[cfg(target_arch = "x86_64")]
use crate::engine::lanes::Four;
use crate::engine::lanes::{Isa, Quad, Scalars};
use crate::engine::particles::{Row, Sum};

/// Sums the contact forces (unless that was done) and moves every particle of a stretch.
pub(super) fn advance(inputs: &Inputs<'_>, stretch: &mut Stretch<'_>) -> Watch {
    match inputs.drag {
        None => damped(inputs, Free, stretch),
        Some(drag) => damped(inputs, drag, stretch),
    }
}

/// Sums the contact forces only.
pub(super) fn sum(inputs: &Inputs<'_>, stretch: &mut Stretch<'_>) -> Watch {
    match inputs.sums {
        Sums::Sized => chosen::<Free, SIZED, false, true>(inputs, Free, stretch),
        _ => chosen::<Free, KEPT, false, true>(inputs, Free, stretch),
    }
}

/// [`Sums`] as constants. `MORE`: there may be constant forces, walls, resistance to rolling.
const DONE: u8 = 0;
const USED: u8 = 1;
const KEPT: u8 = 2;
const SIZED: u8 = 3;

fn damped<D: Drag>(inputs: &Inputs<'_>, drag: D, stretch: &mut Stretch<'_>) -> Watch {
    let contacts = inputs.contacts;
    let more = !inputs.body.is_empty() || contacts.rolls || contacts.whose().meet_walls();
    match inputs.sums {
        Sums::Done => chosen::<D, DONE, true, true>(inputs, drag, stretch),
        // Skips, particle by particle, whatever the scene does not have.
        Sums::Used if !more => chosen::<D, USED, true, false>(inputs, drag, stretch),
        Sums::Used => chosen::<D, USED, true, true>(inputs, drag, stretch),
        Sums::Kept if !more => chosen::<D, KEPT, true, false>(inputs, drag, stretch),
        Sums::Kept => chosen::<D, KEPT, true, true>(inputs, drag, stretch),
        Sums::Sized => chosen::<D, SIZED, true, true>(inputs, drag, stretch),
    }
}

fn chosen<D: Drag, const SUM: u8, const MOVE: bool, const MORE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    #[cfg(target_arch = "x86_64")]
    if inputs.isa >= Isa::Avx2 && Isa::Avx2.is_here() {
        // SAFETY: the processor has it.
        return unsafe { with_four::<D, SUM, MOVE, MORE>(inputs, drag, stretch) };
    }
    run::<Scalars, D, SUM, MOVE, MORE>(inputs, drag, stretch)
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn with_four<D: Drag, const SUM: u8, const MOVE: bool, const MORE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    run::<Four, D, SUM, MOVE, MORE>(inputs, drag, stretch)
}

/// What one particle leaves for FRACC.
#[derive(Clone, Copy)]
struct Seen<Q> {
    /// Velocity and radius before.
    before: Q,
    /// Change of the force, and last the scale that it is judged by.
    change: Q,
    /// Its answer to force.
    gain: Q,
}

impl<Q: Quad> Seen<Q> {
    /// Of a particle that is not there: at rest, of radius one, under no force.
    #[inline(always)]
    fn nobody() -> Self {
        let zero = Q::all(0.0);
        Self {
            before: zero.with_last(Q::all(1.0)),
            change: zero,
            gain: zero,
        }
    }
}

/// The loop over a stretch, ready to run.
struct Loop<'a, Q: Quad, D> {
    drag: D,
    gather: Gather<'a>,
    mobility: *const f64,
    /// Constant forces, if any.
    body: Option<*const [f64; 2]>,
    /// Whether any contact resists rolling.
    rolls: bool,
    dt: Q,
    part: Q,
    /// Columns of the strain rate that carries all particles, and the point at rest in it.
    flow: Option<[Q; 3]>,
}

#[inline(always)]
fn run<Q: Quad, D: Drag, const SUM: u8, const MOVE: bool, const MORE: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) -> Watch {
    let Stretch {
        first,
        rows,
        force,
        ask,
        ..
    } = stretch;
    let (first, count) = (*first, rows.len());
    let particles = inputs.mobility.len();
    assert!(
        force.len() == count
            && first + count <= particles
            && (inputs.body.is_empty() || inputs.body.len() == particles),
        "columns of particles differ in length"
    );
    let all = Loop::<Q, D>::new(inputs, drag);
    let mut watched = Watched::<Q>::new(inputs);
    let ask = *ask;
    let (rows, force) = (rows.as_mut_ptr(), force.as_mut_ptr());
    let mut k = 0;
    // SAFETY: a stretch has so many rows and sums, and its particles have mobilities, constant forces
    // if any, and contacts.
    unsafe {
        while k + 4 <= count {
            if SUM != DONE && ask {
                all.gather.ask_for(first + k);
            }
            // One by one and by no closure, so that what they leave stays in registers.
            let (p, row, sum) = (first + k, rows.add(k), force.add(k));
            let seen = [
                all.one::<SUM, MOVE, MORE>(&mut watched, p, row, sum),
                all.one::<SUM, MOVE, MORE>(&mut watched, p + 1, row.add(1), sum.add(1)),
                all.one::<SUM, MOVE, MORE>(&mut watched, p + 2, row.add(2), sum.add(2)),
                all.one::<SUM, MOVE, MORE>(&mut watched, p + 3, row.add(3), sum.add(3)),
            ];
            if SUM >= KEPT && inputs.fracc {
                watched.fracc(inputs.dt, p, &seen);
            }
            k += 4;
        }
        let mut seen = [Seen::nobody(); 4];
        let p = first + k;
        for seen in seen.iter_mut().take(count - k) {
            *seen = all.one::<SUM, MOVE, MORE>(&mut watched, first + k, rows.add(k), force.add(k));
            k += 1;
        }
        if SUM >= KEPT && inputs.fracc {
            watched.fracc(inputs.dt, p, &seen);
        }
    }
    watched.result()
}

impl<'a, Q: Quad, D: Drag> Loop<'a, Q, D> {
    #[inline(always)]
    fn new(inputs: &Inputs<'a>, drag: D) -> Self {
        let body = (!inputs.body.is_empty()).then_some(inputs.body.as_ptr());
        let flow = inputs.flow.map(|(rate, [c1, c2])| {
            [
                Q::of_four([rate[0][0], rate[1][0], 0.0, 0.0]),
                Q::of_four([rate[0][1], rate[1][1], 0.0, 0.0]),
                Q::of_four([c1, c2, 0.0, 0.0]),
            ]
        });
        Self {
            drag,
            gather: Gather::new(inputs.contacts, inputs.mobility.len()),
            mobility: inputs.mobility.as_ptr().cast(),
            body,
            rolls: inputs.contacts.rolls,
            dt: Q::all(inputs.dt),
            part: Q::all(inputs.part),
            flow,
        }
    }

    /// Particle `p`.
    ///
    /// # Safety
    /// There must be such a particle, and nobody else may work on its row and sum.
    #[inline(always)]
    unsafe fn one<const SUM: u8, const MOVE: bool, const MORE: bool>(
        &self,
        watched: &mut Watched<Q>,
        p: usize,
        row: *mut Row,
        force: *mut Sum,
    ) -> Seen<Q> {
        // SAFETY: the caller's; rows, sums and mobilities are two, one and one times four numbers.
        unsafe {
            let state = row.cast::<f64>();
            let sum = force.cast::<f64>();
            let mut seen = Seen::nobody();
            let mut total = match SUM {
                DONE => Q::read(sum),
                USED => self.gathered::<false, MORE>(p, state).force,
                _ => {
                    let (total, change) = self.summed::<SUM, MORE>(p, state, sum);
                    total.write(sum);
                    seen.change = change;
                    total
                }
            };
            seen.before = Q::read(state);
            seen.gain = Q::read(self.mobility.add(4 * p));
            if !MOVE {
                return seen;
            }
            if MORE && let Some(body) = self.body {
                total = total + Q::read_two(body.add(p).cast());
            }
            let kicked = self.drag.kick(seen.before, self.part * seen.gain, total);
            let kicked = kicked.with_last(seen.before);
            let mut place = Q::read(state.add(4));
            if let Some([first, second, centre]) = self.flow {
                let [d1, d2] = (place - centre).spread();
                place = place + -(first * d1 + second * d2) * self.dt;
            }
            let moved = place + kicked * self.dt;
            kicked.write(state);
            // Spin times radius, where contacts look for it.
            moved
                .with_last(kicked * kicked.swapped())
                .write(state.add(4));
            watched.speed(kicked);
            seen
        }
    }

    /// The sums of the forces on particle `p` with the scale that goes with them, and their change.
    #[inline(always)]
    unsafe fn summed<const SUM: u8, const MORE: bool>(
        &self,
        p: usize,
        state: *const f64,
        sum: *const f64,
    ) -> (Q, Q) {
        // SAFETY: the caller's: there is such a particle, with a row and a sum.
        unsafe {
            let was = Q::read(sum);
            let total = if SUM == SIZED {
                let sums = self.gathered::<true, MORE>(p, state);
                let size = (sums.size + sums.size.swapped()).spread()[0];
                sums.force.with_last(size)
            } else {
                self.gathered::<false, MORE>(p, state).force.with_last(was)
            };
            (total, (total - was).with_last(total))
        }
    }

    /// The sums over the contacts of particle `p`, rolling moments with the others.
    #[inline(always)]
    unsafe fn gathered<const SIZE: bool, const MORE: bool>(
        &self,
        p: usize,
        state: *const f64,
    ) -> Total<Q> {
        // SAFETY: the caller's: there is such a particle, with a row.
        unsafe {
            let mut total = self.gather.of::<Q, SIZE, MORE>(p);
            if MORE && self.rolls {
                let mut sums = total.force.numbers();
                sums[2] -= sums[3] / *state.add(3);
                total.force = Q::of(&sums);
            }
            total
        }
    }
}

/// The largest of what was watched.
struct Watched<Q: Quad> {
    /// Of the speeds in either direction.
    fastest: Q,
    /// No particle below it moves by its radius; and whether all are.
    limit: Q,
    tame: Q::Mask,
    /// In four lanes.
    fracc: Q,
    /// Index of the particle of the largest FRACC⁴.
    index: Q,
}

impl<Q: Quad> Watched<Q> {
    #[inline(always)]
    fn new(inputs: &Inputs<'_>) -> Self {
        let zero = Q::all(0.0);
        Self {
            fastest: zero,
            limit: Q::of_four([inputs.limit, inputs.limit, f64::INFINITY, f64::INFINITY]),
            tame: Q::mask(0b1111),
            fracc: zero,
            index: zero,
        }
    }

    #[inline(always)]
    fn speed(&mut self, velocity: Q) {
        let speed = velocity.abs();
        self.fastest = self.fastest.larger(speed);
        // Written so that what is not a number fails it.
        self.tame = self.tame & self.limit.at_least(speed);
    }

    /// FRACC⁴ of four particles from `first`, (4.35) to (4.40) with the vector difference of the force
    /// sums: dt⁴ |ΔΣF|²/(16 m² |Δx|²). Zero where it says nothing: neither place nor force changed beyond
    /// rounding, or the velocity is prescribed.
    #[inline(always)]
    fn fracc(&mut self, dt: f64, first: usize, [a, b, c, d]: &[Seen<Q>; 4]) {
        let [v1, v2, _, radius] = Q::transposed([a.before, b.before, c.before, d.before]);
        let [gain1, gain2, ..] = Q::transposed([a.gain, b.gain, c.gain, d.gain]);
        let [d1, d2, _, scale] = Q::transposed([a.change, b.change, c.change, d.change]);
        let change = d1 * d1 + d2 * d2;
        let speed = v1 * v1 + v2 * v2;
        let noise = Q::all(1e-12) * scale;
        let rest = Q::all(1e-15) * radius;
        let dt2 = Q::all(dt * dt);
        let says = change.above(noise * noise) & (speed * dt2).above(rest * rest);
        let (above, below) = (gain1 * gain2 * change, Q::all(16.0) * speed);
        // Divided only if it may be the largest so far, which it seldom is.
        let least = Q::all(1.0 - 1e-12) * self.fracc * below;
        let says = says & above.above(least);
        if !Q::any(says) {
            return;
        }
        let fracc = above / below;
        let larger = says & fracc.above(self.fracc);
        self.fracc = Q::pick(larger, fracc, self.fracc);
        let index = Q::all(first as f64) + Q::of_four([0.0, 1.0, 2.0, 3.0]);
        self.index = Q::pick(larger, index, self.index);
    }

    #[inline(always)]
    fn result(self) -> Watch {
        let [fastest, fracc, index] = [
            self.fastest.numbers(),
            self.fracc.numbers(),
            self.index.numbers(),
        ];
        let mut watch = Watch {
            fastest: fastest[0] * fastest[0] + fastest[1] * fastest[1],
            tame: Q::bits(self.tame) == 0b1111,
            fracc: (0.0, 0),
        };
        for lane in 0..4 {
            let (most, which) = watch.fracc;
            let earlier = fracc[lane] == most && (index[lane] as usize) < which;
            if fracc[lane] > most || earlier && most > 0.0 {
                watch.fracc = (fracc[lane], index[lane] as usize);
            }
        }
        watch
    }
}
