//! Particles as their neighbours see them: with the velocity of the imposed flow, and once more
//! for each image that somebody may touch.
//!
//! Only where there is a cell or a flow: elsewhere contacts read the particles themselves.

use super::cell::{Cell, HERE, Image};
use super::straining::{Tensor, velocity};
use crate::engine::particles::Row;
use crate::engine::threads::Threads;

/// Rows that contacts read.
#[derive(Debug, Clone, Default)]
pub(in crate::engine) struct Seen {
    /// Every particle, then every image.
    pub(in crate::engine) rows: Vec<Row>,
    /// The two rows of each pair.
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
        particles: usize,
        pairs: &[[u32; 2]],
        images: &[Image],
    ) {
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
    }

    /// Looks at the particles again.
    pub(in crate::engine) fn look(
        &mut self,
        rows: &[Row],
        flow: Option<(&Tensor, [f64; 2])>,
        cell: Option<&Cell>,
        threads: &Threads,
    ) {
        let images = if cell.is_some() { self.images.len() } else { 0 };
        self.rows.resize(rows.len() + images, Row::default());
        let (own, others) = self.rows.split_at_mut(rows.len());
        threads.each(own, |first, seen| {
            let rows = &rows[first..first + seen.len()];
            let Some((rate, centre)) = flow else {
                seen.copy_from_slice(rows);
                return;
            };
            for (seen, row) in seen.iter_mut().zip(rows) {
                let v = velocity(rate, [row.x[0] - centre[0], row.x[1] - centre[1]]);
                *seen = *row;
                seen.v = [row.v[0] + v[0], row.v[1] + v[1]];
            }
        });
        let Some(cell) = cell else { return };
        for (seen, &(p, image, _)) in others.iter_mut().zip(&self.images) {
            *seen = own[p as usize];
            let shift = cell.shift(image);
            seen.x = [seen.x[0] + shift[0], seen.x[1] + shift[1]];
            if let Some((rate, _)) = flow {
                let v = velocity(rate, shift);
                seen.v = [seen.v[0] + v[0], seen.v[1] + v[1]];
            }
        }
    }
}
