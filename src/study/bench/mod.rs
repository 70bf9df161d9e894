//! How fast standard scenes run, and where the time goes.
//!
//! The rate is the median of several stretches without any clock inside the cycle; where the time goes
//! is measured afterwards, by a clock that is asked after each part of every cycle.

mod bandwidth;
mod machine;
mod scenes;
mod table;

use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use rustix::time::{ClockId, clock_gettime};

pub use bandwidth::Memory;
pub use machine::{machine, peak};
pub use scenes::{STANDARD, Standard, find};
pub use table::{csv, rows};

use crate::engine::bytes::Bytes;
use crate::engine::neighbours::Status;
use crate::engine::phase::Phase;
use crate::engine::traffic::Traffic;
use crate::engine::{Fault, World};
use crate::session::Session;

/// Stretches that the median is taken of.
const STRETCHES: u32 = 5;

/// Cycles between looks at the clock, for small scenes.
const BETWEEN_LOOKS: u64 = 16;

/// More pairs than this are many: the clock is looked at after every cycle.
const MANY: usize = 20_000;

/// How long a scene is run.
#[derive(Debug, Clone, Copy)]
pub enum Length {
    /// So long [s].
    Seconds(f64),
    /// So many cycles.
    Cycles(u64),
}

/// What was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// Name of the scene.
    pub scene: String,
    /// Contact law.
    pub law: &'static str,
    /// Instructions that were used.
    pub isa: String,
    /// Number of threads.
    pub threads: usize,
    /// Particles.
    pub particles: usize,
    /// Listed pairs at the end.
    pub pairs: usize,
    /// Touching contacts, mean of start and end.
    pub contacts: f64,
    /// Cycles that were timed.
    pub cycles: u64,
    /// Cycles per second, the median.
    pub rate: f64,
    /// Share of the time in which its threads had a processor to themselves: 1 on a quiet machine.
    pub busy: f64,
    /// Mean stress in the default region after all these cycles [Pa].
    pub stress: f64,
    /// Cycles between two times the list was made; none if it never was.
    pub list_lasts: Option<f64>,
    /// Bytes of each particle and each pair.
    pub bytes: Bytes,
    /// What a step moves at least.
    pub traffic: Traffic,
    /// Most memory the process had so far [bytes], where the system tells.
    pub peak: Option<u64>,
    /// Shares of the time, in the order of [`Phase::ALL`].
    pub shares: [f64; Phase::ALL.len()],
    /// Hash of the state at the end.
    pub state: u64,
}

impl Measured {
    /// Contact updates per second.
    pub fn updates(&self) -> f64 {
        self.rate * self.contacts
    }

    /// Bytes per second that its steps move at least.
    pub fn moved(&self) -> f64 {
        self.rate * self.traffic.bytes() as f64
    }
}

/// Times a scene from where it stands.
pub fn measure(name: &str, session: &mut Session, length: Length) -> Result<Measured, Fault> {
    let world = session.world_mut();
    let first = world.cycle_number();
    let look = if world.contacts().len() > MANY {
        1
    } else {
        BETWEEN_LOOKS
    };
    // Caches and branches get used to it, lists get the room they need.
    let warm = match length {
        Length::Seconds(seconds) => Length::Seconds(0.1 * seconds),
        Length::Cycles(cycles) => Length::Cycles(cycles / 10),
    };
    stretch(world, warm, look)?;
    let (touching, lists) = (touching(world), world.contacts().rebuilds);
    let part = match length {
        Length::Seconds(seconds) => Length::Seconds(seconds / f64::from(STRETCHES)),
        Length::Cycles(cycles) => {
            Length::Cycles(((cycles - cycles / 10) / u64::from(STRETCHES)).max(1))
        }
    };
    let mut stretches = Vec::new();
    let (used, start) = (processor_time(), Instant::now());
    for _ in 0..STRETCHES {
        stretches.push(stretch(world, part, look)?);
    }
    let used = processor_time().saturating_sub(used).as_secs_f64();
    let busy = used / (start.elapsed().as_secs_f64() * world.threads() as f64).max(1e-9);
    let cycles: u64 = stretches.iter().map(|(cycles, _)| cycles).sum();
    let mut rates: Vec<f64> = (stretches.iter())
        .map(|(cycles, time)| *cycles as f64 / time.as_secs_f64().max(1e-9))
        .collect();
    rates.sort_by(f64::total_cmp);
    let (after, lists) = (self::touching(world), world.contacts().rebuilds - lists);
    // What does not divide by the stretches, so that the state is the one after all cycles.
    if let Length::Cycles(cycles) = length {
        let rest = cycles.saturating_sub(world.cycle_number() - first);
        stretch(world, Length::Cycles(rest), look)?;
    }
    let state = world.state_hash();
    let stress = session.sample().regional().stress().isotropic();
    let world = session.world_mut();
    let shares = shares(world, part, look)?;
    Ok(Measured {
        scene: name.to_owned(),
        law: world.model().law.card().name,
        isa: world.instructions().to_string(),
        threads: world.threads(),
        particles: world.particles().len(),
        pairs: world.contacts().len(),
        contacts: 0.5 * (touching + after) as f64,
        cycles,
        rate: rates[rates.len() / 2],
        busy,
        stress,
        list_lasts: (lists > 0).then(|| cycles as f64 / lists as f64),
        bytes: world.bytes(),
        traffic: world.traffic(),
        peak: peak(),
        shares,
        state,
    })
}

/// Processor time of this process so far.
fn processor_time() -> Duration {
    let used = clock_gettime(ClockId::ProcessCPUTime);
    Duration::new(used.tv_sec as u64, used.tv_nsec as u32)
}

/// Touching contacts.
fn touching(world: &World) -> usize {
    let status = world.contacts().status.iter();
    status.filter(|status| **status != Status::Apart).count()
}

/// Runs a stretch; answers its cycles and its time.
fn stretch(world: &mut World, length: Length, look: u64) -> Result<(u64, Duration), Fault> {
    let start = Instant::now();
    let mut done = 0;
    loop {
        let over = match length {
            Length::Cycles(cycles) => done >= cycles,
            Length::Seconds(seconds) => {
                done > 0 && done.is_multiple_of(look) && start.elapsed().as_secs_f64() >= seconds
            }
        };
        if over {
            return Ok((done, start.elapsed()));
        }
        world.cycle()?;
        done += 1;
    }
}

/// Where the time of a stretch goes, as shares.
fn shares(world: &mut World, length: Length, look: u64) -> Result<[f64; Phase::ALL.len()], Fault> {
    let times = Arc::new(Mutex::new([0.0; Phase::ALL.len()]));
    let shared = Arc::clone(&times);
    let mut last = Instant::now();
    world.set_clock(Some(Box::new(move |phase| {
        let now = Instant::now();
        let place = Phase::ALL.iter().position(|(_, known)| *known == phase);
        let mut times = shared.lock().unwrap_or_else(PoisonError::into_inner);
        times[place.unwrap_or_default()] += (now - last).as_secs_f64();
        last = now;
    })));
    let ran = stretch(world, length, look);
    world.set_clock(None);
    ran?;
    let times = *times.lock().unwrap_or_else(PoisonError::into_inner);
    let all: f64 = times.iter().sum();
    Ok(times.map(|time| time / all))
}
