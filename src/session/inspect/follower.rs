//! What a contact did, cycle by cycle, while somebody looked: bounded, and read only.

use crate::engine::World;
use crate::engine::neighbours::Status;
use crate::measure::columns::Partner;
use crate::measure::sample::find_contact;

/// Moments kept at most; then every second one goes, and half as many come.
const MOST: usize = 4096;

/// A contact at a cycle boundary.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Moment {
    /// Cycles done.
    pub cycle: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Which touch since the contact is followed, from 1: paths do not lead from one to the next.
    pub touch: u32,
    /// Overlap α [m].
    pub alpha: f64,
    /// Tangential displacement δ since first touch, or since the contact is followed if energies
    /// are not booked [m].
    pub delta: f64,
    /// Normal force N, dashpot included [N].
    pub n: f64,
    /// Tangential force T, dashpot included [N].
    pub t: f64,
}

/// Follows one contact.
#[derive(Debug, Clone)]
pub struct Follower {
    first: u32,
    partner: Partner,
    since: u64,
    moments: Vec<Moment>,
    /// The newest, kept or not; `None` while the contact is apart.
    now: Option<Moment>,
    touches: u32,
    delta: f64,
    /// Only every so many moments is kept.
    stride: u32,
    skipped: u32,
}

impl Follower {
    /// Begins with the contact as it is.
    pub(super) fn new(first: u32, partner: Partner, world: &World) -> Self {
        let mut follower = Self {
            first,
            partner,
            since: world.cycle_number(),
            moments: Vec::new(),
            now: None,
            touches: 0,
            delta: 0.0,
            stride: 1,
            skipped: 0,
        };
        if let Some(k) = follower.touching(world) {
            follower.touches = 1;
            follower.delta = world.pass().book(k).delta;
            follower.note(world, k);
        }
        follower
    }

    /// Lower particle number.
    pub(super) fn first(&self) -> u32 {
        self.first
    }

    /// The other body.
    pub(super) fn partner(&self) -> &Partner {
        &self.partner
    }

    /// `1-2` or `3-floor`.
    pub fn name(&self) -> String {
        match &self.partner {
            Partner::Particle(j) => format!("{}-{j}", self.first),
            Partner::Wall(wall) => format!("{}-{wall}", self.first),
        }
    }

    /// Whether it is of this contact.
    pub(super) fn is_of(&self, first: u32, partner: &Partner) -> bool {
        self.first == first && self.partner == *partner
    }

    /// Cycle at which it began.
    pub fn since(&self) -> u64 {
        self.since
    }

    /// Number of the listed contact, while it touches.
    pub(super) fn touching(&self, world: &World) -> Option<usize> {
        let found = find_contact(world, self.first, &self.partner);
        found.filter(|&k| world.contacts().status[k] != Status::Apart)
    }

    /// Takes the contact along after a cycle.
    pub(in crate::session) fn take(&mut self, world: &World) {
        let Some(k) = self.touching(world) else {
            self.now = None;
            return;
        };
        if self.now.is_none() {
            self.touches += 1;
            self.delta = 0.0;
            // A touch is seen from its first cycle on.
            self.skipped = self.stride;
        }
        self.delta += world.meeting(k).slide * world.dt();
        self.note(world, k);
    }

    fn note(&mut self, world: &World, k: usize) {
        let reaction = world.reaction(k);
        let moment = Moment {
            cycle: world.cycle_number(),
            time: world.time(),
            touch: self.touches,
            alpha: world.geometry(k).overlap,
            delta: self.delta,
            n: reaction.normal,
            t: reaction.tangential,
        };
        self.now = Some(moment);
        self.skipped += 1;
        if self.skipped < self.stride {
            return;
        }
        self.skipped = 0;
        self.moments.push(moment);
        if self.moments.len() > MOST {
            let mut keep = false;
            self.moments.retain(|_| {
                keep = !keep;
                keep
            });
            self.stride *= 2;
        }
    }

    /// What was kept, and the newest.
    pub fn trace(&self) -> Vec<Moment> {
        let mut trace = self.moments.clone();
        trace.extend(self.now.filter(|now| self.moments.last() != Some(now)));
        trace
    }

    /// Cycles between two moments that were kept.
    pub fn stride(&self) -> u32 {
        self.stride
    }
}
