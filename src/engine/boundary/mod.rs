//! What strain and stress are imposed by: a ring of particles, walls, a periodic cell, and the flow
//! of a continuum that carries all particles along.
//!
//! A flow moves positions and enters the relative velocities of contacts, but never the velocities
//! that are stored: those are the particles' own, beside the flow (Cundall 1988 in Randall 1989,
//! (4.41), (4.42)).

pub mod cell;
mod drive;
mod ring;
pub(super) mod seen;
pub mod straining;

use serde::{Deserialize, Serialize};

pub use cell::Cell;
pub use ring::Ring;
pub use straining::{Straining, Tensor};

use super::setup::BoundarySetup;

/// The boundary as it is now. Positions are relative to the origin of the world.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Boundary {
    /// Its kind.
    pub kind: Kind,
    /// The point that the imposed strain leaves where it is [m].
    pub centre: [f64; 2],
    /// The imposed strain.
    pub straining: Straining,
    /// Whether it carries all particles along, as a cell always does.
    pub carries: bool,
}

/// What the boundary consists of.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Kind {
    /// Particles.
    Ring(Ring),
    /// The walls of the scene.
    Walls,
    /// Images of the assembly.
    Cell(Cell),
}

impl Boundary {
    /// From the setup.
    pub(super) fn new(setup: BoundarySetup, origin: [f64; 2], rate: Tensor) -> Self {
        let inner = |x: [f64; 2]| [x[0] - origin[0], x[1] - origin[1]];
        let (kind, centre) = match setup {
            BoundarySetup::Ring {
                centre,
                radius,
                turning,
            } => (Kind::Ring(Ring::new(radius, turning)), inner(centre)),
            BoundarySetup::Walls { centre } => (Kind::Walls, inner(centre)),
            BoundarySetup::Cell { corner, edges } => {
                let corner = inner(corner);
                let middle = |k: usize| corner[k] + 0.5 * (edges[0][k] + edges[1][k]);
                (Kind::Cell(Cell { corner, edges }), [middle(0), middle(1)])
            }
        };
        let mut straining = Straining::default();
        straining.set(rate, 0, 0);
        let carries = matches!(kind, Kind::Cell(_));
        Self {
            kind,
            centre,
            straining,
            carries,
        }
    }

    /// The same where the origin of coordinates is further back by this much [m].
    pub(super) fn moved(&self, by: [f64; 2]) -> Self {
        let there = |x: [f64; 2]| [x[0] + by[0], x[1] + by[1]];
        let mut moved = self.clone();
        moved.centre = there(self.centre);
        if let Kind::Cell(cell) = &mut moved.kind {
            cell.corner = there(cell.corner);
        }
        moved
    }

    /// Nothing is imposed any more, and no strain has been.
    pub(super) fn rest(&mut self) {
        self.straining = Straining::default();
        if let Kind::Ring(ring) = &mut self.kind {
            ring.hold();
        }
    }

    /// What is imposed goes on as it is now; ramps and servos end, and strain counts from zero.
    pub(super) fn restart(&mut self) {
        self.straining.restart();
        if let Kind::Ring(ring) = &mut self.kind
            && let Some(stress) = ring.stress()
        {
            let chain = ring.chain().to_vec();
            ring.carry(stress, 0, 0, chain);
        }
    }

    /// What a preset would say of it: of a ring that was strained, the circle of the same area.
    pub fn setup(&self) -> BoundarySetup {
        match &self.kind {
            Kind::Ring(ring) => BoundarySetup::Ring {
                centre: self.centre,
                radius: ring.mean_radius(),
                turning: ring.turning,
            },
            Kind::Walls => BoundarySetup::Walls {
                centre: self.centre,
            },
            Kind::Cell(Cell { corner, edges }) => BoundarySetup::Cell {
                corner: *corner,
                edges: *edges,
            },
        }
    }

    /// The cell, if it is one.
    pub fn cell(&self) -> Option<&Cell> {
        match &self.kind {
            Kind::Cell(cell) => Some(cell),
            Kind::Ring(_) | Kind::Walls => None,
        }
    }

    /// The ring, if it is one.
    pub fn ring(&self) -> Option<&Ring> {
        match &self.kind {
            Kind::Ring(ring) => Some(ring),
            Kind::Cell(_) | Kind::Walls => None,
        }
    }
}
