//! PRINT BALLS: where the particles are, how they move, what acts on them.

use super::super::figure::figure;
use super::layout::{Table, number, words};
use crate::engine::World;
use crate::language::command::ParticleRange;
use crate::measure::load::load;
use crate::measure::reference::Reference;

/// Indices of the particles in a range; all without one.
pub(super) fn chosen(world: &World, range: Option<ParticleRange>) -> Vec<usize> {
    let ids = world.particles().id.iter().enumerate();
    ids.filter(|(_, id)| range.is_none_or(|range| range.contains(**id)))
        .map(|(p, _)| p)
        .collect()
}

/// What is said when there are none.
pub(super) fn none(range: Option<ParticleRange>) -> Vec<String> {
    vec![match range {
        None => "there are no particles".to_owned(),
        Some(range) => format!("there are no particles numbered {range}"),
    }]
}

/// What of its motion is prescribed, in words.
pub(in crate::session) fn prescribed(fixed: [bool; 3]) -> String {
    if fixed == [true; 3] {
        return "driven".into();
    }
    let names = ["x", "y", "spin"];
    let given = names.iter().zip(fixed).filter(|(_, fixed)| *fixed);
    let given: Vec<&str> = given.map(|(name, _)| *name).collect();
    given.join(" ")
}

/// The table.
pub(super) fn lines(
    world: &World,
    reference: &Reference,
    range: Option<ParticleRange>,
) -> Vec<String> {
    let chosen = chosen(world, range);
    if chosen.is_empty() {
        return none(range);
    }
    let mut lines = motion(world, &chosen);
    lines.push(String::new());
    lines.push(format!(
        "force with weight and applied force; displacement u since cycle {}",
        reference.cycle
    ));
    lines.extend(forces(world, reference, &chosen));
    lines
}

fn motion(world: &World, chosen: &[usize]) -> Vec<String> {
    let particles = world.particles();
    let mut table = Table::new(
        1,
        &[
            number("ball", ""),
            number("x", "m"),
            number("y", "m"),
            number("angle", "rad"),
            number("vx", "m/s"),
            number("vy", "m/s"),
            number("spin", "rad/s"),
            words("fixed"),
        ],
    );
    for &p in chosen {
        let (x, (v, spin)) = (world.position(p), world.velocity(p));
        let mut row = vec![particles.id[p].to_string()];
        row.extend([x[0], x[1], particles.row[p].angle, v[0], v[1], spin].map(figure));
        row.push(prescribed(particles.fixed[p]));
        table.row(row);
    }
    table.lines()
}

fn forces(world: &World, reference: &Reference, chosen: &[usize]) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            number("ball", ""),
            number("Fx", "N"),
            number("Fy", "N"),
            number("moment", "N m"),
            number("ux", "m"),
            number("uy", "m"),
            number("rotation", "rad"),
        ],
    );
    for &p in chosen {
        let id = world.particles().id[p];
        let (force, moment) = load(world, p);
        let mut row = vec![id.to_string()];
        row.extend([force[0], force[1], moment].map(figure));
        match reference.change(world, id) {
            Some((u, rotation)) => row.extend([u[0], u[1], rotation].map(figure)),
            None => row.extend(["new", "-", "-"].map(str::to_owned)),
        }
        table.row(row);
    }
    table.lines()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prescribed_motion_in_words() {
        assert_eq!(prescribed([false; 3]), "");
        assert_eq!(prescribed([true, false, true]), "x spin");
        assert_eq!(prescribed([true; 3]), "driven");
    }
}
