//! Who may touch whom: pairs nearer than TOL, found with boxes, kept until TOL is spent.
//!
//! Cundall's halo of 1976 (Randall 1989, 4.1). The list is sorted by particle, so contact memory
//! is carried over by walking old and new list side by side, within its own buffers.

pub(super) mod blocks;
pub(super) mod carry;
mod crop;
mod found;
mod grid;
mod halos;
pub(super) mod images;
mod level;
pub mod list;
mod members;
mod near;
mod partner;
mod party;
mod periodic;
pub(super) mod search;
pub(super) mod skin;
mod spot;
mod tiles;
pub(super) mod travel;
pub(super) mod whose;

use serde::{Deserialize, Serialize};

/// Pairs, and contacts with walls, that so many particles can have without asking for memory: three
/// pairs each, the limit of a planar network of neighbours, and every second particle at a wall.
pub fn room(particles: usize) -> [usize; 2] {
    [3 * particles + 8, particles / 2 + 16]
}

/// Force on the first body of a contact: f1, f2 [N], tangential force times lever arm over radius
/// [N]; and the moment of rolling resistance on the second [N m].
#[repr(C, align(32))]
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Slot(pub [f64; 4]);

/// How a listed contact stands: a byte, 0 to 2.
#[repr(u8)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum Status {
    /// Not touching.
    #[default]
    Apart,
    /// Touching.
    Touching,
    /// Touching, and the whole contact slid in the last cycle.
    Sliding,
}
