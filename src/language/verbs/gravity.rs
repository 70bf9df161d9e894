//! `gravity`: sets the body force.

use crate::engine::setup::Gravity;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "gravity",
    aliases: &[],
    usage: "gravity GX GY | none | towards X Y G",
    summary: "sets gravity",
    detail: "Components in m/s2, or a point in m and the magnitude of an acceleration towards it.",
    examples: &[
        "gravity 0 -9.81",
        "gravity none",
        "gravity towards 0 0 9.81",
    ],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    if words.is_at_number() {
        let g = words.vector("gravity")?;
        return Ok(Command::Gravity(Some(Gravity::Uniform(g))));
    }
    if !words.choose(&[("none", false), ("towards", true)])? {
        return Ok(Command::Gravity(None));
    }
    let towards = words.vector("the point")?;
    let g = words.number("the magnitude")?;
    Ok(Command::Gravity(Some(Gravity::Centripetal { towards, g })))
}
