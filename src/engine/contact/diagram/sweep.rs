//! Energy lost in the annuli that a slip front sweeps over, in closed form.
//!
//! Everything is a polynomial in roots of overlaps, so nothing is divided by the width of a segment.

/// Mean of η^1.5 over the overlaps between p² and q².
#[inline]
pub(super) fn mean_load(p: f64, q: f64) -> f64 {
    let (p2, q2) = (p * p, q * q);
    0.4 * (p2 * p2 + q2 * q2 + p * q * (p2 + p * q + q2)) / (p + q)
}

/// Mean over a segment of g(c; α) = N(α) - N(c) - N'(c) (α - c) without its factor (4/3) E* √R*.
///
/// `inner` and `outer` are the ends of the segment; `[x, y]` are roots, x² the overlap c of the end
/// and y² the overlap α of the contact when the front is there. α is linear in c.
#[inline]
pub(super) fn mean_gap([x, at_x]: [f64; 2], [y, at_y]: [f64; 2]) -> f64 {
    let (x2, y2, sum) = (x * x, y * y, x + y);
    let (near, far) = (at_x * at_x - x2, at_y * at_y - y2);
    // Means of √c and of √c times the way done from the inner end.
    let root = (2.0 / 3.0) * (x2 + x * y + y2) / sum;
    let way = ((6.0 * y + 12.0 * x) * y2 + (8.0 * y + 4.0 * x) * x2) / (15.0 * sum * sum);
    let gap = mean_load(at_x, at_y) - mean_load(x, y) - 1.5 * (near * root + (far - near) * way);
    // Rounding may leave a trace below zero where the front has hardly left the edge.
    if gap > 0.0 { gap } else { 0.0 }
}
