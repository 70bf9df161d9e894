//! One kind of contact over the whole list: parameters and memories as columns, and the loop over
//! them.
//!
//! Called once per cycle through [`ContactPass`], the only dynamic face; inside, the law is a type.
#![allow(
    unsafe_code,
    reason = "lends columns to the loop; each use says what it relies on"
)]

use std::any::Any;
use std::ops::Range;

pub(crate) use super::book::Book;
use super::book::LOSSES;
use super::columns::{MOST, Parameters};
use super::inner::Inner;
use super::kernel::Kernel;
use super::law::{Law, React};
use super::memories::Memories;
use super::memory::Memory;
use super::numbers::Column;
use super::quantities::{BasisOwned, Stiffness};
use super::traction::Traction;
use crate::engine::boundary::Tensor;
use crate::engine::lanes::Isa;
use crate::engine::neighbours::{Slot, Status};
use crate::engine::particles::{Row, are_far};
use crate::engine::shares;
use crate::engine::threads::{Threads, share};
use crate::engine::wall_contact::{WallPair, WallTouch};

/// What the pass reads.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// Particles, and images that pairs name.
    pub rows: &'a [Row],
    /// Listed pairs of particles, as indices, lower number first.
    pub pairs: &'a [[u32; 2]],
    /// Listed pairs of particle and wall: they follow the pairs in slots and status.
    pub wall_pairs: &'a [WallPair],
    /// Where those stand now.
    pub wall_touches: &'a [WallTouch],
    /// Strain rate that carries everything along besides [1/s], and the point at rest in it [m].
    pub flow: Option<(Tensor, [f64; 2])>,
    /// Time step [s].
    pub dt: f64,
    /// Vector instructions.
    pub isa: Isa,
}

/// The dynamic face of a [`Pass`].
pub trait ContactPass: Send + Sync {
    /// Evaluates all contacts; advances their memory.
    fn evaluate(
        &mut self,
        view: View<'_>,
        slots: &mut [Slot],
        status: &mut [Status],
        threads: &Threads,
    );
    /// The list changed: `old[k]` is where contact k stood before, `u32::MAX` if it is new. The first
    /// `pairs` are between particles. `room` is how many contacts memory is kept ready for.
    fn relist(
        &mut self,
        old: &[u32],
        pairs: usize,
        room: usize,
        basis: &dyn Fn(usize) -> BasisOwned,
    );
    /// The same where nothing has changed that listed contacts were prepared from: old places ascend.
    fn follow(
        &mut self,
        old: &[u32],
        pairs: usize,
        room: usize,
        basis: &dyn Fn(usize) -> BasisOwned,
    );
    /// Moves the memory of one contact to another.
    fn hand_over(&mut self, from: usize, to: usize);
    /// Whether spins exist.
    fn tangential(&self) -> bool;
    /// Whether rolling is resisted.
    fn rolling(&self) -> bool;
    /// Spring energies of a contact with this overlap [J].
    fn energy(&self, k: usize, overlap: f64) -> [f64; 2];
    /// Spring forces of a contact with this overlap [N]; memory does not advance.
    fn springs(&self, k: usize, overlap: f64) -> [f64; 2];
    /// Stiffness of a contact with this overlap.
    fn stiffness(&self, k: usize, overlap: f64) -> Stiffness;
    /// Whether a contact has a friction limit.
    fn is_frictional(&self, k: usize) -> bool;
    /// Reduced memory of a contact: spring forces [N].
    fn reduced(&self, k: usize) -> [f64; 2];
    /// Shows every number in the memory of a contact that the future depends on.
    fn visit(&self, k: usize, see: &mut dyn FnMut(f64));
    /// Takes over the memories and bookings of the pass before, whatever its kind: whole where
    /// nothing that they depend on has changed, else as spring forces at these overlaps [m].
    fn take_over(&mut self, before: &dyn ContactPass, overlap: &dyn Fn(usize) -> f64);
    /// The traction inside a contact, if the law knows it.
    fn traction(&self, k: usize) -> Option<Traction>;
    /// What the memory of a contact with this overlap holds, for people.
    fn inner(&self, k: usize, overlap: f64) -> Vec<Inner>;
    /// For [`ContactPass::take_over`].
    fn as_any(&self) -> &dyn Any;
    /// What each contact lost in the last step by sliding, rolling included, by slip within, and in
    /// dashpots [J]; nothing when no bookings are kept.
    fn losses(&self) -> [&[f64]; 3];
    /// Bookings of a contact; zero when none are kept.
    fn book(&self, k: usize) -> Book;
    /// Counts sliding ways from zero again.
    fn forget_slid(&mut self);
    /// Whether contact k is bonded.
    fn is_bonded(&self, k: usize) -> bool;
    /// Bonds contact k, if the law knows bonds.
    fn bond(&mut self, k: usize);
    /// Bytes per contact: parameters, memory, bookings.
    fn bytes(&self) -> [usize; 3];
    /// Number of contacts.
    fn count(&self) -> usize;
    /// Memory and bookings of some contacts for a checkpoint, in place of what is in the buffer.
    fn save(&self, contacts: Range<usize>, buffer: Vec<u8>) -> postcard::Result<Vec<u8>>;
    /// From a checkpoint; false when the bytes do not fit.
    fn load(&mut self, contacts: Range<usize>, bytes: &[u8]) -> bool;
}

