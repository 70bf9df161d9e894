//! A world on its way into a checkpoint and back: what is not stored is made again, and what contacts
//! remember goes piece by piece, so that a large world needs no second place for it.

use std::fmt;

use serde::de::{Deserializer, Visitor};
use serde::ser::{Error, SerializeSeq};
use serde::{Deserialize, Serialize, Serializer};

use super::World;
use super::contact::pass::ContactPass;
use super::threads::Threads;

/// Contacts in a piece.
const PIECE: usize = 4096;

/// Where a world has its pass: out of a checkpoint, until there is one, what its contacts remembered.
#[derive(Default)]
pub(super) struct PassPlace {
    pub(super) pass: Option<Box<dyn ContactPass>>,
    pieces: Vec<Piece>,
}

/// What some contacts remember, as bytes.
struct Piece(Vec<u8>);

impl World {
    /// After reading a checkpoint: what is not stored is made again. False if it does not fit.
    /// `threads` 0: as many as suit its size.
    pub fn unpack(&mut self, threads: usize) -> bool {
        let (particles, walls) = (self.particles.len(), self.walls.len());
        let known = self.particles.fit(self.model.materials.len());
        if !known || !self.contacts.unpack(particles, walls) {
            return false;
        }
        self.threads = Threads::team(threads, particles);
        let mut pass = self.plan().pass();
        let old = vec![u32::MAX; self.contacts.len()];
        pass.relist(&old, self.contacts.pairs.len(), self.room(), &|k| {
            self.basis(k)
        });
        let fits = self.place.fill(pass.as_mut(), self.contacts.len());
        for row in &mut self.particles.row {
            row.set_spin(row.spin);
        }
        self.place.pass = Some(pass);
        self.see();
        fits
    }
}

impl PassPlace {
    /// Gives a pass over so many contacts what they remembered; false if that is not theirs.
    fn fill(&mut self, pass: &mut dyn ContactPass, contacts: usize) -> bool {
        let pieces = std::mem::take(&mut self.pieces);
        pieces.len() == contacts.div_ceil(PIECE)
            && (pieces.into_iter().enumerate())
                .all(|(k, piece)| pass.load(part(k, contacts), &piece.0))
    }
}

/// The contacts of a piece, of so many.
fn part(piece: usize, contacts: usize) -> std::ops::Range<usize> {
    let first = piece * PIECE;
    first..(first + PIECE).min(contacts)
}

impl Serialize for PassPlace {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Some(pass) = &self.pass else {
            return Err(S::Error::custom("there is no contact pass to save"));
        };
        let contacts = pass.count();
        let count = contacts.div_ceil(PIECE);
        let mut pieces = serializer.serialize_seq(Some(count))?;
        let mut piece = Piece(Vec::new());
        for k in 0..count {
            piece.0 = pass
                .save(part(k, contacts), std::mem::take(&mut piece.0))
                .map_err(S::Error::custom)?;
            pieces.serialize_element(&piece)?;
        }
        pieces.end()
    }
}

impl<'de> Deserialize<'de> for PassPlace {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let pieces = Vec::deserialize(deserializer)?;
        Ok(Self { pass: None, pieces })
    }
}

impl Serialize for Piece {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_bytes(&self.0)
    }
}

impl<'de> Deserialize<'de> for Piece {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_byte_buf(Bytes)
    }
}

/// Takes bytes as they come.
struct Bytes;

impl Visitor<'_> for Bytes {
    type Value = Piece;

    fn expecting(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        to.write_str("bytes")
    }

    fn visit_bytes<E: serde::de::Error>(self, bytes: &[u8]) -> Result<Piece, E> {
        Ok(Piece(bytes.to_vec()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_that_is_not_at_hand_is_no_empty_one() {
        assert!(postcard::to_allocvec(&PassPlace::default()).is_err());
    }
}
