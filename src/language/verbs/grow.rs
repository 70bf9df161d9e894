//! `grow`: all particles get larger, or smaller.

use std::fmt;

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number::format as number;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "grow",
    aliases: &[],
    usage: "grow F [over N] | off",
    summary: "multiplies all radii",
    detail: "Over N cycles the factor is reached linearly; `off` leaves the radii as they are then. Masses \
             follow the radii and velocities stay; the energy that takes is work of the command. So a sample \
             is prepared where it is: no boundary moves. The time step follows the radii as \
             model.time_step says.",
    examples: &["grow 1.2 over 50000", "grow 0.999", "grow off"],
    parse,
    changes_world: true,
};

/// How much all radii change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grow {
    /// Factor at the end [-].
    pub factor: f64,
    /// Cycles; 0: at once.
    pub over: u64,
}

impl fmt::Display for Grow {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&number(self.factor))?;
        if self.over > 0 {
            write!(f, " over {}", self.over)?;
        }
        Ok(())
    }
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    if !words.is_at_number() && !words.is_at_end() {
        words.choose(&[("off", ())])?;
        return Ok(Command::Grow(None));
    }
    let factor = words.positive("the factor")?;
    let over = match words.optional_keyword(&["over"])? {
        Some(_) => words.count("the number of cycles")?,
        None => 0,
    };
    Ok(Command::Grow(Some(Grow { factor, over })))
}
