//! Commands that change the world.

use super::Refusal;
use super::figure::{figure, vector};
use super::print::prescribed;
use super::room::{cut, deepest};
use crate::engine::World;
use crate::engine::boundary::Kind;
use crate::engine::edit::Motion;
use crate::engine::pair::PairTable;
use crate::engine::setup::{
    Damping, Dashpot, Material, PairOverride, ParticleSetup, Setup, WallSetup,
};
use crate::language::Command;
use crate::language::command::{
    Bond, Continuum, Create, Damper, FrictionOf, Imposed, ParticleChange, ParticleRange, Property,
    WallChange,
};

/// Carries the change out and says what is so now.
pub(super) fn world(world: &mut World, command: &Command) -> Result<String, Refusal> {
    match command {
        Command::Create(new) => create(world, new),
        Command::Delete(range) => Ok(delete(world, *range)),
        Command::Wall(name, change) => wall(world, name, change),
        Command::Particle(id, change) => particle(world, *id, change),
        Command::Property(material, key, value) => property(world, material, *key, *value),
        Command::Bond(new) => bond(world, new),
        Command::Friction(value, of) => Ok(friction(world, *value, of)),
        Command::Frac(frac) => {
            world.set_frac(*frac);
            Ok(step(world))
        }
        Command::FracAuto(share) => {
            world.set_frac_auto(Some(*share));
            Ok(step(world))
        }
        Command::Damp(damper, value) => {
            world.set_damping(damping(world.model().damping, *damper, *value));
            Ok(format!("damping {damper} {}", figure(*value)))
        }
        Command::Con1(con1) => {
            world.set_damping(Damping {
                con1: *con1,
                ..world.model().damping
            });
            Ok(format!("con1 {}", figure(*con1)))
        }
        Command::Gravity(gravity) => {
            world.set_gravity(*gravity);
            Ok(match gravity {
                Some(_) => command.to_string(),
                None => "no gravity".into(),
            })
        }
        Command::Boundary(boundary) => {
            world.set_boundary(*boundary);
            Ok(boundary_line(world))
        }
        Command::Strain(Imposed { tensor, over }) => {
            world.set_strain_rate(*tensor, *over);
            Ok(command.to_string() + " 1/s")
        }
        Command::Continuum(continuum) => {
            match continuum {
                Continuum::Off => world.set_continuum(None, 0),
                Continuum::Boundary => world.carry_along(),
                Continuum::Rate(imposed) => {
                    world.set_continuum(Some(imposed.tensor), imposed.over);
                }
            }
            Ok(command.to_string())
        }
        Command::Rotation(on) => {
            world.set_rotation(*on);
            Ok(format!(
                "particles {}",
                if *on { "turn" } else { "do not turn" }
            ))
        }
        Command::Zero => {
            world.zero_velocities();
            Ok("all velocities are zero".into())
        }
        other => Err(Refusal::new(
            format!("`{other}` changes no world"),
            "this is a fault of the program, please report it",
        )),
    }
}

/// The material of new particles: the first one of the scene if none is named.
pub(super) fn material(world: &World, name: Option<&String>) -> Result<usize, Refusal> {
    let materials = &world.model().materials;
    let named = |name: &String| materials.iter().position(|m| m.name == *name);
    let material = name.and_then(named).unwrap_or(0);
    if materials[material].rigid {
        return Err(Refusal::new(
            format!("material {} is rigid", materials[material].name),
            "only walls can be: name another material",
        ));
    }
    Ok(material)
}

fn create(world: &mut World, new: &Create) -> Result<String, Refusal> {
    let material = material(world, new.material.as_ref())?;
    if !world.model().overlap_allowed
        && let Some((what, overlap)) = deepest(world, new.at, new.radius)
    {
        return Err(Refusal::new(
            format!("it would overlap {what} by {} m", figure(overlap)),
            "move it, or set model.overlap = \"allow\" in the preset",
        ));
    }
    let id = world.create(&ParticleSetup {
        at: new.at,
        radius: new.radius,
        material,
        velocity: new.velocity,
        spin: new.spin,
        angle: 0.0,
        force: [0.0; 2],
        fixed: [false; 3],
    });
    Ok(format!("particle {id}"))
}

fn delete(world: &mut World, range: ParticleRange) -> String {
    let ids = &world.particles().id;
    let stays: Vec<bool> = ids.iter().map(|id| !range.contains(*id)).collect();
    let gone = stays.iter().filter(|stays| !**stays).count();
    if gone > 0 {
        world.keep_only(&stays);
    }
    format!("{gone} deleted, {} left", world.particles().len())
}

