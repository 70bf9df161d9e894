//! The order of many particles: along Hilbert's curve, so that neighbours in place are neighbours in
//! memory. Placed at random and numbered as they came, a million cost three and a half times as much
//! per step.

/// Fewer than so many lie in a processor's own memory: they stay in the rows of their lattice.
pub(crate) const MANY: usize = 5_000;

/// The curve passes through 2^16 by 2^16 boxes.
const BITS: u32 = 16;

/// Orders items by where they are.
pub(crate) fn order<T>(items: &mut [T], at: impl Fn(&T) -> [f64; 2]) {
    let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for at in items.iter().map(&at) {
        low = [0, 1].map(|k| at[k].min(low[k]));
        high = [0, 1].map(|k| at[k].max(high[k]));
    }
    let side = (high[0] - low[0]).max(high[1] - low[1]);
    let boxes = f64::from(1 << BITS);
    // A number too large becomes the largest: the box at the end.
    let number = |x: f64| ((x / side * boxes) as u32).min((1 << BITS) - 1);
    // Stable: those of one box stay in their order.
    items.sort_by_cached_key(|item| {
        let at = at(item);
        along([0, 1].map(|k| number(at[k] - low[k])))
    });
}

/// How far along the curve a box is (Hilbert 1891): quarter by quarter, each entered where the last
/// was left.
fn along([mut x, mut y]: [u32; 2]) -> u32 {
    let mut way = 0;
    for bit in (0..BITS).rev() {
        let half = 1 << bit;
        let (right, up) = (u32::from(x & half > 0), u32::from(y & half > 0));
        way = 4 * way + ((3 * right) ^ up);
        if up == 0 {
            if right == 1 {
                (x, y) = (!x, !y);
            }
            (x, y) = (y, x);
        }
    }
    way
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_goes_from_box_to_neighbour_through_all() {
        let side = 32;
        let mut boxes: Vec<[u32; 2]> = (0..side * side).map(|k| [k % side, k / side]).collect();
        boxes.sort_by_key(|place| along(*place));
        for pair in boxes.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            assert_eq!(a[0].abs_diff(b[0]) + a[1].abs_diff(b[1]), 1, "{a:?} {b:?}");
            assert!(along(a) < along(b));
        }
        assert_eq!(along([0; 2]), 0);
    }

    #[test]
    fn neighbours_in_place_become_neighbours_in_number() {
        // Scattered over a square: each step is most of it in the one order, little in the other.
        let place = |k: usize| [(k * 7919 % 10_007) as f64, (k * 104_729 % 10_009) as f64];
        let steps = |places: &[[f64; 2]]| -> f64 {
            let step = |pair: &[[f64; 2]]| {
                (pair[0][0] - pair[1][0]).abs() + (pair[0][1] - pair[1][1]).abs()
            };
            places.windows(2).map(step).sum()
        };
        for (count, share) in [(10_000, 0.03), (600, 0.1)] {
            let mut places: Vec<[f64; 2]> = (0..count).map(place).collect();
            let before = steps(&places);
            order(&mut places, |place| *place);
            let after = steps(&places);
            assert!(after < share * before, "{count}: {after} {before}");
        }
    }

    #[test]
    fn one_place_for_all_and_nobody_are_no_fault() {
        let mut same = [(1, [2.0; 2]), (2, [2.0; 2])];
        order(&mut same, |item| item.1);
        assert_eq!(same.map(|item| item.0), [1, 2]);
        order(&mut [], |place: &[f64; 2]| *place);
    }
}
