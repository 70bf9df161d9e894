//! The value of any column at a cycle boundary. Each group of measures is taken at most once, and
//! only when a column asks for it.

use std::cell::OnceCell;

use super::assembly::Assembly;
use super::columns::{COLUMNS, CONTACT_COLUMNS, Column, PARTICLE_COLUMNS, Partner, WALL_COLUMNS};
use super::region::{Region, Shape};
use super::regional::Regional;
use super::wall_force::WallForce;
use crate::engine::World;
use crate::engine::ledger::{Bookings, Energies};
use crate::engine::neighbours::Status;

/// A world at a cycle boundary, measured as far as asked.
pub struct Sample<'a> {
    world: &'a World,
    assembly: OnceCell<Assembly>,
    energies: OnceCell<Energies>,
    bookings: OnceCell<Bookings>,
    /// Regions with a name; the first is what columns without a region are measured over.
    regions: &'a [Region],
    /// Measures of each, or of everything.
    regional: Vec<Regional<'a>>,
}

impl<'a> Sample<'a> {
    /// Sums the forces of the boundary if that has not been done, and is ready to measure. The whole
    /// assembly is the only region.
    pub fn of(world: &'a mut World) -> Self {
        Self::over(world, &[])
    }

    /// The same with regions, of which the first is the default.
    pub fn over(world: &'a mut World, regions: &'a [Region]) -> Self {
        world.settle();
        let world = &*world;
        let shapes = regions.iter().map(|region| region.shape);
        let all = regions.is_empty().then_some(Shape::All);
        Self {
            world,
            assembly: OnceCell::new(),
            energies: OnceCell::new(),
            bookings: OnceCell::new(),
            regions,
            regional: shapes
                .chain(all)
                .map(|shape| Regional::new(world, shape))
                .collect(),
        }
    }

    /// The world behind it.
    pub fn world(&self) -> &World {
        self.world
    }

    /// Contact statistics.
    pub fn assembly(&self) -> &Assembly {
        self.assembly.get_or_init(|| Assembly::of(self.world))
    }

    /// Measures of the default region: the first one, or the whole assembly.
    pub fn regional(&self) -> &Regional<'a> {
        &self.regional[0]
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
            Column::Global(k) => self.global(COLUMNS[*k].name),
            Column::Wall(name, k) => {
                let Some(w) = self
                    .world
                    .walls()
                    .iter()
                    .position(|wall| wall.name == *name)
                else {
                    return f64::NAN;
                };
                let on = WallForce::of(self.world, w);
                match WALL_COLUMNS[*k].name {
                    "f1" => on.force[0],
                    "f2" => on.force[1],
                    "moment" => on.moment,
                    "eccentricity" => on.eccentricity,
                    _ => f64::NAN,
                }
            }
            Column::Contact(i, partner, k) => self.contact(*i, partner, CONTACT_COLUMNS[*k].name),
            Column::Particle(id, k) => self.particle(*id, PARTICLE_COLUMNS[*k].name),
            Column::Region(name, k) => {
                let region = self.region(name);
                region.map_or(f64::NAN, |region| region.value(COLUMNS[*k].name))
            }
        }
    }

    fn global(&self, name: &str) -> f64 {
        let world = self.world;
        match name {
            "dt" => world.dt(),
            "fracc" => world.fracc_monitor().largest.unwrap_or(f64::NAN),
            "frac_limit" => world.frac_limit(),
            "contacts" => self.assembly().contacts as f64,
            "coordination" => self.assembly().coordination,
            "coordination_mechanical" => self.assembly().coordination_mechanical,
            "sliding_fraction" => self.assembly().sliding_fraction,
            "mean_force" => self.assembly().mean_force,
            "max_force" => self.assembly().max_force,
            "unbalanced" => self.assembly().unbalanced,
            "unbalanced_max" => self.assembly().unbalanced_max,
            "kinetic" => self.energies().kinetic,
            "rotational" => self.energies().rotational,
            "elastic_normal" => self.energies().elastic_normal,
            "elastic_tangential" => self.energies().elastic_tangential,
            "potential" => self.energies().potential,
            "friction_loss" => self.bookings().friction_loss,
            "slip_loss" => self.bookings().slip_loss,
            "damping_loss" => self.bookings().damping_loss,
            "global_loss" => self.bookings().global_loss,
            "boundary_work" => self.bookings().boundary_work,
            "energy_error" => self.bookings().energy_error,
            name => self.regional().value(name),
        }
    }

    fn particle(&self, id: u32, what: &str) -> f64 {
        let Some(p) = self.world.particles().index(id) else {
            return f64::NAN;
        };
        let (v, spin) = self.world.velocity(p);
        let x = self.world.position(p);
        match what {
            "x" => x[0],
            "y" => x[1],
            "angle" => self.world.particles().row[p].angle,
            "vx" => v[0],
            "vy" => v[1],
            "spin" => spin,
            _ => f64::NAN,
        }
    }

    /// An absent contact carries nothing: 0.
    fn contact(&self, i: u32, partner: &Partner, what: &str) -> f64 {
        let Some(k) = find_contact(self.world, i, partner) else {
            return 0.0;
        };
        if self.world.contacts().status[k] == Status::Apart {
            return 0.0;
        }
        match what {
            "n" => self.world.reaction(k).normal,
            "t" => self.world.reaction(k).tangential,
            "alpha" => self.world.geometry(k).overlap,
            "delta" => self.world.pass().book(k).delta,
            _ => f64::NAN,
        }
    }
}

