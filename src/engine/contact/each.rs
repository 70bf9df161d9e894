//! A tangential part whose steps branch too much for lanes: contact by contact within the block.
#![allow(
    unsafe_code,
    reason = "memories of a block by pointer, as the loop hands them over"
)]

use std::marker::PhantomData;

use super::numbers::{Numbers, Reading};
use super::parts::{Tangential, TangentialForce};
use super::quantities::{Load, Shear, Touch};
use crate::engine::lanes::Lanes;

/// What such a part does for one contact.
pub trait Alone: Tangential {
    /// Advances the memory by one step and answers.
    fn force(&self, touch: &Touch, load: &Load, memory: &mut Self::Memo) -> Shear;
}

/// Where the parameters of a block stand.
#[derive(Debug, Clone, Copy)]
pub struct Each<T> {
    from: Reading,
    part: PhantomData<T>,
}

impl<T: Alone, V: Lanes> Numbers<V> for Each<T> {
    const COUNT: usize = T::COUNT;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let here = *from;
        from.skip(T::COUNT);
        Self {
            from: here,
            part: PhantomData,
        }
    }
}

impl<T: Alone, V: Lanes> TangentialForce<V> for Each<T> {
    type Memory = *mut T::Memo;
    const ACTIVE: bool = true;

    #[inline(always)]
    fn force(&self, touch: &Touch<V>, load: &Load<V>, memory: &mut *mut T::Memo) -> Shear<V> {
        let touching = V::bits(touch.touching);
        let [overlap, slide, dt] = [
            touch.overlap.numbers(),
            touch.slide.numbers(),
            touch.dt.numbers(),
        ];
        let total = load.total.numbers();
        let (mut force, mut gross, mut micro, mut limit) = ([0.0; 8], [0.0; 8], [0.0; 8], [0.0; 8]);
        let mut sliding = 0;
        for lane in 0..V::COUNT {
            if touching >> lane & 1 == 0 {
                continue;
            }
            let part = T::take(&mut self.from.further(lane));
            let touch = Touch {
                touching: true,
                overlap: overlap[lane],
                approach: 0.0,
                slide: slide[lane],
                roll: 0.0,
                dt: dt[lane],
            };
            let load = Load {
                elastic: 0.0,
                total: total[lane],
                stiffness: 0.0,
            };
            // SAFETY: the loop hands over where the memories of the block begin, and nobody else
            // works on them.
            let memory = unsafe { &mut *memory.add(lane) };
            let shear = part.force(&touch, &load, memory);
            force[lane] = shear.force;
            [gross[lane], micro[lane]] = shear.loss;
            limit[lane] = shear.limit;
            sliding |= u32::from(shear.sliding) << lane;
        }
        Shear {
            force: V::of(&force),
            loss: [V::of(&gross), V::of(&micro)],
            sliding: V::mask(sliding),
            limit: V::of(&limit),
        }
    }

    fn steepest(&self, overlap: V) -> V {
        let mut stiffness = overlap.numbers();
        for (lane, x) in stiffness.iter_mut().enumerate().take(V::COUNT) {
            *x = T::take(&mut self.from.further(lane)).stiffness(*x);
        }
        V::of(&stiffness)
    }
}
