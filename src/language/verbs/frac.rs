//! `frac`: changes the time step.

use crate::engine::auto_step::USUAL_SHARE;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "frac",
    aliases: &[],
    usage: "frac X | auto [SHARE]",
    summary: "sets the time step as a multiple of the reference step",
    detail: "The reference is what model.time_step names: the Rayleigh step, the critical step or a \
             number of seconds. Large values cost accuracy, then stability; the columns fracc and \
             frac_limit show how far that is. auto keeps the step to a share of the stability bound, \
             0.5 if none is named, and to the same share of the reference.",
    examples: &["frac 0.1", "frac auto", "frac auto 0.7"],
    parse,
    changes_world: true,
};

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    if words.is_at_number() || words.is_at_end() {
        return words.positive("frac").map(Command::Frac);
    }
    words.keyword_of(&["auto"], "a number or `auto`")?;
    if words.is_at_end() {
        return Ok(Command::FracAuto(USUAL_SHARE));
    }
    let share = words.number_that("the share", "above 0 and at most 1", |x| {
        x > 0.0 && x <= 1.0
    })?;
    Ok(Command::FracAuto(share))
}
