//! The linear field that fits given values at given points best: displacements or velocities of
//! particles, and the gradient that they have in common.

use nalgebra::{Matrix2, Vector2};

/// Least determinant of the spread of the points over the square of its trace: below, they lie on a
/// line for all that can be known.
const SPREAD: f64 = 1e-12;

/// u(x) = ū + G (x - x̄).
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Affine {
    /// Mean of the points [m].
    pub(super) middle: Vector2<f64>,
    /// Mean of the values.
    pub(super) mean: Vector2<f64>,
    /// G_ij = ∂u_i/∂x_j.
    pub(super) gradient: Matrix2<f64>,
}

impl Affine {
    /// Least squares over points and their values, all of the same weight; `None` for fewer than
    /// three points that span a triangle.
    pub(super) fn fit(values: &[(Vector2<f64>, Vector2<f64>)]) -> Option<Self> {
        let count = values.len() as f64;
        let sum = values
            .iter()
            .fold((Vector2::zeros(), Vector2::zeros()), |sum, (x, u)| {
                (sum.0 + x, sum.1 + u)
            });
        let (middle, mean) = (sum.0 / count, sum.1 / count);
        // Relative to the means, so that nothing is lost where the points lie far from zero.
        let (mut spread, mut along) = (Matrix2::zeros(), Matrix2::zeros());
        for (x, u) in values {
            let (x, u) = (x - middle, u - mean);
            spread += x * x.transpose();
            along += u * x.transpose();
        }
        let trace: f64 = spread.trace();
        if values.len() < 3 || spread.determinant() <= SPREAD * (trace * trace) {
            return None;
        }
        Some(Self {
            middle,
            mean,
            gradient: along * spread.try_inverse()?,
        })
    }

    /// Value of the field at a point.
    pub(super) fn at(&self, x: &Vector2<f64>) -> Vector2<f64> {
        self.mean + self.gradient * (x - self.middle)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn point(x: f64, y: f64) -> Vector2<f64> {
        Vector2::new(x, y)
    }

    #[test]
    fn points_on_a_line_have_no_gradient() {
        let u = point(1.0, 2.0);
        assert_eq!(Affine::fit(&[]), None);
        let two = [(point(0.0, 0.0), u), (point(1.0, 3.0), u)];
        assert_eq!(Affine::fit(&two), None);
        let line: Vec<_> = (0..9_i32)
            .map(|k| (point(0.1 * f64::from(k), 7.0 + 0.3 * f64::from(k)), u))
            .collect();
        assert_eq!(Affine::fit(&line), None);
        assert_eq!(Affine::fit(&[(u, u); 5]), None);
    }

    proptest! {
        // A linear field comes back. Its points span about 1, a rounding of values up to 100 moves
        // it by 1e-14.
        #[test]
        fn linear_fields_come_back(
            g in prop::array::uniform4(-1.0..1.0_f64), u in prop::array::uniform2(-9.0..9.0_f64),
            far in -50.0..50.0_f64,
        ) {
            let gradient = Matrix2::new(g[0], g[1], g[2], g[3]);
            let field = |x: Vector2<f64>| (x, Vector2::from(u) + gradient * x);
            let points = [[0.0, 0.0], [1.0, 0.1], [0.2, 1.0], [0.9, 0.8], [0.4, 0.3]];
            let values = points.map(|[x, y]| field(point(x + far, y - far)));
            let fit = Affine::fit(&values).unwrap();
            prop_assert!((fit.gradient - gradient).norm() < 1e-12, "{fit:?}");
            let (x, expected) = field(point(far + 3.0, 2.0 - far));
            prop_assert!((fit.at(&x) - expected).norm() < 1e-11, "{fit:?}");
        }

        // Of all linear fields none is nearer: every other one has a larger sum of squares.
        #[test]
        fn no_other_field_is_nearer(
            u in prop::array::uniform32(-1.0..1.0_f64), d in prop::array::uniform4(-0.1..0.1_f64),
        ) {
            let points = (0..16_u32).map(|k| point(f64::from(k % 4), f64::from(k / 4)));
            let values: Vec<_> = points
                .zip(u.chunks_exact(2).map(|u| point(u[0], u[1])))
                .collect();
            let fit = Affine::fit(&values).unwrap();
            let squares = |fit: &Affine| -> f64 {
                values.iter().map(|(x, u)| (u - fit.at(x)).norm_squared()).sum()
            };
            let other = Affine {
                gradient: fit.gradient + Matrix2::new(d[0], d[1], d[2], d[3]),
                ..fit
            };
            // The sum of squares of the points about their middle is 20 in each direction, and
            // nothing in them is common to the two: the excess is known.
            let excess = squares(&other) - squares(&fit);
            let exact = 20.0 * d.iter().map(|d| d * d).sum::<f64>();
            prop_assert!((excess - exact).abs() < 1e-12, "{excess} {exact}");
        }
    }
}
