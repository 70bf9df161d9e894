//! `strain`, `continuum` and `stress`: tensors that are imposed.

use std::fmt;

use crate::engine::boundary::Tensor;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number::format as number;
use crate::language::words::Words;

/// Row of `strain` in the list.
pub const CARD: Card = Card {
    name: "strain",
    aliases: &[],
    usage: "strain rate E11 E12 E21 E22 [over N]",
    summary: "imposes a strain rate by the boundary",
    detail: "In 1/s, compression positive; the first index belongs to the velocity. Over N cycles it is \
             reached linearly. A ring or walls move accordingly; in a periodic cell everything drifts. A \
             ring that carried a stress is held again.",
    examples: &[
        "strain rate 0.1 0 0 0.1",
        "strain rate -0.04 0 0 0.04 over 10000",
    ],
    parse: |words| {
        words.keyword(&["rate"])?;
        imposed(words).map(Command::Strain)
    },
    changes_world: true,
};

/// Row of `continuum` in the list.
pub const CONTINUUM: Card = Card {
    name: "continuum",
    aliases: &[],
    usage: "continuum E11 E12 E21 E22 [over N] | boundary | none",
    summary: "lets every particle drift with a strain rate",
    detail: "In 1/s, compression positive, beside whatever the boundary does; `boundary` takes the rate \
             that the boundary imposes, a servo's share included. Velocities are then what a particle \
             does besides, and con1 damps these alone.",
    examples: &[
        "continuum boundary",
        "continuum 0.1 0 0 0.1",
        "continuum none",
    ],
    parse: |words| {
        if words.is_at_number() {
            return imposed(words).map(|imposed| Command::Continuum(Continuum::Rate(imposed)));
        }
        words
            .choose(&[("boundary", Continuum::Boundary), ("none", Continuum::Off)])
            .map(Command::Continuum)
    },
    changes_world: true,
};

/// Row of `stress` in the list.
pub const STRESS: Card = Card {
    name: "stress",
    aliases: &[],
    usage: "stress S11 S12 S21 S22 [over N]",
    summary: "imposes a stress by the boundary",
    detail: "In Pa, compression positive. The particles of a ring are let go and each carries its share \
             as a force; walls and cells are steered by a servo. Over N cycles it is reached linearly. \
             `strain rate` ends it.",
    examples: &["stress 1e5 0 0 1e5", "stress 1.2e5 0 0 8e4 over 20000"],
    parse: |words| imposed(words).map(Command::Stress),
    changes_world: true,
};

/// A tensor and over how many cycles it is reached.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Imposed {
    /// The tensor.
    pub tensor: Tensor,
    /// Cycles; 0: at once.
    pub over: u64,
}

/// What carries every particle along.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Continuum {
    /// Nothing.
    Off,
    /// Whatever the boundary imposes.
    Boundary,
    /// A strain rate [1/s].
    Rate(Imposed),
}

impl fmt::Display for Continuum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Off => f.write_str("none"),
            Self::Boundary => f.write_str("boundary"),
            Self::Rate(imposed) => imposed.fmt(f),
        }
    }
}

fn imposed(words: &mut Words<'_>) -> Result<Imposed, Mistake> {
    let one = [words.number("component 11")?, words.number("component 12")?];
    let two = [words.number("component 21")?, words.number("component 22")?];
    let over = match words.optional_keyword(&["over"])? {
        Some(_) => words.count("the number of cycles")?,
        None => 0,
    };
    Ok(Imposed {
        tensor: [one, two],
        over,
    })
}

impl fmt::Display for Imposed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all = self.tensor.as_flattened().iter().map(|x| number(*x));
        f.write_str(&all.collect::<Vec<_>>().join(" "))?;
        if self.over > 0 {
            write!(f, " over {}", self.over)?;
        }
        Ok(())
    }
}
