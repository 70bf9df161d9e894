//! One kind of contact over the whole list: the loop everything waits for.
//!
//! Called once per cycle through [`ContactPass`], the only dynamic face; inside, the law is a type.
//! Each contact writes the force on its first body into its own slot, so the bits depend neither
//! on the order of the list nor on the number of threads.

use std::any::Any;

pub use super::book::Book;
use super::book::Step;
use super::inner::Inner;
use super::law::Law;
use super::memory::Memory;
use super::quantities::{BasisOwned, Stiffness, Touch};
use super::traction::Traction;
use crate::engine::neighbours::{Slot, Status};
use crate::engine::particles::Row;
use crate::engine::threads::{MAX_THREADS, Threads, share};
use crate::engine::wall_contact::{WallPair, WallTouch};

/// What the pass reads.
#[derive(Clone, Copy)]
pub struct View<'a> {
    /// Particles.
    pub rows: &'a [Row],
    /// Listed pairs of particles, as indices, lower number first.
    pub pairs: &'a [[u32; 2]],
    /// Listed pairs of particle and wall: they follow the pairs in slots and status.
    pub wall_pairs: &'a [WallPair],
    /// Where those stand now.
    pub wall_touches: &'a [WallTouch],
    /// Time step [s].
    pub dt: f64,
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
    /// The list changed: `old[k]` is where contact k stood before, `u32::MAX` if it is new. `room`
    /// is how many contacts memory is kept ready for.
    fn relist(&mut self, old: &[u32], room: usize, basis: &dyn Fn(usize) -> BasisOwned);
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
    /// Bookings of a contact; zero when none are kept.
    fn book(&self, k: usize) -> Book;
    /// Counts sliding ways from zero again.
    fn forget_slid(&mut self);
    /// Bytes per contact: parameters, memory, bookings.
    fn bytes(&self) -> [usize; 3];
    /// Memory and bookings for a checkpoint.
    fn save(&self) -> Vec<u8>;
    /// From a checkpoint; false when the bytes do not fit.
    fn load(&mut self, bytes: &[u8]) -> bool;
}

/// One law over the list. `BOOK`: energies are booked.
pub struct Pass<L: Law, const BOOK: bool> {
    laws: Vec<L>,
    memory: Vec<L::Memory>,
    book: Vec<Book>,
    spare_memory: Vec<L::Memory>,
    spare_book: Vec<Book>,
}

impl<L: Law, const BOOK: bool> Pass<L, BOOK> {
    /// Without contacts yet.
    pub fn new() -> Self {
        Self {
            laws: Vec::new(),
            memory: Vec::new(),
            book: Vec::new(),
            spare_memory: Vec::new(),
            spare_book: Vec::new(),
        }
    }
}

impl<L: Law, const BOOK: bool> Default for Pass<L, BOOK> {
    fn default() -> Self {
        Self::new()
    }
}

/// A stretch of contacts, written by one thread.
struct Stretch<'a, L: Law> {
    first: usize,
    laws: &'a [L],
    memory: &'a mut [L::Memory],
    book: &'a mut [Book],
    slots: &'a mut [Slot],
    status: &'a mut [Status],
}

/// Geometry of one contact.
struct Geometry {
    e: [f64; 2],
    touch: Touch,
    /// D/(R1 + R2), the ratio by which lever arms are shorter than radii.
    arm: f64,
}

/// State of one contact, to be written.
struct Cell<'a, L: Law> {
    law: &'a L,
    memory: &'a mut L::Memory,
    book: Option<&'a mut Book>,
    slot: &'a mut Slot,
    status: &'a mut Status,
}

impl<L: Law> Cell<'_, L> {
    #[inline(always)]
    fn react(&mut self, g: &Geometry) {
        let r = self.law.react(&g.touch, self.memory);
        let t = [g.e[1], -g.e[0]];
        *self.slot = Slot([
            -(r.normal * g.e[0]) - r.tangential * t[0],
            -(r.normal * g.e[1]) - r.tangential * t[1],
            r.tangential * g.arm,
            r.moment,
        ]);
        *self.status = if r.sliding {
            Status::Sliding
        } else {
            Status::Touching
        };
        if let Some(book) = &mut self.book {
            let step = Step {
                way: [g.touch.approach * g.touch.dt, g.touch.slide * g.touch.dt],
                sliding: r.sliding,
            };
            book.book(r.loss, r.damping, r.excess, &step);
        }
    }

    /// Out of touch, and in touch at the last boundary.
    #[inline(never)]
    fn part(&mut self, touch: &Touch) {
        let loss = self.law.part(touch, self.memory);
        *self.slot = Slot::default();
        *self.status = Status::Apart;
        if let Some(book) = &mut self.book {
            let step = Step {
                way: [touch.approach * touch.dt, touch.slide * touch.dt],
                sliding: false,
            };
            book.book(loss, [0.0; 2], 0.0, &step);
            **book = Book {
                friction_loss: book.friction_loss,
                damping_loss: book.damping_loss,
                ..Book::default()
            };
        }
    }

    /// Still out of touch: only last step's bookings have to go.
    #[inline(always)]
    fn rest(&mut self) {
        if let Some(book) = &mut self.book {
            **book = Book::default();
        }
    }
}

