//! Columns of equal length that are read in lanes from anywhere.

use super::Lanes;

/// So many more numbers can be read than there are.
const SPARE: usize = 8;

/// N numbers each of several things.
#[derive(Debug)]
pub(in crate::engine) struct Columns<const N: usize> {
    /// Each is [`SPARE`] longer than there are things, if there are any.
    columns: [Vec<f64>; N],
    len: usize,
}

impl<const N: usize> Default for Columns<N> {
    fn default() -> Self {
        Self {
            columns: [const { Vec::new() }; N],
            len: 0,
        }
    }
}

impl<const N: usize> Columns<N> {
    /// Of so many things from now on; what their numbers are is to be [put](Self::put) there.
    pub(in crate::engine) fn resize(&mut self, len: usize) {
        self.len = len;
        for column in &mut self.columns {
            column.resize(len + SPARE, 0.0);
        }
    }

    /// Number of things.
    pub(in crate::engine) fn len(&self) -> usize {
        self.len
    }

    /// Puts the numbers of a thing.
    #[inline(always)]
    pub(in crate::engine) fn put(&mut self, at: usize, numbers: [f64; N]) {
        for (column, number) in self.columns.iter_mut().zip(numbers) {
            column[at] = number;
        }
    }

    /// The numbers of one column.
    pub(in crate::engine) fn column(&self, k: usize) -> &[f64] {
        &self.columns[k][..self.len]
    }

    /// What a thing and those behind it have, and whatever behind the last one.
    ///
    /// # Panics
    /// If there is no such thing.
    #[inline(always)]
    pub(in crate::engine) fn read<V: Lanes>(&self, at: usize) -> [V; N] {
        const { assert!(V::COUNT <= SPARE) };
        assert!(at < self.len, "nothing stands at {at} of {}", self.len);
        let mut lanes = [V::all(0.0); N];
        for (lanes, column) in lanes.iter_mut().zip(&self.columns) {
            // SAFETY: there is that thing, so each column has as many more as are read.
            *lanes = unsafe { V::read(column.as_ptr().add(at)) };
        }
        lanes
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::lanes::Scalars;

    #[test]
    fn what_was_put_is_read_from_anywhere() {
        let mut columns = Columns::<2>::default();
        for len in [11, 5] {
            columns.resize(len);
            for k in 0..len {
                columns.put(k, [k as f64, 0.5 * k as f64]);
            }
            for at in 0..len {
                let read: [Scalars; 2] = columns.read(at);
                let [a, b] = read.map(Lanes::numbers);
                for k in 0..(len - at).min(4) {
                    assert_eq!([a[k], b[k]], [1.0, 0.5].map(|f| f * (at + k) as f64));
                }
            }
        }
        assert_eq!(columns.column(1), [0.0, 0.5, 1.0, 1.5, 2.0]);
    }

    #[test]
    fn nothing_is_read_behind_the_last() {
        let mut columns = Columns::<1>::default();
        let reads =
            |columns: &Columns<1>, at| std::panic::catch_unwind(|| columns.read::<f64>(at)).is_ok();
        assert!(!reads(&columns, 0));
        columns.resize(3);
        assert!(reads(&columns, 2) && !reads(&columns, 3));
    }
}
