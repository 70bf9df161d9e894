//! Particles as their neighbours see them: with the velocity of the imposed flow, and once more
//! for each image that somebody may touch.
//!
//! Only where there is a cell or a flow: elsewhere contacts read the particles themselves.

use super::cell::{Cell, HERE, Image};
use super::straining::{Tensor, velocity};
use crate::engine::particles::Row;

/// Rows that contacts read.
#[derive(Debug, Clone, Default)]
pub(in crate::engine) struct Seen {
    /// Every particle, then every image.
    pub(in crate::engine) rows: Vec<Row>,
    /// The two rows of each pair.
    pub(in crate::engine) pairs: Vec<[u32; 2]>,
    /// Particle and shift of each image.
    images: Vec<(u32, Image)>,
}

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
        for (&[i, j], &image) in pairs.iter().zip(images) {
            if image == HERE {
                self.pairs.push([i, j]);
                continue;
            }
            let wanted = (j, image);
            let known = self.images.iter().rposition(|known| *known == wanted);
            let place = known.unwrap_or_else(|| {
                self.images.push(wanted);
                self.images.len() - 1
            });
            self.pairs.push([i, (particles + place) as u32]);
        }
        self.pairs.extend(pairs.iter().skip(images.len()));
    }

    /// Looks at the particles again.
    pub(in crate::engine) fn look(
        &mut self,
        rows: &[Row],
        flow: Option<(&Tensor, [f64; 2])>,
        cell: Option<&Cell>,
    ) {
        self.rows.clear();
        self.rows.extend_from_slice(rows);
        if let Some((rate, centre)) = flow {
            for row in &mut self.rows {
                let v = velocity(rate, [row.x[0] - centre[0], row.x[1] - centre[1]]);
                row.v = [row.v[0] + v[0], row.v[1] + v[1]];
            }
        }
        let Some(cell) = cell else { return };
        for &(p, image) in &self.images {
            let mut row = self.rows[p as usize];
            let shift = cell.shift(image);
            row.x = [row.x[0] + shift[0], row.x[1] + shift[1]];
            if let Some((rate, _)) = flow {
                let v = velocity(rate, shift);
                row.v = [row.v[0] + v[0], row.v[1] + v[1]];
            }
            self.rows.push(row);
        }
    }
}
