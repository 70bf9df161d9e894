//! Principal values of a second-order tensor in the plane, from its symmetric part.

use nalgebra::Matrix2;

/// Principal values and the direction of the larger one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Principal {
    /// Larger principal value [unit of the tensor].
    pub major: f64,
    /// Smaller principal value [unit of the tensor].
    pub minor: f64,
    /// Direction of the larger one from direction 1, counter-clockwise, in [0, 180) [degrees]; NaN
    /// where both are equal.
    pub angle: f64,
}

impl Principal {
    /// Principal values of a tensor.
    pub fn of(tensor: &Matrix2<f64>) -> Self {
        let middle = 0.5 * (tensor[(0, 0)] + tensor[(1, 1)]);
        let half = 0.5 * deviator(tensor);
        let [difference, sum] = deviatoric(tensor);
        Self {
            major: middle + half,
            minor: middle - half,
            angle: if half > 0.0 {
                crest(sum, difference, 2)
            } else {
                f64::NAN
            },
        }
    }
}

/// The circle of Mohr says the same: its centre is the mean of the principal values, its radius half
/// their difference, and a plane turned by some angle lies twice as far round.
impl Principal {
    /// Centre of the circle of Mohr [unit of the tensor].
    pub fn centre(&self) -> f64 {
        0.5 * (self.major + self.minor)
    }

    /// Radius of the circle of Mohr [unit of the tensor].
    pub fn radius(&self) -> f64 {
        0.5 * (self.major - self.minor)
    }
}

/// What turns with twice the angle of the axes: T11 - T22 and T12 + T21.
pub(super) fn deviatoric(tensor: &Matrix2<f64>) -> [f64; 2] {
    [
        tensor[(0, 0)] - tensor[(1, 1)],
        tensor[(0, 1)] + tensor[(1, 0)],
    ]
}

/// Difference of the principal values; exact where their own difference would cancel.
pub(super) fn deviator(tensor: &Matrix2<f64>) -> f64 {
    let [d, s] = deviatoric(tensor);
    (d * d + s * s).sqrt()
}

/// Deviator of a part, projected on the principal axes of the whole. Undefined for a whole without
/// axes.
pub(super) fn projected(part: &Matrix2<f64>, whole: &Matrix2<f64>) -> f64 {
    let ([d, s], [dw, sw]) = (deviatoric(part), deviatoric(whole));
    (d * dw + s * sw) / deviator(whole)
}

/// The same line with an angle in [0, 180) [degrees].
pub fn half_turn(degrees: f64) -> f64 {
    within(degrees, 180.0)
}

/// Direction in which a wave of so many periods in a turn, cosine C cos(nθ) + sine S sin(nθ), is
/// highest: the first one, below a period [degrees].
pub(super) fn crest(sine: f64, cosine: f64, periods: u32) -> f64 {
    let periods = f64::from(periods);
    within(
        libm::atan2(sine, cosine).to_degrees() / periods,
        360.0 / periods,
    )
}

/// An angle between minus one period and one, moved into [0, period) [degrees].
pub(super) fn within(degrees: f64, period: f64) -> f64 {
    let turned = if degrees < 0.0 {
        degrees + period
    } else {
        degrees
    };
    // A tiny negative angle rounds up to the period itself.
    if turned >= period {
        turned - period
    } else {
        turned
    }
}

/// A tensor of the engine.
pub(super) fn matrix([[a, b], [c, d]]: [[f64; 2]; 2]) -> Matrix2<f64> {
    Matrix2::new(a, b, c, d)
}

/// Undefined quotients are NaN, never infinite.
pub(super) fn ratio(a: f64, b: f64) -> f64 {
    if b == 0.0 { f64::NAN } else { a / b }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn axes_lie_in_the_right_quadrant() {
        let quarter = |xx, xy, yy| Principal::of(&Matrix2::new(xx, xy, xy, yy)).angle;
        assert_eq!(quarter(2.0, 0.0, 1.0), 0.0);
        assert_eq!(quarter(1.0, 0.0, 2.0), 90.0);
        assert_eq!(quarter(1.0, 0.5, 1.0), 45.0);
        assert_eq!(quarter(1.0, -0.5, 1.0), 135.0);
        assert!(quarter(1.0, 0.0, 1.0).is_nan());
        assert_eq!(half_turn(-1e-300), 0.0);
    }

    proptest! {
        // A tensor with given principal values and angle is taken apart again; 1e-13 and 1e-11
        // degrees are some tens of roundings where the values differ by a tenth or more.
        #[test]
        fn values_and_angle_come_back(
            minor in -1.0..1.0_f64, more in 0.1..2.0_f64, angle in 1.0..179.0, spin in -1.0..1.0,
        ) {
            let (s, c) = libm::sincos(f64::to_radians(angle));
            let axes = Matrix2::new(c, -s, s, c);
            let inner: Matrix2<f64> = Matrix2::new(minor + more, spin, -spin, minor);
            let tensor = axes * inner * axes.transpose();
            let p = Principal::of(&tensor);
            prop_assert!((p.major - minor - more).abs() < 1e-13, "{p:?}");
            prop_assert!((p.minor - minor).abs() < 1e-13, "{p:?}");
            prop_assert!((p.angle - angle).abs() < 1e-11, "{p:?}");
            // The whole's own projection is its deviator, whatever its skew part.
            prop_assert!((projected(&tensor, &tensor) - more).abs() < 1e-13);
        }
    }
}
