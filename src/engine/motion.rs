//! Newton's second law: forces to velocities to positions, leapfrog.
//!
//! Cundall & Strack 1979, (22), (22a), (23), (23a), with global damping in the central form (35),
//! (36), Cundall's local damping and Randall's CON1. Velocities stand at half steps.

use super::neighbours::list::ContactList;
use super::particles::{Mobility, Row, Sum};
use super::setup::Damping;
use super::threads::{MAX_THREADS, Threads, share};

/// Damping of the motion.
pub(super) trait Drag: Copy + Sync {
    /// New velocity from the old one, the answer to force and the force.
    fn kick(&self, v: f64, gain: f64, force: f64) -> f64;
}

/// None.
#[derive(Clone, Copy)]
pub(super) struct Free;

impl Drag for Free {
    #[inline(always)]
    fn kick(&self, v: f64, gain: f64, force: f64) -> f64 {
        v + gain * force
    }
}

/// Global, local and CON1 damping together.
#[derive(Clone, Copy)]
pub(super) struct Dragged {
    /// α dt/2.
    half: f64,
    local: f64,
    con1: f64,
}

impl Dragged {
    /// For a step of dt [s]; `None` when nothing damps.
    pub(super) fn new(damping: &Damping, dt: f64) -> Option<Self> {
        let drag = Self {
            half: 0.5 * damping.global * dt,
            local: damping.local,
            con1: damping.con1,
        };
        (drag.half != 0.0 || drag.local != 0.0 || drag.con1 != 1.0).then_some(drag)
    }
}

impl Drag for Dragged {
    #[inline(always)]
    fn kick(&self, v: f64, gain: f64, force: f64) -> f64 {
        // A prescribed velocity is not damped.
        if gain == 0.0 {
            return v;
        }
        let against = if v > 0.0 { force.abs() } else { -force.abs() };
        let force = if v == 0.0 {
            force
        } else {
            force - self.local * against
        };
        self.con1 * ((v * (1.0 - self.half) + gain * force) / (1.0 + self.half))
    }
}

impl Dragged {
    /// The velocity before the kick for which the mean of before and after is `mean`.
    fn before(&self, mean: f64, gain: f64, force: f64) -> f64 {
        // At rest in the mean, the half step before it goes against the force.
        let against = if mean == 0.0 { -force } else { mean };
        let force = force - self.local * force.abs() * sign(against);
        let kept = self.con1 * (1.0 - self.half) / (1.0 + self.half);
        (2.0 * mean - self.con1 * gain * force / (1.0 + self.half)) / (1.0 + kept)
    }
}

fn sign(x: f64) -> f64 {
    if x == 0.0 { 0.0 } else { 1f64.copysign(x) }
}

/// The kick as the pass over the particles gives it, for a single degree of freedom.
pub(super) fn kick(drag: Option<Dragged>, v: f64, gain: f64, force: f64) -> f64 {
    match drag {
        None => Free.kick(v, gain, force),
        Some(drag) => drag.kick(v, gain, force),
    }
}

/// The velocity of the half step before a boundary at which the mean of the half steps is `mean`.
pub(super) fn before(drag: Option<Dragged>, mean: f64, gain: f64, force: f64) -> f64 {
    match drag {
        Some(drag) if gain != 0.0 => drag.before(mean, gain, force),
        _ => mean - 0.5 * gain * force,
    }
}

/// What the pass noticed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch {
    /// Square of the largest speed [m²/s²].
    pub fastest: f64,
    /// Whether some particle moved by its radius or more, or not by a number.
    pub wild: bool,
    /// Largest FRACC⁴, and the index of its particle.
    pub fracc: (f64, usize),
}

impl Watch {
    pub(super) const NOTHING: Self = Self {
        fastest: 0.0,
        wild: false,
        fracc: (0.0, 0),
    };

    fn and(self, other: Self) -> Self {
        Self {
            fastest: self.fastest.max(other.fastest),
            wild: self.wild || other.wild,
            // Equal values: the earlier stretch holds the lower number.
            fracc: if other.fracc.0 > self.fracc.0 {
                other.fracc
            } else {
                self.fracc
            },
        }
    }
}

/// What the pass reads.
#[derive(Clone, Copy)]
pub(super) struct Inputs<'a> {
    pub(super) contacts: &'a ContactList,
    pub(super) mobility: &'a [Mobility],
    /// Weight and applied force [N]; empty when there is none.
    pub(super) body: &'a [[f64; 2]],
    /// Time step [s].
    pub(super) dt: f64,
    /// 1, or ½ in the first kick: given velocities are those of the start.
    pub(super) part: f64,
    /// Whether forces were already summed.
    pub(super) settled: bool,
    /// Whether FRACC is evaluated.
    pub(super) fracc: bool,
    /// Whether spins exist.
    pub(super) spin: bool,
    pub(super) drag: Option<Dragged>,
}

struct Stretch<'a> {
    first: usize,
    rows: &'a mut [Row],
    force: &'a mut [Sum],
    watch: Watch,
}

/// Sums the contact forces (unless that was done) and moves every particle by one step.
pub(super) fn advance(
    inputs: Inputs<'_>,
    rows: &mut [Row],
    force: &mut [Sum],
    threads: &Threads,
) -> Watch {
    in_stretches(rows, force, threads, |stretch| match inputs.drag {
        None => dispatch(&inputs, Free, stretch),
        Some(drag) => dispatch(&inputs, drag, stretch),
    })
}

