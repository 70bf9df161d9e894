//! Physics gone wrong, named.

use serde::{Deserialize, Serialize};

/// Why a run cannot go on. Particles are named by number, walls by name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, thiserror::Error)]
pub enum Fault {
    /// A position or velocity is not a number.
    #[error(
        "cycle {cycle}: motion of particle {particle} is not a number; \
         reduce frac and look for overlaps at the start"
    )]
    NotANumber {
        /// Cycle in which it happened.
        cycle: u64,
        /// Number of the particle.
        particle: u32,
    },
    /// A particle moved by more than its own radius within one cycle.
    #[error(
        "cycle {cycle}: particle {particle} ran away, {distance:.3e} m in one cycle is more than \
         its radius; reduce frac, or if it flies freely delete it or put a wall in its way"
    )]
    Runaway {
        /// Cycle in which it happened.
        cycle: u64,
        /// Number of the particle.
        particle: u32,
        /// Distance in that cycle [m].
        distance: f64,
    },
    /// A wall moved further in one cycle than the radius of a particle, which it would step over.
    #[error(
        "cycle {cycle}: wall {wall} ran away, {distance:.3e} m in one cycle is more than the \
         smallest radius; slow it down or reduce frac"
    )]
    WallRunaway {
        /// Cycle in which it happened.
        cycle: u64,
        /// Name of the wall.
        wall: String,
        /// Distance in that cycle, of its fastest point near particles [m].
        distance: f64,
    },
    /// A particle left the region in which particles can be found again.
    #[error(
        "cycle {cycle}: particle {particle} is lost, {distance:.3e} m from the middle of the \
         scene; close the walls or delete it"
    )]
    Lost {
        /// Cycle in which it happened.
        cycle: u64,
        /// Number of the particle.
        particle: u32,
        /// Distance from the middle of the scene [m].
        distance: f64,
    },
    /// The centre of a particle passed a wall.
    #[error(
        "cycle {cycle}: the centre of particle {particle} went through wall {wall}; \
         reduce frac, the speed, or stiffen the contact"
    )]
    ThroughWall {
        /// Cycle in which it happened.
        cycle: u64,
        /// Number of the particle.
        particle: u32,
        /// Name of the wall.
        wall: String,
    },
    /// A periodic cell has become narrower than a particle.
    #[error(
        "cycle {cycle}: the periodic cell is {width:.3e} m wide, less than the radius of a particle; \
         strain it less"
    )]
    Narrow {
        /// Cycle in which it happened.
        cycle: u64,
        /// Distance between two sides [m].
        width: f64,
    },
    /// The time step is zero, infinite or no number.
    #[error(
        "cycle {cycle}: the time step is {dt:?} s; check densities and stiffnesses, or give \
         model.time_step in seconds where no particle can move"
    )]
    NoStep {
        /// Cycle in which it was worked out.
        cycle: u64,
        /// The step [s].
        dt: f64,
    },
    /// Two centres coincide, so that the contact has no direction.
    #[error("cycle {cycle}: the centres of particles {first} and {second} coincide; reduce frac")]
    Coincident {
        /// Cycle in which it happened.
        cycle: u64,
        /// Number of one particle.
        first: u32,
        /// Number of the other.
        second: u32,
    },
}
