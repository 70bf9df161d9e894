//! How much of a disc lies in a circle or in a rectangle, exactly.
//!
//! Every term is a circular segment or sector whose angle comes from `atan2` of its own sine and
//! cosine: none loses digits where the cut is thin.

use std::f64::consts::PI;

/// Area of the disc of `radius` [m] about `centre` inside the circle of radius `circle` about the
/// zero point [m²].
pub(super) fn by_circle(centre: [f64; 2], radius: f64, circle: f64) -> f64 {
    let distance = length(centre);
    let (r, big) = (radius, circle);
    if distance >= big + r {
        return 0.0;
    }
    if distance <= (big - r).abs() {
        let inner = r.min(big);
        return PI * inner * inner;
    }
    // Half the common chord, by the area of the triangle of the two radii and the distance; each
    // factor is positive here.
    let product =
        (r + big + distance) * (r + big - distance) * (distance + r - big) * (distance - r + big);
    let chord = product.max(0.0).sqrt() / (2.0 * distance);
    let to_chord = |own: f64, other: f64| {
        (distance * distance + (own - other) * (own + other)) / (2.0 * distance)
    };
    segment(r, chord, to_chord(r, big)) + segment(big, chord, to_chord(big, r))
}

/// Area beyond a chord of half length `chord` at distance `depth` from the centre; negative depth:
/// the centre is beyond it too.
fn segment(radius: f64, chord: f64, depth: f64) -> f64 {
    radius * radius * libm::atan2(chord, depth) - chord * depth
}

/// Area of the disc of `radius` [m] about `centre` inside a rectangle [m²].
pub(super) fn by_rectangle(centre: [f64; 2], radius: f64, min: [f64; 2], max: [f64; 2]) -> f64 {
    let low = [min[0] - centre[0], min[1] - centre[1]];
    let high = [max[0] - centre[0], max[1] - centre[1]];
    if (0..2).all(|k| low[k] <= -radius && high[k] >= radius) {
        return PI * radius * radius;
    }
    if (0..2).any(|k| low[k] >= radius || high[k] <= -radius) {
        return 0.0;
    }
    // The rectangle is made of four quadrants with signs.
    let quadrant = |x: f64, y: f64| quadrant(radius, x, y);
    let area = quadrant(high[0], high[1]) - quadrant(low[0], high[1]) - quadrant(high[0], low[1])
        + quadrant(low[0], low[1]);
    area.clamp(0.0, PI * radius * radius)
}

/// Area of the disc about zero to the left of x and below y [m²].
fn quadrant(radius: f64, x: f64, y: f64) -> f64 {
    let (x, y) = (x.clamp(-radius, radius), y.clamp(-radius, radius));
    if x * x + y * y >= radius * radius {
        // The corner is outside: what is cut off are whole segments.
        return match (x >= 0.0, y >= 0.0) {
            (true, true) => PI * radius * radius - beyond(radius, x) - beyond(radius, y),
            (true, false) => beyond(radius, -y),
            (false, true) => beyond(radius, -x),
            (false, false) => 0.0,
        };
    }
    // The corner is inside: the sector between the points where its two edges leave the disc, and
    // the triangles from the zero point to the edges.
    let down = (radius * radius - x * x).sqrt();
    let left = (radius * radius - y * y).sqrt();
    let turn = 0.5 * PI + libm::atan2(x, down) + libm::atan2(y, left);
    0.5 * (radius * radius * turn + x * (y + down) + y * (x + left))
}

/// Area of a disc about zero beyond a line at signed distance `depth` [m²].
fn beyond(radius: f64, depth: f64) -> f64 {
    let chord = ((radius - depth) * (radius + depth)).max(0.0).sqrt();
    segment(radius, chord, depth)
}

