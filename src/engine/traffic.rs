//! How much one step has to move between memory and processor, counted by what its passes read and write:
//! a bound that no order of work and no instructions can undercut once a scene is larger than the caches.

use super::World;
use super::neighbours::whose::Places;
use super::neighbours::{Slot, Status};
use super::particles::{Mobility, Row, Sum};

/// Bytes that one step reads and writes at least, a list that still holds: what two bodies share is
/// counted once in each pass, and what the processor reads only to write over it not at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Traffic {
    /// Rows of particles: contacts read them, motion reads and writes them.
    pub rows: usize,
    /// How particles answer to force, and constant forces.
    pub answers: usize,
    /// Sums of forces, read and written where FRACC wants them in every cycle.
    pub sums: usize,
    /// Whose the contacts are.
    pub places: usize,
    /// Listed pairs.
    pub pairs: usize,
    /// Parameters of the law for each contact.
    pub parameters: usize,
    /// What contacts remember and book, read and written.
    pub memory: usize,
    /// Forces of contacts: written by one pass, read by the other.
    pub slots: usize,
    /// How contacts stand.
    pub status: usize,
}

/// Read and written.
const BOTH: usize = 2;

impl Traffic {
    /// All of it.
    pub fn bytes(&self) -> usize {
        let particles = self.rows + self.answers + self.sums + self.places;
        let contacts = self.pairs + self.parameters + self.memory + self.slots + self.status;
        particles + contacts
    }
}

impl World {
    /// What one step moves at least.
    pub fn traffic(&self) -> Traffic {
        let (particles, contacts) = (self.particles.len(), self.contacts.len());
        let [parameters, memory, book] = self.pass().bytes();
        // Sums that FRACC does not want are used and forgotten.
        let kept = if (1..=2).contains(&self.model.fracc_every) {
            BOTH
        } else {
            0
        };
        Traffic {
            rows: (1 + BOTH) * particles * size_of::<Row>(),
            answers: particles * size_of::<Mobility>()
                + self.particles.body.len() * size_of::<[f64; 2]>(),
            sums: kept * particles * size_of::<Sum>(),
            places: particles * size_of::<Places>(),
            pairs: contacts * size_of::<[u32; 2]>(),
            parameters: contacts * parameters,
            memory: BOTH * contacts * (memory + book),
            slots: BOTH * contacts * size_of::<Slot>(),
            status: contacts * size_of::<Status>(),
        }
    }
}
