//! Area of the convex hull of discs, exact for any radii.
//!
//! A convex body is the envelope of its support function h(φ), the largest extent in direction
//! u(φ); that of a disc is c·u + R, that of the hull the largest of its discs'. Two such functions
//! cross at most twice, so the envelope is found by merging halves, and the area ½∫(h² - h'²)dφ
//! has a closed form on each of its pieces.

use std::f64::consts::{PI, TAU};

/// A centre [m] and a radius [m].
pub(super) type Disc = ([f64; 2], f64);

/// Directions from `from` to the next piece's, in which a disc reaches furthest.
#[derive(Clone, Copy)]
struct Piece {
    from: f64,
    disc: usize,
}

/// Area of the convex hull [m²]; 0 without discs.
pub(super) fn area(discs: &[Disc]) -> f64 {
    let Some(&(zero, _)) = discs.first() else {
        return 0.0;
    };
    let discs: Vec<Disc> = discs
        .iter()
        .map(|&(c, r)| ([c[0] - zero[0], c[1] - zero[1]], r))
        .collect();
    let discs = without_inner(discs);
    let pieces = envelope(&discs, 0, discs.len());
    let ends = pieces.iter().skip(1).map(|next| next.from).chain([TAU]);
    let twice: f64 = pieces
        .iter()
        .zip(ends)
        .map(|(piece, to)| twice_area(discs[piece.disc], piece.from, to))
        .sum();
    0.5 * twice
}

/// Leaves out discs that lie inside the octagon of the centres that reach furthest: most of a large
/// assembly.
fn without_inner(discs: Vec<Disc>) -> Vec<Disc> {
    let furthest = |k: u32| {
        let (s, c) = libm::sincos(f64::from(k) * PI / 4.0);
        let reach = |&(x, r): &Disc| c * x[0] + s * x[1] + r;
        let most = discs.iter().max_by(|a, b| reach(a).total_cmp(&reach(b)));
        most.map_or([0.0; 2], |disc| disc.0)
    };
    let corners: Vec<[f64; 2]> = (0..8).map(furthest).collect();
    let edges: Vec<([f64; 2], [f64; 2], f64)> = (0..8)
        .map(|k| (corners[k], corners[(k + 1) % 8]))
        .map(|(a, b)| (a, [b[0] - a[0], b[1] - a[1]]))
        .map(|(a, d)| (a, d, (d[0] * d[0] + d[1] * d[1]).sqrt()))
        .filter(|edge| edge.2 > 0.0)
        .collect();
    let is_inner = |&(x, r): &Disc| {
        edges.len() > 2
            && edges.iter().all(|&(a, d, length)| {
                let height = d[0] * (x[1] - a[1]) - d[1] * (x[0] - a[0]);
                height > r * length
            })
    };
    discs.into_iter().filter(|disc| !is_inner(disc)).collect()
}

/// Pieces from direction 0 to a full turn of the discs `first..end`.
fn envelope(discs: &[Disc], first: usize, end: usize) -> Vec<Piece> {
    if end - first == 1 {
        return vec![Piece {
            from: 0.0,
            disc: first,
        }];
    }
    let middle = first.midpoint(end);
    let (left, right) = (envelope(discs, first, middle), envelope(discs, middle, end));
    let mut merged: Vec<Piece> = Vec::with_capacity(left.len() + right.len());
    let (mut i, mut j, mut from) = (0, 0, 0.0);
    let next = |pieces: &[Piece], k: usize| pieces.get(k + 1).map_or(TAU, |piece| piece.from);
    while from < TAU {
        let (left_end, right_end) = (next(&left, i), next(&right, j));
        let to = left_end.min(right_end);
        compare(discs, [left[i].disc, right[j].disc], from, to, &mut merged);
        i += usize::from(left_end <= to);
        j += usize::from(right_end <= to);
        from = to;
    }
    merged
}

/// Appends which of two discs reaches further between two directions.
fn compare(discs: &[Disc], pair: [usize; 2], from: f64, to: f64, merged: &mut Vec<Piece>) {
    let [(a, ra), (b, rb)] = pair.map(|k| discs[k]);
    let (d, more) = ([a[0] - b[0], a[1] - b[1]], ra - rb);
    let distance = (d[0] * d[0] + d[1] * d[1]).sqrt();
    let mut cuts = [from, from, to];
    let towards = libm::atan2(d[1], d[0]);
    if distance > more.abs() {
        let half = libm::acos(-more / distance);
        let mut turns = [towards - half, towards + half].map(|angle| {
            let turned = if angle < 0.0 { angle + TAU } else { angle };
            turned.clamp(from, to)
        });
        if turns[0] > turns[1] {
            turns.swap(0, 1);
        }
        cuts = [turns[0], turns[1], to];
    }
    let mut start = from;
    for cut in cuts {
        if cut > start {
            let first = distance * libm::cos(0.5 * (start + cut) - towards) + more >= 0.0;
            let disc = pair[usize::from(!first)];
            if merged.last().is_none_or(|last| last.disc != disc) {
                merged.push(Piece { from: start, disc });
            }
            start = cut;
        }
    }
}

