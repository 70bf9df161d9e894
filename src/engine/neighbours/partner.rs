//! A second body and the image of it that is meant, as one number: sorting compares nothing else.

use crate::engine::boundary::cell::Image;

/// They order as bodies do, and images of one body as pairs of numbers.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Partner(u64);

/// What makes signed numbers order as unsigned ones.
const SIGN: u16 = 1 << 15;

impl Partner {
    /// Above all that there are.
    pub(super) const MOST: Self = Self(u64::MAX);

    #[inline(always)]
    pub(super) fn new(body: u32, image: Image) -> Self {
        let [n, m] = image.map(|n| u64::from(n as u16 ^ SIGN));
        Self(u64::from(body) << 32 | n << 16 | m)
    }

    /// Body and image.
    #[inline(always)]
    pub(super) fn meant(self) -> (u32, Image) {
        let image = [self.0 >> 16, self.0].map(|n| (n as u16 ^ SIGN) as i16);
        ((self.0 >> 32) as u32, image)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn numbers_order_as_what_they_mean(
            a in (any::<u32>(), any::<[i16; 2]>()),
            b in (any::<u32>(), any::<[i16; 2]>()),
            same in any::<bool>(),
        ) {
            let b = (if same { a.0 } else { b.0 }, b.1);
            let [one, other] = [a, b].map(|(body, image)| Partner::new(body, image));
            prop_assert_eq!(one.meant(), a);
            prop_assert_eq!(one.cmp(&other), a.cmp(&b));
        }
    }
}
