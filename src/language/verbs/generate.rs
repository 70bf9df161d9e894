//! `generate`: adds particles at random without contacts.

use crate::language::command::{Command, vector};
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::words::{Words, quoted};
use crate::measure::region::Shape;
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
    pub place: GeneratePlace,
    /// Radius [m].
    pub radius: f64,
    /// How many; `None`: as many as fit.
    pub count: Option<u64>,
    /// Name of the material; `None`: the first of the scene.
    pub material: Option<String>,
}

/// A part of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GeneratePlace {
    /// A circle.
    Circle {
        /// Its centre [m].
        centre: [f64; 2],
        /// Its radius [m].
        radius: f64,
    },
    /// A rectangle along the axes.
    Rectangle {
        /// Lower left corner [m].
        min: [f64; 2],
        /// Upper right corner [m].
        max: [f64; 2],
    },
}

/// Most particles that are generated at once.
pub const MOST_GENERATED: u64 = 10_000_000;

impl Generate {
    /// More than can fit: each disc takes at least 2√3 R², but for those at the border.
    pub fn most(&self) -> u64 {
        let area = match self.place {
            GeneratePlace::Circle { radius, .. } => std::f64::consts::PI * radius * radius,
            GeneratePlace::Rectangle { min, max } => (max[0] - min[0]) * (max[1] - min[1]),
        };
        let fit = (area / (3.0 * self.radius * self.radius)) as u64;
        self.count.unwrap_or(u64::MAX).min(fit.saturating_add(8))
    }
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    words.keyword(&["in"])?;
    let place = place(words)?;
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

/// A circle or a rectangle.
pub(super) fn place(words: &mut Words<'_>) -> Result<GeneratePlace, Mistake> {
    if words.keyword(&["circle", "rectangle"])? == "circle" {
        Ok(GeneratePlace::Circle {
            centre: words.vector("the centre")?,
            radius: words.positive("the radius of the circle")?,
        })
    } else {
        rectangle(words)
    }
}

fn rectangle(words: &mut Words<'_>) -> Result<GeneratePlace, Mistake> {
    let a = words.vector("one corner")?;
    let begin = words.position();
    let b = words.vector("the opposite corner")?;
    let min = [a[0].min(b[0]), a[1].min(b[1])];
    let max = [a[0].max(b[0]), a[1].max(b[1])];
    if min[0] == max[0] || min[1] == max[1] {
        return Err(Mistake::new(
            "the rectangle has no area",
            "give two opposite corners",
            begin..words.position(),
        ));
    }
    Ok(GeneratePlace::Rectangle { min, max })
}

impl GeneratePlace {
    /// The same place as a region that particles are in or not.
    pub fn shape(self) -> Shape {
        match self {
            Self::Circle { centre, radius } => Shape::Circle { centre, radius },
            Self::Rectangle { min, max } => Shape::Rectangle { min, max },
        }
    }
}

impl fmt::Display for GeneratePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Circle { centre, radius } => {
                let radius = number::format(radius);
                write!(f, "circle {} {radius}", vector(centre))
            }
            Self::Rectangle { min, max } => {
                write!(f, "rectangle {} {}", vector(min), vector(max))
            }
        }
    }
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
