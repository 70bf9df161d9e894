//! What the command `generate` places in a world as it is.

use super::chance::Chance;
use super::crowd::Disc;
use super::fill::{Size, Task, fill};
use super::region::Region;
use crate::engine::setup::WallSetup;
use crate::language::command::{Generate, Place};

/// What a new particle must keep clear of.
#[derive(Debug, Clone, Default)]
pub struct Around {
    /// Centre and radius of every particle [m].
    pub discs: Vec<([f64; 2], f64)>,
    /// Walls where they stand.
    pub walls: Vec<WallSetup>,
}

/// The centres of the particles that are added at this moment, cycle and next number [m].
pub fn places(wanted: &Generate, around: &Around, seed: u64, moment: (u64, u32)) -> Vec<[f64; 2]> {
    let region = match wanted.place {
        Place::Circle { centre, radius } => Region::Circle { centre, radius },
        Place::Rectangle { min, max } => Region::Rectangle { min, max },
    };
    let discs = around.discs.iter();
    let there: Vec<Disc> = discs.map(|&(at, radius)| Disc { at, radius }).collect();
    let task = Task {
        region: &region,
        walls: &around.walls,
        there: &there,
        sizes: &[Size {
            radius: wanted.radius,
            count: wanted.most() as usize,
        }],
        gap: 0.0,
        periodic: false,
        tries: None,
        stops: false,
    };
    let (discs, _) = fill(&task, &mut Chance::of_moment(seed, moment));
    discs.iter().map(|disc| disc.at).collect()
}
