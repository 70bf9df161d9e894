//! Eight lanes: AVX-512.

use std::arch::x86_64::{
    __m512d, __mmask8, _CMP_EQ_OQ, _CMP_GE_OQ, _CMP_GT_OQ, _mm256_loadu_pd, _mm256_storeu_si256,
    _mm512_add_pd, _mm512_and_pd, _mm512_andnot_pd, _mm512_castpd256_pd512, _mm512_cmp_pd_mask,
    _mm512_cvttpd_epi32, _mm512_div_pd, _mm512_insertf64x4, _mm512_load_pd, _mm512_loadu_pd,
    _mm512_mask_blend_pd, _mm512_maskz_compress_pd, _mm512_max_pd, _mm512_min_pd, _mm512_mul_pd,
    _mm512_or_pd, _mm512_permutex2var_pd, _mm512_set1_pd, _mm512_setr_epi64, _mm512_setr_pd,
    _mm512_shuffle_f64x2, _mm512_sqrt_pd, _mm512_storeu_pd, _mm512_sub_pd, _mm512_unpackhi_pd,
    _mm512_unpacklo_pd, _mm512_xor_pd,
};

use super::{Lanes, Meeting, arithmetic, plain_members};
use crate::engine::particles::Row;

/// Numbers.
#[derive(Clone, Copy)]
pub(crate) struct Eight(__m512d);

/// One bit per lane.
#[derive(Clone, Copy)]
pub(crate) struct Mask(__mmask8);

arithmetic!(Eight: Add add _mm512_add_pd, Sub sub _mm512_sub_pd, Mul mul _mm512_mul_pd, Div div _mm512_div_pd);

impl std::ops::BitAnd for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl std::ops::BitOr for Mask {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }
}

impl std::ops::Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        Self(!self.0)
    }
}

impl std::ops::Neg for Eight {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: lanes of this width exist only where the processor has them.
        Self(unsafe { _mm512_xor_pd(self.0, _mm512_set1_pd(-0.0)) })
    }
}

/// Blocks of two numbers 0, 2 of `a`, then 0, 2 of `b`.
#[inline(always)]
unsafe fn even(a: __m512d, b: __m512d) -> __m512d {
    // SAFETY: the caller has AVX-512.
    unsafe { _mm512_shuffle_f64x2::<0b10_00_10_00>(a, b) }
}

/// Blocks of two numbers 1, 3 of `a`, then 1, 3 of `b`.
#[inline(always)]
unsafe fn odd(a: __m512d, b: __m512d) -> __m512d {
    // SAFETY: the caller has AVX-512.
    unsafe { _mm512_shuffle_f64x2::<0b11_01_11_01>(a, b) }
}

/// One pair; a row is a register. First less second, but sums of radii and of the speeds of rims:
/// a change of signs and a sum, as the former delays no other sum.
#[inline(always)]
unsafe fn pair(rows: *const Row, [i, j]: [u32; 2]) -> __m512d {
    // SAFETY: the caller has AVX-512, and rows at both indices.
    unsafe {
        let signs = _mm512_setr_pd(-0.0, -0.0, -0.0, 0.0, -0.0, -0.0, -0.0, 0.0);
        let a = _mm512_load_pd(rows.add(i as usize).cast());
        let b = _mm512_load_pd(rows.add(j as usize).cast());
        _mm512_add_pd(a, _mm512_xor_pd(b, signs))
    }
}

/// Two rows of four in one register.
#[inline(always)]
unsafe fn two(low: *const [f64; 4], high: *const [f64; 4]) -> __m512d {
    // SAFETY: the caller has AVX-512, and rows at both places.
    unsafe {
        let low = _mm512_castpd256_pd512(_mm256_loadu_pd(low.cast()));
        _mm512_insertf64x4::<1>(low, _mm256_loadu_pd(high.cast()))
    }
}

// SAFETY of all blocks: lanes of this width exist only in functions that are entered when the
// processor has AVX-512 F and DQ; pointers are as the trait demands.
#[allow(
    clippy::undocumented_unsafe_blocks,
    reason = "one reason for all, above"
)]
impl Lanes for Eight {
    const COUNT: usize = 8;
    type Mask = Mask;

    plain_members!(
        _mm512_set1_pd,
        _mm512_loadu_pd,
        _mm512_storeu_pd,
        _mm512_sqrt_pd,
        _mm512_and_pd,
        _mm512_andnot_pd,
        _mm512_or_pd,
        _mm512_max_pd,
        _mm512_min_pd
    );

