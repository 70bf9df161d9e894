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
    /// Advances the memory by one step to an overlap > 0 with a tangential displacement [m].
    fn advance(&self, overlap: f64, displacement: f64, memory: &mut Self::Memo) -> Slipped;
    /// Friction coefficient [-].
    fn friction(&self) -> f64;
}

/// What a step of it answers.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slipped {
    /// Tangential force at the end of the step [N].
    pub force: f64,
    /// Energy lost by slip of the whole contact [J].
    pub gross: f64,
    /// Energy lost by slip of outer annuli while the inside sticks, and by what the law forgets [J]; of
    /// either sign.
    pub micro: f64,
    /// Whether the whole contact slid.
    pub sliding: bool,
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
        let (overlap, d) = (touch.overlap.numbers(), (touch.slide * touch.dt).numbers());
        let [mut force, mut gross, mut micro, mut friction] = [[0.0; 8]; 4];
        let mut sliding = 0;
        for lane in 0..V::COUNT {
            if touching >> lane & 1 == 0 {
                continue;
            }
            let part = T::take(&mut self.from.further(lane));
            // SAFETY: the loop hands over where the memories of the block begin, and nobody else
            // works on them.
            let memory = unsafe { &mut *memory.add(lane) };
            let slip = part.advance(overlap[lane], d[lane], memory);
            (force[lane], gross[lane], micro[lane]) = (slip.force, slip.gross, slip.micro);
            friction[lane] = part.friction();
            sliding |= u32::from(slip.sliding) << lane;
        }
        Shear {
            force: V::of(&force),
            loss: [V::of(&gross), V::of(&micro)],
            sliding: V::mask(sliding),
            limit: load.limit(V::of(&friction), V::all(0.0)),
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
