//! `particle`: moves, pushes, resizes, fixes or frees one particle.

use crate::language::command::{Command, vector};
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "particle",
    aliases: &[],
    usage: "particle I velocity VX VY | spin W | force FX FY | radius R | fix x|y|spin | free",
    summary: "moves, pushes, resizes, fixes or frees a particle",
    detail: "Velocity in m/s, spin in rad/s, applied force in N, radius in m: mass and \
             time step follow it. What is fixed keeps its velocity \
             whatever acts on it; several can be named at once. `free` lets all of them follow the \
             forces again.",
    examples: &[
        "particle 1 velocity 0 -0.5",
        "particle 1 spin 3.5",
        "particle 7 force 0 -12",
        "particle 7 radius 1.2e-3",
        "particle 7 fix x spin",
        "particle 7 free",
    ],
    parse,
    changes_world: true,
};

/// What to do with a particle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ParticleChange {
    /// Velocity [m/s].
    Velocity([f64; 2]),
    /// Spin [rad/s], positive counter-clockwise.
    Spin(f64),
    /// Applied force [N].
    Force([f64; 2]),
    /// Radius [m], above 0.
    Radius(f64),
    /// Which of velocity in x, velocity in y and spin to prescribe from now on; the others stay
    /// as they are.
    Fix([bool; 3]),
    /// Nothing is prescribed any more.
    Free,
}

const FIXED: [(&str, usize); 3] = [("x", 0), ("y", 1), ("spin", 2)];

type Reader = fn(&mut Words<'_>) -> Result<ParticleChange, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let id = words.particle()?;
    let change = words.choose::<Reader>(&[
        ("velocity", |w| {
            w.vector("the velocity").map(ParticleChange::Velocity)
        }),
        ("spin", |w| w.number("the spin").map(ParticleChange::Spin)),
        ("force", |w| {
            w.vector("the force").map(ParticleChange::Force)
        }),
        ("radius", |w| {
            w.positive("the radius").map(ParticleChange::Radius)
        }),
        ("fix", fix),
        ("free", |_| Ok(ParticleChange::Free)),
    ])?(words)?;
    Ok(Command::Particle(id, change))
}

fn fix(words: &mut Words<'_>) -> Result<ParticleChange, Mistake> {
    let mut fixed = [false; 3];
    loop {
        let which = words.choose(&FIXED)?;
        fixed[which] = true;
        if words.is_at_end() {
            return Ok(ParticleChange::Fix(fixed));
        }
    }
}

impl fmt::Display for ParticleChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Velocity(v) => write!(f, "velocity {}", vector(*v)),
            Self::Spin(w) => write!(f, "spin {}", number::format(*w)),
            Self::Force(force) => write!(f, "force {}", vector(*force)),
            Self::Radius(radius) => write!(f, "radius {}", number::format(*radius)),
            Self::Fix(fixed) => {
                f.write_str("fix")?;
                for (word, which) in FIXED {
                    if fixed[which] {
                        write!(f, " {word}")?;
                    }
                }
                Ok(())
            }
            Self::Free => f.write_str("free"),
        }
    }
}
