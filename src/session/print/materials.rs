//! PRINT TYPES: the materials, and what their pairs make of them.

use super::super::figure::figure;
use super::layout::{Head, Table, name, number, optional, words};
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
    let bonds = world.model().law.has_bonds();
    let mut columns = vec![
        words("type"),
        number("density", "kg/m3"),
        number("k_n", "N/m"),
        number("k_s", "N/m"),
        number("friction", "-"),
        number("cohesion", "N"),
    ];
    columns.extend(bonds.then(strengths).into_iter().flatten());
    columns.extend([
        number("young", "Pa"),
        number("poisson", "-"),
        words("rigid"),
    ]);
    let mut table = Table::new(1, &columns);
    for material in &world.model().materials {
        let mut cells = vec![
            name(&material.name),
            figure(material.density),
            optional(material.normal_stiffness),
            optional(material.shear_stiffness),
            figure(material.friction),
            figure(material.cohesion),
        ];
        if bonds {
            cells.extend([material.bond_tension, material.bond_shear].map(figure));
        }
        cells.extend([
            optional(material.young),
            optional(material.poisson),
            if material.rigid { "rigid" } else { "" }.to_owned(),
        ]);
        table.row(cells);
    }
    table.lines()
}

fn pairs(world: &World) -> Table {
    let bonds = world.model().law.has_bonds();
    let mut columns = vec![
        words("type"),
        words("with"),
        number("k_n", "N/m"),
        number("k_s", "N/m"),
        number("mu", "-"),
        number("cohesion", "N"),
    ];
    columns.extend(bonds.then(strengths).into_iter().flatten());
    columns.push(words("dashpot"));
    let mut table = Table::new(2, &columns);
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
        let mut cells = vec![
            name(&materials[a].name),
            with,
            figure(pair.normal_stiffness),
            figure(pair.shear_stiffness),
            figure(pair.friction),
            figure(pair.cohesion),
        ];
        if bonds {
            cells.extend([pair.bond_tension, pair.bond_shear].map(figure));
        }
        cells.push(dashpots(pair));
        table.row(cells);
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

/// What bonds bear, in tension and in shear.
fn strengths() -> [Head; 2] {
    [number("bond_tension", "N"), number("bond_shear", "N")]
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
