//! Images of particles beyond the edges of a cell, each a row of its own that contacts read.

use super::cell::{Cell, HERE, Image};
use crate::engine::rows::Rows;

/// Who is seen beyond the edges.
#[derive(Debug, Clone, Default)]
pub(in crate::engine) struct Seen {
    /// The two rows of each pair, those of images after all others.
    pub(in crate::engine) pairs: Vec<[u32; 2]>,
    /// Particle and shift of each image, and the image of the same particle found before it.
    images: Vec<(u32, Image, u32)>,
    /// The last image of each particle.
    last: Vec<u32>,
}

/// No image.
const NONE: u32 = u32::MAX;

impl Seen {
    /// The list was made anew: `images[k]` says where the second body of pair k is.
    pub(in crate::engine) fn relist(
        &mut self,
        rows: &mut Rows,
        pairs: &[[u32; 2]],
        images: &[Image],
    ) {
        let particles = rows.len();
        self.images.clear();
        self.pairs.clear();
        self.last.clear();
        self.last.resize(particles, NONE);
        for (&[i, j], &image) in pairs.iter().zip(images) {
            if image == HERE {
                self.pairs.push([i, j]);
                continue;
            }
            let mut place = self.last[j as usize];
            while place != NONE && self.images[place as usize].1 != image {
                place = self.images[place as usize].2;
            }
            if place == NONE {
                place = self.images.len() as u32;
                self.images.push((j, image, self.last[j as usize]));
                self.last[j as usize] = place;
            }
            self.pairs.push([i, particles as u32 + place]);
        }
        self.pairs.extend(pairs.iter().skip(images.len()));
        rows.show(self.images.len());
    }

    /// Looks at the particles again.
    pub(in crate::engine) fn look(&self, rows: &mut Rows, cell: &Cell) {
        let (own, images) = rows.split();
        for (seen, &(p, image, _)) in images.iter_mut().zip(&self.images) {
            *seen = own[p as usize];
            let shift = cell.shift(image);
            seen.x = [seen.x[0] + shift[0], seen.x[1] + shift[1]];
        }
    }
}
