//! Numbers of a contact that are kept as columns: parameters of its law, and what it remembers.
#![allow(
    unsafe_code,
    reason = "columns by pointer, one addition per column; each use says what it relies on"
)]

use crate::engine::lanes::Lanes;

/// A value that is made of nothing but numbers; `V` holds those of several contacts.
pub trait Numbers<V: Lanes>: Copy {
    /// How many.
    const COUNT: usize;
    /// The next numbers of some contacts.
    fn take(from: &mut Reading) -> Self;
}

/// One that can be written back.
pub trait Written<V: Lanes>: Numbers<V> {
    /// Writes them; lanes that the mask leaves out get noughts.
    fn give(self, mask: V::Mask, to: &mut Writing);
}

/// A column: where it begins, and whether there is a number for each contact (1) or one for all (0).
#[derive(Debug, Clone, Copy)]
pub struct Column {
    start: *mut f64,
    stride: usize,
}

impl Column {
    /// No column.
    pub const NONE: Self = Self {
        start: std::ptr::null_mut(),
        stride: 0,
    };

    /// With a number for each contact.
    pub fn each(numbers: &mut [f64]) -> Self {
        Self {
            start: numbers.as_mut_ptr(),
            stride: 1,
        }
    }

    /// To be read only; with the same number for all contacts unless `each`.
    pub fn shared(numbers: &[f64], each: bool) -> Self {
        Self {
            start: numbers.as_ptr().cast_mut(),
            stride: usize::from(each),
        }
    }
}

/// Goes through the columns of a contact, reading.
#[derive(Debug, Clone, Copy)]
pub struct Reading {
    columns: *const Column,
    contact: usize,
}

impl Reading {
    /// At the contact (or the first of several).
    ///
    /// # Safety
    /// Each of the columns must hold the contacts that are read, and outlive the reading.
    #[inline(always)]
    pub unsafe fn at(columns: *const Column, contact: usize) -> Self {
        Self { columns, contact }
    }

    /// The next column.
    #[inline(always)]
    pub fn column<V: Lanes>(&mut self) -> V {
        // SAFETY: whoever made the reading promised columns, and numbers in them.
        unsafe {
            let column = *self.columns;
            self.columns = self.columns.add(1);
            V::read(column.start.add(column.stride * self.contact))
        }
    }

    /// Leaves columns out.
    #[inline(always)]
    pub fn skip(&mut self, columns: usize) {
        // SAFETY: as above; one past the last is allowed.
        self.columns = unsafe { self.columns.add(columns) };
    }

    /// The same columns at a contact further on.
    #[inline(always)]
    #[must_use]
    pub fn further(self, contacts: usize) -> Self {
        Self {
            contact: self.contact + contacts,
            ..self
        }
    }
}

/// Goes through the columns of a contact, writing.
#[derive(Debug)]
pub struct Writing(Reading);

impl Writing {
    /// At the contact (or the first of several).
    ///
    /// # Safety
    /// Each of the columns must hold the contacts that are written, with a number for each, and
    /// nobody else may use them meanwhile.
    #[inline(always)]
    pub unsafe fn at(columns: *const Column, contact: usize) -> Self {
        // SAFETY: the caller's.
        Self(unsafe { Reading::at(columns, contact) })
    }

    /// The next column.
    #[inline(always)]
    pub fn column<V: Lanes>(&mut self, numbers: V) {
        // SAFETY: whoever made the writing promised columns, and room in them.
        unsafe {
            let column = *self.0.columns;
            self.0.columns = self.0.columns.add(1);
            numbers.write(column.start.add(self.0.contact));
        }
    }
}

impl<V: Lanes> Numbers<V> for V {
    const COUNT: usize = 1;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        from.column()
    }
}

impl<V: Lanes> Written<V> for V {
    #[inline(always)]
    fn give(self, mask: V::Mask, to: &mut Writing) {
        to.column(V::pick(mask, self, V::all(0.0)));
    }
}

impl<V: Lanes> Numbers<V> for [V; 2] {
    const COUNT: usize = 2;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let first = from.column();
        [first, from.column()]
    }
}

impl<V: Lanes> Written<V> for [V; 2] {
    #[inline(always)]
    fn give(self, mask: V::Mask, to: &mut Writing) {
        self[0].give(mask, to);
        self[1].give(mask, to);
    }
}

impl<V: Lanes> Numbers<V> for [V; 3] {
    const COUNT: usize = 3;

    #[inline(always)]
    fn take(from: &mut Reading) -> Self {
        let first = from.column();
        let second = from.column();
        [first, second, from.column()]
    }
}

impl<V: Lanes> Written<V> for [V; 3] {
    #[inline(always)]
    fn give(self, mask: V::Mask, to: &mut Writing) {
        self[0].give(mask, to);
        self[1].give(mask, to);
        self[2].give(mask, to);
    }
}

impl<V: Lanes> Numbers<V> for () {
    const COUNT: usize = 0;

    #[inline(always)]
    fn take(_: &mut Reading) -> Self {}
}

impl<V: Lanes> Written<V> for () {
    #[inline(always)]
    fn give(self, _: V::Mask, _: &mut Writing) {}
}

/// Says of a struct whose fields are numbers, or that has none, that it is.
macro_rules! numbers {
    ($name:ident) => {
        impl<V: Lanes> Numbers<V> for $name {
            const COUNT: usize = 0;

            #[inline(always)]
            fn take(_: &mut Reading) -> Self {
                Self
            }
        }

        impl<V: Lanes> Written<V> for $name {
            #[inline(always)]
            fn give(self, _: V::Mask, _: &mut Writing) {}
        }
    };
    ($name:ident $(<const $constant:ident>)? { $($field:ident: $kind:ty),* $(,)? }) => {
        impl<V: Lanes $(, const $constant: bool)?> Numbers<V> for $name<V $(, $constant)?> {
            const COUNT: usize = 0 $(+ <$kind as Numbers<V>>::COUNT)*;

            #[inline(always)]
            fn take(_from: &mut Reading) -> Self {
                $(let $field = <$kind as Numbers<V>>::take(_from);)*
                Self { $($field),* }
            }
        }

        impl<V: Lanes $(, const $constant: bool)?> Written<V> for $name<V $(, $constant)?> {
            #[inline(always)]
            fn give(self, _mask: V::Mask, _to: &mut Writing) {
                $(self.$field.give(_mask, _to);)*
            }
        }
    };
}
pub(super) use numbers;
