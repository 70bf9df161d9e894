//! Newton's second law: forces to velocities to positions, leapfrog.
//!
//! Cundall & Strack 1979, (22), (22a), (23), (23a), with global damping in the central form (35),
//! (36), Cundall's local damping and Randall's CON1. Velocities stand at half steps.

mod drag;
mod gather;
mod kernel;

pub(super) use drag::{Dragged, before, kick};

use super::boundary::Tensor;
use super::boundary::seen::Beyond;
use super::extent::Extent;
use super::lanes::Isa;
use super::neighbours::blocks::{self, BLOCK};
use super::neighbours::list::ContactList;
use super::particles::{Mobility, Row, Sum, are_far};
use super::rows::Rows;
use super::shares;
use super::threads::{Apart, MAX_THREADS, Threads};

/// What the pass noticed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Watch {
    /// Square of a speed that no particle exceeds: of the largest components [m²/s²].
    pub fastest: f64,
    /// Whether all velocities are numbers below the limit.
    pub tame: bool,
    /// Largest FRACC⁴, and the index of its particle.
    pub fracc: (f64, usize),
}

impl Watch {
    pub(super) const NOTHING: Self = Self {
        fastest: 0.0,
        tame: true,
        fracc: (0.0, 0),
    };

    fn and(self, other: Self) -> Self {
        Self {
            fastest: self.fastest.max(other.fastest),
            tame: self.tame && other.tame,
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
    pub(super) sums: Sums,
    /// Whether FRACC is evaluated.
    pub(super) fracc: bool,
    /// Particles below it in both directions do not move by their radius in a step [m/s].
    pub(super) limit: f64,
    /// Strain rate that carries all particles [1/s], and the point at rest in it [m].
    pub(super) flow: Option<(Tensor, [f64; 2])>,
    pub(super) drag: Option<Dragged>,
    /// Images that are to follow their particles.
    pub(super) beyond: Option<Beyond<'a>>,
    /// Vector instructions.
    pub(super) isa: Isa,
}

/// What is done about the sums of forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Sums {
    /// Nothing: they are those of this boundary already.
    Done,
    /// They are used and forgotten.
    Used,
    /// They are kept, for FRACC now or at the next boundary, or for whoever looks.
    Kept,
    /// They are kept with the scale that FRACC judges their change by.
    Sized,
}

/// Particles of one thread.
#[derive(Default)]
struct Stretch<'a> {
    /// Index of its first particle.
    first: usize,
    rows: &'a mut [Row],
    /// Rows of the images of these particles.
    images: &'a mut [Row],
    force: &'a mut [Sum],
    /// Boxes around the ways of its blocks, if ways are noted.
    ways: &'a mut [Extent],
    /// Whether slots are asked for ahead.
    ask: bool,
}

/// What is wrong if a stretch cannot be cut.
const FEWER: &str = "a stretch is longer than its part";

impl Stretch<'_> {
    /// Cuts off the part before this particle, with so many images.
    fn cut(&mut self, end: usize, images: usize) -> Self {
        let count = end - self.first;
        let blocks = self.ways.len().min(count / BLOCK);
        Self {
            first: std::mem::replace(&mut self.first, end),
            rows: self.rows.split_off_mut(..count).expect(FEWER),
            images: self.images.split_off_mut(..images).expect(FEWER),
            force: self.force.split_off_mut(..count).expect(FEWER),
            ways: self.ways.split_off_mut(..blocks).expect(FEWER),
            ask: self.ask,
        }
    }
}

/// Sums the contact forces (unless that was done) and moves every particle by one step.
pub(super) fn advance(
    inputs: Inputs<'_>,
    rows: &mut Rows,
    force: &mut [Sum],
    ways: &mut [Extent],
    threads: &Threads,
) -> Watch {
    in_stretches(&inputs, rows, force, ways, threads, |stretch| {
        let watch = if stretch.ways.is_empty() {
            kernel::advance(&inputs, stretch)
        } else {
            noting_ways(&inputs, stretch)
        };
        if let Some(beyond) = inputs.beyond {
            beyond.look(stretch.first, stretch.rows, stretch.images);
        }
        watch
    })
}