impl<L: Law, const BOOK: bool> Pass<L, BOOK> {
    #[inline(always)]
    fn cell<'b>(s: &'b mut Stretch<'_, L>, k: usize) -> Cell<'b, L> {
        Cell {
            law: &s.laws[k],
            memory: &mut s.memory[k],
            book: if BOOK { Some(&mut s.book[k]) } else { None },
            slot: &mut s.slots[k],
            status: &mut s.status[k],
        }
    }

    fn run(view: View<'_>, s: &mut Stretch<'_, L>) {
        let pairs = view.pairs.len();
        let end = s.first + s.laws.len();
        for k in s.first..end.min(pairs) {
            Self::pair(&view, view.pairs[k], &mut Self::cell(s, k - s.first));
        }
        for k in s.first.max(pairs)..end {
            let w = k - pairs;
            let touch = &view.wall_touches[w];
            let row = &view.rows[view.wall_pairs[w].particle as usize];
            Self::wall(&view, row, touch, &mut Self::cell(s, k - s.first));
        }
    }

    #[inline(always)]
    fn pair(view: &View<'_>, [i, j]: [u32; 2], cell: &mut Cell<'_, L>) {
        let (a, b) = (&view.rows[i as usize], &view.rows[j as usize]);
        let (dx, dy) = (b.x[0] - a.x[0], b.x[1] - a.x[1]);
        let square = dx * dx + dy * dy;
        let reach = a.radius + b.radius;
        let apart = square >= reach * reach;
        if apart && *cell.status == Status::Apart {
            return cell.rest();
        }
        let distance = square.sqrt();
        let overlap = reach - distance;
        let e = [dx / distance, dy / distance];
        let v = [a.v[0] - b.v[0], a.v[1] - b.v[1]];
        let arm = distance / reach;
        let slide = if L::TANGENTIAL {
            v[0] * e[1] - v[1] * e[0] - (a.spin * a.radius + b.spin * b.radius) * arm
        } else {
            0.0
        };
        let approach = v[0] * e[0] + v[1] * e[1];
        let touch = Touch {
            overlap,
            approach,
            slide,
            roll: if L::ROLLING { a.spin - b.spin } else { 0.0 },
            dt: view.dt,
        };
        if apart || overlap <= 0.0 {
            return if *cell.status == Status::Apart {
                cell.rest();
            } else {
                cell.part(&touch);
            };
        }
        cell.react(&Geometry { e, touch, arm });
    }

