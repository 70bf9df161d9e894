//! Several contacts at once: one number for each, in the registers that the processor has.
//!
//! A law is written once over [`Lanes`]; `f64` itself is the one lane that everything else has to
//! agree with. Only + - * / and √ are done, correctly rounded everywhere, and no product is fused
//! with a sum, so all widths give the same bits.
#![allow(
    unsafe_code,
    reason = "vector instructions and rows by pointer; each use says what it relies on"
)]

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(target_arch = "x86_64")]
mod avx512;
mod columns;
mod cube_root;
mod in_lanes;
mod isa;
mod one;
mod quad;

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Neg, Not, Sub};

#[cfg(target_arch = "x86_64")]
pub(super) use avx2::Four;
#[cfg(target_arch = "x86_64")]
pub(super) use avx512::Eight;
pub(super) use columns::Columns;
pub(super) use cube_root::cube_root;
pub(super) use in_lanes::InLanes;
pub use isa::Isa;
pub(super) use quad::{Quad, Scalars};

use super::particles::Row;

/// One number per lane.
#[allow(
    clippy::return_self_not_must_use,
    reason = "these are formulas: nobody drops the value of one"
)]
pub trait Lanes:
    Copy
    + Send
    + Sync
    + 'static
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
{
    /// Number of lanes, at most 8.
    const COUNT: usize;
    /// Yes or no per lane.
    type Mask: Copy
        + BitAnd<Output = Self::Mask>
        + BitOr<Output = Self::Mask>
        + Not<Output = Self::Mask>;
    /// The same number in all lanes.
    fn all(x: f64) -> Self;
    /// Consecutive numbers.
    ///
    /// # Safety
    /// `COUNT` numbers must be readable there.
    unsafe fn read(from: *const f64) -> Self;
    /// Writes consecutive numbers.
    ///
    /// # Safety
    /// `COUNT` numbers must be writable there.
    unsafe fn write(self, to: *mut f64);
    /// Square root.
    fn sqrt(self) -> Self;
    /// Without sign.
    fn abs(self) -> Self;
    /// With the sign of another.
    fn copysign(self, sign: Self) -> Self;
    /// Greater than another; no if either is not a number.
    fn above(self, other: Self) -> Self::Mask;
    /// Not less than another; no if either is not a number.
    fn at_least(self, other: Self) -> Self::Mask;
    /// Equal to another; no if either is not a number.
    fn equals(self, other: Self) -> Self::Mask;
    /// `yes` where the mask says so, else `no`.
    fn pick(mask: Self::Mask, yes: Self, no: Self) -> Self;
    /// The larger; the other if either is not a number, or both are equal.
    fn larger(self, other: Self) -> Self;
    /// The smaller; the other if either is not a number, or both are equal.
    fn smaller(self, other: Self) -> Self;
    /// The mask as bits, lane 0 lowest.
    fn bits(mask: Self::Mask) -> u32;
    /// Writes the numbers that the mask chooses one after another, as whole ones of less than 2³¹, and
    /// whatever behind them. Answers how many.
    #[inline(always)]
    fn pack(self, mask: Self::Mask, to: &mut [u32; 8]) -> usize {
        let (numbers, bits) = (self.numbers(), Self::bits(mask));
        let mut count = 0;
        for (k, number) in numbers.into_iter().enumerate().take(Self::COUNT) {
            to[count] = number as u32;
            count += (bits >> k & 1) as usize;
        }
        count
    }
    /// What pairs of particles see of each other.
    ///
    /// # Safety
    /// `COUNT` pairs must be readable, and their indices must be those of readable rows.
    unsafe fn meet(rows: *const Row, pairs: *const [u32; 2]) -> Meeting<Self>;
    /// Columns of rows of four numbers that stand anywhere.
    ///
    /// # Safety
    /// A row of four numbers must be readable at each of the first `COUNT` places.
    unsafe fn read_rows(from: &[*const [f64; 4]; 8]) -> [Self; 4];
    /// Writes one row of four numbers per lane.
    ///
    /// # Safety
    /// `COUNT` rows of four numbers must be writable there.
    unsafe fn write_rows(columns: [Self; 4], to: *mut [f64; 4]);

    /// What a function makes of each.
    #[inline(always)]
    fn each(self, function: fn(f64) -> f64) -> Self {
        let mut numbers = [0.0; 8];
        // SAFETY: there are at most eight lanes.
        unsafe {
            self.write(numbers.as_mut_ptr());
            for number in &mut numbers[..Self::COUNT] {
                *number = function(*number);
            }
            Self::read(numbers.as_ptr())
        }
    }

    /// The numbers, lane by lane; noughts beyond the last.
    #[inline(always)]
    fn numbers(self) -> [f64; 8] {
        let mut numbers = [0.0; 8];
        // SAFETY: there are at most eight lanes.
        unsafe { self.write(numbers.as_mut_ptr()) };
        numbers
    }

    /// From numbers, lane by lane.
    #[inline(always)]
    fn of(numbers: &[f64; 8]) -> Self {
        // SAFETY: there are at most eight lanes.
        unsafe { Self::read(numbers.as_ptr()) }
    }

    /// Lanes whose bits are set.
    fn mask(bits: u32) -> Self::Mask;

    /// Whether the mask says yes of any.
    #[inline(always)]
    fn any(mask: Self::Mask) -> bool {
        Self::bits(mask) != 0
    }

    /// Greater than zero, else zero.
    #[inline(always)]
    fn positive(self) -> Self {
        self.larger(Self::all(0.0))
    }
}

