//! Images of particles beyond the edges of a cell, each a row of its own that contacts read.

use super::cell::{Cell, HERE, Image};
use crate::engine::neighbours::images::Images;
use crate::engine::particles::Row;
use crate::engine::rows::Rows;

/// Who is seen beyond the edges.
#[derive(Debug, Clone, Default)]
pub(in crate::engine) struct Seen {
    /// The two rows of each pair, those of images after all others.
    pub(in crate::engine) pairs: Vec<[u32; 2]>,
    /// Particle and image of each row beyond the edges, ascending.
    images: Vec<(u32, Image)>,
    /// Whether these rows stand where they belong now.
    current: bool,
}

impl Seen {
    /// The list was made anew, and the second bodies of its pairs are these images.
    pub(in crate::engine) fn relist(
        &mut self,
        rows: &mut Rows,
        pairs: &[[u32; 2]],
        images: &Images,
    ) {
        let particles = rows.len() as u32;
        let all = || pairs.iter().zip(images.each());
        let beyond = all().filter(|(_, image)| *image != HERE);
        self.images.clear();
        self.images
            .extend(beyond.map(|(pair, image)| (pair[1], image)));
        self.images.sort_unstable();
        self.images.dedup();
        let row = |j: u32, image: Image| {
            if image == HERE {
                return j;
            }
            particles + self.images.partition_point(|seen| *seen < (j, image)) as u32
        };
        self.pairs.clear();
        self.pairs
            .extend(all().map(|(&[i, j], image)| [i, row(j, image)]));
        rows.show(self.images.len());
        self.current = false;
    }

    /// Which image of its second body pair k means, of so many particles.
    pub(in crate::engine) fn image(&self, k: usize, particles: usize) -> Image {
        let place = (self.pairs[k][1] as usize).checked_sub(particles);
        place.map_or(HERE, |place| self.images[place].1)
    }

    /// Looks at the particles again, unless that was done since they moved.
    pub(in crate::engine) fn look(&mut self, rows: &mut Rows, cell: &Cell) {
        if !std::mem::take(&mut self.current) {
            let (own, images) = rows.split();
            self.ahead(cell).look(0, own, images);
        }
    }

    /// For those who move the particles: they look at once.
    pub(in crate::engine) fn ahead<'a>(&'a self, cell: &'a Cell) -> Beyond<'a> {
        Beyond {
            images: &self.images,
            cell,
        }
    }

    /// That was done.
    pub(in crate::engine) fn have_followed(&mut self) {
        self.current = true;
    }
}

/// Images whose rows are written as soon as their particles have moved.
#[derive(Clone, Copy)]
pub(in crate::engine) struct Beyond<'a> {
    images: &'a [(u32, Image)],
    cell: &'a Cell,
}

impl Beyond<'_> {
    /// How many images there are of particles below `p`.
    pub(in crate::engine) fn below(&self, p: usize) -> usize {
        self.images.partition_point(|image| (image.0 as usize) < p)
    }

    /// Writes the rows of the images of particles from number `first` on.
    pub(in crate::engine) fn look(&self, first: usize, own: &[Row], rows: &mut [Row]) {
        let images = &self.images[self.below(first)..];
        for (seen, &(p, image)) in rows.iter_mut().zip(images) {
            *seen = own[p as usize - first];
            let shift = self.cell.shift(image);
            seen.x = [seen.x[0] + shift[0], seen.x[1] + shift[1]];
        }
    }
}