    #[inline(always)]
    fn above(self, other: Self) -> Mask {
        Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Mask {
        Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn equals(self, other: Self) -> Mask {
        Mask(unsafe { _mm512_cmp_pd_mask::<_CMP_EQ_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn pick(mask: Mask, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm512_mask_blend_pd(mask.0, no.0, yes.0) })
    }

    #[inline(always)]
    fn bits(mask: Mask) -> u32 {
        u32::from(mask.0)
    }

    #[inline(always)]
    fn mask(bits: u32) -> Mask {
        Mask(bits as u8)
    }

    #[inline(always)]
    fn pack(self, mask: Mask, to: &mut [u32; 8]) -> usize {
        unsafe {
            let chosen = _mm512_maskz_compress_pd(mask.0, self.0);
            _mm256_storeu_si256(to.as_mut_ptr().cast(), _mm512_cvttpd_epi32(chosen));
        }
        mask.0.count_ones() as usize
    }

    #[inline(always)]
    unsafe fn meet(rows: *const Row, pairs: *const [u32; 2]) -> Meeting<Self> {
        unsafe {
            let (r0, r1) = (pair(rows, *pairs), pair(rows, *pairs.add(1)));
            let (r2, r3) = (pair(rows, *pairs.add(2)), pair(rows, *pairs.add(3)));
            let (r4, r5) = (pair(rows, *pairs.add(4)), pair(rows, *pairs.add(5)));
            let (r6, r7) = (pair(rows, *pairs.add(6)), pair(rows, *pairs.add(7)));
            let low = [
                _mm512_unpacklo_pd(r0, r1),
                _mm512_unpacklo_pd(r2, r3),
                _mm512_unpacklo_pd(r4, r5),
                _mm512_unpacklo_pd(r6, r7),
            ];
            let high = [
                _mm512_unpackhi_pd(r0, r1),
                _mm512_unpackhi_pd(r2, r3),
                _mm512_unpackhi_pd(r4, r5),
                _mm512_unpackhi_pd(r6, r7),
            ];
            let columns_04 = [even(low[0], low[1]), even(low[2], low[3])];
            let columns_15 = [even(high[0], high[1]), even(high[2], high[3])];
            let columns_26 = [odd(low[0], low[1]), odd(low[2], low[3])];
            let columns_37 = [odd(high[0], high[1]), odd(high[2], high[3])];
            let v1 = even(columns_04[0], columns_04[1]);
            let x1 = odd(columns_04[0], columns_04[1]);
            let v2 = even(columns_15[0], columns_15[1]);
            let x2 = odd(columns_15[0], columns_15[1]);
            let spin = even(columns_26[0], columns_26[1]);
            let reach = even(columns_37[0], columns_37[1]);
            let rim = odd(columns_37[0], columns_37[1]);
            Meeting {
                // Not negated, which would make negative noughts.
                d: [Self::all(0.0) - Self(x1), Self::all(0.0) - Self(x2)],
                v: [Self(v1), Self(v2)],
                spin: Self(spin),
                rim: Self(rim),
                reach: Self(reach),
            }
        }
    }

    #[inline(always)]
    unsafe fn read_rows(from: &[*const [f64; 4]; 8]) -> [Self; 4] {
        unsafe {
            let (p, q) = (two(from[0], from[2]), two(from[1], from[3]));
            let (r, s) = (two(from[4], from[6]), two(from[5], from[7]));
            let low = [_mm512_unpacklo_pd(p, q), _mm512_unpacklo_pd(r, s)];
            let high = [_mm512_unpackhi_pd(p, q), _mm512_unpackhi_pd(r, s)];
            [
                Self(even(low[0], low[1])),
                Self(even(high[0], high[1])),
                Self(odd(low[0], low[1])),
                Self(odd(high[0], high[1])),
            ]
        }
    }

    #[inline(always)]
    unsafe fn write_rows([a, b, c, d]: [Self; 4], to: *mut [f64; 4]) {
        unsafe {
            // Rows 0 2 4 6 and 1 3 5 7, in halves of two numbers.
            let ab = [_mm512_unpacklo_pd(a.0, b.0), _mm512_unpackhi_pd(a.0, b.0)];
            let cd = [_mm512_unpacklo_pd(c.0, d.0), _mm512_unpackhi_pd(c.0, d.0)];
            let low = _mm512_setr_epi64(0, 1, 8, 9, 4, 5, 12, 13);
            let high = _mm512_setr_epi64(2, 3, 10, 11, 6, 7, 14, 15);
            let rows_04 = _mm512_permutex2var_pd(ab[0], low, cd[0]);
            let rows_15 = _mm512_permutex2var_pd(ab[1], low, cd[1]);
            let rows_26 = _mm512_permutex2var_pd(ab[0], high, cd[0]);
            let rows_37 = _mm512_permutex2var_pd(ab[1], high, cd[1]);
            let to = to.cast::<f64>();
            _mm512_storeu_pd(to, _mm512_shuffle_f64x2::<0b01_00_01_00>(rows_04, rows_15));
            _mm512_storeu_pd(
                to.add(8),
                _mm512_shuffle_f64x2::<0b01_00_01_00>(rows_26, rows_37),
            );
            _mm512_storeu_pd(
                to.add(16),
                _mm512_shuffle_f64x2::<0b11_10_11_10>(rows_04, rows_15),
            );
            _mm512_storeu_pd(
                to.add(24),
                _mm512_shuffle_f64x2::<0b11_10_11_10>(rows_26, rows_37),
            );
        }
    }
}
