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
        (elastic + self.0[0] * touch.approach).positive()
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

/// A dashpot along the normal that follows the stiffness of the spring beside it.
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
    fn rubs(&self, _: &Touch<V>) -> bool {
        false
    }

    #[inline(always)]
    fn tangential(&self, _: V, _: &Touch<V>) -> V {
        V::all(0.0)
    }
}
