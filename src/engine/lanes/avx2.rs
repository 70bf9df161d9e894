//! Four lanes: AVX2.

use std::arch::x86_64::{
    __m256d, _CMP_EQ_OQ, _CMP_GE_OQ, _CMP_GT_OQ, _mm_load_si128, _mm_loadu_pd, _mm_shuffle_epi8,
    _mm_storeu_si128, _mm256_add_pd, _mm256_and_pd, _mm256_and_si256, _mm256_andnot_pd,
    _mm256_blend_pd, _mm256_blendv_pd, _mm256_castsi256_pd, _mm256_cmp_pd, _mm256_cmpeq_epi64,
    _mm256_cvttpd_epi32, _mm256_div_pd, _mm256_load_pd, _mm256_loadu_pd, _mm256_max_pd,
    _mm256_min_pd, _mm256_movemask_pd, _mm256_mul_pd, _mm256_or_pd, _mm256_permute_pd,
    _mm256_permute2f128_pd, _mm256_permute4x64_pd, _mm256_set_epi64x, _mm256_set1_epi64x,
    _mm256_set1_pd, _mm256_sqrt_pd, _mm256_storeu_pd, _mm256_sub_pd, _mm256_unpackhi_pd,
    _mm256_unpacklo_pd, _mm256_xor_pd, _mm256_zextpd128_pd256,
};

use super::{Lanes, Meeting, Quad, arithmetic, plain_members};
use crate::engine::particles::Row;

/// Numbers.
#[derive(Clone, Copy)]
pub(crate) struct Four(__m256d);

/// All bits of a lane, or none.
#[derive(Clone, Copy)]
pub(crate) struct Mask(__m256d);

arithmetic!(Four: Add add _mm256_add_pd, Sub sub _mm256_sub_pd, Mul mul _mm256_mul_pd, Div div _mm256_div_pd);
arithmetic!(Mask: BitAnd bitand _mm256_and_pd, BitOr bitor _mm256_or_pd);

impl std::ops::Not for Mask {
    type Output = Self;
    #[inline(always)]
    fn not(self) -> Self {
        // SAFETY: lanes of this width exist only where the processor has them.
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_castsi256_pd(_mm256_set1_epi64x(-1))) })
    }
}

impl std::ops::Neg for Four {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        // SAFETY: lanes of this width exist only where the processor has them.
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_set1_pd(-0.0)) })
    }
}

/// The bytes of four whole numbers, those first that a mask chooses.
#[repr(align(16))]
struct Order([u8; 16]);

/// For each mask of four.
const CHOSEN: [Order; 16] = {
    let mut orders = [const { Order([0; 16]) }; 16];
    let mut bits = 0;
    while bits < 16 {
        let (mut lane, mut to) = (0, 0);
        while lane < 4 {
            if bits >> lane & 1 == 1 {
                let mut byte = 0;
                while byte < 4 {
                    orders[bits].0[4 * to + byte] = (4 * lane + byte) as u8;
                    byte += 1;
                }
                to += 1;
            }
            lane += 1;
        }
        bits += 1;
    }
    orders
};

/// Rows to columns, or back.
#[inline(always)]
unsafe fn transposed([a, b, c, d]: [__m256d; 4]) -> [__m256d; 4] {
    // SAFETY: the caller has AVX2.
    unsafe {
        let even = [_mm256_unpacklo_pd(a, b), _mm256_unpacklo_pd(c, d)];
        let odd = [_mm256_unpackhi_pd(a, b), _mm256_unpackhi_pd(c, d)];
        [
            _mm256_permute2f128_pd::<0x20>(even[0], even[1]),
            _mm256_permute2f128_pd::<0x20>(odd[0], odd[1]),
            _mm256_permute2f128_pd::<0x31>(even[0], even[1]),
            _mm256_permute2f128_pd::<0x31>(odd[0], odd[1]),
        ]
    }
}

/// One pair: velocities, spins and radii, and places and rims; radii and rims add up.
#[inline(always)]
unsafe fn pair(rows: *const Row, [i, j]: [u32; 2]) -> (__m256d, __m256d) {
    // SAFETY: the caller has AVX2, and rows at both indices.
    unsafe {
        let a = rows.add(i as usize).cast::<f64>();
        let b = rows.add(j as usize).cast::<f64>();
        let (one, two) = (_mm256_load_pd(a), _mm256_load_pd(b));
        let difference = _mm256_sub_pd(one, two);
        let motion = _mm256_blend_pd::<0b1000>(difference, _mm256_add_pd(one, two));
        let (one, two) = (_mm256_load_pd(a.add(4)), _mm256_load_pd(b.add(4)));
        let difference = _mm256_sub_pd(two, one);
        let place = _mm256_blend_pd::<0b1000>(difference, _mm256_add_pd(one, two));
        (motion, place)
    }
}

// SAFETY of all blocks without a comment of their own: lanes of this width exist only in functions
// that are entered when the processor has AVX2.
#[allow(
    clippy::undocumented_unsafe_blocks,
    reason = "one reason for all, above"
)]
impl Lanes for Four {
    const COUNT: usize = 4;
    type Mask = Mask;

