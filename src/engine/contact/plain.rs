//! Dashpots as most scenes have them: nowhere critical, not pulling, not centred. What all contacts have
//! in common there is not read for each of them, which is an eighth of the time of the whole loop.

use super::dashpot::{Constant, Following, any};
use super::numbers::{Numbers, Reading};
use super::parts::Dashpots;
use super::quantities::Touch;
use crate::engine::lanes::Lanes;

/// Dashpots of constant viscosity.
#[derive(Debug, Clone, Copy)]
pub struct PlainConstant<V>([V; 2]);

impl<V: Lanes> Numbers<V> for PlainConstant<V> {
    const COUNT: usize = <Constant<V> as Numbers<V>>::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let c = <[V; 2]>::take(from);
        from.skip(<Self as Numbers<V>>::COUNT - 2);
        Self(c)
    }
}

impl<V: Lanes> Dashpots<V> for PlainConstant<V> {
    #[inline(always)]
    fn normal(&self, elastic: V, _: V, touch: &Touch<V>) -> V {
        self.bonded(elastic, elastic, touch).positive()
    }

    #[inline(always)]
    fn bonded(&self, elastic: V, _: V, touch: &Touch<V>) -> V {
        elastic + self.0[0] * touch.approach
    }

    #[inline(always)]
    fn rubs(&self, _: &Touch<V>) -> bool {
        any(self.0[1])
    }

    #[inline(always)]
    fn tangential(&self, _: V, touch: &Touch<V>) -> V {
        self.0[1] * touch.slide
    }
}

/// A dashpot along the normal that follows the stiffness of the spring beside it, 2 b √M* its only number:
/// without one across, and without β.
#[derive(Debug, Clone, Copy)]
pub struct PlainFollowing<V>(V);

impl<V: Lanes> Numbers<V> for PlainFollowing<V> {
    const COUNT: usize = <Following<V> as Numbers<V>>::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let gauge = from.column();
        from.skip(<Self as Numbers<V>>::COUNT - 1);
        Self(gauge)
    }
}

impl<V: Lanes> Dashpots<V> for PlainFollowing<V> {
    #[inline(always)]
    fn normal(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V {
        if any(self.0) {
            (elastic + self.0 * stiffness.sqrt() * touch.approach).positive()
        } else {
            elastic.positive()
        }
    }

    #[inline(always)]
    fn bonded(&self, elastic: V, stiffness: V, touch: &Touch<V>) -> V {
        elastic + self.0 * stiffness.sqrt() * touch.approach
    }
}

#[cfg(test)]
mod tests {
    use super::super::columns::Parameters;
    use super::super::hertz::Hertz;
    use super::super::hertz_mindlin::HertzMindlin;
    use super::super::law::{Contact, Law};
    use super::super::linear::{LinearNormal, LinearShear};
    use super::super::quantities::Basis;
    use super::super::rolling::Unresisted;
    use super::*;
    use crate::engine::pair::Pair;
    use crate::engine::setup::Dashpot;

    type Spheres = Contact<Hertz, HertzMindlin<f64, false>, Unresisted, Following>;
    type Discs = Contact<LinearNormal, LinearShear, Unresisted, Constant>;

    const PAIR: Pair = Pair {
        normal_stiffness: 1e6,
        shear_stiffness: 1e6,
        young: 1e9,
        shear: 4e8,
        friction: 0.5,
        cohesion: 0.0,
        bond_tension: 0.0,
        bond_shear: 0.0,
        rolling_friction: 0.0,
        rolling_shape: 0.0,
        dashpot: Dashpot::None,
        fraction: [0.1, 0.0],
        beta: [0.0; 2],
        pull: false,
        centred: false,
    };

    /// Whether three contacts of different sizes, two of one pair of materials and one of another, are
    /// all plain.
    fn plain<L: Law>(pairs: &[Pair; 2], critical_above: f64) -> bool {
        let mut parameters = Parameters::<L>::new();
        for (k, pair) in [&pairs[0], &pairs[0], &pairs[1]].into_iter().enumerate() {
            let basis = Basis {
                pair,
                m_eff: 1.0 + k as f64,
                r_eff: 0.5 + k as f64,
                critical_above,
                nodes: 0,
                booked: false,
            };
            parameters.push(L::prepare(&basis), 3);
        }
        L::all_plain(&parameters.common()[..L::COUNT])
    }

    fn both(pair: Pair) -> [bool; 2] {
        let above = f64::INFINITY;
        [
            plain::<Spheres>(&[pair; 2], above),
            plain::<Discs>(&[pair; 2], above),
        ]
    }

    /// Otherwise the fast way would be taken by nobody, and no other test would tell.
    #[test]
    fn most_scenes_are_plain_and_what_needs_more_is_not() {
        assert_eq!(both(PAIR), [true; 2]);
        let undamped = Pair {
            fraction: [0.0; 2],
            ..PAIR
        };
        assert_eq!(both(undamped), [true; 2]);
        // Constant dashpots across are read in any case.
        let across = Pair {
            fraction: [0.1; 2],
            ..PAIR
        };
        assert_eq!(both(across), [false, true]);
        let beta = Pair {
            beta: [1e-5, 0.0],
            ..PAIR
        };
        assert_eq!(both(beta), [false, true]);
        assert_eq!(both(Pair { pull: true, ..PAIR }), [false; 2]);
        assert_eq!(
            both(Pair {
                centred: true,
                ..PAIR
            }),
            [false; 2]
        );
        assert!(!plain::<Spheres>(&[PAIR; 2], 0.01) && !plain::<Discs>(&[PAIR; 2], 0.01));
        let smooth = Pair {
            friction: 0.0,
            ..PAIR
        };
        assert_eq!(both(smooth), [false, true]);
        let two = [
            PAIR,
            Pair {
                friction: 0.2,
                ..PAIR
            },
        ];
        assert!(!plain::<Spheres>(&two, f64::INFINITY));
        let sticky = two.map(|pair| Pair {
            cohesion: 3.0,
            ..pair
        });
        assert!(plain::<Spheres>(&sticky, f64::INFINITY));
    }
}
