//! `wall`: moves, adds or removes a wall.

use crate::language::command::{Command, vector};
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "wall",
    aliases: &[],
    usage: "wall NAME velocity VX VY | spin W | from X Y to X Y [material M] | delete",
    summary: "moves, adds or removes a wall",
    detail: "Walls are kinematic: they move as told, whatever pushes them. Velocity in m/s, spin in \
             rad/s about the wall's turning point. `from ... to` adds a wall between two points in \
             m; without a material it takes the first of the scene.",
    examples: &[
        "wall left velocity 0.05 0",
        "wall floor spin 0.2",
        "wall step from -0.01 0.02 to 0.01 0.02 material steel",
        "wall step delete",
    ],
    parse,
    changes_world: true,
};

/// What to do with a wall.
#[derive(Debug, Clone, PartialEq)]
pub enum WallChange {
    /// Velocity [m/s].
    Velocity([f64; 2]),
    /// Angular velocity about the turning point [rad/s].
    Spin(f64),
    /// A new wall between two points.
    Create {
        /// Where it begins [m].
        from: [f64; 2],
        /// Where it ends [m].
        to: [f64; 2],
        /// Name of the material; `None`: the first of the scene.
        material: Option<String>,
    },
    /// Removes it.
    Delete,
}

type Reader = fn(&mut Words<'_>) -> Result<WallChange, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let name = words.wall()?;
    let change = words.choose::<Reader>(&[
        ("velocity", |w| {
            w.vector("the velocity").map(WallChange::Velocity)
        }),
        ("spin", |w| w.number("the spin").map(WallChange::Spin)),
        ("from", between),
        ("delete", |_| Ok(WallChange::Delete)),
    ])?(words)?;
    Ok(Command::Wall(name, change))
}

fn between(words: &mut Words<'_>) -> Result<WallChange, Mistake> {
    let from = words.vector("the first end")?;
    words.keyword(&["to"])?;
    let begin = words.position();
    let to = words.vector("the other end")?;
    if from == to {
        return Err(Mistake::new(
            "the wall begins and ends at the same point",
            "walls have a length",
            begin..words.position(),
        ));
    }
    let material = match words.optional_keyword(&["material"])? {
        Some(_) => Some(words.material()?),
        None => None,
    };
    Ok(WallChange::Create { from, to, material })
}

impl fmt::Display for WallChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Velocity(v) => write!(f, "velocity {}", vector(*v)),
            Self::Spin(w) => write!(f, "spin {}", number::format(*w)),
            Self::Create { from, to, material } => {
                write!(f, "from {} to {}", vector(*from), vector(*to))?;
                match material {
                    Some(material) => write!(f, " material {}", quoted(material)),
                    None => Ok(()),
                }
            }
            Self::Delete => f.write_str("delete"),
        }
    }
}
