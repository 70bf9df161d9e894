//! `export`: writes tables for other programs.

use super::print::{profile, profile_words};
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::place::Where;
use crate::language::words::{Words, quoted};
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "export",
    aliases: &[],
    usage: "export csv FILE | particles FILE | contacts FILE | profile FILE [PLACE] [RINGS] | \
            path FILE | traction FILE | vtk particles|contacts FILE | \
            svg assembly FILE [numbers] [velocities] | svg polygon I FILE | \
            svg contact|path|mohr|histogram|rose FILE | lammps FOLDER [nearest]",
    summary: "writes the history recorded so far, a table or a picture of what there is now, the contact \
              that is followed, or a deck for LAMMPS",
    detail: "All but vtk, svg and lammps are CSV: one header row, then a row for each sample, particle, \
             contact or ring, in SI units. Of the contact that `inspect` follows, path is overlap, \
             displacement and forces, traction the tangential traction over the radius now, svg \
             contact a picture of both. vtk is legacy VTK for ParaView: particles as points with \
             radius, velocity, spin, force, contacts ..., contacts as lines with n, t, overlap ... \
             The other pictures are the assembly with its forces, and if asked for the numbers of its \
             particles and arrows along their velocities; the forces on particle I, head to tail; the \
             stress path of the history; circles of Mohr, histograms and roses of the contacts of the \
             default region. lammps writes a \
             folder with the state now as a deck that runs there, and a README of what maps; what LAMMPS \
             lacks is refused, or with `nearest` written as what comes nearest.",
    examples: &[
        "export csv shear.csv",
        "export contacts now.csv",
        "export profile rings.csv core 20",
        "export path loop.csv",
        "export vtk particles now.vtk",
        "export svg contact loop.svg",
        "export svg assembly now.svg",
        "export svg assembly now.svg numbers velocities",
        "export svg polygon 7 forces.svg",
        "export lammps deck nearest",
    ],
    parse,
    changes_world: false,
};

/// What to write.
#[derive(Debug, Clone, PartialEq)]
pub enum Export {
    /// The history.
    History,
    /// All particles or all contacts as they are now.
    All(DumpOf),
    /// Porosity by distance from the middle of a place, in so many rings.
    Profile(Where, Option<u64>),
    /// The contact that is followed.
    Contact(ContactFile),
    /// All particles or all contacts as VTK.
    Vtk(DumpOf),
    /// A picture.
    Picture(PictureOf),
    /// A deck for LAMMPS; what it lacks refused, or if true as what comes nearest.
    Lammps(bool),
}

/// What pictures can be drawn of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PictureOf {
    /// Discs, walls, forces, and what is laid over them.
    Assembly(Layers),
    /// Deviator stress over mean stress.
    StressPath,
    /// Circles of Mohr.
    Mohr,
    /// Obliquity, normal force, contact stress.
    Histogram,
    /// Contacts by direction.
    Rose,
    /// Forces on the particle of this number, head to tail.
    Polygon(u32),
}

/// What is laid over a picture of the assembly.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layers {
    /// The numbers of the particles.
    pub numbers: bool,
    /// Arrows along their velocities.
    pub velocities: bool,
}

impl Layers {
    /// None.
    pub const NONE: Self = Self {
        numbers: false,
        velocities: false,
    };

    const WORDS: [&str; 2] = ["numbers", "velocities"];

    fn parse(words: &mut Words<'_>) -> Result<Self, Mistake> {
        let mut layers = Self::NONE;
        while let Some(word) = words.optional_keyword(&Self::WORDS)? {
            layers.numbers |= word == Self::WORDS[0];
            layers.velocities |= word == Self::WORDS[1];
        }
        Ok(layers)
    }
}

impl fmt::Display for Layers {
    /// A blank before each.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let asked = Self::WORDS.into_iter().zip([self.numbers, self.velocities]);
        asked
            .filter(|(_, asked)| *asked)
            .try_for_each(|(word, _)| write!(f, " {word}"))
    }
}

impl PictureOf {
    /// Those that need no particle to be named.
    pub const ALL: [Self; 5] = [
        Self::Assembly(Layers::NONE),
        Self::StressPath,
        Self::Mohr,
        Self::Histogram,
        Self::Rose,
    ];

    /// Its word.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Assembly(_) => "assembly",
            Self::StressPath => "path",
            Self::Mohr => "mohr",
            Self::Histogram => "histogram",
            Self::Rose => "rose",
            Self::Polygon(_) => "polygon",
        }
    }
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
        "vtk",
        "svg",
        "lammps",
    ])?;
    let drawn = match what {
        "vtk" => Some(Export::Vtk(DumpOf::of(
            words.keyword(&["particles", "contacts"])?,
        ))),
        "svg" => {
            let [a, b, c, d, e] = PictureOf::ALL.map(PictureOf::word);
            let of = words.keyword(&["contact", "polygon", a, b, c, d, e])?;
            let picture = PictureOf::ALL.into_iter().find(|known| known.word() == of);
            Some(match picture {
                Some(of) => Export::Picture(of),
                None if of == "polygon" => Export::Picture(PictureOf::Polygon(words.particle()?)),
                None => Export::Contact(ContactFile::Picture),
            })
        }
        _ => None,
    };
    let file = words.file()?;
    if let Some(drawn) = drawn {
        let drawn = match drawn {
            Export::Picture(PictureOf::Assembly(_)) => {
                Export::Picture(PictureOf::Assembly(Layers::parse(words)?))
            }
            other => other,
        };
        return Ok(Command::Export(drawn, file));
    }
    let what = match what {
        "csv" => Export::History,
        "profile" => {
            let (place, rings) = profile(words)?;
            Export::Profile(place, rings)
        }
        "path" => Export::Contact(ContactFile::Path),
        "lammps" => Export::Lammps(words.optional_keyword(&["nearest"])?.is_some()),
        "traction" => Export::Contact(ContactFile::Traction),
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
        Export::Vtk(of) => format!("vtk {of} {file}"),
        Export::Picture(PictureOf::Assembly(layers)) => format!("svg assembly {file}{layers}"),
        Export::Picture(PictureOf::Polygon(id)) => format!("svg polygon {id} {file}"),
        Export::Picture(of) => format!("svg {} {file}", of.word()),
        Export::Lammps(false) => format!("lammps {file}"),
        Export::Lammps(true) => format!("lammps {file} nearest"),
        Export::Profile(place, rings) => {
            format!("profile {file}{}", profile_words(place, *rings))
        }
    }
}
