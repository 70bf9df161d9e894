//! Cube roots in lanes, rounded correctly.

use super::Lanes;

/// x^(1/3) on [1/8, 1] to .0053 of it: the cubic of least relative error, by Remez.
const CUBIC: [f64; 4] = [0.340_842, 1.458_113, -1.385_925, 0.592_185];

/// Adding and taking away again leaves multiples of 2^-17 of a number near 1.
const COARSE: f64 = 1.5 * (1_u64 << 35) as f64;

/// Cube roots of numbers from 0 to 1, and where they are certain to be those that `libm::cbrt`
/// gives, which rounds correctly (Zimmermann, Sibidanov & Gladman, core-math): from 2^-12 on, unless
/// the true root lies within .001 of the middle between two numbers, and for nought.
///
/// A root y of 17 bits has an exact cube, and 1 - y³/x is exact but for one division: the series
/// of (1 - v)^(-1/3) adds the rest to 10^-4 of half a last place.
#[inline(always)]
pub(crate) fn cube_root<V: Lanes>(x: V) -> (V, V::Mask) {
    let (zero, one) = (V::all(0.0), V::all(1.0));
    let (small, smaller, least) = (
        V::all(0.125),
        V::all(0.125 * 0.125),
        V::all(0.125 * 0.015_625),
    );
    let (is_small, is_smaller, is_least) = (small.above(x), smaller.above(x), least.above(x));
    let by = V::pick(
        is_smaller,
        V::all(64.0),
        V::pick(is_small, V::all(8.0), one),
    );
    let z = x * V::pick(is_least, V::all(512.0), by);
    let scale = V::pick(
        is_smaller,
        V::all(0.25),
        V::pick(is_small, V::all(0.5), one),
    );
    let scale = V::pick(is_least, V::all(0.125), scale);
    let inverse = one / z;
    let even = V::all(CUBIC[0]) + V::all(CUBIC[1]) * z;
    let rough = even + z * z * (V::all(CUBIC[2]) + V::all(CUBIC[3]) * z);
    let h = rough * rough * (rough * inverse) - one;
    let close = rough - h * rough * (V::all(1.0 / 3.0) - V::all(2.0 / 9.0) * h);
    let y = close + V::all(COARSE) - V::all(COARSE);
    let v = (z - y * y * y) * inverse;
    let tail = V::all(2.0 / 9.0) + v * (V::all(14.0 / 81.0) + v * V::all(35.0 / 243.0));
    let more = y * (v * (V::all(1.0 / 3.0) + v * tail));
    let root = y + more;
    let rest = more - (root - y);
    let certain = (root + rest * V::all(1.0 + 1.0 / 1024.0)).equals(root);
    let is_nought = x.equals(zero);
    let covered = x.at_least(V::all(1.0 / 4096.0)) & one.at_least(x);
    (
        V::pick(is_nought, zero, root * scale),
        is_nought | certain & covered,
    )
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Whether it is certain; wrong it must not be.
    fn check(x: f64) -> bool {
        let (root, certain) = cube_root(x);
        if certain {
            assert_eq!(root.to_bits(), libm::cbrt(x).to_bits(), "{x:e}");
        }
        certain
    }

    #[test]
    fn corners_are_certain() {
        assert!(check(0.0) && check(1.0));
        for scale in [1.0, 0.125, 0.015_625, 0.001_953_125] {
            for x in [scale, 0.421_875 * scale, scale / 8.0, 0.7 * scale] {
                assert!(check(x) && check(x.next_up().min(1.0)), "{x}");
                assert!(x <= 1.0 / 4096.0 || check(x.next_down()), "{x}");
            }
        }
        assert!(!check(1.0 / 4097.0) && !check(1.1) && !check(f64::NAN));
    }

    /// Of the numbers themselves and of cubes rounded, whose roots lie as near to a number as
    /// roots can.
    #[test]
    fn nearly_all_are_certain_and_none_is_wrong() {
        let count = 400_000;
        let mut doubtful = 0;
        for k in 0..count {
            let share = (f64::from(k) + 0.5) / f64::from(count) * 0.618_033_988_749_895;
            let x = (f64::from(k) * 0.618_033_988_749_895)
                .fract()
                .max(1.0 / 4096.0);
            let root = 0.07 + share;
            doubtful += u32::from(!check(x)) + u32::from(!check(root * root * root));
        }
        // Within .001 of the middle lies one in a thousand.
        assert!(doubtful < count / 400, "{doubtful}");
    }

    proptest! {
        #[test]
        fn certain_roots_are_those_of_libm(x in 0.0..=1.0_f64, nearly in 0.0..1e-9_f64) {
            check(x);
            check(1.0 - nearly);
        }
    }
}
