//! A periodic cell: what leaves through one side comes in through the opposite one.
//!
//! The plane is tiled with copies of a parallelogram. Particles keep their coordinates when they
//! leave it: a contact knows by how many edges its second body is shifted, so nothing jumps.

use serde::{Deserialize, Serialize};

use super::straining::{Tensor, velocity};

/// How many edges 1 and 2 an image is shifted by.
pub type Image = [i16; 2];

/// The particle itself.
pub const HERE: Image = [0; 2];

/// The cell as it is now.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Its lower left corner [m], relative to the origin of the world.
    pub corner: [f64; 2],
    /// Its two edges [m]; the second is on the left of the first.
    pub edges: [[f64; 2]; 2],
}

/// Other edges of the same lattice: one edge less so many times the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::engine) struct Upright {
    /// Which edge is another one then.
    edge: usize,
    times: i16,
}

impl Upright {
    /// How many of the new edges an image is shifted by.
    pub(in crate::engine) fn image(self, mut image: Image) -> Image {
        let more = image[self.edge].saturating_mul(self.times);
        let other = &mut image[1 - self.edge];
        *other = other.saturating_add(more);
        image
    }
}

impl Cell {
    /// The edges with which it leans less, if one leans by more than half of the other: sheared on and on
    /// it would get as narrow as a particle. An edge along an axis stays, if the other is not along one.
    pub(in crate::engine) fn upright(&self) -> Option<Upright> {
        let [a, b] = self.edges;
        let dot = |a: [f64; 2], b: [f64; 2]| a[0] * b[0] + a[1] * b[1];
        let along = |edge: [f64; 2]| edge[0] == 0.0 || edge[1] == 0.0;
        [1, 0].into_iter().find_map(|edge| {
            let other = self.edges[1 - edge];
            if along(self.edges[edge]) && !along(other) {
                return None;
            }
            let lean = dot(a, b) / dot(other, other);
            // At half an edge it may lean either way.
            let times = lean.round() as i16;
            (lean.abs() > 0.5).then_some(Upright { edge, times })
        })
    }

    /// Takes those edges.
    pub(in crate::engine) fn set_upright(&mut self, Upright { edge, times }: Upright) {
        let other = self.edges[1 - edge];
        for (x, other) in self.edges[edge].iter_mut().zip(other) {
            *x -= f64::from(times) * other;
        }
    }

    /// Shift of an image [m].
    #[inline(always)]
    pub fn shift(&self, image: Image) -> [f64; 2] {
        let [n, m] = image.map(f64::from);
        [0, 1].map(|k| n * self.edges[0][k] + m * self.edges[1][k])
    }

    /// Its area [m²].
    pub fn area(&self) -> f64 {
        let [a, b] = self.edges;
        a[0] * b[1] - a[1] * b[0]
    }

    /// Distance between the two sides that each edge connects [m].
    pub fn widths(&self) -> [f64; 2] {
        let length = |e: [f64; 2]| (e[0] * e[0] + e[1] * e[1]).sqrt();
        [
            self.area() / length(self.edges[1]),
            self.area() / length(self.edges[0]),
        ]
    }

    /// Coordinates of a point in terms of the edges, 0 at the corner.
    pub fn fractions(&self, x: [f64; 2]) -> [f64; 2] {
        let ([a, b], area) = (self.edges, self.area());
        let d = [x[0] - self.corner[0], x[1] - self.corner[1]];
        [
            (d[0] * b[1] - d[1] * b[0]) / area,
            (a[0] * d[1] - a[1] * d[0]) / area,
        ]
    }

    /// The image of the cell that a point is in.
    pub fn image(&self, x: [f64; 2]) -> Image {
        self.fractions(x).map(whole_below)
    }

    /// The same point in the cell itself [m].
    pub fn home(&self, x: [f64; 2]) -> [f64; 2] {
        let shift = self.shift(self.image(x));
        [x[0] - shift[0], x[1] - shift[1]]
    }