/// One law over the list. `BOOK`: energies are booked.
pub(crate) struct Pass<L: Law, const BOOK: bool> {
    /// Parameters of pairs, and of contacts with walls.
    laws: [Parameters<L>; 2],
    memory: Memories<L::Memo>,
    book: Memories<Book>,
    tables: Tables,
}

/// Where the columns of parameters stand. Kept apart and written only when the list is made anew: every
/// thread reads them in every cycle, and a write would take the line away from all of them.
struct Tables {
    laws: [[Column; MOST]; 2],
    /// Pairs, and contacts with walls.
    counts: [usize; 2],
    /// Whether all pairs are plain.
    plain: bool,
}

impl Tables {
    const NONE: Self = Self {
        laws: [[Column::NONE; MOST]; 2],
        counts: [0; 2],
        plain: false,
    };
}

// SAFETY: the columns are those of the pass itself, which changes them only with the tables.
unsafe impl Send for Tables {}
// SAFETY: as above.
unsafe impl Sync for Tables {}

impl<L: Law, const BOOK: bool> Pass<L, BOOK> {
    /// Without contacts yet.
    pub(crate) fn new() -> Self {
        Self {
            laws: [Parameters::new(), Parameters::new()],
            memory: Memories::default(),
            book: Memories::default(),
            tables: Tables::NONE,
        }
    }

    /// The parameters of a contact.
    fn law(&self, k: usize) -> L {
        let [pairs, walls] = &self.laws;
        match k.checked_sub(pairs.len()) {
            None => pairs.get(k),
            Some(w) => walls.get(w),
        }
    }
}

impl<L: Law, const BOOK: bool> Default for Pass<L, BOOK> {
    fn default() -> Self {
        Self::new()
    }
}

impl<L: Law, const BOOK: bool> ContactPass for Pass<L, BOOK> {
    fn evaluate(
        &mut self,
        view: View<'_>,
        slots: &mut [Slot],
        status: &mut [Status],
        threads: &Threads,
    ) {
        let total = self.count();
        let one_each = [self.memory.len(), status.len()];
        let at_walls = [view.wall_pairs.len(), view.wall_touches.len()];
        assert!(
            one_each == [total; 2]
                && at_walls == [self.laws[1].len(); 2]
                && slots.len() > total
                && view.pairs.len() == self.laws[0].len()
                && self.tables.counts == [self.laws[0].len(), self.laws[1].len()]
                && (!BOOK || self.book.len() == total),
            "lists of contacts differ in length"
        );
        let isa = view.isa;
        let parts = threads.parts(total);
        let (memory, whole) = self.memory.columns();
        let books;
        let book = if BOOK {
            books = self.book.columns().0;
            books.as_ptr()
        } else {
            std::ptr::null()
        };
        let kernel = Kernel::<L> {
            view,
            laws: &self.tables.laws,
            plain: self.tables.plain,
            memory,
            whole,
            book,
            slots: slots.as_mut_ptr(),
            status: status.as_mut_ptr().cast(),
            ask: are_far(view.rows.len()),
        };
        if parts == 1 {
            // SAFETY: all columns have a place for each contact, and the list names rows there are.
            return unsafe { kernel.run::<BOOK>(0, total, isa) };
        }
        let pairs = view.pairs.len();
        threads.split(parts, |part| {
            let own = shares::pairs(pairs, parts, part);
            let walls = share(total - pairs, parts, part);
            // SAFETY: as above; the stretches do not overlap.
            unsafe {
                kernel.run::<BOOK>(own.start, own.end, isa);
                kernel.run::<BOOK>(pairs + walls.start, pairs + walls.end, isa);
            }
        });
    }

    fn relist(
        &mut self,
        old: &[u32],
        pairs: usize,
        room: usize,
        basis: &dyn Fn(usize) -> BasisOwned,
    ) {
        for laws in &mut self.laws {
            laws.clear();
        }
        self.follow(old, pairs, room, basis);
    }