/// Number of the listed contact between a particle and its partner.
pub fn find_contact(world: &World, i: u32, partner: &Partner) -> Option<usize> {
    let list = world.contacts();
    let i = world.particles().index(i)? as u32;
    match partner {
        Partner::Particle(j) => {
            let j = world.particles().index(*j)? as u32;
            list.pairs.binary_search(&[i.min(j), i.max(j)]).ok()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::setup::*;

    #[test]
    fn every_listed_column_has_a_value() {
        let particle = |x: f64| ParticleSetup {
            at: [x, 0.0],
            radius: 0.5,
            material: 0,
            velocity: [0.3, 0.1],
            spin: 0.2,
            angle: 0.0,
            force: [0.0; 2],
            fixed: [false; 3],
        };
        let wall = WallSetup {
            name: "floor".into(),
            material: 0,
            point: [0.0, -0.49],
            direction: [1.0, 0.0],
            h1: -2.0,
            h2: 2.0,
            velocity: [0.0; 2],
            angular_velocity: 0.0,
            about: [0.0, -0.49],
        };
        let setup = Setup {
            body: Body::Disc,
            law: LawChoice::linear(),
            normal: NormalForm::Total,
            unloading: Unloading::Rescale,
            nodes: 16,
            time_step: TimeStepChoice::Critical,
            frac: 0.1,
            frac_auto: None,
            rotation: true,
            gravity: Some(Gravity::Uniform([0.0, -1.0])),
            damping: Damping {
                contact: Dashpot::Fraction(0.1),
                ..Damping::default()
            },
            materials: vec![Material {
                name: "m".into(),
                density: 1.0,
                young: None,
                poisson: None,
                friction: 0.5,
                cohesion: 0.0,
                normal_stiffness: Some(1e3),
                shear_stiffness: Some(1e3),
                rolling_friction: 0.0,
                rigid: false,
            }],
            pairs: vec![],
            particles: vec![particle(0.0), particle(0.99)],
            walls: vec![wall],
            tol: None,
            fracc_every: 1,
            overlap_allowed: false,
            ledger: true,
        };
        let mut world = World::build(setup, 1).unwrap();
        for _ in 0..3 {
            world.cycle().unwrap();
        }
        let sample = Sample::of(&mut world);
        let families = [
            ("", COLUMNS),
            ("wall:floor:", WALL_COLUMNS),
            ("contact:1-2:", CONTACT_COLUMNS),
            ("contact:1-floor:", CONTACT_COLUMNS),
            ("particle:2:", PARTICLE_COLUMNS),
        ];
        for (prefix, list) in families {
            for card in list.iter().filter(|card| card.name != "state_hash") {
                let column = Column::parse(&format!("{prefix}{}", card.name)).unwrap();
                assert!(sample.value(&column).is_finite(), "{}", column.name());
            }
        }
    }
}
