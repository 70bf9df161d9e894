//! Where the crowd is: a grain that has left it must not stretch the boxes of all others.

use super::level::BOXES_PER_PARTICLE;
use super::spot::Spot;
use crate::engine::extent::Extent;

/// An extent of so many boxes per particle, each as large as particles reach in the mean square, is left as
/// it is: twice the limit, below which boxes become no larger than by half.
const SPARSE: f64 = 2.0 * BOXES_PER_PARTICLE as f64;

/// Particles that are looked at, to find the outer tenths: to a fiftieth, one standard deviation.
const LOOKED_AT: usize = 256;

/// Share of them that is left out at either end, and that may be far away.
const TAIL: f64 = 0.1;

/// The part of the extent [m] to lay boxes over, if not all of it: between the outer tenths, and as much to
/// either side, which holds all of an assembly that is spread evenly. Who is outside counts as in the nearest
/// box.
pub(super) fn crowd(spots: &[Spot], extent: Extent, mean_square: f64) -> Option<Extent> {
    // As if a box wider, so that those in a line take some, too.
    let area = |extent: &Extent| {
        let sides = extent.size().map(|side| (side * side + mean_square).sqrt());
        sides[0] * sides[1]
    };
    let whole = area(&extent);
    if spots.is_empty() || whole <= SPARSE * spots.len() as f64 * mean_square {
        return None;
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
    // Pairs that are looked at, but for a factor that is the same: at worst all outside share a box, against so
    // many times more of the crowd in each of theirs.
    let larger = whole / area(&crowd);
    (larger > 2.0 && outside * outside < larger * spots.len() as f64).then_some(crowd)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spots(at: impl Fn(usize) -> [f64; 2]) -> (Vec<Spot>, Extent) {
        let spots: Vec<Spot> = (0..900).map(|k| Spot::new(at(k), 0.5)).collect();
        let mut extent = Extent::default();
        for spot in &spots {
            extent.take_in(spot.x);
        }
        (spots, extent)
    }

    /// The extent and the crowd of a square of 30 by 30, of which the last `few` are moved away by this.
    fn square(few: usize, away: [f64; 2]) -> (Extent, Option<Extent>) {
        let (spots, extent) = spots(|k| {
            let x = [(k % 30) as f64, (k / 30) as f64];
            let moved = [0, 1].map(|axis| x[axis] + away[axis]);
            if k < 900 - few { x } else { moved }
        });
        (extent, crowd(&spots, extent, 1.0))
    }

    #[test]
    fn those_who_have_left_do_not_count() {
        for away in [[300.0, 0.0], [0.0, -1e6], [-50.0, 4000.0]] {
            for few in [1, 25] {
                let (extent, crowd) = square(few, away);
                let crowd = crowd.unwrap_or_else(|| panic!("{few} {away:?}"));
                for k in 0..2 {
                    // All who stayed are inside, with no more room than as much again to either side.
                    assert!(crowd.low[k] <= 0.0 && crowd.high[k] >= 28.0, "{crowd:?}");
                    assert!(crowd.size()[k] < 90.0, "{crowd:?}");
                    assert!(crowd.low[k] >= extent.low[k] && crowd.high[k] <= extent.high[k]);
                }
            }
        }
    }

    /// A twelfth in one box would be compared with each other: that pays only where they are so far away that
    /// the boxes of all others would be very large.
    #[test]
    fn a_group_counts_unless_it_is_far_away() {
        assert!(square(5, [200.0, 0.0]).1.is_some());
        assert!(square(75, [200.0, 0.0]).1.is_none());
        assert!(square(75, [2000.0, 0.0]).1.is_some());
    }

    #[test]
    fn those_who_stand_thinly_or_in_halves_all_count() {
        for (few, away) in [(0, [0.0; 2]), (450, [1e4, 0.0])] {
            assert_eq!(square(few, away).1, None);
        }
        let (thin, extent) = spots(|k| [(k % 30) as f64 * 9.0, (k / 30) as f64 * 7.0]);
        assert_eq!(crowd(&thin, extent, 1.0), None);
        assert_eq!(crowd(&[], Extent::default(), 1.0), None);
    }
}
