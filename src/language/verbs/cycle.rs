//! `cycle`, `step`, `go` and `pause`: run and stop.

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::Words;

/// Row of `cycle` in the list.
pub const CARD: Card = Card {
    name: "cycle",
    aliases: &[],
    usage: "cycle N",
    summary: "runs N cycles",
    detail: "A cycle moves the particles by one time step and finds the new contact forces.",
    examples: &["cycle 1000", "cycle 2_000_000"],
    parse: |words| words.count("the number of cycles").map(Command::Cycle),
    changes_world: false,
};

/// Row of `step` in the list.
pub const STEP: Card = Card {
    name: "step",
    aliases: &[],
    usage: "step [N]",
    summary: "runs one cycle, or N, and shows each",
    detail: "For looking closely: `cycle` shows only where it ends.",
    examples: &["step", "step 10"],
    parse: step,
    changes_world: false,
};

/// Row of `go` in the list.
pub const GO: Card = Card {
    name: "go",
    aliases: &[],
    usage: "go",
    summary: "runs on until paused",
    detail: "`pause` stops it.",
    examples: &["go"],
    parse: |_| Ok(Command::Go),
    changes_world: false,
};

/// Row of `pause` in the list.
pub const PAUSE: Card = Card {
    name: "pause",
    aliases: &[],
    usage: "pause",
    summary: "stops running at the end of the cycle",
    detail: "`go` continues to the same bits.",
    examples: &["pause"],
    parse: |_| Ok(Command::Pause),
    changes_world: false,
};

fn step(words: &mut Words<'_>) -> Result<Command, Mistake> {
    if words.is_at_end() {
        return Ok(Command::Step(1));
    }
    words.count("the number of cycles").map(Command::Step)
}
