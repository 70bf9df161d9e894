//! Parameters of all contacts as columns, each no longer than it must be.
#![allow(
    unsafe_code,
    reason = "reads and writes columns by pointer; each use says what it relies on"
)]

use std::marker::PhantomData;

use super::numbers::{Column, Reading, Writing, Written};
use crate::engine::neighbours::carry::carry;

/// More columns than this no law has.
pub(super) const MOST: usize = 24;

/// As many equal numbers as there are lanes at most.
const WIDEST: usize = 8;

/// Parameters: what is the same for all contacts is kept once.
pub(super) struct Parameters<L> {
    columns: Vec<Shared>,
    len: usize,
    law: PhantomData<L>,
}

/// One column.
#[derive(Debug, Default)]
struct Shared {
    /// One number for each contact, or [`WIDEST`] equal ones for all.
    numbers: Vec<f64>,
    each: bool,
}

impl Shared {
    fn push(&mut self, len: usize, room: usize, number: f64) {
        if len == 0 {
            self.each = false;
            self.numbers.clear();
            self.numbers.resize(WIDEST, number);
        }
        self.differ(len, room, number);
        if self.each {
            self.numbers.push(number);
        }
    }

    /// Gives each of `len` contacts its own number if a new one is not that of all.
    fn differ(&mut self, len: usize, room: usize, number: f64) {
        if !self.each && self.numbers[0].to_bits() != number.to_bits() {
            self.each = true;
            let same = self.numbers[0];
            self.numbers.clear();
            self.numbers.reserve(room);
            self.numbers.resize(len, same);
        }
    }
}

impl<L: Written<f64>> Parameters<L> {
    /// Without contacts.
    pub(super) fn new() -> Self {
        const { assert!(L::COUNT <= MOST, "more columns than a law may have") };
        Self {
            columns: (0..L::COUNT).map(|_| Shared::default()).collect(),
            len: 0,
            law: PhantomData,
        }
    }

    /// Forgets all contacts, but keeps the memory.
    pub(super) fn clear(&mut self) {
        self.len = 0;
    }

    /// Number of contacts.
    pub(super) fn len(&self) -> usize {
        self.len
    }

    /// Appends the parameters of a contact; `room` contacts are kept ready for.
    pub(super) fn push(&mut self, law: L, room: usize) {
        for (column, number) in self.columns.iter_mut().zip(Self::numbers(law)) {
            column.push(self.len, room, number);
        }
        self.len += 1;
    }

    /// Follows the list: contact k stood `shift` places before `old[k]`, or is new and `fresh`.
    pub(super) fn follow(
        &mut self,
        old: &[u32],
        shift: u32,
        room: usize,
        fresh: impl Fn(usize) -> L,
    ) {
        if self.len == 0 {
            for k in 0..old.len() {
                self.push(fresh(k), room);
            }
            return;
        }
        for column in self.columns.iter_mut().filter(|column| column.each) {
            carry(&mut column.numbers, old, shift, room, |_| 0.0);
        }
        let had = std::mem::replace(&mut self.len, old.len());
        for (k, from) in old.iter().enumerate() {
            if (from.wrapping_sub(shift) as usize) < had {
                continue;
            }
            let numbers = Self::numbers(fresh(k));
            for (column, number) in self.columns.iter_mut().zip(numbers) {
                column.differ(self.len, room, number);
                if column.each {
                    column.numbers[k] = number;
                }
            }
        }
    }

    fn numbers(law: L) -> [f64; MOST] {
        let mut numbers = [0.0; MOST];
        let columns: [Column; MOST] = std::array::from_fn(|k| Column::each(&mut numbers[k..=k]));
        // SAFETY: one number in each of MOST columns, for contact 0.
        law.give(true, &mut unsafe { Writing::at(columns.as_ptr(), 0) });
        numbers
    }

    /// Of each number the value that all contacts have, if they have one.
    pub(super) fn common(&self) -> [Option<f64>; MOST] {
        let mut common = [None; MOST];
        for (common, shared) in common.iter_mut().zip(&self.columns) {
            *common = shared.numbers.first().copied().filter(|_| !shared.each);
        }
        common
    }

    /// The columns, for the loop.
    #[inline]
    pub(super) fn columns(&self) -> [Column; MOST] {
        let mut columns = [Column::NONE; MOST];
        for (column, shared) in columns.iter_mut().zip(&self.columns) {
            *column = Column::shared(&shared.numbers, shared.each);
        }
        columns
    }

    /// The parameters of a contact.
    ///
    /// # Panics
    /// If there is no such contact.
    pub(super) fn get(&self, k: usize) -> L {
        assert!(k < self.len, "contact {k} of {}", self.len);
        let columns = self.columns();
        // SAFETY: all columns hold contact k, and outlive the reading.
        L::take(&mut unsafe { Reading::at(columns.as_ptr(), k) })
    }

    /// Bytes per contact.
    pub(super) fn bytes(&self) -> usize {
        let each = self.columns.iter().filter(|column| column.each);
        each.count() * size_of::<f64>()
    }
}
