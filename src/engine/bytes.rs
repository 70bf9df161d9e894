//! How much memory a world takes, counted by what is kept of each particle and contact.

use super::World;
use super::particles::{Mobility, Particles, Row, Sum};

/// Memory of a world.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Bytes {
    /// Per particle.
    pub particle: usize,
    /// Per listed contact.
    pub contact: usize,
    /// Of those the law's own: parameters, memory and bookings.
    pub law: usize,
}

impl World {
    /// Bytes per particle and per listed contact, the buffers of the search included; images beyond the
    /// edges of a cell are few.
    pub fn bytes(&self) -> Bytes {
        let cell = self.cell().is_some();
        let [contact, particle] = self.contacts.bytes(cell, self.threads.count() > 1);
        let law: usize = self.pass().bytes().iter().sum();
        let ledger = if self.ledger.is_some() {
            super::ledger::BYTES_PER_PARTICLE
        } else {
            0
        };
        Bytes {
            particle: particle + self.particles.bytes() + ledger,
            contact: contact + law,
            law,
        }
    }
}

impl Particles {
    /// Bytes per particle.
    fn bytes(&self) -> usize {
        let cold =
            size_of::<u32>() + 2 * size_of::<f64>() + size_of::<u16>() + size_of::<[bool; 3]>();
        let either = [!self.body.is_empty(), !self.applied.is_empty()];
        let forces = either.map(usize::from).iter().sum::<usize>() * size_of::<[f64; 2]>();
        size_of::<Row>() + size_of::<Mobility>() + size_of::<Sum>() + forces + cold
    }
}
