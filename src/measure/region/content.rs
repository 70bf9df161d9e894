//! What is in a region: its particles, its discs, its porosity.

use std::f64::consts::PI;

use super::Shape;
use crate::engine::World;
use crate::measure::tensor::ratio;

/// What is in a region at a cycle boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Content {
    /// For each particle, whether its centre is inside.
    pub inside: Vec<bool>,
    /// Area of the region [m²].
    pub area: f64,
    /// Area of discs in the region, each cut exactly at its boundary [m²]. Where discs overlap, the
    /// overlap counts twice.
    pub disc_area: f64,
    /// Area of the discs whose centre is inside, uncut [m²].
    pub member_area: f64,
    /// Thickness of the assembly [m].
    pub thickness: f64,
}

impl Content {
    /// Looks at a region.
    pub fn of(world: &World, shape: Shape) -> Self {
        let inside = shape.members(world);
        let shape = shape.inner(world);
        let (mut disc_area, mut member_area) = (0.0, 0.0);
        let parts = |x: [f64; 2], radius: f64| match world.cell() {
            Some(cell) if shape != Shape::All => cell
                .images(x, 1)
                .map(|(_, x)| shape.part_of(x, radius))
                .sum(),
            _ => shape.part_of(x, radius),
        };
        for (row, &is_inside) in world.particles().row.iter().zip(&inside) {
            disc_area += parts(row.x, row.radius);
            if is_inside {
                member_area += PI * row.radius * row.radius;
            }
        }
        Self {
            inside,
            area: shape.area(world),
            disc_area,
            member_area,
            thickness: world.thickness(),
        }
    }

    /// Number of particles whose centre is inside.
    pub fn particles(&self) -> usize {
        self.inside.iter().filter(|&&inside| inside).count()
    }

    /// Areal porosity: the part of the area that no disc covers; NaN without area.
    pub fn porosity(&self) -> f64 {
        1.0 - ratio(self.disc_area, self.area)
    }

    /// (1 - n)/ΣV of a stress [1/m³]: V is the volume a particle stands for, disc area times
    /// thickness for both bodies, so that (1 - n) and V speak of the same solid. For spheres this
    /// is the stress of a slice one mean diameter thick.
    pub fn per_volume(&self) -> f64 {
        ratio(1.0 - self.porosity(), self.member_area * self.thickness)
    }
}
