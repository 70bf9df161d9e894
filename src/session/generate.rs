//! `generate`: particles at random in a world as it is.

use super::Refusal;
use super::change::material;
use super::figure::figure;
use crate::engine::World;
use crate::engine::setup::{ParticleSetup, WallSetup};
use crate::language::command::{Generate, MOST_GENERATED, Place};
use crate::scene::{Around, places};

/// Adds them; says which.
pub(super) fn generate(world: &mut World, seed: u64, new: &Generate) -> Result<String, Refusal> {
    let material = material(world, new.material.as_ref())?;
    if new.count.is_none() && new.most() > MOST_GENERATED {
        return Err(Refusal::new(
            format!("up to {} particles would fit", new.most()),
            format!("give a count of at most {MOST_GENERATED}"),
        ));
    }
    if !lies_in_cell(world, new.place) {
        return Err(Refusal::new(
            "the region reaches out of the periodic cell",
            "choose a circle or rectangle whose corners lie inside",
        ));
    }
    let radius = new.radius;
    let places = places(new, &around(world), seed, world.moment());
    let particle = |at: &[f64; 2]| ParticleSetup {
        at: *at,
        radius,
        material,
        velocity: [0.0; 2],
        spin: 0.0,
        angle: 0.0,
        force: [0.0; 2],
        fixed: [false; 3],
    };
    let particles: Vec<ParticleSetup> = places.iter().map(particle).collect();
    if particles.is_empty() {
        return Err(Refusal::new(
            format!(
                "there is no room for a particle of radius {} m",
                figure(radius)
            ),
            "choose a smaller radius or a larger region",
        ));
    }
    let first = world.create_all(&particles);
    let last = first + particles.len() as u32 - 1;
    let short = new.count.map_or(0, |count| count - particles.len() as u64);
    let which = if first == last {
        format!("particle {first}")
    } else {
        format!("particles {first} to {last}")
    };
    Ok(match short {
        0 => which,
        short => format!("{which}; no room for {short} more"),
    })
}

/// Whether new particles cannot meet images of each other: their region lies in the cell.
fn lies_in_cell(world: &World, place: Place) -> bool {
    let Some(cell) = world.cell() else {
        return true;
    };
    let [min, max] = match place {
        Place::Circle { centre, radius } => {
            [centre.map(|x| x - radius), centre.map(|x| x + radius)]
        }
        Place::Rectangle { min, max } => [min, max],
    };
    let origin = world.origin();
    let corners = [min, max, [min[0], max[1]], [max[0], min[1]]];
    corners.iter().all(|x| {
        let inner = [x[0] - origin[0], x[1] - origin[1]];
        // Rounding of a region that is the cell itself.
        cell.fractions(inner)
            .iter()
            .all(|f| (-1e-9..=1.0 + 1e-9).contains(f))
    })
}

/// What there is to keep clear of, in the coordinates of the preset; with the images around a cell.
fn around(world: &World) -> Around {
    let (particles, origin) = (world.particles(), world.origin());
    let images = |p: usize| -> Vec<[f64; 2]> {
        let Some(cell) = world.cell() else {
            return vec![world.position(p)];
        };
        let images = cell.images(particles.row[p].x, 1);
        images
            .map(|(_, x)| [x[0] + origin[0], x[1] + origin[1]])
            .collect()
    };
    let discs = |p: usize| {
        let radius = particles.row[p].radius;
        images(p).into_iter().map(move |at| (at, radius))
    };
    let wall = |wall: &crate::engine::wall::Wall| WallSetup {
        name: wall.name.clone(),
        material: wall.material,
        point: [wall.point[0] + origin[0], wall.point[1] + origin[1]],
        direction: wall.direction,
        h1: wall.h1,
        h2: wall.h2,
        velocity: [0.0; 2],
        angular_velocity: 0.0,
        about: [0.0; 2],
    };
    Around {
        discs: (0..particles.len()).flat_map(discs).collect(),
        walls: world.walls().iter().map(wall).collect(),
    }
}
