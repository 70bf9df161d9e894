//! `boundary`: what strain and stress are imposed by.

use crate::engine::setup::BoundarySetup;
use crate::language::command::{Command, vector};
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number::format as number;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "boundary",
    aliases: &[],
    usage: "boundary circle RADIUS [at X Y] [turning] | walls [about X Y] | none",
    summary: "chooses what strain and stress are imposed by",
    detail: "A circle makes a ring of the particles whose centres are outside, and of those that get \
             there later; `turning` lets them turn. The walls move and turn as lines of the strained \
             plane. Strain leaves the centre, or the point about which, at rest; all in m. A periodic \
             cell stands in the preset, [cell].",
    examples: &[
        "boundary circle 0.017",
        "boundary circle 0.2 at 0.1 0.1 turning",
        "boundary walls about 0.05 0.05",
        "boundary none",
    ],
    parse,
    changes_world: true,
};

type Reader = fn(&mut Words<'_>) -> Result<Option<BoundarySetup>, Mistake>;

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let boundary =
        words.choose::<Reader>(&[("circle", circle), ("walls", walls), ("none", |_| Ok(None))])?(
            words,
        )?;
    Ok(Command::Boundary(boundary))
}

fn circle(words: &mut Words<'_>) -> Result<Option<BoundarySetup>, Mistake> {
    let radius = words.positive("the radius")?;
    let (mut centre, mut turning) = ([0.0; 2], false);
    let mut left = vec!["at", "turning"];
    while let Some(option) = words.next_option(&mut left)? {
        match option {
            "at" => centre = words.vector("the centre")?,
            _ => turning = true,
        }
    }
    Ok(Some(BoundarySetup::Ring {
        centre,
        radius,
        turning,
    }))
}

fn walls(words: &mut Words<'_>) -> Result<Option<BoundarySetup>, Mistake> {
    let centre = match words.optional_keyword(&["about"])? {
        Some(_) => words.vector("the point at rest")?,
        None => [0.0; 2],
    };
    Ok(Some(BoundarySetup::Walls { centre }))
}

/// What follows the verb in the canonical line.
pub fn line(boundary: Option<&BoundarySetup>) -> String {
    let place = |word: &str, x: [f64; 2]| match x {
        [0.0, 0.0] => String::new(),
        x => format!(" {word} {}", vector(x)),
    };
    match boundary {
        None | Some(BoundarySetup::Cell { .. }) => "none".into(),
        Some(BoundarySetup::Walls { centre }) => format!("walls{}", place("about", *centre)),
        Some(BoundarySetup::Ring {
            centre,
            radius,
            turning,
        }) => {
            let turning = if *turning { " turning" } else { "" };
            format!(
                "circle {}{}{turning}",
                number(*radius),
                place("at", *centre)
            )
        }
    }
}