fn wall(world: &mut World, name: &str, change: &WallChange) -> Result<String, Refusal> {
    if let WallChange::Create { from, to, material } = change {
        let d = [to[0] - from[0], to[1] - from[1]];
        let length = (d[0] * d[0] + d[1] * d[1]).sqrt();
        let material = material
            .as_ref()
            .and_then(|name| world.model().materials.iter().position(|m| m.name == *name))
            .unwrap_or(0);
        let wall = WallSetup {
            name: name.to_owned(),
            material,
            point: *from,
            direction: [d[0] / length, d[1] / length],
            h1: 0.0,
            h2: length,
            velocity: [0.0; 2],
            angular_velocity: 0.0,
            about: *from,
        };
        if !world.model().overlap_allowed
            && let Some(id) = cut(world, &wall)
        {
            return Err(Refusal::new(
                format!("it would cut into particle {id}"),
                "leave room for it, or set model.overlap = \"allow\" in the preset",
            ));
        }
        world.create_wall(&wall);
        return Ok(format!("wall {name}"));
    }
    let w = world.walls().iter().position(|wall| wall.name == name);
    let w = w.ok_or_else(|| Refusal::new(format!("there is no wall {name}"), "see print walls"))?;
    match change {
        WallChange::Velocity(v) => world.set_wall_velocity(w, *v),
        WallChange::Spin(spin) => world.set_wall_spin(w, *spin),
        WallChange::Delete => {
            world.delete_wall(w);
            return Ok(format!("wall {name} deleted"));
        }
        WallChange::Create { .. } | WallChange::Servo { .. } | WallChange::Force { .. } => {}
    }
    let wall = &world.walls()[w];
    Ok(format!(
        "wall {name}: velocity {} m/s, spin {} rad/s",
        vector(wall.velocity),
        figure(wall.spin)
    ))
}

fn particle(world: &mut World, id: u32, change: &ParticleChange) -> Result<String, Refusal> {
    let p = world
        .particles()
        .index(id)
        .ok_or_else(|| Refusal::new(format!("there is no particle {id}"), "see print balls"))?;
    match change {
        ParticleChange::Velocity(v) => world.set_motion(p, Motion::Velocity(*v)),
        ParticleChange::Spin(spin) => world.set_motion(p, Motion::Spin(*spin)),
        ParticleChange::Force(force) => world.set_force(p, *force),
        ParticleChange::Radius(radius) => {
            world.set_radius(p, *radius);
            let mass = world.particles().mass[p];
            return Ok(format!(
                "particle {id}: radius {} m, mass {} kg, dt = {:.6e} s",
                figure(*radius),
                figure(mass),
                world.dt()
            ));
        }
        ParticleChange::Fix(fix) => {
            let now = world.particles().fixed[p];
            world.set_fixed(p, [now[0] | fix[0], now[1] | fix[1], now[2] | fix[2]]);
        }
        ParticleChange::Free => world.set_fixed(p, [false; 3]),
    }
    world.settle();
    let (v, spin) = world.velocity(p);
    let body = world.particles().applied(p);
    let mut text = format!(
        "particle {id}: velocity {} m/s, spin {} rad/s",
        vector(v),
        figure(spin)
    );
    if body != [0.0; 2] {
        text.push_str(&[", force ", &vector(body), " N"].concat());
    }
    match prescribed(world.particles().fixed[p]).as_str() {
        "" => {}
        "driven" => text += ", driven",
        axes => text.push_str(&[", ", axes, " prescribed"].concat()),
    }
    Ok(text)
}

/// The step and how far it may go.
fn step(world: &World) -> String {
    let limit = world.frac_limit();
    let limit = if world.frac() > limit {
        let (frac, limit) = (figure(world.frac()), figure(limit));
        format!("unstable: frac {frac} is above its limit {limit}")
    } else if limit.is_finite() {
        format!("frac limit {}", figure(limit))
    } else {
        "no frac limit yet, nothing touches".into()
    };
    format!("dt = {} s, {limit}", figure(world.dt()))
}

fn property(
    world: &mut World,
    material: &str,
    key: Property,
    value: f64,
) -> Result<String, Refusal> {
    let law = world.model().law.card();
    if key == Property::Cohesion && value > 0.0 && !law.reads("cohesion") {
        return Err(Refusal::new(
            format!("the law {} knows no cohesion", law.name),
            "linear, bonded and hertz-mindlin do: set model.law in the preset",
        ));
    }
    if matches!(key, Property::BondTension | Property::BondShear) && value > 0.0 {
        check_bonds(world)?;
    }
    let change = |model: &mut Setup| {
        // A wall with friction of its own still is of its material otherwise.
        let of_wall = format!("{material}@");
        let is_meant = |m: &&mut Material| {
            m.name == material || key != Property::Friction && m.name.starts_with(&of_wall)
        };
        for m in model.materials.iter_mut().filter(is_meant) {
            match key {
                Property::Density => m.density = value,
                Property::Friction => m.friction = value,
                Property::Cohesion => m.cohesion = value,
                Property::BondTension => m.bond_tension = value,
                Property::BondShear => m.bond_shear = value,
                Property::RollingFriction => m.rolling_friction = value,
                Property::NormalStiffness => m.normal_stiffness = Some(value),
                Property::ShearStiffness => m.shear_stiffness = Some(value),
                Property::Young => m.young = Some(value),
                Property::Poisson => m.poisson = Some(value),
            }
        }
    };
    check_reach(world, change)?;
    world.change_materials(change);
    Ok(format!(
        "{material} {key} = {}, dt = {} s",
        figure(value),
        figure(world.dt())
    ))
}

