//! PRINT WALLS: where they stand, how they move, what the particles do to them.

use super::super::figure::figure;
use super::layout::{Table, name, number, optional, words};
use crate::engine::World;
use crate::measure::wall_force::WallForce;

/// The tables.
pub(super) fn lines(world: &World) -> Vec<String> {
    if world.walls().is_empty() {
        return vec!["there are no walls".into()];
    }
    let mut lines = place(world);
    lines.push(String::new());
    lines.push("force of the particles on the wall, moment about its turning point".into());
    lines.extend(force(world));
    lines
}

fn place(world: &World) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            words("wall"),
            number("x1", "m"),
            number("y1", "m"),
            number("x2", "m"),
            number("y2", "m"),
            number("vx", "m/s"),
            number("vy", "m/s"),
        ],
    );
    let origin = world.origin();
    for wall in world.walls() {
        let mut row = vec![name(&wall.name)];
        for (end, h) in [wall.h1, wall.h2].into_iter().enumerate() {
            for (axis, shift) in origin.iter().enumerate() {
                // An infinite stretch along one axis says nothing about the other.
                let run = if wall.direction[axis] == 0.0 {
                    wall.point[axis]
                } else if h.is_finite() {
                    wall.end(end)[axis]
                } else {
                    h * wall.direction[axis]
                };
                row.push(figure(run + shift));
            }
        }
        row.extend(wall.velocity.map(figure));
        table.row(row);
    }
    table.lines()
}

fn force(world: &World) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            words("wall"),
            number("f1", "N"),
            number("f2", "N"),
            number("moment", "N m"),
            number("eccentricity", "-"),
            number("spin", "rad/s"),
            number("turned", "rad"),
        ],
    );
    for (w, wall) in world.walls().iter().enumerate() {
        let on = WallForce::of(world, w);
        table.row(vec![
            name(&wall.name),
            figure(on.force[0]),
            figure(on.force[1]),
            figure(on.moment),
            optional(Some(on.eccentricity).filter(|e| e.is_finite())),
            figure(wall.spin),
            figure(wall.angle),
        ]);
    }
    table.lines()
}
