//! Memories of all contacts: columns of numbers, and what is kept whole.
#![allow(
    unsafe_code,
    reason = "reads and writes columns by pointer; each use says what it relies on"
)]

use std::ops::Range;

use serde::{Serialize, Serializer};

use super::columns::MOST;
use super::memory::Memory;
use super::numbers::{Column, Reading, Writing};
use crate::engine::neighbours::carry::carry;

/// One memory per contact.
pub(super) struct Memories<M: Memory> {
    columns: Vec<Vec<f64>>,
    whole: Vec<M::Whole>,
}

impl<M: Memory> Default for Memories<M> {
    fn default() -> Self {
        const { assert!(M::COLUMNS <= MOST, "more columns than a memory may have") };
        Self {
            columns: (0..M::COLUMNS).map(|_| Vec::new()).collect(),
            whole: Vec::new(),
        }
    }
}

impl<M: Memory> Memories<M> {
    /// Whether parts are kept whole.
    pub(super) const WHOLE: bool = size_of::<M::Whole>() > 0;

    /// Number of contacts.
    pub(super) fn len(&self) -> usize {
        self.whole.len()
    }

    /// Follows the list: the k-th contact stood at `old[k]` before, or is new.
    pub(super) fn follow(&mut self, old: &[u32], room: usize) {
        for column in &mut self.columns {
            carry(column, old, 0, room, |_| 0.0);
        }
        if Self::WHOLE {
            carry(&mut self.whole, old, 0, room, |_| M::Whole::default());
        } else {
            self.whole.resize(old.len(), M::Whole::default());
        }
    }

    /// The columns, for the loop, from a contact on, and what is kept whole.
    #[inline]
    pub(super) fn columns(&mut self) -> ([Column; MOST], *mut M::Whole) {
        let mut columns = [Column::NONE; MOST];
        for (column, numbers) in columns.iter_mut().zip(&mut self.columns) {
            *column = Column::each(numbers);
        }
        (columns, self.whole.as_mut_ptr())
    }

    /// A column of numbers.
    pub(super) fn column(&self, column: usize) -> &[f64] {
        &self.columns[column]
    }

    /// The memory of a contact.
    pub(super) fn get(&self, k: usize) -> M {
        let whole = &self.whole[k];
        let mut columns = [Column::NONE; MOST];
        for (column, numbers) in columns.iter_mut().zip(&self.columns) {
            *column = Column::shared(numbers, true);
        }
        // SAFETY: all columns are as long as `whole`, which has contact k.
        M::take(&mut unsafe { Reading::at(columns.as_ptr(), k) }, whole)
    }

    /// Changes the memory of a contact.
    pub(super) fn set(&mut self, k: usize, memory: M) {
        assert!(k < self.len(), "contact {k} of {}", self.len());
        let (columns, _) = self.columns();
        // SAFETY: all columns are as long as `whole`, which has contact k.
        let mut to = unsafe { Writing::at(columns.as_ptr(), k) };
        memory.give(&mut to, &mut self.whole[k]);
    }

    /// Those of some contacts, for a checkpoint.
    pub(super) fn part(&self, contacts: Range<usize>) -> Part<'_, M> {
        Part {
            all: self,
            contacts,
        }
    }

    /// Bytes per contact.
    pub(super) fn bytes() -> usize {
        M::COLUMNS * size_of::<f64>() + size_of::<M::Whole>()
    }
}

/// Memories of some contacts.
pub(super) struct Part<'m, M: Memory> {
    all: &'m Memories<M>,
    contacts: Range<usize>,
}

/// One by one, as a list of memories.
impl<M: Memory> Serialize for Part<'_, M> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.contacts.clone().map(|k| self.all.get(k)))
    }
}