/// What two particles see of each other.
#[derive(Clone, Copy)]
pub struct Meeting<V> {
    /// From the first centre to the second [m].
    pub d: [V; 2],
    /// Velocity of the first less that of the second [m/s].
    pub v: [V; 2],
    /// Spin of the first less that of the second [rad/s].
    pub spin: V,
    /// Sum of spin times radius [m/s].
    pub rim: V,
    /// Sum of radii [m].
    pub reach: V,
}

/// + - * / of vectors by their intrinsics.
#[cfg(target_arch = "x86_64")]
macro_rules! arithmetic {
    ($lanes:ident: $($operator:ident $method:ident $intrinsic:ident),*) => {$(
        impl std::ops::$operator for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                // SAFETY: lanes of this width exist only where the processor has them.
                Self(unsafe { $intrinsic(self.0, other.0) })
            }
        }
    )*};
}
#[cfg(target_arch = "x86_64")]
use arithmetic;

/// Members of [`Lanes`] that are one instruction or two, whatever the width.
#[cfg(target_arch = "x86_64")]
macro_rules! plain_members {
    ($all:ident, $read:ident, $write:ident, $root:ident, $and:ident, $and_not:ident, $or:ident, $max:ident, $min:ident) => {
        #[inline(always)]
        fn all(x: f64) -> Self {
            // SAFETY: lanes of this width exist only where the processor has them.
            Self(unsafe { $all(x) })
        }

        #[inline(always)]
        unsafe fn read(from: *const f64) -> Self {
            // SAFETY: as above, and the caller's.
            Self(unsafe { $read(from) })
        }

        #[inline(always)]
        unsafe fn write(self, to: *mut f64) {
            // SAFETY: as above, and the caller's.
            unsafe { $write(to, self.0) }
        }

        #[inline(always)]
        fn sqrt(self) -> Self {
            // SAFETY: as above.
            Self(unsafe { $root(self.0) })
        }

        #[inline(always)]
        fn abs(self) -> Self {
            // SAFETY: as above.
            Self(unsafe { $and_not($all(-0.0), self.0) })
        }

        #[inline(always)]
        fn larger(self, other: Self) -> Self {
            // SAFETY: as above.
            Self(unsafe { $max(self.0, other.0) })
        }

        #[inline(always)]
        fn smaller(self, other: Self) -> Self {
            // SAFETY: as above.
            Self(unsafe { $min(self.0, other.0) })
        }

        #[inline(always)]
        fn copysign(self, sign: Self) -> Self {
            // SAFETY: as above.
            unsafe {
                let bit = $all(-0.0);
                Self($or($and_not(bit, self.0), $and(bit, sign.0)))
            }
        }
    };
}
#[cfg(target_arch = "x86_64")]
use plain_members;

#[cfg(test)]
mod tests;
