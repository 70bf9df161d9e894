//! Where the crowd is: a grain that has left it must not stretch the boxes of all others.

use super::spot::Spot;
use crate::engine::extent::Extent;

/// An extent with room for fewer boxes per particle than this, each as large as particles reach in the mean
/// square, is left as it is: there is nothing to gain.
const SPARSE: f64 = 4.0;

/// Particles that are looked at.
const LOOKED_AT: usize = 256;

/// Share of them that is left out at either end, and that may be far away.
const TAIL: f64 = 0.1;

/// Whether and what rectangle of the extent holds the crowd [m]: between the outer tenths, and as much to
/// either side. True if some are outside.
pub(super) fn crowded(spots: &[Spot], extent: Extent, mean_square: f64) -> (Extent, bool) {
    // With a box around, so that a line has an area, too.
    let area = |extent: &Extent| {
        let sides = extent.size().map(|side| (side * side + mean_square).sqrt());
        sides[0] * sides[1]
    };
    let whole = area(&extent);
    if spots.is_empty() || whole <= SPARSE * spots.len() as f64 * mean_square {
        return (extent, false);
    }
    let every = spots.len().div_ceil(LOOKED_AT);
    let mut crowd = extent;
    for k in 0..2 {
        let mut along: Vec<f64> = spots.iter().step_by(every).map(|spot| spot.x[k]).collect();
        along.sort_unstable_by(f64::total_cmp);
        let out = (TAIL * along.len() as f64) as usize;
        let [low, high] = [along[out], along[along.len() - 1 - out]];
        crowd.low[k] = crowd.low[k].max(low - (high - low));
        crowd.high[k] = crowd.high[k].min(high + (high - low));
    }
    let is_outside = |spot: &&Spot| {
        let beyond = |k: usize| spot.x[k] < crowd.low[k] || spot.x[k] > crowd.high[k];
        beyond(0) || beyond(1)
    };
    let outside = spots.iter().filter(is_outside).count() as f64;
    // At worst all outside share a box and are compared with each other; without a crop so many of the crowd
    // share each of theirs.
    let larger = whole / area(&crowd);
    if larger > 2.0 && outside * outside < larger * spots.len() as f64 {
        (crowd, true)
    } else {
        (extent, false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The extent and the crowd of a square of 30 by 30, of which the last `few` are moved away by this.
    fn square(few: usize, away: [f64; 2]) -> (Extent, (Extent, bool)) {
        let mut extent = Extent::default();
        let spots: Vec<Spot> = (0..900)
            .map(|k| {
                let mut x = [(k % 30) as f64, (k / 30) as f64];
                if k >= 900 - few {
                    x = [0, 1].map(|axis| x[axis] + away[axis]);
                }
                extent.take_in(x);
                Spot::new(x, 0.5)
            })
            .collect();
        (extent, crowded(&spots, extent, 1.0))
    }

    #[test]
    fn one_that_has_left_does_not_count() {
        for away in [[300.0, 0.0], [0.0, -1e6], [-50.0, 4000.0]] {
            for few in [1, 25] {
                let (extent, (crowd, open)) = square(few, away);
                assert!(open, "{few} {away:?}");
                for k in 0..2 {
                    // All who stayed are inside, with no more room than as much again to either side.
                    assert!(crowd.low[k] <= 0.0 && crowd.high[k] >= 28.0, "{crowd:?}");
                    assert!(crowd.size()[k] < 90.0, "{crowd:?}");
                    assert!(crowd.low[k] >= extent.low[k] && crowd.high[k] <= extent.high[k]);
                }
            }
        }
    }

    #[test]
    fn those_who_stand_thinly_or_in_groups_all_count() {
        // Of the last but one a twelfth went not far: in one box together they would cost more than they do now.
        for (few, away) in [(0, [0.0; 2]), (75, [90.0, 0.0]), (450, [1e4, 0.0])] {
            let (extent, crowd) = square(few, away);
            assert_eq!(crowd, (extent, false));
        }
        let thin: Vec<Spot> = (0..900)
            .map(|k| Spot::new([f64::from(k % 30) * 9.0, f64::from(k / 30) * 7.0], 0.5))
            .collect();
        let mut extent = Extent::default();
        for spot in &thin {
            extent.take_in(spot.x);
        }
        assert_eq!(crowded(&thin, extent, 1.0), (extent, false));
        assert!(!crowded(&[], Extent::default(), 1.0).1);
    }
}
