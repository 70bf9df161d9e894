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
    usage: "wall NAME velocity VX VY | spin W | servo FN [over N] [gain G] | force FX FY [gain G] | from X Y to X Y [material M] | delete",
    summary: "moves, adds or removes a wall",
    detail: "Walls are kinematic: they move as told, whatever pushes them. Velocity in m/s, spin in \
             rad/s about the wall's turning point. `servo` moves the wall along its normal until the \
             particles press on it with FN newtons, reached linearly over N cycles; `force` until they \
             hold a force that is applied to it. Gain 1 suits most assemblies with dashpots or \
             friction, and less those without any, which a servo sets swinging; more is faster, up to where \
             the looks every 10 cycles are the limit. `velocity` ends both. `from ... to` adds a wall \
             between two points in m; without a material it takes the first of the scene.",
    examples: &[
        "wall left velocity 0.05 0",
        "wall floor spin 0.2",
        "wall lid servo 25 over 1000",
        "wall lid force 0 -25",
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
    /// Moves along its normal until the particles press on it like this.
    Servo {
        /// Normal force [N].
        force: f64,
        /// Cycles in which it is reached; 0: at once.
        over: u64,
        /// Gain.
        gain: f64,
    },
    /// Moves until the particles hold a force that is applied to it.
    Force {
        /// The force [N].
        force: [f64; 2],
        /// Gain.
        gain: f64,
    },
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
        ("servo", servo),
        ("force", force),
        ("from", between),
        ("delete", |_| Ok(WallChange::Delete)),
    ])?(words)?;
    Ok(Command::Wall(name, change))
}

fn servo(words: &mut Words<'_>) -> Result<WallChange, Mistake> {
    let force = words.not_negative("the normal force")?;
    let (mut over, mut gain) = (0, 1.0);
    let mut left = vec!["over", "gain"];
    while let Some(option) = words.next_option(&mut left)? {
        match option {
            "over" => over = words.count("the number of cycles")?,
            _ => gain = words.positive("the gain")?,
        }
    }
    Ok(WallChange::Servo { force, over, gain })
}

fn force(words: &mut Words<'_>) -> Result<WallChange, Mistake> {
    let force = words.vector("the force")?;
    let gain = match words.optional_keyword(&["gain"])? {
        Some(_) => words.positive("the gain")?,
        None => 1.0,
    };
    Ok(WallChange::Force { force, gain })
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
            Self::Servo { force, over, gain } => {
                write!(f, "servo {}", number::format(*force))?;
                if *over > 0 {
                    write!(f, " over {over}")?;
                }
                write_gain(f, *gain)
            }
            Self::Force { force, gain } => {
                write!(f, "force {}", vector(*force))?;
                write_gain(f, *gain)
            }
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

fn write_gain(f: &mut fmt::Formatter<'_>, gain: f64) -> fmt::Result {
    if gain == 1.0 {
        return Ok(());
    }
    write!(f, " gain {}", number::format(gain))
}