/// Sums the contact forces only.
pub(super) fn settle(
    inputs: Inputs<'_>,
    rows: &mut Rows,
    force: &mut [Sum],
    ways: &mut [Extent],
    threads: &Threads,
) -> Watch {
    in_stretches(&inputs, rows, force, ways, threads, |stretch| {
        kernel::sum(&inputs, stretch)
    })
}

/// Moves a few blocks after the other, whose ways are noted while they are near the processor.
fn noting_ways(inputs: &Inputs<'_>, stretch: &mut Stretch<'_>) -> Watch {
    let end = stretch.first + stretch.rows.len();
    let mut rest = Stretch {
        first: stretch.first,
        rows: &mut *stretch.rows,
        images: &mut [],
        force: &mut *stretch.force,
        ways: &mut *stretch.ways,
        ask: stretch.ask,
    };
    let mut watch = Watch::NOTHING;
    while rest.first + NEAR < end {
        let mut few = rest.cut(rest.first + NEAR, 0);
        watch = watch.and(kernel::advance(inputs, &mut few));
        blocks::go_on(few.ways, few.rows, inputs.dt);
    }
    watch = watch.and(kernel::advance(inputs, &mut rest));
    blocks::go_on(rest.ways, rest.rows, inputs.dt);
    watch
}

/// So many particles stay near the processor: 32 kB of rows, of 512, did not.
const NEAR: usize = 4 * BLOCK;

fn in_stretches(
    inputs: &Inputs<'_>,
    rows: &mut Rows,
    force: &mut [Sum],
    ways: &mut [Extent],
    threads: &Threads,
    work: impl Fn(&mut Stretch<'_>) -> Watch + Sync,
) -> Watch {
    let (rows, images) = rows.split();
    let total = rows.len();
    let parts = threads.parts(total);
    let ask = are_far(total);
    let mut rest = Stretch {
        first: 0,
        rows,
        images,
        force,
        ways,
        ask,
    };
    if parts == 1 {
        return work(&mut rest);
    }
    // Few, so that they are soon laid out.
    if parts <= FEW {
        in_parts::<FEW>(inputs, rest, (threads, parts), work)
    } else {
        in_parts::<MAX_THREADS>(inputs, rest, (threads, parts), work)
    }
}

/// Works on so many parts, at most `MOST`.
fn in_parts<const MOST: usize>(
    inputs: &Inputs<'_>,
    mut rest: Stretch<'_>,
    (threads, parts): (&Threads, usize),
    work: impl Fn(&mut Stretch<'_>) -> Watch + Sync,
) -> Watch {
    let total = rest.rows.len();
    // Blocks are not cut.
    let whole = if rest.ways.is_empty() { 1 } else { BLOCK };
    let mut jobs: [Option<Job<'_>>; MOST] = [const { None }; MOST];
    let jobs = &mut jobs[..parts];
    let mut seen_before = 0;
    for (part, job) in jobs.iter_mut().enumerate() {
        let own = shares::particles(&inputs.contacts.pairs, total, (parts, part), whole);
        let seen = match inputs.beyond {
            Some(beyond) if part + 1 < parts => beyond.below(own.end),
            _ => seen_before,
        };
        let stretch = if part + 1 < parts {
            rest.cut(own.end, seen - seen_before)
        } else {
            std::mem::take(&mut rest)
        };
        *job = Some(Apart((stretch, Watch::NOTHING)));
        seen_before = seen;
    }
    threads.run(jobs, |job| {
        if let Some(Apart((stretch, watch))) = job {
            *watch = work(stretch);
        }
    });
    jobs.iter()
        .flatten()
        .fold(Watch::NOTHING, |all, Apart((_, watch))| all.and(*watch))
}

/// A stretch and what was watched there.
type Job<'a> = Apart<(Stretch<'a>, Watch)>;

/// Parts that are laid out at once.
const FEW: usize = 4;

/// FRACC from its fourth power.
pub(super) fn fracc(fourth: f64) -> f64 {
    fourth.sqrt().sqrt()
}