    /// A point in the cell itself and in the cells up to `far` edges around, and where that is [m].
    pub fn images(
        &self,
        x: [f64; 2],
        far: i16,
    ) -> impl Iterator<Item = (Image, [f64; 2])> + use<'_> {
        let home = self.home(x);
        let all = (-far..=far).flat_map(move |n| (-far..=far).map(move |m| [n, m]));
        all.map(move |image| {
            let shift = self.shift(image);
            (image, [home[0] + shift[0], home[1] + shift[1]])
        })
    }

    /// The shortest of the vectors [m] between two points and their images; in a cell that leans by more
    /// than half an edge it may be the second shortest.
    pub fn nearest(&self, d: [f64; 2]) -> [f64; 2] {
        let from_corner = [d[0] + self.corner[0], d[1] + self.corner[1]];
        let image = self.fractions(from_corner).map(|f| f.round() as i16);
        let shift = self.shift(image);
        [d[0] - shift[0], d[1] - shift[1]]
    }

    /// Takes a step of `dt` [s] under a strain rate that leaves `centre` where it is.
    pub(super) fn deform(&mut self, rate: &Tensor, centre: [f64; 2], dt: f64) {
        let moved = |x: [f64; 2], d: [f64; 2]| {
            let v = velocity(rate, d);
            [x[0] + v[0] * dt, x[1] + v[1] * dt]
        };
        for edge in &mut self.edges {
            *edge = moved(*edge, *edge);
        }
        let d = [self.corner[0] - centre[0], self.corner[1] - centre[1]];
        self.corner = moved(self.corner, d);
    }
}

/// The largest whole number that is not above: what the processor itself rounds to only with newer
/// instructions.
#[inline(always)]
pub(in crate::engine) fn whole_below(fraction: f64) -> i16 {
    let towards_nought = fraction as i16;
    towards_nought.saturating_sub(i16::from(f64::from(towards_nought) > fraction))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_come_home_by_whole_edges() {
        let cell = Cell {
            corner: [1.0, -1.0],
            edges: [[2.0, 0.0], [0.5, 1.0]],
        };
        assert_eq!(cell.area(), 2.0);
        assert_eq!(cell.image([2.0, -0.5]), HERE);
        assert_eq!(cell.image([1.0, 0.5]), [-1, 1]);
        assert_eq!(cell.home([1.0, 0.5]), [2.5, -0.5]);
        let images: Vec<_> = cell.images([1.0, 0.5], 1).collect();
        assert_eq!(images.len(), 9);
        assert_eq!(images[4], (HERE, [2.5, -0.5]));
        // The point itself is one of them.
        assert_eq!(images[2], ([-1, 1], [1.0, 0.5]));
        let widths = cell.widths();
        assert!((widths[0] - 2.0 / 1.25f64.sqrt()).abs() < 1e-15);
        assert_eq!(widths[1], 1.0);
    }

    #[test]
    fn an_upright_cell_has_the_same_images() {
        for edges in [
            [[2.0, 0.0], [1.25, 1.0]],
            [[2.0, 0.0], [-6.75, 1.0]],
            [[2.0, 3.5], [0.0, 1.0]],
            [[2.0, 0.5], [1.75, 1.0]],
        ] {
            let corner = [1.0, -1.0];
            let mut cell = Cell { corner, edges };
            let before = cell.clone();
            let turn = cell.upright().expect("it leans");
            cell.set_upright(turn);
            for image in [[0, 0], [1, 0], [0, 1], [-3, 2], [5, -4]] {
                assert_eq!(cell.shift(turn.image(image)), before.shift(image));
            }
            assert_eq!(cell.area(), before.area());
            assert!(cell.widths().iter().sum::<f64>() > before.widths().iter().sum());
            // Neither edge along an axis: the other one may lean now.
            if let Some(again) = cell.upright() {
                cell.set_upright(again);
            }
            assert_eq!(cell.upright(), None, "{cell:?}");
        }
        // By less than half of the edge along the axis.
        let stands = Cell {
            corner: [0.0; 2],
            edges: [[2.0, 0.0], [0.9, 1.0]],
        };
        assert_eq!(stands.upright(), None);
    }

    #[test]
    fn whole_numbers_below_are_those_of_the_library() {
        let least = f64::from(i16::MIN);
        for x in [
            0.0,
            -0.0,
            0.5,
            -0.5,
            1.0,
            -1.0,
            -1e-20,
            7.999,
            -7.001,
            least,
            least - 0.5,
            1e9,
            -1e9,
            f64::NAN,
        ] {
            assert_eq!(whole_below(x), x.floor() as i16, "{x}");
        }
    }
}
