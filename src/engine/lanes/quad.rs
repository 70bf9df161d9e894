//! Rows of four numbers: what the pass over the particles works on.

use std::ops::{Add, Div, Mul, Neg, Sub};

use super::{Lanes, Meeting};
use crate::engine::particles::Row;

/// Lanes that hold one row of four numbers.
#[allow(
    clippy::return_self_not_must_use,
    reason = "these are formulas: nobody drops the value of one"
)]
pub(crate) trait Quad: Lanes {
    /// Rows to columns.
    fn transposed(rows: [Self; 4]) -> [Self; 4];
    /// The first three numbers, and the last of another.
    fn with_last(self, other: Self) -> Self;
    /// The first number everywhere, and the second.
    fn spread(self) -> [Self; 2];
    /// With the other sign where the signs say so.
    fn turned(self, signs: Self) -> Self;
    /// First and second number exchanged, and third and fourth.
    #[must_use]
    fn swapped(self) -> Self;
    /// Four numbers.
    #[inline(always)]
    fn of_four(numbers: [f64; 4]) -> Self {
        // SAFETY: there are four.
        unsafe { Self::read(numbers.as_ptr()) }
    }
    /// Two numbers and two noughts.
    ///
    /// # Safety
    /// Two numbers must be readable there.
    unsafe fn read_two(from: *const f64) -> Self;
}

/// Four lanes without instructions of their own.
#[derive(Clone, Copy)]
pub(crate) struct Scalars([f64; 4]);

/// Yes or no of four.
#[derive(Clone, Copy)]
pub(crate) struct ScalarMask([bool; 4]);

macro_rules! by_lane {
    ($($operator:ident $method:ident),*) => {$(
        impl $operator for Scalars {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let (a, b) = (self.0, other.0);
                Self([
                    a[0].$method(b[0]),
                    a[1].$method(b[1]),
                    a[2].$method(b[2]),
                    a[3].$method(b[3]),
                ])
            }
        }
    )*};
}
by_lane!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Scalars {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self(self.0.map(|x| -x))
    }
}

impl std::ops::BitAnd for ScalarMask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] & other.0[k]))
    }
}

impl std::ops::BitOr for ScalarMask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] | other.0[k]))
    }
}

impl std::ops::Not for ScalarMask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(self.0.map(|yes| !yes))
    }
}

impl Lanes for Scalars {
    const COUNT: usize = 4;
    type Mask = ScalarMask;

    #[inline(always)]
    fn all(x: f64) -> Self {
        Self([x; 4])
    }

    #[inline(always)]
    unsafe fn read(from: *const f64) -> Self {
        // SAFETY: the caller's.
        Self(unsafe { from.cast::<[f64; 4]>().read() })
    }

    #[inline(always)]
    unsafe fn write(self, to: *mut f64) {
        // SAFETY: the caller's.
        unsafe { to.cast::<[f64; 4]>().write(self.0) }
    }

    #[inline(always)]
    fn sqrt(self) -> Self {
        Self(self.0.map(f64::sqrt))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(self.0.map(f64::abs))
    }

    #[inline(always)]
    fn copysign(self, sign: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k].copysign(sign.0[k])))
    }

    #[inline(always)]
    fn above(self, other: Self) -> ScalarMask {
        ScalarMask(std::array::from_fn(|k| self.0[k] > other.0[k]))
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> ScalarMask {
        ScalarMask(std::array::from_fn(|k| self.0[k] >= other.0[k]))
    }

    #[inline(always)]
    fn equals(self, other: Self) -> ScalarMask {
        ScalarMask(std::array::from_fn(|k| self.0[k] == other.0[k]))
    }

    #[inline(always)]
    fn pick(mask: ScalarMask, yes: Self, no: Self) -> Self {
        Self(std::array::from_fn(|k| {
            if mask.0[k] { yes.0[k] } else { no.0[k] }
        }))
    }

    #[inline(always)]
    fn larger(self, other: Self) -> Self {
        Self::pick(self.above(other), self, other)
    }

    #[inline(always)]
    fn smaller(self, other: Self) -> Self {
        Self::pick(other.above(self), self, other)
    }

    #[inline(always)]
    fn bits(mask: ScalarMask) -> u32 {
        (0..4).fold(0, |bits, k| bits | u32::from(mask.0[k]) << k)
    }

    #[inline(always)]
    fn mask(bits: u32) -> ScalarMask {
        ScalarMask(std::array::from_fn(|k| bits >> k & 1 == 1))
    }

    #[inline(always)]
    unsafe fn meet(rows: *const Row, pairs: *const [u32; 2]) -> Meeting<Self> {
        // SAFETY: the caller's: four pairs.
        let m: [Meeting<f64>; 4] =
            std::array::from_fn(|k| unsafe { f64::meet(rows, pairs.add(k)) });
        Meeting {
            d: [Self(m.map(|m| m.d[0])), Self(m.map(|m| m.d[1]))],
            v: [Self(m.map(|m| m.v[0])), Self(m.map(|m| m.v[1]))],
            spin: Self(m.map(|m| m.spin)),
            rim: Self(m.map(|m| m.rim)),
            reach: Self(m.map(|m| m.reach)),
        }
    }

    #[inline(always)]
    unsafe fn read_rows(from: &[*const [f64; 4]; 8]) -> [Self; 4] {
        // SAFETY: the caller's: four rows.
        Self::transposed(std::array::from_fn(|k| Self(unsafe { *from[k] })))
    }

    #[inline(always)]
    unsafe fn write_rows(columns: [Self; 4], to: *mut [f64; 4]) {
        for (k, row) in Self::transposed(columns).into_iter().enumerate() {
            // SAFETY: the caller's: four rows.
            unsafe { to.add(k).write(row.0) };
        }
    }
}

impl Quad for Scalars {
    #[inline(always)]
    fn transposed(rows: [Self; 4]) -> [Self; 4] {
        std::array::from_fn(|k| Self(rows.map(|row| row.0[k])))
    }

    #[inline(always)]
    fn with_last(self, other: Self) -> Self {
        Self([self.0[0], self.0[1], self.0[2], other.0[3]])
    }

    #[inline(always)]
    fn spread(self) -> [Self; 2] {
        [Self([self.0[0]; 4]), Self([self.0[1]; 4])]
    }

    #[inline(always)]
    fn turned(self, signs: Self) -> Self {
        Self(std::array::from_fn(|k| {
            let sign = signs.0[k].to_bits() & (-0.0f64).to_bits();
            f64::from_bits(self.0[k].to_bits() ^ sign)
        }))
    }

    #[inline(always)]
    fn swapped(self) -> Self {
        let [a, b, c, d] = self.0;
        Self([b, a, d, c])
    }

    #[inline(always)]
    unsafe fn read_two(from: *const f64) -> Self {
        // SAFETY: the caller's.
        unsafe { Self([*from, *from.add(1), 0.0, 0.0]) }
    }
}
