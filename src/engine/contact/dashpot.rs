//! Dashpots at contacts.
//!
//! Cundall & Strack 1979, (26) to (28): forces from the velocities of the last half step, the
//! tangential one off while the contact slides.

use super::numbers::{Numbers, Reading, Writing, Written, numbers};
use super::parts::{Dashpots, Viscosity};
use super::plain::{PlainConstant, PlainFollowing};
use super::quantities::{Basis, BasisOwned, Touch};
use crate::engine::lanes::Lanes;

/// No dashpot.
#[derive(Debug, Clone, Copy)]
pub struct Undamped;

numbers!(Undamped);

impl<V: Lanes> Dashpots<V> for Undamped {
    #[inline(always)]
    fn normal(&self, elastic: V, _: V, _: &Touch<V>) -> V {
        // A spring that was summed up from increments may have gone below zero.
        elastic.positive()
    }

    #[inline(always)]
    fn bonded(&self, elastic: V, _: V, _: &Touch<V>) -> V {
        elastic
    }
}

impl Viscosity for Undamped {
    type On<V: Lanes> = Self;
    type Plain<V: Lanes> = Self;

    fn all_plain(_: &[Option<f64>]) -> bool {
        true
    }

    fn prepare(_: &Basis<'_>) -> Self {
        Self
    }

    fn viscosity(&self, _: [f64; 2], _: f64) -> [f64; 2] {
        [0.0; 2]
    }
}

/// What a dashpot does to the normal force, whatever its viscosity.
#[derive(Debug, Clone, Copy)]
struct Rule<V = f64> {
    /// Overlap above which the contact is damped critically [m].
    above: V,
    /// The least the total normal force may be [N].
    floor: V,
    /// 1/(2 M*) for the centred form, 0 for velocities of the half step before [1/kg].
    centre: V,
}

numbers!(Rule {
    above: V,
    floor: V,
    centre: V
});

impl Rule {
    /// Neither critical anywhere nor pulling nor centred.
    const PLAIN: [Option<f64>; 3] = [Some(f64::INFINITY), Some(0.0), Some(0.0)];

    fn of(basis: &Basis<'_>) -> Self {
        let pair = basis.pair;
        Self {
            above: basis.critical_above,
            floor: if pair.pull { f64::NEG_INFINITY } else { 0.0 },
            centre: if pair.centred { 0.5 / basis.m_eff } else { 0.0 },
        }
    }
}

impl<V: Lanes> Rule<V> {
    /// Where a contact is damped critically.
    #[inline(always)]
    fn is_critical(&self, touch: &Touch<V>) -> V::Mask {
        touch.overlap.above(self.above) & touch.touching
    }

    /// Spring and dashpot together [N]. Centred: the velocity at the boundary itself, as far as the
    /// force of this contact makes it, v - F dt/(2 M*), solved for F.
    #[inline(always)]
    fn normal(&self, elastic: V, c: V, touch: &Touch<V>) -> V {
        let sum = self.sum(elastic, c, touch);
        V::pick(sum.above(self.floor), sum, self.floor)
    }

    /// The same, however much it pulls.
    #[inline(always)]
    fn sum(&self, elastic: V, c: V, touch: &Touch<V>) -> V {
        let sum = elastic + c * touch.approach;
        if V::any(self.centre.above(V::all(0.0))) {
            sum / (V::all(1.0) + c * self.centre * touch.dt)
        } else {
            sum
        }
    }
}

/// Whether any of these numbers is not nought.
#[inline(always)]
pub(super) fn any<V: Lanes>(numbers: V) -> bool {
    V::any(!numbers.equals(V::all(0.0)))
}

/// Dashpots of constant viscosity, beside constant springs.
#[derive(Debug, Clone, Copy)]
pub struct Constant<V = f64> {
    c: [V; 2],
    critical: [V; 2],
    rule: Rule<V>,
}

