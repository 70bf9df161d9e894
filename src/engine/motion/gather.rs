//! The sum of the contact forces on a particle, in an order that the list alone decides.
//!
//! No processor can predict how many contacts a particle has, and a loop that ends unexpectedly costs
//! as much as ten sums: so the first few of either kind are summed always, with nobody's slot, which
//! is zero, where there is no contact.
#![allow(
    unsafe_code,
    reason = "slots by pointer; each use says what it relies on"
)]

use crate::engine::lanes::Quad;
use crate::engine::neighbours::list::ContactList;
use crate::engine::neighbours::whose::{LASTS, NUMBERS, Places, Whose};

/// Signs of force, tangential force and rolling moment on the second body, beside those on the first.
const SECOND: [f64; 4] = [-1.0, -1.0, 1.0, -1.0];

/// Particles whose slots are asked for before their turn.
const AHEAD: usize = 16;

/// Where forces are found.
#[derive(Clone, Copy)]
pub(super) struct Gather<'a> {
    slots: *const f64,
    places: *const Places,
    particles: usize,
    /// Places of those that had none of their own.
    more: &'a [u32],
    /// First contact of each particle with a wall, if anybody is near one.
    walls: Option<*const u32>,
}

/// Sums over contacts of one particle.
#[derive(Clone, Copy)]
pub(super) struct Total<Q> {
    /// Of the forces.
    pub(super) force: Q,
    /// Of their absolute values, if asked for.
    pub(super) size: Q,
}

impl<'a> Gather<'a> {
    /// From the list of contacts of so many particles.
    ///
    /// # Panics
    /// If its contacts were not noted, or are those of another number of particles.
    pub(super) fn new(contacts: &'a ContactList, particles: usize) -> Self {
        let whose = contacts.whose();
        assert!(
            whose.places().len() == particles
                && whose.is_of(contacts.len())
                && contacts.slots.len() > contacts.len()
                && (!whose.meet_walls() || whose.walls().len() > particles),
            "places of other particles or contacts"
        );
        Self {
            slots: contacts.slots.as_ptr().cast(),
            places: whose.places().as_ptr(),
            particles,
            more: whose.more(),
            walls: whose.meet_walls().then(|| whose.walls().as_ptr()),
        }
    }

    /// Asks for the slots of lower particles that four further on need: the first three of each, as few
    /// have more.
    #[inline(always)]
    pub(super) fn ask_for(&self, p: usize) {
        #[cfg(target_arch = "x86_64")]
        if p + AHEAD + 4 <= self.particles {
            use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
            for p in p + AHEAD..p + AHEAD + 4 {
                // SAFETY: there is such a particle; asking for memory is harmless, whatever is there.
                unsafe {
                    let [a, b, c, ..] = *self.places.add(p);
                    for slot in [a, b, c] {
                        _mm_prefetch::<_MM_HINT_T0>(self.slots.wrapping_add(slot as usize).cast());
                    }
                }
            }
        }
    }

    /// The sums of particle `p`, with absolute values if `SIZE`, at walls, too, if `WALLS`: over either kind
    /// of its pairs in the order of the list, so that pairs that do not touch change no bit.
    ///
    /// # Safety
    /// There must be such a particle.
    #[inline(always)]
    pub(super) unsafe fn of<Q: Quad, const SIZE: bool, const WALLS: bool>(
        &self,
        p: usize,
    ) -> Total<Q> {
        // SAFETY: the caller's, and places name slots there are, nobody's included.
        unsafe {
            let places: *const u32 = self.places.add(p).cast();
            let [last_second, last_first] = LASTS.map(|last| *places.add(last));
            let slot = |k: usize| self.slots.add(*places.add(k) as usize);
            let mut second = Total::<Q>::of::<SIZE>([slot(0), slot(1)])
                .and::<SIZE>(slot(2))
                .and::<SIZE>(slot(3));
            let mut first = Total::<Q>::of::<SIZE>([slot(5), slot(6)])
                .and::<SIZE>(slot(7))
                .and::<SIZE>(slot(8));
            let at_walls = match self.walls {
                Some(first) if WALLS => *first.add(p)..*first.add(p + 1),
                _ => 0..0,
            };
            if Whose::is_more(last_second | last_first) || !at_walls.is_empty() {
                second = self.others::<Q, SIZE>(second, last_second);
                first = self.others::<Q, SIZE>(first, last_first);
                for k in at_walls {
                    first = first.and::<SIZE>(self.slots.add((k * NUMBERS) as usize));
                }
            } else {
                second = second.and::<SIZE>(self.slots.add(last_second as usize));
                first = first.and::<SIZE>(self.slots.add(last_first as usize));
            }
            Total {
                // No negative nought, whose sign would depend on what does not touch.
                force: second.force.turned(Q::of_four(SECOND)) + first.force + Q::all(0.0),
                size: second.size + first.size,
            }
        }
    }

    /// Adds what stands in the last place of a kind: a slot, or where it and others are.
    #[inline(always)]
    unsafe fn others<Q: Quad, const SIZE: bool>(&self, mut sum: Total<Q>, last: u32) -> Total<Q> {
        // SAFETY: the caller's: it is a last place. Places of several were noted with how many follow, and
        // name slots there are.
        unsafe {
            let Some(at) = Whose::more_at(last) else {
                return sum.and::<SIZE>(self.slots.add(last as usize));
            };
            let count = *self.more.get_unchecked(at) as usize;
            for slot in self.more.get_unchecked(at + 1..=at + count) {
                sum = sum.and::<SIZE>(self.slots.add(*slot as usize));
            }
        }
        sum
    }
}

impl<Q: Quad> Total<Q> {
    /// Of two slots.
    #[inline(always)]
    unsafe fn of<const SIZE: bool>([one, other]: [*const f64; 2]) -> Self {
        // SAFETY: the caller's: there are such slots.
        let (one, other) = unsafe { (Q::read(one), Q::read(other)) };
        Self {
            force: one + other,
            size: if SIZE {
                one.abs() + other.abs()
            } else {
                Q::all(0.0)
            },
        }
    }

    #[inline(always)]
    unsafe fn and<const SIZE: bool>(self, slot: *const f64) -> Self {
        // SAFETY: the caller's: there is such a slot.
        let slot = unsafe { Q::read(slot) };
        Self {
            force: self.force + slot,
            size: if SIZE {
                self.size + slot.abs()
            } else {
                self.size
            },
        }
    }
}
