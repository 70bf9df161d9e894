//! PRINT BOUNDARY: what strain and stress are imposed by, particles whose motion is prescribed, and the
//! walls.

use super::super::figure::{figure, vector};
use super::layout::{Table, number, words};
use super::{balls, walls};
use crate::engine::World;
use crate::engine::boundary::{Boundary, Kind, Tensor};
use crate::measure::load::load;

/// The tables.
pub(super) fn lines(world: &World) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(boundary) = world.boundary() {
        lines.extend(imposed(world, boundary));
        lines.push(String::new());
    }
    if let Some(flow) = world.continuum() {
        lines.push(format!(
            "everything drifts with {} 1/s",
            tensor(flow.rate())
        ));
        lines.push(String::new());
    }
    let particles = particles(world);
    if particles.is_empty() && world.walls().is_empty() {
        lines.push("no particle has a prescribed motion, and there are no walls".into());
        return lines;
    }
    if particles.is_empty() {
        lines.push("no particle has a prescribed motion".into());
    } else {
        lines.extend(particles.lines());
    }
    lines.push(String::new());
    lines.extend(walls::lines(world));
    lines
}

/// What a boundary is, where and how large.
pub fn boundary_itself(world: &World, boundary: &Boundary) -> String {
    let origin = world.origin();
    let outer = |x: [f64; 2]| vector([x[0] + origin[0], x[1] + origin[1]]);
    match &boundary.kind {
        Kind::Ring(ring) => format!(
            "a ring of {} particles about {} m, {} m in radius before it was strained",
            ring.members.len(),
            outer(boundary.centre),
            figure(ring.radius)
        ),
        Kind::Walls => format!("the walls, about {} m", outer(boundary.centre)),
        Kind::Cell(cell) => format!(
            "a periodic cell at {} m with edges {} and {} m",
            outer(cell.corner),
            vector(cell.edges[0]),
            vector(cell.edges[1])
        ),
    }
}

fn imposed(world: &World, boundary: &Boundary) -> Vec<String> {
    let mut lines = vec![boundary_itself(world, boundary)];
    if let Kind::Ring(ring) = &boundary.kind
        && let Some(stress) = ring.stress()
    {
        lines.push(format!("carries the stress   {} Pa", tensor(stress)));
    } else {
        lines.push(format!(
            "strain rate          {} 1/s",
            tensor(boundary.straining.rate())
        ));
    }
    lines.push(format!(
        "strain imposed so far {}",
        tensor(boundary.straining.strain())
    ));
    lines
}

/// Components 11, 12, 21, 22.
fn tensor(tensor: Tensor) -> String {
    let all = tensor.as_flattened().iter().map(|x| figure(*x));
    all.collect::<Vec<_>>().join("  ")
}

/// Force and moment are those of contacts, weight and applied force: what holds the particle bears
/// them.
fn particles(world: &World) -> Table {
    let particles = world.particles();
    let mut table = Table::new(
        1,
        &[
            number("ball", ""),
            words("prescribed"),
            number("vx", "m/s"),
            number("vy", "m/s"),
            number("spin", "rad/s"),
            number("Fx", "N"),
            number("Fy", "N"),
            number("moment", "N m"),
        ],
    );
    for p in (0..particles.len()).filter(|&p| particles.fixed[p].contains(&true)) {
        let ((v, spin), (force, moment)) = (world.velocity(p), load(world, p));
        let mut row = vec![
            particles.id[p].to_string(),
            balls::prescribed(particles.fixed[p]),
        ];
        row.extend([v[0], v[1], spin, force[0], force[1], moment].map(figure));
        table.row(row);
    }
    table
}
