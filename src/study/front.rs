//! Which variants are worth having.

/// Marks the points that no other point beats in both coordinates: not larger in either and smaller
/// in one. Points that are no numbers are on no front.
pub fn front(points: &[[f64; 2]]) -> Vec<bool> {
    let is_number = |p: &[f64; 2]| p.iter().all(|x| x.is_finite());
    let beats =
        |a: &[f64; 2], b: &[f64; 2]| a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1]);
    points
        .iter()
        .map(|p| is_number(p) && !points.iter().any(|other| beats(other, p)))
        .collect()
}

/// The point with the smallest first coordinate among those whose second is at most `bound`.
pub fn first_within(points: &[[f64; 2]], bound: f64) -> Option<usize> {
    (0..points.len())
        .filter(|&k| points[k][0].is_finite() && points[k][1] <= bound)
        .min_by(|&a, &b| points[a][0].total_cmp(&points[b][0]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn the_front_holds_what_nothing_beats() {
        let nan = f64::NAN;
        let points = [
            [1.0, 8.0],
            [2.0, 4.0],
            [3.0, 5.0],
            [4.0, 1.0],
            [4.0, 2.0],
            [nan, 0.0],
            [0.0, nan],
            [0.5, f64::INFINITY],
            [9.0, 1.0],
        ];
        let marked = [true, true, false, true, false, false, false, false, false];
        assert_eq!(front(&points), marked);
        // Equals do not beat each other.
        assert_eq!(front(&[[1.0, 1.0], [1.0, 1.0]]), [true, true]);
        assert!(front(&[]).is_empty());
    }

    #[test]
    fn the_fastest_within_a_bound_is_found() {
        let points = [[3.0, 0.1], [2.0, 0.2], [1.0, 0.5], [f64::NAN, 0.0]];
        assert_eq!(first_within(&points, 0.2), Some(1));
        assert_eq!(first_within(&points, 0.1), Some(0));
        assert_eq!(first_within(&points, 0.05), None);
        assert_eq!(first_within(&[[1.0, f64::NAN]], 1.0), None);
    }

    proptest! {
        #[test]
        fn every_point_is_on_the_front_or_beaten_by_one_that_is(
            points in prop::collection::vec(prop::array::uniform2(0u8..8), 1..20)
        ) {
            let points: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::from)).collect();
            let marked = front(&points);
            prop_assert!(marked.contains(&true));
            for (p, on) in points.iter().zip(&marked) {
                let beaten = points.iter().zip(&marked).any(|(q, other)| {
                    *other && q != p && q[0] <= p[0] && q[1] <= p[1]
                });
                prop_assert_ne!(beaten, *on);
            }
        }
    }
}