/// Sums the contact forces only.
pub(super) fn settle(
    inputs: Inputs<'_>,
    rows: &mut [Row],
    force: &mut [Sum],
    threads: &Threads,
) -> Watch {
    in_stretches(rows, force, threads, |stretch| {
        for k in 0..stretch.rows.len() {
            let old = stretch.force[k];
            let p = stretch.first + k;
            stretch.force[k] = inputs.contacts.sum::<true>(p, stretch.rows[k].radius);
            if inputs.fracc {
                let next = fracc4(
                    inputs.dt,
                    &inputs.mobility[p],
                    &stretch.rows[k],
                    &old,
                    &stretch.force[k],
                );
                if next > stretch.watch.fracc.0 {
                    stretch.watch.fracc = (next, p);
                }
            }
        }
    })
}

fn in_stretches(
    rows: &mut [Row],
    force: &mut [Sum],
    threads: &Threads,
    work: impl Fn(&mut Stretch<'_>) + Sync,
) -> Watch {
    let total = rows.len();
    let parts = threads.parts(total);
    let mut rest = Stretch {
        first: 0,
        rows,
        force,
        watch: Watch::NOTHING,
    };
    if parts == 1 {
        work(&mut rest);
        return rest.watch;
    }
    let mut jobs: [Option<Stretch<'_>>; MAX_THREADS] = [const { None }; MAX_THREADS];
    for (part, job) in jobs.iter_mut().enumerate().take(parts) {
        let n = share(total, parts, part).len();
        let (rows, rows_rest) = rest.rows.split_at_mut(n);
        let (force, force_rest) = rest.force.split_at_mut(n);
        *job = Some(Stretch {
            first: rest.first,
            rows,
            force,
            watch: Watch::NOTHING,
        });
        rest = Stretch {
            first: rest.first + n,
            rows: rows_rest,
            force: force_rest,
            watch: Watch::NOTHING,
        };
    }
    threads.run(&mut jobs[..parts], |job| {
        if let Some(stretch) = job {
            work(stretch);
        }
    });
    jobs.iter()
        .flatten()
        .fold(Watch::NOTHING, |all, stretch| all.and(stretch.watch))
}

fn dispatch<D: Drag>(inputs: &Inputs<'_>, drag: D, stretch: &mut Stretch<'_>) {
    match (inputs.settled, inputs.fracc) {
        (true, _) => run::<D, false, false>(inputs, drag, stretch),
        (false, false) => run::<D, true, false>(inputs, drag, stretch),
        (false, true) => run::<D, true, true>(inputs, drag, stretch),
    }
}

fn run<D: Drag, const GATHER: bool, const FRACC: bool>(
    inputs: &Inputs<'_>,
    drag: D,
    stretch: &mut Stretch<'_>,
) {
    let Inputs { dt, part, .. } = *inputs;
    let mut watch = Watch::NOTHING;
    let mut tame = true;
    for (k, (row, force)) in stretch
        .rows
        .iter_mut()
        .zip(stretch.force.iter_mut())
        .enumerate()
    {
        let p = stretch.first + k;
        let mobility = &inputs.mobility[p];
        if GATHER {
            let sum = inputs.contacts.sum::<FRACC>(p, row.radius);
            if FRACC {
                let next = fracc4(dt, mobility, row, force, &sum);
                if next > watch.fracc.0 {
                    watch.fracc = (next, p);
                }
            }
            *force = sum;
        }
        let body = inputs.body.get(p).copied().unwrap_or([0.0; 2]);
        let total = [force.f[0] + body[0], force.f[1] + body[1]];
        row.v[0] = drag.kick(row.v[0], part * mobility.kick[0], total[0]);
        row.v[1] = drag.kick(row.v[1], part * mobility.kick[1], total[1]);
        row.x[0] += row.v[0] * dt;
        row.x[1] += row.v[1] * dt;
        if inputs.spin {
            row.spin = drag.kick(row.spin, part * mobility.turn, force.tau);
            row.angle += row.spin * dt;
        }
        let speed = row.v[0] * row.v[0] + row.v[1] * row.v[1];
        // Written so that a NaN fails it.
        tame &= speed * (dt * dt) < row.radius * row.radius;
        watch.fastest = if speed > watch.fastest {
            speed
        } else {
            watch.fastest
        };
    }
    watch.wild = !tame;
    stretch.watch = watch;
}

/// FRACC⁴ of one particle, (4.35) to (4.40) with the vector difference of the force sums:
/// dt⁴ |ΔΣF|²/(16 m² |Δx|²). Zero where it says nothing: neither place nor force changed beyond
/// rounding, or the velocity is prescribed.
#[inline(always)]
fn fracc4(dt: f64, mobility: &Mobility, row: &Row, old: &Sum, new: &Sum) -> f64 {
    let d = [new.f[0] - old.f[0], new.f[1] - old.f[1]];
    let change = d[0] * d[0] + d[1] * d[1];
    let speed = row.v[0] * row.v[0] + row.v[1] * row.v[1];
    let gain = mobility.kick[0] * mobility.kick[1];
    let noise = 1e-12 * new.scale;
    let rest = 1e-15 * row.radius;
    if change > noise * noise && speed * (dt * dt) > rest * rest {
        gain * change / (16.0 * speed)
    } else {
        0.0
    }
}

/// FRACC from its fourth power.
pub(super) fn fracc(fourth: f64) -> f64 {
    fourth.sqrt().sqrt()
}
