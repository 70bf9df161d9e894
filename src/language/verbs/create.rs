//! `create`: adds a particle.

use crate::language::command::{Command, vector};
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "create",
    aliases: &[],
    usage: "create at X Y radius R [material M] [velocity VX VY] [spin W]",
    summary: "adds a particle",
    detail: "Lengths in m, velocity in m/s, spin in rad/s, positive counter-clockwise. The particle \
             takes the next free number. Without a material it takes the first of the scene.",
    examples: &[
        "create at 0 0.01 radius 1e-3",
        "create at 0.002 0 radius 1e-3 material steel velocity 0 -1 spin 10",
    ],
    parse,
    changes_world: true,
};

/// A particle to add.
#[derive(Debug, Clone, PartialEq)]
pub struct Create {
    /// Centre [m].
    pub at: [f64; 2],
    /// Radius [m].
    pub radius: f64,
    /// Name of the material; `None`: the first of the scene.
    pub material: Option<String>,
    /// Velocity [m/s].
    pub velocity: [f64; 2],
    /// Spin [rad/s], positive counter-clockwise.
    pub spin: f64,
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.keyword(&["at"])?;
    let at = words.vector("the centre")?;
    words.keyword(&["radius"])?;
    let mut create = Create {
        at,
        radius: words.positive("the radius")?,
        material: None,
        velocity: [0.0; 2],
        spin: 0.0,
    };
    let mut left = vec!["material", "velocity", "spin"];
    while let Some(option) = words.next_option(&mut left)? {
        match option {
            "material" => create.material = Some(words.material()?),
            "velocity" => create.velocity = words.vector("the velocity")?,
            _ => create.spin = words.number("the spin")?,
        }
    }
    Ok(Command::Create(create))
}

impl fmt::Display for Create {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let radius = number::format(self.radius);
        write!(f, "at {} radius {radius}", vector(self.at))?;
        if let Some(material) = &self.material {
            write!(f, " material {}", quoted(material))?;
        }
        if self.velocity != [0.0; 2] {
            write!(f, " velocity {}", vector(self.velocity))?;
        }
        if self.spin != 0.0 {
            write!(f, " spin {}", number::format(self.spin))?;
        }
        Ok(())
    }
}
