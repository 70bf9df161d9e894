//! Whether there is room for something new.

use crate::engine::World;
use crate::engine::setup::WallSetup;
use crate::engine::wall::Wall;
use crate::engine::wall_contact;

/// Largest overlap of something new, as a fraction of the smaller radius.
const ACCEPTED: f64 = 0.05;

/// What a new particle would overlap most in terms of the smaller radius, more than is accepted, and
/// by how much [m].
pub(super) fn deepest(world: &World, at: [f64; 2], radius: f64) -> Option<(String, f64)> {
    let (particles, origin, cell) = (world.particles(), world.origin(), world.cell());
    let at = [at[0] - origin[0], at[1] - origin[1]];
    // In a cell it is there many times.
    let places: Vec<[f64; 2]> = match cell {
        Some(cell) => cell.images(at, 1).map(|(_, x)| x).collect(),
        None => vec![at],
    };
    let nearest = |x: [f64; 2], places: &[[f64; 2]]| {
        let squares = places.iter().map(|at| {
            let d = [x[0] - at[0], x[1] - at[1]];
            d[0] * d[0] + d[1] * d[1]
        });
        squares.fold(f64::INFINITY, f64::min).sqrt()
    };
    let with_particles = particles.row.iter().zip(&particles.id).map(|(row, id)| {
        let x = cell.map_or(row.x, |cell| cell.home(row.x));
        let overlap = radius + row.radius - nearest(x, &places);
        (
            overlap / radius.min(row.radius),
            overlap,
            Met::Particle(*id),
        )
    });
    let with_walls = world.walls().iter().map(|wall| {
        let overlap = radius - wall_contact::distance(wall, at);
        (overlap / radius, overlap, Met::Wall(&wall.name))
    });
    // The one in the middle is itself.
    let (before, after) = places.split_at(places.len() / 2);
    let own = [before, &after[1..]].concat();
    let overlap = 2.0 * radius - nearest(after[0], &own);
    let with_itself = std::iter::once((overlap / radius, overlap, Met::Itself));
    let worst = with_particles
        .chain(with_walls)
        .chain(with_itself)
        .max_by(|a, b| a.0.total_cmp(&b.0))?;
    let name = match worst.2 {
        Met::Particle(id) => format!("particle {id}"),
        Met::Wall(name) => format!("wall {name}"),
        Met::Itself => "itself across the cell".into(),
    };
    (worst.0 > ACCEPTED).then_some((name, worst.1))
}

/// What a new particle may overlap.
enum Met<'a> {
    Particle(u32),
    Wall(&'a str),
    Itself,
}

/// The first particle that a new wall would overlap more than is accepted.
pub(super) fn cut(world: &World, wall: &WallSetup) -> Option<u32> {
    let wall = Wall::new(wall, world.origin());
    let particles = world.particles();
    (0..particles.len())
        .find(|&p| {
            let row = &particles.row[p];
            row.radius - wall_contact::distance(&wall, row.x) > ACCEPTED * row.radius
        })
        .map(|p| particles.id[p])
}
