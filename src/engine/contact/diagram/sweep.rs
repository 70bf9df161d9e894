//! Energy lost in the annuli that a slip front sweeps over, in closed form.
//!
//! Everything is a polynomial in roots of overlaps, so nothing is divided by the width of a segment.

/// Mean of η^1.5 over the overlaps between p² and q².
#[inline]
pub(super) fn mean_load(p: f64, q: f64) -> f64 {
    quintic(p, q) / (p + q)
}

/// (2/5) (q^5 - p^5)/(q - p).
#[inline]
fn quintic(p: f64, q: f64) -> f64 {
    let (p2, q2, pq) = (p * p, q * q, p * q);
    0.4 * (p2 * p2 + q2 * q2 + pq * (p2 + pq + q2))
}

/// Mean over the forces of a segment of how deep inside the edge it lies, α - c [m], with the ends as
/// in [`mean_gap`] and α at its mean.
#[inline]
pub(super) fn mean_depth([x, at_x]: [f64; 2], [y, at_y]: [f64; 2]) -> f64 {
    let (x2, y2, xy) = (x * x, y * y, x * y);
    // ∫ c dN/(N' - N) = (3/5) (y^5 - x^5)/(y^3 - x^3).
    let mean = 0.6 * (x2 * x2 + y2 * y2 + xy * (x2 + xy + y2)) / (x2 + xy + y2);
    0.5 * (at_x * at_x + at_y * at_y) - mean
}

/// Mean over a segment of g(c; α) = N(α) - N(c) - N'(c) (α - c) without its factor (4/3) E* √R*.
///
/// The inner and the outer end of the segment are given by roots: x² is the overlap c of the end, and
/// `at`² the overlap α of the contact when the front is there. α is linear in c.
#[inline]
pub(super) fn mean_gap([x, at_x]: [f64; 2], [y, at_y]: [f64; 2]) -> f64 {
    let (x2, y2, per_sum) = (x * x, y * y, 1.0 / (x + y));
    let (near, far) = (at_x * at_x - x2, at_y * at_y - y2);
    // 3/2 of the means of √c and of √c times the way done from the inner end.
    let root = x2 + x * y + y2;
    let way = 0.1 * per_sum * ((6.0 * y + 12.0 * x) * y2 + (8.0 * y + 4.0 * x) * x2);
    let slope = near * root + (far - near) * way;
    let gap = mean_load(at_x, at_y) - (quintic(x, y) + slope) * per_sum;
    // Rounding may leave a trace below zero where the front has hardly left the edge.
    if gap > 0.0 { gap } else { 0.0 }
}