numbers!(Constant { c: [V; 2], critical: [V; 2], rule: Rule<V> });

impl<V: Lanes> Constant<V> {
    #[inline(always)]
    fn at(&self, part: usize, touch: &Touch<V>) -> V {
        V::pick(
            self.rule.is_critical(touch),
            self.critical[part],
            self.c[part],
        )
    }
}

impl<V: Lanes> Dashpots<V> for Constant<V> {
    #[inline(always)]
    fn normal(&self, elastic: V, _: V, touch: &Touch<V>) -> V {
        self.rule.normal(elastic, self.at(0, touch), touch)
    }

    #[inline(always)]
    fn bonded(&self, elastic: V, _: V, touch: &Touch<V>) -> V {
        self.rule.sum(elastic, self.at(0, touch), touch)
    }

    #[inline(always)]
    fn rubs(&self, touch: &Touch<V>) -> bool {
        any(self.at(1, touch))
    }

    #[inline(always)]
    fn tangential(&self, _: V, touch: &Touch<V>) -> V {
        self.at(1, touch) * touch.slide
    }
}

impl Viscosity for Constant {
    type On<V: Lanes> = Constant<V>;
    type Plain<V: Lanes> = PlainConstant<V>;

    fn all_plain(common: &[Option<f64>]) -> bool {
        matches!(common, [_, _, _, _, rule @ ..] if rule == Rule::PLAIN)
    }

    fn prepare(basis: &Basis<'_>) -> Self {
        let Basis { pair, m_eff, .. } = basis;
        let (k_n, k_s) = (pair.normal_stiffness, pair.shear_stiffness);
        let critical = |b: f64, k: f64| 2.0 * b * (m_eff * k).sqrt();
        // One of the two is zero, and adding zero changes no bit.
        let c = |part: usize, k: f64| critical(pair.fraction[part], k) + pair.beta[part] * k;
        let rule = Rule::of(basis);
        Self {
            c: [c(0, k_n), c(1, k_s)],
            critical: if rule.above.is_infinite() {
                [0.0; 2]
            } else {
                [critical(1.0, k_n), critical(1.0, k_s)]
            },
            rule,
        }
    }

    fn viscosity(&self, _: [f64; 2], overlap: f64) -> [f64; 2] {
        if overlap > self.rule.above {
            self.critical
        } else {
            self.c
        }
    }
}

/// Dashpots that follow the stiffness of the springs beside them: c = 2 b √(M* k), Randall 1989,
/// (4.13), or c = β k.
#[derive(Debug, Clone, Copy)]
pub struct Following<V = f64> {
    /// 2 b √M* [kg^½].
    gauge: [V; 2],
    /// 2 √M* [kg^½].
    critical: V,
    /// c/k [s].
    beta: [V; 2],
    rule: Rule<V>,
}

numbers!(Following { gauge: [V; 2], critical: V, beta: [V; 2], rule: Rule<V> });

impl<V: Lanes> Following<V> {
    /// Whether there is a dashpot in any lane.
    #[inline(always)]
    fn acts(&self, part: usize, touch: &Touch<V>) -> bool {
        any(self.gauge[part]) || any(self.beta[part]) || V::any(self.rule.is_critical(touch))
    }

    #[inline(always)]
    fn at(&self, part: usize, k: V, touch: &Touch<V>) -> V {
        let root = k.sqrt();
        V::pick(
            self.rule.is_critical(touch),
            self.critical * root,
            self.gauge[part] * root + self.beta[part] * k,
        )
    }
}

