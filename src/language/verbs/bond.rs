//! `bond`: bonds particles that touch.

use std::fmt;

use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::number;
use crate::language::place::Place;
use crate::language::words::Words;

/// Row in the list.
pub const CARD: Card = Card {
    name: "bond",
    aliases: &[],
    usage: "bond [gap G] [in circle X Y R|rectangle X1 Y1 X2 Y2]",
    summary: "bonds particles that touch, under the law bonded",
    detail: "Lengths in m. Without a gap it bonds what touches but for rounding, up to a millionth of the \
             smaller radius; with one also particles that are apart by less, unless the pull there would \
             break the bond at once. Both centres must be inside. A bond pulls and shears up to \
             bond_tension and bond_shear of its materials, then it breaks for good; bonds are made by \
             this command only. Its springs are at rest where the particles just touch. Walls are not \
             bonded.",
    examples: &["bond", "bond gap 1e-6", "bond in rectangle 0 0 0.1 0.02"],
    parse,
    changes_world: true,
};

/// Which particles are bonded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bond {
    /// Largest gap [m]; `None`: a millionth of the smaller radius.
    pub gap: Option<f64>,
    /// Where; `None`: everywhere.
    pub place: Option<Place>,
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let mut bond = Bond {
        gap: None,
        place: None,
    };
    let mut left = vec!["gap", "in"];
    while let Some(option) = words.next_option(&mut left)? {
        match option {
            "gap" => bond.gap = Some(words.not_negative("the gap")?),
            _ => bond.place = Some(Place::parse(words)?),
        }
    }
    Ok(Command::Bond(bond))
}

impl fmt::Display for Bond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(gap) = self.gap {
            write!(f, " gap {}", number::format(gap))?;
        }
        match self.place {
            Some(place) => write!(f, " in {place}"),
            None => Ok(()),
        }
    }
}