fn length(v: [f64; 2]) -> f64 {
    (v[0] * v[0] + v[1] * v[1]).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const CLOSE: f64 = 1e-14;

    #[test]
    fn halves_quarters_and_lenses() {
        let far = 100.0;
        let half = by_rectangle([0.0; 2], 2.0, [-far, -far], [0.0, far]);
        assert!((half - 2.0 * PI).abs() < CLOSE);
        let quarter = by_rectangle([0.0; 2], 2.0, [0.0, 0.0], [far, far]);
        assert!((quarter - PI).abs() < CLOSE);
        // A strip through the middle, half the radius to each side: two segments are missing.
        let strip = by_rectangle([5.0, 7.0], 1.0, [4.5, -far], [5.5, far]);
        let exact = PI / 3.0 + 3f64.sqrt() / 2.0;
        assert!((strip - exact).abs() < CLOSE, "{strip} {exact}");
        // The square inscribed, the square around, one that holds nothing.
        let s = 0.5f64.sqrt();
        assert!((by_rectangle([0.0; 2], 1.0, [-s, -s], [s, s]) - 2.0).abs() < 2.0 * CLOSE);
        assert_eq!(by_rectangle([0.0; 2], 1.0, [-1.0, -1.0], [1.0, 1.0]), PI);
        assert_eq!(by_rectangle([0.0; 2], 1.0, [1.0, -1.0], [2.0, 1.0]), 0.0);
        assert!(by_rectangle([0.0; 2], 1.0, [0.8, 0.8], [2.0, 2.0]).abs() < CLOSE);
        // Two unit circles through each other's centre.
        let lens = 2.0 * PI / 3.0 - 3f64.sqrt() / 2.0;
        assert!((by_circle([0.6, 0.8], 1.0, 1.0) - lens).abs() < CLOSE);
        assert_eq!(by_circle([3.0, 0.0], 1.0, 4.0), PI);
        assert_eq!(by_circle([5.0, 0.0], 1.0, 4.0), 0.0);
        assert_eq!(by_circle([0.0, 0.5], 2.0, 1.0), PI);
        // A disc is halved by a circle through its centre that is nearly a line; what it bends away
        // is r³/(3 R) to first order, r²/R² smaller to the next.
        let bend = PI / 2.0 - by_circle([1e4, 0.0], 1.0, 1e4);
        assert!((bend - 1.0 / 3e4).abs() < 1e-11, "{bend}");
    }

    proptest! {
        // The disc's box cut in four at any point: nothing is lost and nothing counted twice.
        #[test]
        fn rectangles_share_a_disc(
            x in -1.5..1.5, y in -1.5..1.5, cx in -50.0..50.0, cy in -50.0..50.0, r in 0.1..10.0,
        ) {
            let (low, mid) = ([cx - 2.0 * r, cy - 2.0 * r], [cx + x * r, cy + y * r]);
            let high = [cx + 2.0 * r, cy + 2.0 * r];
            let cut = |min, max| by_rectangle([cx, cy], r, min, max);
            let parts = [
                cut(low, mid),
                cut([mid[0], low[1]], [high[0], mid[1]]),
                cut([low[0], mid[1]], [mid[0], high[1]]),
                cut(mid, high),
            ];
            let sum: f64 = parts.iter().sum();
            // The corner is rounded at the coordinates' size, up to 70: a side of 4 r times that.
            prop_assert!((sum - PI * r * r).abs() < 4.0 * r * 1e-13 + 1e-14 * r * r);
            prop_assert!(parts.iter().all(|&part| part >= 0.0));
        }

        // A circle lies between the polygons inscribed in it and drawn about it: here thin
        // rectangles, since those are cut by the other routine.
        #[test]
        fn circles_lie_between_staircases(d in 0.0..4.0, r in 0.2..2.0) {
            let (circle, n) = (1.5, 400);
            let step = 2.0 * circle / f64::from(n);
            let (mut least, mut most) = (0.0, 0.0);
            for k in 0..n {
                let (left, right) = (-circle + f64::from(k) * step, -circle + f64::from(k + 1) * step);
                let height = |x: f64| (circle * circle - x * x).max(0.0).sqrt();
                let (a, b) = (height(left), height(right));
                let (low, high) = (a.min(b), if left * right <= 0.0 { circle } else { a.max(b) });
                let slab = |h: f64| by_rectangle([d, 0.0], r, [left, -h], [right, h]);
                least += slab(low);
                most += slab(high);
            }
            let cut = by_circle([d, 0.0], r, circle);
            prop_assert!(least - 1e-12 <= cut && cut <= most + 1e-12, "{least} {cut} {most}");
            // Tight enough to notice a wrong formula: the staircases differ by their steps.
            prop_assert!(most - least < 4.1 * circle * step);
        }

        // The lens belongs to both circles alike.
        #[test]
        fn lenses_are_symmetric(d in 0.0..4.0, a in 0.1..3.0, b in 0.1..3.0) {
            let (one, two) = (by_circle([d, 0.0], a, b), by_circle([0.0, d], b, a));
            prop_assert!((one - two).abs() < 1e-13);
        }
    }
}