fn check_bonds(world: &World) -> Result<(), Refusal> {
    let law = world.model().law;
    if law.has_bonds() {
        return Ok(());
    }
    Err(Refusal::new(
        format!("the law {} knows no bonds", law.card().name),
        "bonded does: set model.law in the preset",
    ))
}

/// Bonds that stretch by more than a radius would hold over particles between.
fn check_reach(world: &World, change: impl FnOnce(&mut Setup)) -> Result<(), Refusal> {
    let smallest = world.particles().smallest_radius();
    let mut model = world.model().clone();
    change(&mut model);
    let reach = PairTable::new(&model).bond_reach();
    if !model.law.has_bonds() || reach <= smallest {
        return Ok(());
    }
    Err(Refusal::new(
        format!(
            "a bond would stretch by {} m before it breaks",
            figure(reach)
        ),
        format!(
            "bond_tension / normal_stiffness may be the smallest radius, {} m, at most",
            figure(smallest)
        ),
    ))
}

fn bond(world: &mut World, bond: &Bond) -> Result<String, Refusal> {
    check_bonds(world)?;
    let inside = bond.place.map(|place| place.shape().members(world));
    let made = world.bond(bond.gap, |p| inside.as_ref().is_none_or(|inside| inside[p]));
    Ok(format!("{made} bonds made, {} hold", world.bonds()))
}

fn damping(now: Damping, damper: Damper, value: f64) -> Damping {
    match damper {
        Damper::Contact => Damping {
            contact: Dashpot::Fraction(value),
            ..now
        },
        Damper::Wall => Damping {
            wall: Some(Dashpot::Fraction(value)),
            ..now
        },
        Damper::Tangential => Damping {
            tangential: Some(value),
            ..now
        },
        Damper::Beta => Damping {
            contact: Dashpot::Beta(value),
            ..now
        },
        Damper::Restitution => Damping {
            contact: Dashpot::Restitution(value),
            ..now
        },
        Damper::Overlap => Damping {
            overlap_critical: (value > 0.0).then_some(value),
            ..now
        },
        Damper::Global => Damping {
            global: value,
            ..now
        },
        Damper::Local => Damping {
            local: value,
            ..now
        },
    }
}

fn friction(world: &mut World, value: f64, of: &FrictionOf) -> String {
    let name = match of {
        FrictionOf::Everything => {
            world.change_materials(|model| {
                model.materials.iter_mut().for_each(|m| m.friction = value);
                model.pairs.iter_mut().for_each(|pair| pair.friction = None);
            });
            "everywhere".to_owned()
        }
        FrictionOf::Material(name) => {
            world.change_materials(|model| {
                model
                    .materials
                    .iter_mut()
                    .filter(|m| m.name == *name)
                    .for_each(|m| m.friction = value);
            });
            format!("of {name}")
        }
        FrictionOf::Pair(a, b) => {
            world.change_materials(|model| {
                let find = |name: &str| model.materials.iter().position(|m| m.name == name);
                if let (Some(a), Some(b)) = (find(a), find(b)) {
                    pair_friction(model, [a, b], value);
                }
            });
            format!("between {a} and {b}")
        }
        FrictionOf::Wall(name) => {
            world.set_wall_friction(name, value);
            format!("on wall {name}")
        }
    };
    format!("friction {} {name}", figure(value))
}

fn pair_friction(model: &mut Setup, materials: [usize; 2], value: f64) {
    let [a, b] = materials;
    let known = model
        .pairs
        .iter_mut()
        .rfind(|p| p.materials == [a, b] || p.materials == [b, a]);
    match known {
        Some(pair) => pair.friction = Some(value),
        None => model.pairs.push(PairOverride {
            materials,
            friction: Some(value),
            rolling_friction: None,
            cohesion: None,
            bond_tension: None,
            bond_shear: None,
            restitution: None,
            normal_stiffness: None,
            shear_stiffness: None,
        }),
    }
}

fn boundary_line(world: &World) -> String {
    match world.boundary().map(|boundary| &boundary.kind) {
        None => "no boundary".into(),
        Some(Kind::Ring(ring)) => format!("{} boundary particles", ring.members.len()),
        Some(Kind::Walls) => "the walls are the boundary".into(),
        Some(Kind::Cell(cell)) => format!("a periodic cell of {} m2", figure(cell.area())),
    }
}
