//! PRINT POLYGON: the forces on a particle, head to tail.

use crate::engine::World;
use crate::measure::polygon::ForcePolygon;
use crate::session::figure::{figure, vector};
use crate::session::print::layout::{Table, name, number, words};

/// The table.
pub(in crate::session::print) fn lines(world: &World, id: u32) -> Vec<String> {
    let Some(p) = world.particles().index(id) else {
        return vec![format!("there is no particle {id}")];
    };
    let polygon = ForcePolygon::of(world, p);
    let mut table = Table::new(
        1,
        &[
            words("by"),
            number("at", "deg"),
            number("Fx", "N"),
            number("Fy", "N"),
            number("sum x", "N"),
            number("sum y", "N"),
        ],
    );
    let corners = polygon.corners();
    let (body, sides) = (polygon.body, polygon.sides.iter());
    let sides = sides.map(|side| (name(&side.by), figure(side.direction), side.force));
    let body = ("weight, applied".to_owned(), String::new(), body);
    for ((by, at, force), sum) in sides.chain([body]).zip(&corners[1..]) {
        let mut cells = vec![by, at];
        cells.extend([force[0], force[1], sum[0], sum[1]].map(figure));
        table.row(cells);
    }
    let mut lines = vec![format!(
        "forces on ball {id}, counter-clockwise from direction 1"
    )];
    lines.extend(table.lines());
    lines.push(format!(
        "out of balance {} N, size {} N",
        vector(polygon.gap()),
        figure(polygon.residual())
    ));
    lines
}
