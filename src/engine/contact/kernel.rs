//! The loop everything waits for: geometry, law and force of blocks of contacts.
//!
//! One block is as many contacts as there are lanes; what is left over at the end of a stretch, and
//! contacts with walls, go one by one through the same code. Each contact writes the force on its
//! first body into its own slot, so the bits depend neither on the order of the list nor on widths
//! and threads.
#![allow(
    unsafe_code,
    reason = "columns by pointer and vector instructions; each use says what it relies on"
)]

use super::book::{Book, Step};
use super::columns::MOST;
use super::geometry::{Geometry, lane_of};
use super::law::{Law, React};
use super::memory::Memory;
use super::numbers::{Column, Numbers, Reading, Writing, Written};
use super::parts::Held;
use super::pass::View;
use super::quantities::{Reaction, Touch};
use crate::engine::boundary::straining::velocity;
#[cfg(target_arch = "x86_64")]
use crate::engine::lanes::{Eight, Four};
use crate::engine::lanes::{Isa, Lanes, Meeting};
use crate::engine::neighbours::Slot;
use crate::engine::particles::Row;
use crate::engine::wall_contact::WallTouch;

/// How far ahead rows are asked for [contacts].
const AHEAD: usize = 64;

/// Columns and pointers of a pass, for the threads of one evaluation.
pub(super) struct Kernel<'a, L: Law> {
    pub(super) view: View<'a>,
    /// Parameters of pairs, and of contacts with walls (counted from their own first).
    pub(super) laws: &'a [[Column; MOST]; 2],
    /// Whether all pairs are plain.
    pub(super) plain: bool,
    pub(super) memory: [Column; MOST],
    pub(super) whole: *mut <L::Memo as Memory>::Whole,
    /// Columns of bookings, if they are kept.
    pub(super) book: *const Column,
    pub(super) slots: *mut Slot,
    /// How each contact stands, as a byte.
    pub(super) status: *mut u8,
    /// Whether rows are asked for ahead.
    pub(super) ask: bool,
}

// SAFETY: the pointers are to contacts, and each contact is worked on by one thread only.
unsafe impl<L: Law> Send for Kernel<'_, L> {}
// SAFETY: as above.
unsafe impl<L: Law> Sync for Kernel<'_, L> {}

/// Bytes that say of each of eight contacts whether its bit is set.
static SPREAD: [u64; 256] = {
    let mut table = [0; 256];
    let mut bits = 0;
    while bits < 256 {
        let mut lane = 0;
        while lane < 8 {
            table[bits] |= ((bits as u64 >> lane) & 1) << (8 * lane);
            lane += 1;
        }
        bits += 1;
    }
    table
};

/// Blocks whose geometry is worked out before their laws: one block alone is a long chain of steps
/// that wait for each other, and a processor looks ahead a block or two at most.
const AT_ONCE: usize = 8;

