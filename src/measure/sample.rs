//! The value of any column at a cycle boundary. Each group of measures is taken at most once, and
//! only when a column asks for it.

use std::cell::OnceCell;

use nalgebra::Matrix2;

use super::assembly::Assembly;
use super::class::{self, Class};
use super::columns::{Column, Partner, Read, ReadContact};
use super::reference::Reference;
use super::region::{Region, Shape};
use super::regional::Regional;
use super::tensor::matrix;
use crate::engine::World;
use crate::engine::ledger::{Bookings, Energies};
use crate::engine::neighbours::Status;

/// A world at a cycle boundary, measured as far as asked.
pub struct Sample<'a> {
    world: &'a World,
    energies: OnceCell<Energies>,
    bookings: OnceCell<Bookings>,
    /// By material, in the default region.
    materials: OnceCell<Vec<Class>>,
    reference: Option<&'a Reference>,
    /// Regions with a name; the first is what columns without a region are measured over.
    regions: &'a [Region],
    /// Measures of each.
    regional: Vec<Regional<'a>>,
    /// Measures of everything.
    whole: Regional<'a>,
}

impl<'a> Sample<'a> {
    /// Sums the forces of the boundary if that has not been done, and is ready to measure. The whole
    /// assembly is the only region.
    pub fn of(world: &'a mut World) -> Self {
        Self::over(world, &[], None)
    }

    /// The same with regions, of which the first is the default, and with a state that differences
    /// are measured from.
    pub fn over(
        world: &'a mut World,
        regions: &'a [Region],
        reference: Option<&'a Reference>,
    ) -> Self {
        world.settle();
        let world = &*world;
        let regional = |shape| Regional::new(world, shape, reference);
        let shapes = regions.iter().map(|region| region.shape);
        Self {
            world,
            energies: OnceCell::new(),
            bookings: OnceCell::new(),
            materials: OnceCell::new(),
            reference,
            regions,
            regional: shapes.map(regional).collect(),
            whole: regional(Shape::All),
        }
    }

    /// The world behind it.
    pub fn world(&self) -> &World {
        self.world
    }

    /// The state that differences are measured from.
    pub fn reference(&self) -> Option<&Reference> {
        self.reference
    }

    /// Strain that the boundary has imposed since the reference, compression positive; NaN where
    /// nothing imposes any.
    pub fn imposed_strain(&self) -> Matrix2<f64> {
        let now = self.world.imposed_strain();
        let then = self
            .reference
            .map_or_else(Matrix2::zeros, Reference::imposed);
        now.map_or(Matrix2::from_element(f64::NAN), |now| matrix(now) - then)
    }

    /// Strain rate that the boundary imposes [1/s]; NaN where nothing imposes any.
    pub fn imposed_rate(&self) -> Matrix2<f64> {
        let rate = self.world.imposed_rate();
        rate.map_or(Matrix2::from_element(f64::NAN), matrix)
    }

    /// Contact statistics of the whole assembly.
    pub fn assembly(&self) -> &Assembly {
        self.whole.assembly()
    }

