//! Rows of all particles, and after them those of images beyond the edges of a cell.

use std::ops::{Deref, DerefMut};

use serde::{Deserialize, Serialize, Serializer};

use super::keep::only;
use super::particles::Row;

/// A row for each particle. As a slice, images left out.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(from = "Vec<Row>")]
pub struct Rows {
    all: Vec<Row>,
    images: usize,
}

impl Rows {
    /// Appends that of a new particle. There are no images after that until they are shown again.
    pub fn push(&mut self, row: Row) {
        self.show(0);
        self.all.push(row);
    }

    /// Removes those of particles that do not stay. There are no images after that.
    pub fn keep_only(&mut self, stays: &[bool]) {
        self.show(0);
        only(&mut self.all, stays);
    }

    /// Makes room for so many more particles.
    pub fn reserve_exact(&mut self, count: usize) {
        self.all.reserve_exact(count);
    }

    /// Has so many images from now on; what they are is to be written.
    pub(super) fn show(&mut self, images: usize) {
        let particles = self.len();
        if self.all.capacity() < particles + images {
            // Room for twice the images, not for twice the particles.
            let room = particles + 2 * images - self.all.len();
            self.all.reserve_exact(room);
        }
        self.all.resize(particles + images, Row::default());
        self.images = images;
    }

    /// Particles and images.
    pub(super) fn seen(&self) -> &[Row] {
        &self.all
    }

    /// Particles, and images.
    pub(super) fn split(&mut self) -> (&mut [Row], &mut [Row]) {
        let particles = self.len();
        self.all.split_at_mut(particles)
    }

    fn count(&self) -> usize {
        self.all.len() - self.images
    }
}

impl Deref for Rows {
    type Target = [Row];

    fn deref(&self) -> &[Row] {
        &self.all[..self.count()]
    }
}

impl DerefMut for Rows {
    fn deref_mut(&mut self) -> &mut [Row] {
        let particles = self.count();
        &mut self.all[..particles]
    }
}

impl From<Vec<Row>> for Rows {
    fn from(all: Vec<Row>) -> Self {
        Self { all, images: 0 }
    }
}

impl Serialize for Rows {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (**self).serialize(serializer)
    }
}

impl PartialEq for Rows {
    fn eq(&self, other: &Self) -> bool {
        **self == **other
    }
}

impl<'a> IntoIterator for &'a Rows {
    type Item = &'a Row;
    type IntoIter = std::slice::Iter<'a, Row>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a> IntoIterator for &'a mut Rows {
    type Item = &'a mut Row;
    type IntoIter = std::slice::IterMut<'a, Row>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(x: f64) -> Row {
        Row::new([x, 0.0], 1.0, [0.0; 2], 0.0)
    }

    #[test]
    fn images_are_no_particles() {
        let mut rows = Rows::from(vec![row(1.0), row(2.0)]);
        rows.show(3);
        assert_eq!([rows.len(), rows.seen().len()], [2, 5]);
        let same = Rows::from(vec![row(1.0), row(2.0)]);
        assert_eq!(rows, same);
        let stored = postcard::to_allocvec(&rows).expect("rows are numbers");
        assert_eq!(postcard::from_bytes::<Rows>(&stored), Ok(same));
        rows.push(row(3.0));
        assert_eq!(rows.seen().len(), 3);
        rows.show(1);
        rows.keep_only(&[false, true, true]);
        let left: Vec<f64> = rows.iter().map(|row| row.x[0]).collect();
        assert_eq!((left, rows.seen().len()), (vec![2.0, 3.0], 2));
    }
}
