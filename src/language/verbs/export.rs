//! `export`: writes tables for other programs.

use super::print::{profile, profile_words};
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "export",
    aliases: &[],
    usage: "export csv FILE | particles FILE | contacts FILE | profile FILE [REGION] [RINGS] | \
            path FILE | traction FILE | svg contact FILE",
    summary: "writes the history recorded so far, a table of what there is now, or the contact that \
              is followed",
    detail: "All but svg are CSV: one header row, then a row for each sample, particle, contact or \
             ring, in SI units. Of the contact that `inspect` follows, path is overlap, displacement \
             and forces, traction the tangential traction over the radius now, svg a picture of both.",
    examples: &[
        "export csv shear.csv",
        "export contacts now.csv",
        "export profile rings.csv core 20",
        "export path loop.csv",
        "export svg contact loop.svg",
    ],
    parse,
    changes_world: false,
};

/// What to write.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Export {
    /// The history.
    History,
    /// All particles or all contacts as they are now.
    All(DumpOf),
    /// Porosity by distance from the middle of a region, in so many rings.
    Profile(Option<String>, Option<u64>),
    /// The contact that is followed.
    Contact(ContactFile),
}

/// What of the contact that is followed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactFile {
    /// Overlap, displacement and forces.
    Path,
    /// Traction over the radius.
    Traction,
    /// Both as a picture.
    Picture,
}

/// Tables of everything at one moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DumpOf {
    /// Particles.
    Particles,
    /// Contacts.
    Contacts,
}

impl DumpOf {
    /// By its word; any other than `contacts` means particles.
    pub fn of(word: &str) -> Self {
        if word == "contacts" {
            Self::Contacts
        } else {
            Self::Particles
        }
    }
}

impl fmt::Display for DumpOf {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Particles => "particles",
            Self::Contacts => "contacts",
        })
    }
}

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let what = words.keyword(&[
        "csv",
        "particles",
        "contacts",
        "profile",
        "path",
        "traction",
        "svg",
    ])?;
    if what == "svg" {
        words.keyword(&["contact"])?;
    }
    let file = words.file()?;
    let what = match what {
        "csv" => Export::History,
        "profile" => {
            let (region, rings) = profile(words)?;
            Export::Profile(region, rings)
        }
        "path" => Export::Contact(ContactFile::Path),
        "traction" => Export::Contact(ContactFile::Traction),
        "svg" => Export::Contact(ContactFile::Picture),
        word => Export::All(DumpOf::of(word)),
    };
    Ok(Command::Export(what, file))
}

/// What follows the verb.
pub(crate) fn line(what: &Export, file: &str) -> String {
    let file = quoted(file);
    match what {
        Export::History => format!("csv {file}"),
        Export::All(of) => format!("{of} {file}"),
        Export::Contact(ContactFile::Path) => format!("path {file}"),
        Export::Contact(ContactFile::Traction) => format!("traction {file}"),
        Export::Contact(ContactFile::Picture) => format!("svg contact {file}"),
        Export::Profile(region, rings) => {
            format!("profile {file}{}", profile_words(region.as_ref(), *rings))
        }
    }
}
