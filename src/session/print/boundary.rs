//! PRINT BOUNDARY: particles whose motion is prescribed, and the walls.

use super::super::figure::figure;
use super::layout::{Table, number, words};
use super::{balls, walls};
use crate::engine::World;
use crate::measure::load::load;

/// The tables.
pub(super) fn lines(world: &World) -> Vec<String> {
    let particles = particles(world);
    if particles.is_empty() && world.walls().is_empty() {
        return vec!["no particle has a prescribed motion, and there are no walls".into()];
    }
    let mut lines = if particles.is_empty() {
        vec!["no particle has a prescribed motion".into()]
    } else {
        particles.lines()
    };
    lines.push(String::new());
    lines.extend(walls::lines(world));
    lines
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
