//! One lane: a plain number.

use super::{Lanes, Meeting};
use crate::engine::particles::Row;

impl Lanes for f64 {
    const COUNT: usize = 1;
    type Mask = bool;

    #[inline(always)]
    fn all(x: f64) -> Self {
        x
    }

    #[inline(always)]
    unsafe fn read(from: *const f64) -> Self {
        // SAFETY: the caller's.
        unsafe { *from }
    }

    #[inline(always)]
    unsafe fn write(self, to: *mut f64) {
        // SAFETY: the caller's.
        unsafe { *to = self }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    #[inline(always)]
    fn abs(self) -> Self {
        f64::abs(self)
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        f64::copysign(self, sign)
    }

    #[inline(always)]
    fn above(self, other: Self) -> bool {
        self > other
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> bool {
        self >= other
    }

    #[inline(always)]
    fn equals(self, other: Self) -> bool {
        self == other
    }

    #[inline(always)]
    fn pick(mask: bool, yes: Self, no: Self) -> Self {
        if mask { yes } else { no }
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        if self > other { self } else { other }
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        if self < other { self } else { other }
    }

    #[inline(always)]
    fn bits(mask: bool) -> u32 {
        u32::from(mask)
    }

    #[inline(always)]
    fn mask(bits: u32) -> bool {
        bits != 0
    }

    #[inline(always)]
    unsafe fn meet(rows: *const Row, pairs: *const [u32; 2]) -> Meeting<Self> {
        // SAFETY: the caller's.
        let (a, b) = unsafe {
            let [i, j] = *pairs;
            (&*rows.add(i as usize), &*rows.add(j as usize))
        };
        Meeting {
            d: [b.x[0] - a.x[0], b.x[1] - a.x[1]],
            v: [a.v[0] - b.v[0], a.v[1] - b.v[1]],
            spin: a.spin - b.spin,
            rim: a.spin * a.radius + b.spin * b.radius,
            reach: a.radius + b.radius,
        }
    }

    #[inline(always)]
    unsafe fn read_rows(from: &[*const [f64; 4]; 8]) -> [Self; 4] {
        // SAFETY: the caller's.
        unsafe { *from[0] }
    }

    #[inline(always)]
    unsafe fn write_rows(columns: [Self; 4], to: *mut [f64; 4]) {
        // SAFETY: the caller's.
        unsafe { *to = columns }
    }
}