    /// Measures of the whole assembly.
    pub fn whole(&self) -> &Regional<'a> {
        &self.whole
    }

    /// Measures of the default region: the first one, or the whole assembly.
    pub fn regional(&self) -> &Regional<'a> {
        self.regional.first().unwrap_or(&self.whole)
    }

    /// Names of the regions, the default one first.
    pub fn region_names(&self) -> impl Iterator<Item = &'a str> {
        self.regions.iter().map(|region| region.name.as_str())
    }

    /// Measures of a region by name.
    pub fn region(&self, name: &str) -> Option<&Regional<'a>> {
        let found = self.regions.iter().position(|region| region.name == name)?;
        self.regional.get(found)
    }

    /// Energies.
    pub fn energies(&self) -> &Energies {
        self.energies.get_or_init(|| self.world.energies())
    }

    /// Losses and work; NaN when energies are not booked.
    pub fn bookings(&self) -> &Bookings {
        self.bookings.get_or_init(|| {
            let none = Bookings {
                friction_loss: f64::NAN,
                slip_loss: f64::NAN,
                bond_loss: f64::NAN,
                damping_loss: f64::NAN,
                global_loss: f64::NAN,
                boundary_work: f64::NAN,
                energy_error: f64::NAN,
            };
            self.world.bookings().unwrap_or(none)
        })
    }

    /// State hash, for the column that shows it.
    pub fn hash(&self) -> u64 {
        self.world.state_hash()
    }

    /// Value of a column; undefined ones, and particles that are gone, are NaN.
    pub fn value(&self, column: &Column) -> f64 {
        match column {
            Column::Global(row) => match row.read {
                Read::World(read) | Read::Either(read, _) => read(self),
                Read::Region(read) => read(self.regional()),
                Read::Whole(read) => read(&self.whole),
            },
            Column::Region(name, row) => match (self.region(name), row.read) {
                (Some(region), Read::Region(read) | Read::Whole(read) | Read::Either(_, read)) => {
                    read(region)
                }
                _ => f64::NAN,
            },
            Column::Wall(name, row) => {
                let mut walls = self.world.walls().iter();
                let found = walls.position(|wall| wall.name == *name);
                found.map_or(f64::NAN, |w| (row.read)(self.world, w))
            }
            Column::Contact(i, partner, row) => self.contact(*i, partner, row.read),
            Column::Particle(id, row) => {
                let found = self.world.particles().index(*id);
                found.map_or(f64::NAN, |p| (row.read)(self, p))
            }
            Column::Particles(first, last, row) => {
                let of = &self.world.particles().id;
                let there = of.iter().enumerate();
                let (sum, count) = there
                    .filter(|(_, id)| (first..=last).contains(id))
                    .fold((0.0, 0u32), |(sum, count), (p, _)| {
                        (sum + (row.read)(self, p), count + 1)
                    });
                sum / f64::from(count)
            }
            Column::Material(name, row) => {
                let mut materials = self.world.model().materials.iter();
                let found = materials.position(|material| material.name == *name);
                found.map_or(f64::NAN, |m| (row.read)(&self.materials()[m]))
            }
        }
    }

    fn materials(&self) -> &[Class] {
        let inside = || self.regional().members();
        self.materials
            .get_or_init(|| class::by_material(self.world, inside()))
    }

    /// An absent contact carries nothing: 0.
    fn contact(&self, i: u32, partner: &Partner, read: ReadContact) -> f64 {
        let found = find_contact(self.world, i, partner);
        let touching = found.filter(|&k| self.world.contacts().status[k] != Status::Apart);
        touching.map_or(0.0, |k| read(self.world, k))
    }
}

/// Number of the listed contact between a particle and its partner. In a small cell two particles may
/// be listed through several images: one that touches comes before those that do not.
pub fn find_contact(world: &World, i: u32, partner: &Partner) -> Option<usize> {
    let list = world.contacts();
    let i = world.particles().index(i)? as u32;
    match partner {
        Partner::Particle(j) => {
            let j = world.particles().index(*j)? as u32;
            let pair = [i.min(j), i.max(j)];
            let first = list.pairs.partition_point(|other| *other < pair);
            let count = list.pairs[first..]
                .iter()
                .take_while(|other| **other == pair);
            let mut same = first..first + count.count();
            let touching = same.clone().find(|&k| list.status[k] != Status::Apart);
            touching.or(same.next())
        }
        Partner::Wall(name) => {
            let w = world.walls().iter().position(|wall| wall.name == *name)? as u32;
            let k = list
                .walls
                .binary_search_by_key(&(i, w), |pair| (pair.particle, pair.wall));
            k.ok().map(|k| k + list.pairs.len())
        }
    }
}
