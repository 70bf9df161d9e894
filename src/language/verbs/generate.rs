//! `generate`: adds particles at random without contacts.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::place::Place;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "generate",
    aliases: &[],
    usage: "generate in circle X Y R|rectangle X1 Y1 X2 Y2 radius R [count N] [material M]",
    summary: "adds particles at random without contacts",
    detail: "Lengths in m. They lie wholly inside, clear of walls and of other particles, each as \
             likely anywhere it fits. Without a count as many come as fit, without a material they \
             take the first of the scene. Places follow from the seed of the preset, the cycle and \
             the next number, so that a replay gives the same.",
    examples: &[
        "generate in circle 0 0 0.02 radius 1e-3",
        "generate in rectangle 0 0 0.1 0.05 radius 5e-4 count 200 material glass",
    ],
    parse,
    changes_world: true,
};

/// Particles to add.
#[derive(Debug, Clone, PartialEq)]
pub struct Generate {
    /// Where.
    pub place: Place,
    /// Radius [m].
    pub radius: f64,
    /// How many; `None`: as many as fit.
    pub count: Option<u64>,
    /// Name of the material; `None`: the first of the scene.
    pub material: Option<String>,
}

/// Most particles that are generated at once.
pub const MOST_GENERATED: u64 = 10_000_000;

impl Generate {
    /// More than can fit: each disc takes at least 2√3 R², but for those at the border.
    pub fn most(&self) -> u64 {
        let area = match self.place {
            Place::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
            Place::Rectangle { min, max } => (max[0] - min[0]) * (max[1] - min[1]),
        };
        let fit = (area / (3.0 * self.radius * self.radius)) as u64;
        self.count.unwrap_or(u64::MAX).min(fit.saturating_add(8))
    }
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.keyword(&["in"])?;
    let place = Place::parse(words)?;
    words.keyword(&["radius"])?;
    let mut generate = Generate {
        place,
        radius: words.positive("the radius")?,
        count: None,
        material: None,
    };
    let mut left = vec!["count", "material"];
    while let Some(option) = words.next_option(&mut left)? {
        match option {
            "count" => generate.count = Some(words.count_up_to("the count", MOST_GENERATED)?),
            _ => generate.material = Some(words.material()?),
        }
    }
    Ok(Command::Generate(generate))
}

impl fmt::Display for Generate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let radius = number::format(self.radius);
        write!(f, "in {} radius {radius}", self.place)?;
        if let Some(count) = self.count {
            write!(f, " count {count}")?;
        }
        match &self.material {
            Some(material) => write!(f, " material {}", quoted(material)),
            None => Ok(()),
        }
    }
}
