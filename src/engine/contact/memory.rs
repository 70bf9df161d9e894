//! What a contact remembers from cycle to cycle.
//!
//! A memory of few numbers is kept as columns and worked on in lanes; a larger one is kept whole, one
//! beside the other, and worked on contact by contact.

use serde::{Serialize, de::DeserializeOwned};

use super::numbers::{Reading, Writing};
use crate::engine::lanes::Lanes;

/// Memory of a part of a law. The reduced form (forces in newtons) is what survives a change of law.
pub trait Memory: Copy + Default + Send + Sync + Serialize + DeserializeOwned + 'static {
    /// How many columns it has.
    const COLUMNS: usize;
    /// What of it is kept whole; `()` if nothing.
    type Whole: Copy + Default + Send + Sync + 'static;
    /// What lanes work on.
    type In<V: Lanes>: Copy;
    /// Memory of a contact.
    fn take(from: &mut Reading, whole: &Self::Whole) -> Self;
    /// Writes the memory of a contact.
    fn give(self, to: &mut Writing, whole: &mut Self::Whole);
    /// What lanes work on: numbers from the columns, and where the whole ones of the lanes begin.
    fn lanes<V: Lanes>(from: &mut Reading, whole: *mut Self::Whole) -> Self::In<V>;
    /// Writes the numbers back, noughts where the mask says no.
    fn keep<V: Lanes>(lanes: Self::In<V>, mask: V::Mask, to: &mut Writing);
    /// Normal and tangential spring force [N] as far as this part holds them.
    fn reduced(&self) -> [f64; 2];
    /// Shows every number that the future depends on, for the state hash.
    fn visit(&self, see: &mut dyn FnMut(f64));
    /// Whether a bond holds the bodies.
    fn is_bonded(&self) -> bool {
        false
    }
    /// Bonds them, if the law knows bonds.
    fn bond(&mut self) {}
}

/// The first members of [`Memory`], for one that is kept as columns.
macro_rules! kept_as_columns {
    ($name:ident) => {
        const COLUMNS: usize = <$name<f64> as Numbers<f64>>::COUNT;
        type Whole = ();
        type In<V: Lanes> = $name<V>;

        #[inline(always)]
        fn take(from: &mut Reading, (): &()) -> Self {
            <Self as Numbers<f64>>::take(from)
        }

        fn give(self, to: &mut Writing, (): &mut ()) {
            Written::<f64>::give(self, true, to);
        }

        #[inline(always)]
        fn lanes<V: Lanes>(from: &mut Reading, _: *mut ()) -> $name<V> {
            <$name<V> as Numbers<V>>::take(from)
        }

        #[inline(always)]
        fn keep<V: Lanes>(lanes: $name<V>, mask: V::Mask, to: &mut Writing) {
            lanes.give(mask, to);
        }
    };
}
pub(super) use kept_as_columns;

/// The first members of [`Memory`], for one that is kept whole.
macro_rules! kept_whole {
    () => {
        const COLUMNS: usize = 0;
        type Whole = Self;
        type In<V: Lanes> = *mut Self;

        fn take(_: &mut Reading, whole: &Self) -> Self {
            *whole
        }

        fn give(self, _: &mut Writing, whole: &mut Self) {
            *whole = self;
        }

        #[inline(always)]
        fn lanes<V: Lanes>(_: &mut Reading, whole: *mut Self) -> *mut Self {
            whole
        }

        #[inline(always)]
        fn keep<V: Lanes>(_: *mut Self, _: V::Mask, _: &mut Writing) {}
    };
}
pub(super) use kept_whole;

impl Memory for () {
    const COLUMNS: usize = 0;
    type Whole = ();
    type In<V: Lanes> = ();

    #[inline(always)]
    fn take(_: &mut Reading, (): &()) -> Self {}

    fn give(self, _: &mut Writing, (): &mut ()) {}

    #[inline(always)]
    fn lanes<V: Lanes>(_: &mut Reading, _: *mut ()) {}

    #[inline(always)]
    fn keep<V: Lanes>((): (), _: V::Mask, _: &mut Writing) {}

    fn reduced(&self) -> [f64; 2] {
        [0.0; 2]
    }

    fn visit(&self, _: &mut dyn FnMut(f64)) {}
}

/// Only a tangential part keeps anything whole.
impl<N: Memory<Whole = ()>, T: Memory, R: Memory<Whole = ()>> Memory for (N, T, R) {
    const COLUMNS: usize = N::COLUMNS + T::COLUMNS + R::COLUMNS;
    type Whole = T::Whole;
    type In<V: Lanes> = (N::In<V>, T::In<V>, R::In<V>);

    #[inline(always)]
    fn take(from: &mut Reading, whole: &Self::Whole) -> Self {
        let normal = N::take(from, &());
        let tangential = T::take(from, whole);
        (normal, tangential, R::take(from, &()))
    }

    fn give(self, to: &mut Writing, whole: &mut Self::Whole) {
        self.0.give(to, &mut ());
        self.1.give(to, whole);
        self.2.give(to, &mut ());
    }

    #[inline(always)]
    fn lanes<V: Lanes>(from: &mut Reading, whole: *mut Self::Whole) -> Self::In<V> {
        let none = std::ptr::null_mut();
        let normal = N::lanes(from, none);
        let tangential = T::lanes(from, whole);
        (normal, tangential, R::lanes(from, none))
    }

    #[inline(always)]
    fn keep<V: Lanes>(lanes: Self::In<V>, mask: V::Mask, to: &mut Writing) {
        N::keep::<V>(lanes.0, mask, to);
        T::keep::<V>(lanes.1, mask, to);
        R::keep::<V>(lanes.2, mask, to);
    }

    fn reduced(&self) -> [f64; 2] {
        [self.0.reduced()[0], self.1.reduced()[1]]
    }

    fn visit(&self, see: &mut dyn FnMut(f64)) {
        self.0.visit(see);
        self.1.visit(see);
        self.2.visit(see);
    }

    fn is_bonded(&self) -> bool {
        self.1.is_bonded()
    }

    fn bond(&mut self) {
        self.1.bond();
    }
}