/// ∫(h² - h'²)dφ of one disc, from h + h'' = R: ∫hR dφ - [h h'].
fn twice_area((c, r): Disc, from: f64, to: f64) -> f64 {
    let at = |angle: f64| {
        let (s, cos) = libm::sincos(angle);
        (c[0] * cos + c[1] * s, c[1] * cos - c[0] * s)
    };
    let ((along, across), (along_end, across_end)) = (at(from), at(to));
    // The antiderivative of c·u is -c·u'.
    let swept = r * (across - across_end) + r * r * (to - from);
    swept - (along_end + r) * across_end + (along + r) * across
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn simple_hulls() {
        let close = |discs: &[Disc], exact: f64| {
            let found = area(discs);
            assert!((found - exact).abs() < 1e-14 * exact, "{found} {exact}");
        };
        assert_eq!(area(&[]), 0.0);
        close(&[([3.0, 4.0], 2.0)], 4.0 * PI);
        close(&[([3.0, 4.0], 2.0), ([3.5, 4.0], 1.0)], 4.0 * PI);
        // A stadium, a rounded square with a disc in its middle and one on its side.
        close(&[([0.0, 0.0], 1.0), ([3.0, 4.0], 1.0)], PI + 10.0);
        let square = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 2.0],
            [0.0, 2.0],
            [1.0, 1.0],
            [1.0, 0.0],
        ];
        close(&square.map(|at| (at, 0.5)), 4.0 + 4.0 + PI / 4.0);
        // Radii 2 and 1, 2 apart: half angle 60 degrees, two tangents of length √3 with trapezia of
        // area 3√3/2, arcs of 240 and 120 degrees.
        let arcs = 4.0 * PI * 2.0 / 3.0 + PI / 3.0;
        close(
            &[([0.0, 0.0], 2.0), ([0.0, 2.0], 1.0)],
            arcs + 3.0 * 3f64.sqrt(),
        );
    }

    proptest! {
        // Centres on a convex curve: the hull is their polygon, offset by the radius. And discs
        // inside or duplicates change nothing.
        #[test]
        fn equal_radii_offset_the_polygon(n in 3_usize..40, r in 0.01..2.0, turn in 0.0..6.0) {
            let at = |k: usize| {
                let (s, c) = libm::sincos(turn + TAU * k as f64 / n as f64);
                [3.0 * c + 7.0, 2.0 * s - 4.0]
            };
            let corners: Vec<[f64; 2]> = (0..n).map(at).collect();
            let (mut polygon, mut round) = (0.0, 0.0);
            for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                polygon += 0.5 * (a[0] * b[1] - a[1] * b[0]);
                let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
                round += (dx * dx + dy * dy).sqrt();
            }
            let exact = polygon + round * r + PI * r * r;
            let mut discs: Vec<Disc> = corners.iter().map(|&at| (at, r)).collect();
            let found = area(&discs);
            prop_assert!((found - exact).abs() < 1e-13 * exact, "{found} {exact}");
            discs.extend(discs.clone());
            discs.push(([7.1, -3.9], 0.5 * r));
            prop_assert!((area(&discs) - exact).abs() < 1e-13 * exact);
        }

        // For any radii against the support function itself, summed over many directions: the
        // trapezium rule on a periodic function with kinks in h', step squared times jumps.
        #[test]
        fn any_radii_follow_the_support_function(
            discs in proptest::collection::vec(((-3.0..3.0, -3.0..3.0), 0.1..1.5), 1..12),
        ) {
            let discs: Vec<Disc> = discs.iter().map(|&((x, y), r)| ([x, y], r)).collect();
            let n = 20_000;
            let mut twice = 0.0;
            for k in 0..n {
                let (s, c) = libm::sincos(TAU * (f64::from(k) + 0.5) / f64::from(n));
                let reach = |(x, r): &Disc| x[0] * c + x[1] * s + r;
                let most = discs.iter().max_by(|a, b| reach(a).total_cmp(&reach(b))).unwrap();
                let slope = most.0[1] * c - most.0[0] * s;
                twice += (reach(most) * reach(most) - slope * slope) * TAU / f64::from(n);
            }
            // h' jumps by at most 2·3√2 at up to 24 places, each half a step off: 3e-4·24·36/2.
            prop_assert!((area(&discs) - 0.5 * twice).abs() < 0.07, "{} {}", area(&discs), 0.5 * twice);
        }
    }
}
