//! PRINT TYPES: the materials, and what their pairs make of them.

use super::super::figure::figure;
use super::layout::{Table, name, number, optional, words};
use crate::engine::World;
use crate::engine::pair::Pair;
use crate::engine::setup::Dashpot;

/// The tables.
pub(super) fn lines(world: &World) -> Vec<String> {
    let mut lines = properties(world);
    lines.push(String::new());
    let pairs = pairs(world);
    if pairs.is_empty() {
        lines.push("no pair of materials can meet".into());
    } else {
        lines.push("pairs that can meet, as contacts use them".into());
        lines.extend(pairs.lines());
    }
    lines
}

fn properties(world: &World) -> Vec<String> {
    let mut table = Table::new(
        1,
        &[
            words("type"),
            number("density", "kg/m3"),
            number("k_n", "N/m"),
            number("k_s", "N/m"),
            number("friction", "-"),
            number("cohesion", "N"),
            number("young", "Pa"),
            number("poisson", "-"),
            words("rigid"),
        ],
    );
    for material in &world.model().materials {
        table.row(vec![
            name(&material.name),
            figure(material.density),
            optional(material.normal_stiffness),
            optional(material.shear_stiffness),
            figure(material.friction),
            figure(material.cohesion),
            optional(material.young),
            optional(material.poisson),
            if material.rigid { "rigid" } else { "" }.to_owned(),
        ]);
    }
    table.lines()
}

fn pairs(world: &World) -> Table {
    let mut table = Table::new(
        2,
        &[
            words("type"),
            words("with"),
            number("k_n", "N/m"),
            number("k_s", "N/m"),
            number("mu", "-"),
            number("cohesion", "N"),
            words("dashpot"),
        ],
    );
    let materials = &world.model().materials;
    let count = materials.len();
    let particles: Vec<usize> = (0..count)
        .filter(|&m| {
            world
                .particles()
                .material
                .iter()
                .any(|&of| of as usize == m)
        })
        .collect();
    let walls: Vec<usize> = (0..count)
        .filter(|&m| world.walls().iter().any(|wall| wall.material == m))
        .collect();
    let mut row = |a: usize, with: String, pair: &Pair| {
        table.row(vec![
            name(&materials[a].name),
            with,
            figure(pair.normal_stiffness),
            figure(pair.shear_stiffness),
            figure(pair.friction),
            figure(pair.cohesion),
            dashpots(pair),
        ]);
    };
    for &a in &particles {
        for &b in particles.iter().filter(|&&b| b >= a) {
            let with = name(&materials[b].name);
            row(a, with, world.pair_table().get(a, b, false));
        }
        for &b in &walls {
            let with = format!("wall of {}", name(&materials[b].name));
            row(a, with, world.pair_table().get(a, b, true));
        }
    }
    table
}

/// The dashpots of a pair in few words.
pub(in crate::session) fn dashpots(pair: &Pair) -> String {
    let normal = match pair.dashpot {
        Dashpot::None => "none".to_owned(),
        Dashpot::Fraction(b) => format!("{} critical", figure(b)),
        Dashpot::Beta(beta) => format!("beta {} s", figure(beta)),
        Dashpot::Restitution(e) => format!("restitution {}", figure(e)),
    };
    let [b, beta] = [pair.fraction[1], pair.beta[1]];
    if beta > 0.0 && beta == pair.beta[0] || b == pair.fraction[0] {
        normal
    } else {
        format!("{normal}, tangential {}", figure(b))
    }
}