impl<L: Law> Kernel<'_, L> {
    /// Contacts `from..to`, with the instructions asked for.
    ///
    /// # Safety
    /// The pointers must be to so many contacts, the pairs, those with walls, too, name rows there are,
    /// and nobody else may work on these contacts.
    pub(super) unsafe fn run<const BOOK: bool>(&self, from: usize, to: usize, isa: Isa) {
        let pairs = self.view.pairs.len();
        let last = to.min(pairs);
        if from < last {
            // SAFETY: the caller's; instructions are used only where the processor has them.
            unsafe {
                let plain = self.plain && !BOOK;
                match isa {
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx512 if Isa::Avx512.is_here() && plain => {
                        self.with_eight::<L::Plain<Eight>, false>(from, last);
                    }
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx512 if Isa::Avx512.is_here() => {
                        self.with_eight::<L::On<Eight>, BOOK>(from, last);
                    }
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx2 if Isa::Avx2.is_here() && plain => {
                        self.with_four::<L::Plain<Four>, false>(from, last);
                    }
                    #[cfg(target_arch = "x86_64")]
                    Isa::Avx2 if Isa::Avx2.is_here() => {
                        self.with_four::<L::On<Four>, BOOK>(from, last);
                    }
                    _ => self.pairs::<f64, L::On<f64>, BOOK>(from, last),
                }
            }
        }
        for k in from.max(pairs)..to {
            // SAFETY: the caller's.
            unsafe { self.wall::<BOOK>(k) };
        }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx512f,avx512dq,avx512vl,avx2")]
    unsafe fn with_eight<R, const BOOK: bool>(&self, from: usize, to: usize)
    where
        R: React<Eight, Memory = Held<L::Memo, Eight>>,
    {
        // SAFETY: the caller's.
        unsafe { self.pairs::<Eight, R, BOOK>(from, to) }
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    unsafe fn with_four<R, const BOOK: bool>(&self, from: usize, to: usize)
    where
        R: React<Four, Memory = Held<L::Memo, Four>>,
    {
        // SAFETY: the caller's.
        unsafe { self.pairs::<Four, R, BOOK>(from, to) }
    }

    #[inline(always)]
    unsafe fn pairs<V: Lanes, R, const BOOK: bool>(&self, from: usize, to: usize)
    where
        R: React<V, Memory = Held<L::Memo, V>>,
    {
        let mut k = from;
        let mut seen = [Geometry::<V>::nowhere(); AT_ONCE];
        // SAFETY: the caller's; blocks end before `to`.
        unsafe {
            while k + V::COUNT <= to {
                let blocks = ((to - k) / V::COUNT).min(AT_ONCE);
                for (block, seen) in seen.iter_mut().enumerate().take(blocks) {
                    let k = k + block * V::COUNT;
                    if self.ask {
                        self.ask_for(k + AHEAD, V::COUNT);
                    }
                    self.look::<V>(k, seen);
                }
                for (block, seen) in seen.iter().enumerate().take(blocks) {
                    self.pair::<V, R, BOOK>(k + block * V::COUNT, seen);
                }
                k += blocks * V::COUNT;
            }
            let mut alone = Geometry::<f64>::nowhere();
            while k < to {
                self.look::<f64>(k, &mut alone);
                self.pair::<f64, L::On<f64>, BOOK>(k, &alone);
                k += 1;
            }
        }
    }

    /// Asks for the second bodies' rows of a block of contacts that comes soon: those of the first ascend,
    /// and a processor foresees that by itself.
    #[inline(always)]
    fn ask_for(&self, first: usize, count: usize) {
        #[cfg(target_arch = "x86_64")]
        if let Some(pairs) = self.view.pairs.get(first..first + count) {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            let rows = self.view.rows.as_ptr();
            for &[_, j] in pairs {
                // SAFETY: asking for memory is harmless, whatever is there.
                unsafe { _mm_prefetch::<_MM_HINT_T0>(rows.wrapping_add(j as usize).cast()) };
            }
        }
    }

    /// How the contacts of a block stood, a byte each.
    #[inline(always)]
    unsafe fn stood(&self, k: usize, count: usize) -> u64 {
        // SAFETY: the caller's: so many bytes.
        unsafe {
            let status = self.status.add(k);
            match count {
                8 => status.cast::<u64>().read_unaligned(),
                4 => u64::from(status.cast::<u32>().read_unaligned()),
                _ => u64::from(*status),
            }
        }
    }

    #[inline(always)]
    unsafe fn stand(&self, k: usize, count: usize, bytes: u64) {
        // SAFETY: the caller's: so many bytes.
        unsafe {
            let status = self.status.add(k);
            match count {
                8 => status.cast::<u64>().write_unaligned(bytes),
                4 => status.cast::<u32>().write_unaligned(bytes as u32),
                _ => *status = bytes as u8,
            }
        }
    }

    /// The geometry of a block of pairs.
    #[inline(always)]
    unsafe fn look<V: Lanes>(&self, k: usize, seen: &mut Geometry<V>) {
        // SAFETY: the caller's: a block of pairs.
        let Meeting {
            d,
            mut v,
            spin,
            rim,
            reach,
        } = unsafe { V::meet(self.view.rows.as_ptr(), self.view.pairs.as_ptr().add(k)) };
        if let Some((rate, _)) = &self.view.flow {
            // The imposed flow at the first centre less that at the second.
            let [first, second] = rate;
            v[0] = v[0] + (V::all(first[0]) * d[0] + V::all(first[1]) * d[1]);
            v[1] = v[1] + (V::all(second[0]) * d[0] + V::all(second[1]) * d[1]);
        }
        let square = d[0] * d[0] + d[1] * d[1];
        let distance = square.sqrt();
        let overlap = reach - distance;
        // There is no need to test D² < (R1 + R2)² as well: where that fails, D as rounded is not below
        // R1 + R2 either, as the root of a rounded square is the number itself, barring radii above
        // 1e150 m or below 1e-150 m.
        let apart = V::all(0.0).at_least(overlap);
        // One division for all three: D, R1 + R2 and their ratio.
        let inverse = V::all(1.0) / (reach * distance);
        let per_distance = reach * inverse;
        let e = [d[0] * per_distance, d[1] * per_distance];
        let arm = square * inverse;
        seen.touching = !apart;
        seen.overlap = overlap;
        seen.approach = v[0] * e[0] + v[1] * e[1];
        if <L::On<V> as React<V>>::TANGENTIAL {
            seen.slide = v[0] * e[1] - v[1] * e[0] - rim * arm;
            seen.arm = arm;
        }
        if <L::On<V> as React<V>>::ROLLING {
            seen.roll = spin;
        }
        seen.e = e;
    }

    #[inline(always)]
    unsafe fn pair<V: Lanes, R, const BOOK: bool>(&self, k: usize, seen: &Geometry<V>)
    where
        R: React<V, Memory = Held<L::Memo, V>>,
    {
        // SAFETY: the caller's: a block of pairs.
        unsafe {
            let stood = self.stood(k, V::COUNT);
            if stood == 0 && !V::any(seen.touching) {
                return self.rest::<V, BOOK>(k);
            }
            let laws = Reading::at(self.laws[0].as_ptr(), k);
            self.react::<V, R, BOOK>(k, laws, seen, stood);
        }
    }

    #[inline(never)]
    unsafe fn wall<const BOOK: bool>(&self, k: usize) {
        let w = k - self.view.pairs.len();
        // SAFETY: the caller's: a contact with a wall, whose particle has a row.
        let (wall, row): (&WallTouch, &Row) = unsafe {
            let particle = self.view.wall_pairs.get_unchecked(w).particle;
            (
                self.view.wall_touches.get_unchecked(w),
                self.view.rows.get_unchecked(particle as usize),
            )
        };
        let overlap = row.radius - wall.distance;
        // What is not a number touches.
        let touching = !0.0.at_least(overlap);
        // SAFETY: the caller's: a contact with a wall.
        unsafe {
            let stood = self.stood(k, 1);
            if stood == 0 && !touching {
                return self.rest::<f64, BOOK>(k);
            }
            let e = wall.e;
            let mut v = [row.v[0] - wall.v[0], row.v[1] - wall.v[1]];
            if let Some((rate, centre)) = &self.view.flow {
                let flow = velocity(rate, [row.x[0] - centre[0], row.x[1] - centre[1]]);
                v = [v[0] + flow[0], v[1] + flow[1]];
            }
            let slide = if <L::On<f64> as React<f64>>::TANGENTIAL {
                v[0] * e[1] - v[1] * e[0] - row.spin * row.radius
            } else {
                0.0
            };
            let geometry = Geometry {
                e,
                touching,
                overlap,
                approach: v[0] * e[0] + v[1] * e[1],
                slide,
                roll: if <L::On<f64> as React<f64>>::ROLLING {
                    row.spin - wall.spin
                } else {
                    0.0
                },
                arm: 1.0,
            };
            let laws = Reading::at(self.laws[1].as_ptr(), w);
            self.react::<f64, L::On<f64>, BOOK>(k, laws, &geometry, stood);
        }
    }

    #[inline(always)]
    unsafe fn react<V: Lanes, R, const BOOK: bool>(
        &self,
        k: usize,
        mut laws: Reading,
        g: &Geometry<V>,
        stood: u64,
    ) where
        R: React<V, Memory = Held<L::Memo, V>>,
    {
        // SAFETY: the caller's: a block of contacts, with parameters where `laws` stands.
        unsafe {
            let zero = V::all(0.0);
            let mut touch = g.touch(self.view.dt);
            let parameters = laws;
            let law = R::take(&mut laws);
            let columns = self.memory.as_ptr();
            let whole = self.whole.wrapping_add(k);
            let mut memory = L::Memo::lanes::<V>(&mut Reading::at(columns, k), whole);
            if R::BONDS {
                // A bond that holds is in touch at any distance; one that does not, and overlaps no
                // more, comes apart as any contact does.
                touch.touching = touch.touching | law.holds(&touch, &memory);
            }
            let touching = touch.touching;
            let bits = V::bits(touching);
            let parting = touched(stood) & !bits;
            if (BOOK || size_of::<<L::Memo as Memory>::Whole>() > 0) && parting != 0 {
                for lane in (0..V::COUNT).filter(|lane| parting >> lane & 1 == 1) {
                    self.part::<BOOK>(k + lane, parameters.further(lane), &lane_of(&touch, lane));
                }
            }
            let r = law.react(&touch, &mut memory);
            L::Memo::keep::<V>(memory, touching, &mut Writing::at(columns, k));
            let t = [g.e[1], -g.e[0]];
            let columns = [
                V::pick(touching, -(r.normal * g.e[0]) - r.tangential * t[0], zero),
                V::pick(touching, -(r.normal * g.e[1]) - r.tangential * t[1], zero),
                V::pick(touching, r.tangential * g.arm, zero),
                V::pick(touching, r.moment, zero),
            ];
            V::write_rows(columns, self.slots.add(k).cast());
            let sliding = V::bits(touching & r.sliding);
            let bytes = SPREAD[bits as usize & 255] + SPREAD[sliding as usize & 255];
            self.stand(k, V::COUNT, bytes);
            if BOOK {
                self.book(k, &r, &touch, parting);
            }
        }
    }

    #[inline(always)]
    unsafe fn book<V: Lanes>(&self, k: usize, r: &Reaction<V>, touch: &Touch<V>, parting: u32) {
        let step = Step {
            way: [touch.approach * touch.dt, touch.slide * touch.dt],
            sliding: r.sliding,
        };
        // SAFETY: the caller's: bookings of a block of contacts.
        let (mut from, mut to) = unsafe { (Reading::at(self.book, k), Writing::at(self.book, k)) };
        let was = Book::<V>::take(&mut from);
        let now = was.after(r.loss, r.damping, r.excess, &step);
        // What parting cost was booked before; those who were apart already cost nothing.
        let book = now.or(touch.touching, was);
        book.give(touch.touching | V::mask(parting), &mut to);
    }

    /// Out of touch, and in touch at the last boundary.
    #[cold]
    #[inline(never)]
    unsafe fn part<const BOOK: bool>(&self, k: usize, mut laws: Reading, touch: &Touch) {
        // SAFETY: the caller's: a contact, with parameters where `laws` stands.
        unsafe {
            let columns = self.memory.as_ptr();
            let whole = &mut *self.whole.add(k);
            if BOOK {
                let memory = L::Memo::take(&mut Reading::at(columns, k), whole);
                let loss = L::take(&mut laws).part(touch, &memory);
                let step = Step {
                    way: [touch.approach * touch.dt, touch.slide * touch.dt],
                    sliding: false,
                };
                let mut from = Reading::at(self.book, k);
                let was = <Book as Numbers<f64>>::take(&mut from);
                let last = was.after(loss, [0.0; 2], 0.0, &step);
                let book = Book {
                    friction_loss: last.friction_loss,
                    damping_loss: last.damping_loss,
                    ..Book::default()
                };
                Written::<f64>::give(book, true, &mut Writing::at(self.book, k));
            }
            L::Memo::default().give(&mut Writing::at(columns, k), whole);
        }
    }

    /// Still out of touch: only last step's bookings have to go.
    #[inline(always)]
    unsafe fn rest<V: Lanes, const BOOK: bool>(&self, k: usize) {
        if BOOK {
            // SAFETY: the caller's: bookings of a block of contacts.
            let mut to = unsafe { Writing::at(self.book, k) };
            for _ in 0..Book::COLUMNS {
                to.column(V::all(0.0));
            }
        }
    }
}

/// Of eight contacts, those whose byte says that they touched.
#[inline(always)]
fn touched(stood: u64) -> u32 {
    let ones = 0x0101_0101_0101_0101;
    let either = (stood | stood >> 1) & ones;
    (either.wrapping_mul(0x0102_0408_1020_4080) >> 56) as u32
}
