//! Regions: the parts of an assembly that measures are taken over.
//!
//! Particles whose centre is inside belong to a region; its porosity counts the parts of discs
//! inside, whoever they belong to.

mod content;
mod cut;
mod enclosure;
mod hull;

pub use content::Content;
pub use enclosure::Enclosure;

use crate::engine::World;

/// Where a region is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Shape {
    /// A circle.
    Circle {
        /// Its centre [m], in the coordinates of the preset.
        centre: [f64; 2],
        /// Its radius [m].
        radius: f64,
    },
    /// A rectangle along the axes.
    Rectangle {
        /// Lower left corner [m], in the coordinates of the preset.
        min: [f64; 2],
        /// Upper right corner [m], in the coordinates of the preset.
        max: [f64; 2],
    },
    /// Everything: see [`Enclosure`] for its area.
    All,
}

/// A part of the assembly with a name.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Name in the preset.
    pub name: String,
    /// Where it is; it stays there while particles move through it.
    pub shape: Shape,
}

impl Shape {
    /// For each particle, whether its centre is inside.
    pub fn members(self, world: &World) -> Vec<bool> {
        let inner = self.inner(world);
        let rows = world.particles().row.iter();
        let home = |x| world.cell().map_or(x, |cell| cell.home(x));
        rows.map(|row| inner.contains(home(row.x))).collect()
    }

    /// The same place in the coordinates the world computes in.
    pub(super) fn inner(self, world: &World) -> Self {
        let origin = world.origin();
        let shift = |x: [f64; 2]| [x[0] - origin[0], x[1] - origin[1]];
        match self {
            Self::Circle { centre, radius } => Self::Circle {
                centre: shift(centre),
                radius,
            },
            Self::Rectangle { min, max } => Self::Rectangle {
                min: shift(min),
                max: shift(max),
            },
            Self::All => Self::All,
        }
    }

    /// Whether a point is inside; lower and left edges belong to it, upper and right ones do not, so
    /// that regions side by side share no particle.
    pub(super) fn contains(self, x: [f64; 2]) -> bool {
        match self {
            Self::Circle { centre, radius } => {
                let d = [x[0] - centre[0], x[1] - centre[1]];
                d[0] * d[0] + d[1] * d[1] < radius * radius
            }
            Self::Rectangle { min, max } => (0..2).all(|k| min[k] <= x[k] && x[k] < max[k]),
            Self::All => true,
        }
    }

    /// Area of the part of a disc inside [m²]. Everything holds discs whole: one that overlaps a
    /// wall counts as those that overlap each other do.
    pub(super) fn part_of(self, x: [f64; 2], radius: f64) -> f64 {
        match self {
            Self::Circle { centre, radius: r } => {
                cut::by_circle([x[0] - centre[0], x[1] - centre[1]], radius, r)
            }
            Self::Rectangle { min, max } => cut::by_rectangle(x, radius, min, max),
            Self::All => std::f64::consts::PI * radius * radius,
        }
    }

    /// Area [m²].
    fn area(self, world: &World) -> f64 {
        match self {
            Self::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
            Self::Rectangle { min, max } => (max[0] - min[0]) * (max[1] - min[1]),
            Self::All => Enclosure::of(world).area(world),
        }
    }
}
