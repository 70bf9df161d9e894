//! Dashpots at contacts.
//!
//! Cundall & Strack 1979, (26) to (28): forces from the velocities of the last half step, the
//! tangential one off while the contact slides.

use super::{Basis, Viscosity};
use crate::engine::setup::Dashpot;

/// No dashpot.
#[derive(Debug, Clone, Copy)]
pub struct Undamped;

impl Viscosity for Undamped {
    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    #[inline(always)]
    fn normal(&self, _: f64) -> f64 {
        0.0
    }

    #[inline(always)]
    fn tangential(&self, _: f64) -> f64 {
        0.0
    }

    #[inline(always)]
    fn floor(&self) -> f64 {
        0.0
    }

    fn viscosity(&self) -> [f64; 2] {
        [0.0; 2]
    }
}

/// Constant viscosities.
#[derive(Debug, Clone, Copy)]
pub struct Viscous {
    c_n: f64,
    c_s: f64,
    floor: f64,
}

impl Viscosity for Viscous {
    fn prepare(basis: &Basis<'_>) -> Self {
        let Basis { pair, m_eff } = basis;
        let (k_n, k_s) = (pair.normal_stiffness, pair.shear_stiffness);
        let critical = |b: f64, k: f64| 2.0 * b * (m_eff * k).sqrt();
        let (c_n, fraction) = match pair.dashpot {
            Dashpot::None => (0.0, 0.0),
            Dashpot::Fraction(b) => (critical(b, k_n), b),
            Dashpot::Restitution(e) => {
                let b = fraction_for_restitution(e, pair.pull);
                (critical(b, k_n), b)
            }
            Dashpot::Beta(beta) => (beta * k_n, 0.0),
        };
        let c_s = match (pair.tangential, pair.dashpot) {
            (Some(b), _) => critical(b, k_s),
            (None, Dashpot::Beta(beta)) => beta * k_s,
            (None, _) => critical(fraction, k_s),
        };
        Self {
            c_n,
            c_s,
            floor: if pair.pull { f64::NEG_INFINITY } else { 0.0 },
        }
    }

    #[inline(always)]
    fn normal(&self, approach: f64) -> f64 {
        self.c_n * approach
    }

    #[inline(always)]
    fn tangential(&self, slide: f64) -> f64 {
        self.c_s * slide
    }

    #[inline(always)]
    fn floor(&self) -> f64 {
        self.floor
    }

    fn viscosity(&self) -> [f64; 2] {
        [self.c_n, self.c_s]
    }
}

/// Restitution of a linear spring and dashpot with fraction b of critical.
///
/// With pull the contact ends at zero overlap, e = exp(-π b/√(1-b²)). Without, it ends where the
/// force would turn tensile: e = exp(-(π - 2ψ) tan ψ) with sin ψ = b, beyond b = 1
/// e = exp(-2η coth η) with cosh η = b.
pub fn restitution_for_fraction(b: f64, pull: bool) -> f64 {
    use std::f64::consts::PI;
    if b <= 0.0 {
        return 1.0;
    }
    if pull {
        return if b < 1.0 {
            libm::exp(-PI * b / (1.0 - b * b).sqrt())
        } else {
            0.0
        };
    }
    let exponent = if b < 1.0 {
        (PI - 2.0 * libm::asin(b)) * b / (1.0 - b * b).sqrt()
    } else if b == 1.0 {
        2.0
    } else {
        let eta = libm::acosh(b);
        2.0 * eta / libm::tanh(eta)
    };
    libm::exp(-exponent)
}

/// Inverse of [`restitution_for_fraction`] by bisection to the last bit; e = 0 has no finite answer
/// and gives the fraction for 1e-12.
pub fn fraction_for_restitution(e: f64, pull: bool) -> f64 {
    let e = e.clamp(1e-12, 1.0);
    if e == 1.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, if pull { 1.0 } else { 1e9 });
    while let middle = 0.5 * (low + high)
        && low < middle
        && middle < high
    {
        if restitution_for_fraction(middle, pull) > e {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn restitution_inverts() {
        for pull in [false, true] {
            for e in [0.05, 0.1, 0.2, 0.5, 0.7, 0.9, 0.99, 1.0] {
                let b = fraction_for_restitution(e, pull);
                // exp amplifies the last bit of b by at most the exponent.
                assert!(
                    (restitution_for_fraction(b, pull) - e).abs() < 1e-13,
                    "{e} {pull}"
                );
            }
        }
    }

    #[test]
    fn the_clamp_raises_restitution() {
        assert!(restitution_for_fraction(0.3, false) > restitution_for_fraction(0.3, true));
        // Critically damped: exp(-2), Schwager & Pöschel 2007.
        assert!((restitution_for_fraction(1.0, false) - libm::exp(-2.0)).abs() < 1e-15);
        assert!((restitution_for_fraction(1.0 - 1e-9, false) - libm::exp(-2.0)).abs() < 1e-4);
    }
}