impl<V: Lanes> Dashpots<V> for Following<V> {
    #[inline(always)]
    fn normal(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V {
        if self.acts(0, touch) {
            let c = self.at(0, stiffness, touch);
            self.rule.normal(elastic, c, touch)
        } else {
            V::pick(elastic.above(self.rule.floor), elastic, self.rule.floor)
        }
    }

    #[inline(always)]
    fn bonded(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V {
        let c = self.at(0, stiffness, touch);
        self.rule.sum(elastic, c, touch)
    }

    #[inline(always)]
    fn rubs(&self, touch: &Touch<V>) -> bool {
        self.acts(1, touch)
    }

    #[inline(always)]
    fn tangential(&self, stiffness: V, touch: &Touch<V>) -> V {
        self.at(1, stiffness, touch) * touch.slide
    }
}

impl Viscosity for Following {
    type On<V: Lanes> = Following<V>;
    type Plain<V: Lanes> = PlainFollowing<V>;

    fn all_plain(common: &[Option<f64>]) -> bool {
        let [_, tangential, _, beta_n, beta_s, rule @ ..] = common else {
            return false;
        };
        [tangential, beta_n, beta_s] == [&Some(0.0); 3] && rule == Rule::PLAIN
    }

    fn prepare(basis: &Basis<'_>) -> Self {
        let pair = basis.pair;
        let critical = 2.0 * basis.m_eff.sqrt();
        let rule = Rule::of(basis);
        Self {
            gauge: pair.fraction.map(|b| b * critical),
            critical: if rule.above.is_infinite() {
                0.0
            } else {
                critical
            },
            beta: pair.beta,
            rule,
        }
    }

    fn viscosity(&self, k: [f64; 2], overlap: f64) -> [f64; 2] {
        [0, 1].map(|part| {
            if overlap > self.rule.above {
                self.critical * k[part].sqrt()
            } else {
                self.gauge[part] * k[part].sqrt() + self.beta[part] * k[part]
            }
        })
    }
}

/// Normal and tangential viscosity [N s/m] of a contact that is made of this, beside springs of this
/// stiffness [N/m], at an overlap [m].
pub fn viscosity(basis: &BasisOwned, k: [f64; 2], overlap: f64) -> [f64; 2] {
    let dashpot = <Following as Viscosity>::prepare(&basis.lend(false));
    Viscosity::viscosity(&dashpot, k, overlap)
}

/// The fraction b of critical that gives a coefficient of restitution beside a Hertz spring, with
/// c = 2 b √(M* 2 E* a).
///
/// With y ∝ α^{5/4} and time stretched by α^{1/4} the damped Hertz impact is the damped linear one
/// (Antypov & Elliott 2011), of fraction √(6/5) b and ending at the same instant, with or without
/// pull: the restitution depends on neither size nor speed.
pub fn hertz_fraction_for_restitution(e: f64, pull: bool) -> f64 {
    fraction_for_restitution(e, pull) / 1.2f64.sqrt()
}

/// The reverse of [`hertz_fraction_for_restitution`].
pub fn hertz_restitution_for_fraction(b: f64, pull: bool) -> f64 {
    restitution_for_fraction(1.2f64.sqrt() * b, pull)
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

    /// Values of numerical integration to 1e-7 (data/reference/hertz_damping_restitution.csv).
    #[test]
    fn hertz_restitution_has_a_closed_form() {
        for (b, pulled, clamped) in [
            (0.01, 0.966_169_023, 0.966_400_950),
            (0.1, 0.707_351_285, 0.724_673_546),
        ] {
            assert!((hertz_restitution_for_fraction(b, true) - pulled).abs() < 1e-7);
            assert!((hertz_restitution_for_fraction(b, false) - clamped).abs() < 1e-7);
        }
        let b = hertz_fraction_for_restitution(0.5, false);
        assert!((hertz_restitution_for_fraction(b, false) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn the_clamp_raises_restitution() {
        assert!(restitution_for_fraction(0.3, false) > restitution_for_fraction(0.3, true));
        // Critically damped: exp(-2), Schwager & Pöschel 2007.
        assert!((restitution_for_fraction(1.0, false) - libm::exp(-2.0)).abs() < 1e-15);
        assert!((restitution_for_fraction(1.0 - 1e-9, false) - libm::exp(-2.0)).abs() < 1e-4);
    }
}