    plain_members!(
        _mm256_set1_pd,
        _mm256_loadu_pd,
        _mm256_storeu_pd,
        _mm256_sqrt_pd,
        _mm256_and_pd,
        _mm256_andnot_pd,
        _mm256_or_pd,
        _mm256_max_pd,
        _mm256_min_pd
    );

    #[inline(always)]
    fn above(self, other: Self) -> Mask {
        Mask(unsafe { _mm256_cmp_pd::<_CMP_GT_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn at_least(self, other: Self) -> Mask {
        Mask(unsafe { _mm256_cmp_pd::<_CMP_GE_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn equals(self, other: Self) -> Mask {
        Mask(unsafe { _mm256_cmp_pd::<_CMP_EQ_OQ>(self.0, other.0) })
    }

    #[inline(always)]
    fn pick(mask: Mask, yes: Self, no: Self) -> Self {
        Self(unsafe { _mm256_blendv_pd(no.0, yes.0, mask.0) })
    }

    #[inline(always)]
    fn bits(mask: Mask) -> u32 {
        unsafe { _mm256_movemask_pd(mask.0) as u32 }
    }

    #[inline(always)]
    fn mask(bits: u32) -> Mask {
        unsafe {
            let lanes = _mm256_set_epi64x(8, 4, 2, 1);
            let set = _mm256_and_si256(_mm256_set1_epi64x(i64::from(bits)), lanes);
            Mask(_mm256_castsi256_pd(_mm256_cmpeq_epi64(set, lanes)))
        }
    }

    #[inline(always)]
    fn pack(self, mask: Mask, to: &mut [u32; 8]) -> usize {
        let bits = Self::bits(mask);
        unsafe {
            let order = _mm_load_si128(CHOSEN[bits as usize].0.as_ptr().cast());
            _mm_storeu_si128(
                to.as_mut_ptr().cast(),
                _mm_shuffle_epi8(_mm256_cvttpd_epi32(self.0), order),
            );
        }
        bits.count_ones() as usize
    }

    #[inline(always)]
    unsafe fn meet(rows: *const Row, pairs: *const [u32; 2]) -> Meeting<Self> {
        unsafe {
            let (p, q) = (pair(rows, *pairs), pair(rows, *pairs.add(1)));
            let (r, s) = (pair(rows, *pairs.add(2)), pair(rows, *pairs.add(3)));
            let [v1, v2, spin, reach] = transposed([p.0, q.0, r.0, s.0]);
            let [d1, d2, _, rim] = transposed([p.1, q.1, r.1, s.1]);
            Meeting {
                d: [Self(d1), Self(d2)],
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
            let [a, b, c, d] = transposed([
                _mm256_loadu_pd(from[0].cast()),
                _mm256_loadu_pd(from[1].cast()),
                _mm256_loadu_pd(from[2].cast()),
                _mm256_loadu_pd(from[3].cast()),
            ]);
            [Self(a), Self(b), Self(c), Self(d)]
        }
    }

    #[inline(always)]
    unsafe fn write_rows(columns: [Self; 4], to: *mut [f64; 4]) {
        unsafe {
            let [a, b, c, d] = columns;
            let rows = transposed([a.0, b.0, c.0, d.0]);
            _mm256_storeu_pd(to.cast(), rows[0]);
            _mm256_storeu_pd(to.add(1).cast(), rows[1]);
            _mm256_storeu_pd(to.add(2).cast(), rows[2]);
            _mm256_storeu_pd(to.add(3).cast(), rows[3]);
        }
    }
}

#[allow(
    clippy::undocumented_unsafe_blocks,
    reason = "one reason for all, above"
)]
impl Quad for Four {
    #[inline(always)]
    fn transposed([a, b, c, d]: [Self; 4]) -> [Self; 4] {
        let [a, b, c, d] = unsafe { transposed([a.0, b.0, c.0, d.0]) };
        [Self(a), Self(b), Self(c), Self(d)]
    }

    #[inline(always)]
    fn with_last(self, other: Self) -> Self {
        Self(unsafe { _mm256_blend_pd::<0b1000>(self.0, other.0) })
    }

    #[inline(always)]
    fn spread(self) -> [Self; 2] {
        unsafe {
            let first = _mm256_permute4x64_pd::<0b00_00_00_00>(self.0);
            let second = _mm256_permute4x64_pd::<0b01_01_01_01>(self.0);
            [Self(first), Self(second)]
        }
    }

    #[inline(always)]
    fn turned(self, signs: Self) -> Self {
        Self(unsafe { _mm256_xor_pd(self.0, _mm256_and_pd(signs.0, _mm256_set1_pd(-0.0))) })
    }

    #[inline(always)]
    fn swapped(self) -> Self {
        Self(unsafe { _mm256_permute_pd::<0b0101>(self.0) })
    }

    #[inline(always)]
    unsafe fn read_two(from: *const f64) -> Self {
        Self(unsafe { _mm256_zextpd128_pd256(_mm_loadu_pd(from)) })
    }
}
