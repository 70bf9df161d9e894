//! Porosity by distance from the middle of a region: rings of equal width, discs cut exactly at each
//! of them (Randall 1989, fig. 6.5).

use std::f64::consts::PI;

use super::region::Shape;
use super::tensor::ratio;
use crate::engine::World;

/// Rings when nothing else is asked for.
pub const RINGS: usize = 10;

/// A ring about the middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Inner radius [m]; 0 for the disc in the middle.
    pub inner: f64,
    /// Outer radius [m].
    pub outer: f64,
    /// Area of discs in it [m²].
    pub disc_area: f64,
    /// Particles with their centre in it.
    pub particles: usize,
}

impl Ring {
    /// Area [m²].
    pub fn area(&self) -> f64 {
        PI * (self.outer - self.inner) * (self.outer + self.inner)
    }

    /// The part of its area that no disc covers.
    pub fn porosity(&self) -> f64 {
        1.0 - ratio(self.disc_area, self.area())
    }
}

/// Rings of a region, the innermost first.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// The middle [m], in the coordinates of the preset: the centre of a circle, the middle of a
    /// rectangle, the centre of area of all discs for everything.
    pub centre: [f64; 2],
    /// Rings up to the edge of a circle, to the nearer edges of a rectangle, or as far as discs reach.
    pub rings: Vec<Ring>,
}

impl Profile {
    /// Cuts the discs of all particles by so many rings about the middle of a region.
    pub fn of(world: &World, shape: Shape, count: usize) -> Self {
        let (centre, radius) = middle(world, shape);
        let origin = world.origin();
        let inner = [centre[0] - origin[0], centre[1] - origin[1]];
        let rows = &world.particles().row;
        let edge = |k: usize| radius * k as f64 / count as f64;
        // Area of discs, and number of centres, within a radius.
        let within = |radius: f64| {
            let circle = Shape::Circle {
                centre: inner,
                radius,
            };
            let area: f64 = rows
                .iter()
                .map(|row| circle.part_of(row.x, row.radius))
                .sum();
            (
                area,
                rows.iter().filter(|row| circle.contains(row.x)).count(),
            )
        };
        let mut rings = Vec::with_capacity(count);
        let mut before = (0.0, 0);
        for k in 0..count {
            let now = within(edge(k + 1));
            rings.push(Ring {
                inner: edge(k),
                outer: edge(k + 1),
                disc_area: now.0 - before.0,
                particles: now.1 - before.1,
            });
            before = now;
        }
        Self { centre, rings }
    }
}

/// Middle of a region [m], in the coordinates of the preset, and how far rings about it go [m].
fn middle(world: &World, shape: Shape) -> ([f64; 2], f64) {
    match shape {
        Shape::Circle { centre, radius } => (centre, radius),
        Shape::Rectangle { min, max } => {
            let centre = [0, 1].map(|k| 0.5 * (min[k] + max[k]));
            (centre, 0.5 * (max[0] - min[0]).min(max[1] - min[1]))
        }
        Shape::All => {
            let rows = &world.particles().row;
            let (mut sum, mut area) = ([0.0; 2], 0.0);
            for row in rows {
                let square = row.radius * row.radius;
                area += square;
                sum = [sum[0] + square * row.x[0], sum[1] + square * row.x[1]];
            }
            let inner = sum.map(|sum| if area > 0.0 { sum / area } else { 0.0 });
            let reach = rows.iter().map(|row| {
                let d = [row.x[0] - inner[0], row.x[1] - inner[1]];
                (d[0] * d[0] + d[1] * d[1]).sqrt() + row.radius
            });
            let origin = world.origin();
            let centre = [inner[0] + origin[0], inner[1] + origin[1]];
            (centre, reach.fold(0.0, f64::max))
        }
    }
}