    fn follow(
        &mut self,
        old: &[u32],
        pairs: usize,
        room: usize,
        basis: &dyn Fn(usize) -> BasisOwned,
    ) {
        // Those of before are no longer true from here on.
        self.tables = Tables::NONE;
        let prepare = |k: usize| L::prepare(&basis(k).lend(BOOK));
        let [of_pairs, of_walls] = &mut self.laws;
        let shift = of_pairs.len() as u32;
        of_pairs.follow(&old[..pairs], 0, room, prepare);
        of_walls.follow(&old[pairs..], shift, room, |w| prepare(pairs + w));
        self.memory.follow(old, room);
        if BOOK {
            self.book.follow(old, room);
        }
        self.tables = Tables {
            laws: [self.laws[0].columns(), self.laws[1].columns()],
            counts: [self.laws[0].len(), self.laws[1].len()],
            plain: L::all_plain(&self.laws[0].common()[..L::COUNT]),
        };
    }

    fn hand_over(&mut self, from: usize, to: usize) {
        let memory = self.memory.get(from);
        self.memory.set(to, memory);
        self.memory.set(from, L::Memo::default());
        if BOOK {
            self.book.set(to, self.book.get(from));
            self.book.set(from, Book::default());
        }
    }

    fn tangential(&self) -> bool {
        <L::On<f64> as React<f64>>::TANGENTIAL
    }

    fn rolling(&self) -> bool {
        <L::On<f64> as React<f64>>::ROLLING
    }

    fn energy(&self, k: usize, overlap: f64) -> [f64; 2] {
        self.law(k).energy(overlap, &self.memory.get(k))
    }

    fn springs(&self, k: usize, overlap: f64) -> [f64; 2] {
        self.law(k).springs(overlap, &self.memory.get(k))
    }

    fn stiffness(&self, k: usize, overlap: f64) -> Stiffness {
        self.law(k).stiffness(overlap, &self.memory.get(k))
    }

    fn is_frictional(&self, k: usize) -> bool {
        self.law(k).is_frictional()
    }

    fn reduced(&self, k: usize) -> [f64; 2] {
        self.memory.get(k).reduced()
    }

    fn visit(&self, k: usize, see: &mut dyn FnMut(f64)) {
        self.memory.get(k).visit(see);
    }

    fn take_over(&mut self, before: &dyn ContactPass, overlap: &dyn Fn(usize) -> f64) {
        let same = before.as_any().downcast_ref::<Self>();
        for k in 0..self.count() {
            let law = self.law(k);
            let mut memory = match same {
                Some(same) => law.refit(&same.law(k), overlap(k), &same.memory.get(k)),
                None => law.seed(overlap(k), before.reduced(k)),
            };
            if before.is_bonded(k) {
                memory.bond();
            }
            self.memory.set(k, memory);
            if BOOK {
                self.book.set(k, before.book(k));
            }
        }
    }

    fn traction(&self, k: usize) -> Option<Traction> {
        self.law(k).traction(&self.memory.get(k))
    }

    fn inner(&self, k: usize, overlap: f64) -> Vec<Inner> {
        self.law(k).inner(overlap, &self.memory.get(k))
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn losses(&self) -> [&[f64]; 3] {
        LOSSES.map(|column| self.book.column(column))
    }

    fn book(&self, k: usize) -> Book {
        if BOOK {
            self.book.get(k)
        } else {
            Book::default()
        }
    }

    fn forget_slid(&mut self) {
        for k in 0..self.book.len() {
            let slid = 0.0;
            let book = self.book.get(k);
            self.book.set(k, Book { slid, ..book });
        }
    }

    fn is_bonded(&self, k: usize) -> bool {
        self.memory.get(k).is_bonded()
    }

    fn bond(&mut self, k: usize) {
        let mut memory = self.memory.get(k);
        memory.bond();
        self.memory.set(k, memory);
    }

    fn bytes(&self) -> [usize; 3] {
        let book = if BOOK { Memories::<Book>::bytes() } else { 0 };
        [self.laws[0].bytes(), Memories::<L::Memo>::bytes(), book]
    }

    fn count(&self) -> usize {
        self.laws[0].len() + self.laws[1].len()
    }

    fn save(&self, contacts: Range<usize>, mut buffer: Vec<u8>) -> postcard::Result<Vec<u8>> {
        buffer.clear();
        let booked = if BOOK { contacts.clone() } else { 0..0 };
        let book = self.book.part(booked);
        postcard::to_extend(&(self.memory.part(contacts), book), buffer)
    }

    fn load(&mut self, contacts: Range<usize>, bytes: &[u8]) -> bool {
        let Ok((memory, book)) = postcard::from_bytes::<(Vec<L::Memo>, Vec<Book>)>(bytes) else {
            return false;
        };
        let count = contacts.len();
        if memory.len() != count || contacts.end > self.count() || (BOOK && book.len() != count) {
            return false;
        }
        for (k, memory) in contacts.clone().zip(memory) {
            self.memory.set(k, memory);
        }
        if BOOK {
            for (k, book) in contacts.zip(book) {
                self.book.set(k, book);
            }
        }
        true
    }
}
