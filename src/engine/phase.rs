//! The parts of a cycle, for whoever brings a clock and wants to know where its time goes: the engine has
//! none. Without one nothing is asked.

use super::World;

/// A part of a cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// The boundary, the imposed flow, and particles as their neighbours see them: images of a cell.
    Boundary,
    /// Sums of forces, velocities, positions.
    Motion,
    /// Walls: where they are, and how far from the particles.
    Walls,
    /// Whether the list of neighbours still holds, and making it anew.
    Neighbours,
    /// Forces of all contacts.
    Contacts,
    /// What is left.
    Rest,
}

impl Phase {
    /// With their names.
    pub const ALL: [(&str, Self); 6] = [
        ("contacts", Self::Contacts),
        ("motion", Self::Motion),
        ("neighbours", Self::Neighbours),
        ("boundary", Self::Boundary),
        ("walls", Self::Walls),
        ("rest", Self::Rest),
    ];
}

/// Told what has just been done.
pub type Clock = Box<dyn FnMut(Phase) + Send + Sync>;

/// Tells the clock, if there is one.
#[inline]
pub(super) fn passed(clock: &mut Option<Clock>, phase: Phase) {
    if let Some(clock) = clock {
        clock(phase);
    }
}

impl World {
    /// Tells `clock` after each part of every cycle from now on; `None`: nobody.
    pub fn set_clock(&mut self, clock: Option<Clock>) {
        self.clock = clock;
    }
}