    #[inline(always)]
    fn wall(view: &View<'_>, row: &Row, wall: &WallTouch, cell: &mut Cell<'_, L>) {
        let overlap = row.radius - wall.distance;
        let apart = overlap <= 0.0;
        if apart && *cell.status == Status::Apart {
            return cell.rest();
        }
        let e = wall.e;
        let v = [row.v[0] - wall.v[0], row.v[1] - wall.v[1]];
        let slide = if L::TANGENTIAL {
            v[0] * e[1] - v[1] * e[0] - row.spin * row.radius
        } else {
            0.0
        };
        let approach = v[0] * e[0] + v[1] * e[1];
        let touch = Touch {
            overlap,
            approach,
            slide,
            roll: if L::ROLLING {
                row.spin - wall.spin
            } else {
                0.0
            },
            dt: view.dt,
        };
        if apart {
            return cell.part(&touch);
        }
        cell.react(&Geometry { e, touch, arm: 1.0 });
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
        let mut rest = Stretch {
            first: 0,
            laws: &self.laws[..],
            memory: &mut self.memory[..],
            book: &mut self.book[..],
            slots,
            status,
        };
        let total = rest.laws.len();
        let parts = threads.parts(total);
        if parts == 1 {
            return Self::run(view, &mut rest);
        }
        let mut jobs: [Option<Stretch<'_, L>>; MAX_THREADS] = [const { None }; MAX_THREADS];
        for (part, job) in jobs.iter_mut().enumerate().take(parts) {
            let n = share(total, parts, part).len();
            let (laws, laws_rest) = rest.laws.split_at(n);
            let (memory, memory_rest) = rest.memory.split_at_mut(n);
            let (book, book_rest) = rest.book.split_at_mut(if BOOK { n } else { 0 });
            let (slots, slots_rest) = rest.slots.split_at_mut(n);
            let (status, status_rest) = rest.status.split_at_mut(n);
            *job = Some(Stretch {
                first: rest.first,
                laws,
                memory,
                book,
                slots,
                status,
            });
            rest = Stretch {
                first: rest.first + n,
                laws: laws_rest,
                memory: memory_rest,
                book: book_rest,
                slots: slots_rest,
                status: status_rest,
            };
        }
        threads.run(&mut jobs[..parts], |job| {
            if let Some(stretch) = job {
                Self::run(view, stretch);
            }
        });
    }

    fn relist(&mut self, old: &[u32], room: usize, basis: &dyn Fn(usize) -> BasisOwned) {
        self.laws.clear();
        self.spare_memory.clear();
        self.spare_book.clear();
        self.laws.reserve(room);
        self.spare_memory.reserve(room);
        if BOOK {
            self.spare_book.reserve(room);
        }
        for (k, &from) in old.iter().enumerate() {
            self.laws.push(L::prepare(&basis(k).lend(BOOK)));
            self.spare_memory
                .push(self.memory.get(from as usize).copied().unwrap_or_default());
            if BOOK {
                self.spare_book
                    .push(self.book.get(from as usize).copied().unwrap_or_default());
            }
        }
        std::mem::swap(&mut self.memory, &mut self.spare_memory);
        std::mem::swap(&mut self.book, &mut self.spare_book);
    }

    fn hand_over(&mut self, from: usize, to: usize) {
        self.memory[to] = std::mem::take(&mut self.memory[from]);
        if BOOK {
            self.book[to] = std::mem::take(&mut self.book[from]);
        }
    }

    fn tangential(&self) -> bool {
        L::TANGENTIAL
    }

    fn rolling(&self) -> bool {
        L::ROLLING
    }

    fn energy(&self, k: usize, overlap: f64) -> [f64; 2] {
        self.laws[k].energy(overlap, &self.memory[k])
    }

    fn springs(&self, k: usize, overlap: f64) -> [f64; 2] {
        self.laws[k].springs(overlap, &self.memory[k])
    }

    fn stiffness(&self, k: usize, overlap: f64) -> Stiffness {
        self.laws[k].stiffness(overlap, &self.memory[k])
    }

    fn is_frictional(&self, k: usize) -> bool {
        self.laws[k].is_frictional()
    }

    fn reduced(&self, k: usize) -> [f64; 2] {
        self.memory[k].reduced()
    }

    fn visit(&self, k: usize, see: &mut dyn FnMut(f64)) {
        self.memory[k].visit(see);
    }

    fn take_over(&mut self, before: &dyn ContactPass, overlap: &dyn Fn(usize) -> f64) {
        let same = before.as_any().downcast_ref::<Self>();
        for k in 0..self.laws.len() {
            self.memory[k] = match same {
                Some(same) => self.laws[k].refit(&same.laws[k], overlap(k), &same.memory[k]),
                None => self.laws[k].seed(overlap(k), before.reduced(k)),
            };
            if BOOK {
                self.book[k] = before.book(k);
            }
        }
    }

    fn traction(&self, k: usize) -> Option<Traction> {
        self.laws[k].traction(&self.memory[k])
    }

    fn inner(&self, k: usize, overlap: f64) -> Vec<Inner> {
        self.laws[k].inner(overlap, &self.memory[k])
    }

    fn as_any(&self) -> &dyn Any {
        self
    }

    fn book(&self, k: usize) -> Book {
        self.book.get(k).copied().unwrap_or_default()
    }

    fn forget_slid(&mut self) {
        for book in &mut self.book {
            book.slid = 0.0;
        }
    }

    fn bytes(&self) -> [usize; 3] {
        let book = if BOOK { size_of::<Book>() } else { 0 };
        [size_of::<L>(), size_of::<L::Memory>(), book]
    }

    fn save(&self) -> Vec<u8> {
        postcard::to_allocvec(&(&self.memory, &self.book)).unwrap_or_default()
    }

    fn load(&mut self, bytes: &[u8]) -> bool {
        let Ok((memory, book)) = postcard::from_bytes::<(Vec<L::Memory>, Vec<Book>)>(bytes) else {
            return false;
        };
        if memory.len() != self.laws.len() || (BOOK && book.len() != self.laws.len()) {
            return false;
        }
        (self.memory, self.book) = (memory, book);
        true
    }
}
