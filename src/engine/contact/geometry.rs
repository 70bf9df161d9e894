//! Where the contacts of a block stand, worked out before their laws.

use super::quantities::Touch;
use crate::engine::lanes::Lanes;

/// Geometry of a block.
#[derive(Clone, Copy)]
pub(super) struct Geometry<V: Lanes> {
    /// Unit vector from the first body to the second.
    pub(super) e: [V; 2],
    pub(super) touching: V::Mask,
    /// As in [`Touch`].
    pub(super) overlap: V,
    pub(super) approach: V,
    pub(super) slide: V,
    pub(super) roll: V,
    /// D/(R1 + R2), the ratio by which lever arms are shorter than radii.
    pub(super) arm: V,
}

impl<V: Lanes> Geometry<V> {
    #[inline(always)]
    pub(super) fn nowhere() -> Self {
        let zero = V::all(0.0);
        Self {
            e: [zero; 2],
            touching: V::mask(0),
            overlap: zero,
            approach: zero,
            slide: zero,
            roll: zero,
            arm: zero,
        }
    }

    /// What the law is told.
    #[inline(always)]
    pub(super) fn touch(&self, dt: f64) -> Touch<V> {
        Touch {
            touching: self.touching,
            overlap: self.overlap,
            approach: self.approach,
            slide: self.slide,
            roll: self.roll,
            dt: V::all(dt),
        }
    }
}

/// What one contact of a block is told.
#[inline(always)]
pub(super) fn lane_of<V: Lanes>(touch: &Touch<V>, lane: usize) -> Touch {
    Touch {
        touching: V::bits(touch.touching) >> lane & 1 == 1,
        overlap: touch.overlap.numbers()[lane],
        approach: touch.approach.numbers()[lane],
        slide: touch.slide.numbers()[lane],
        roll: touch.roll.numbers()[lane],
        dt: touch.dt.numbers()[lane],
    }
}
