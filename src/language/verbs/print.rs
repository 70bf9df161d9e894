//! `print`: shows tables.

use super::delete::ParticleRange;
use crate::language::command::Command;
use crate::language::list::Card;
use crate::language::mistake::Mistake;
use crate::language::place::Where;
use crate::language::words::Words;
use std::fmt;

/// Row in the list.
pub const CARD: Card = Card {
    name: "print",
    aliases: &[],
    usage: "print balls|contacts [I|I-J] | walls|types|boundary|energy|step | \
            stress|partition|mohr|strain|fabric|fourier|rose|coordination|redundancy|changes \
            [PLACE] | histogram obliquity|stress|force [PLACE] | profile [PLACE] [RINGS] | \
            polygon I | averages|all",
    summary: "shows a table",
    detail: "balls and contacts can be limited to particle numbers; types are the materials. From \
             stress to profile, measures are those of a place: a region of the preset, the first one \
             unless another is named, or `in circle X Y R` or `in rectangle X1 Y1 X2 Y2`. polygon sums \
             the forces on a particle head to tail. `averages` makes later tables end with averages \
             only, `all` shows every row again.",
    examples: &[
        "print balls",
        "print contacts 1-9",
        "print energy",
        "print partition",
        "print stress core",
        "print stress in circle 0 0 0.01",
        "print histogram obliquity",
        "print profile 20",
        "print polygon 7",
        "print averages",
    ],
    parse,
    changes_world: false,
};

/// What to show.
#[derive(Debug, Clone, PartialEq)]
pub enum Printout {
    /// Particles, all or those in a range.
    Balls(Option<ParticleRange>),
    /// Contacts, all or those of particles in a range.
    Contacts(Option<ParticleRange>),
    /// Walls.
    Walls,
    /// Materials.
    Types,
    /// Boundary particles.
    Boundary,
    /// Energies and their balance.
    Energy,
    /// Time step and its limits.
    Step,
    /// A measure of a place.
    Measure(Measure, Where),
    /// Porosity by distance from the middle of a place, in so many rings.
    Profile(Where, Option<u64>),
    /// Forces on the particle of this number.
    Polygon(u32),
    /// From now on, tables hold averages only.
    Averages,
    /// From now on, tables hold every row.
    All,
}

/// Measures of a region that have a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measure {
    /// Stress.
    Stress,
    /// Where it comes from.
    Partition,
    /// Circles of Mohr.
    Mohr,
    /// Strain, its rate and what goes with them.
    Strain,
    /// Fabric tensors.
    Fabric,
    /// Fourier coefficients.
    Fourier,
    /// Contacts by direction.
    Rose,
    /// Coordination by material and by size.
    Coordination,
    /// Unknown forces against equations.
    Redundancy,
    /// Differences from the reference.
    Changes,
    /// Histogram of obliquities.
    Obliquity,
    /// Histogram of mean normal contact stresses.
    ContactStress,
    /// Histogram of normal forces.
    Force,
}

/// Measures by the words for them; histograms have a word before.
const MEASURES: &[(&str, Measure)] = &[
    ("stress", Measure::Stress),
    ("partition", Measure::Partition),
    ("mohr", Measure::Mohr),
    ("strain", Measure::Strain),
    ("fabric", Measure::Fabric),
    ("fourier", Measure::Fourier),
    ("rose", Measure::Rose),
    ("coordination", Measure::Coordination),
    ("redundancy", Measure::Redundancy),
    ("changes", Measure::Changes),
];

const HISTOGRAMS: &[(&str, Measure)] = &[
    ("obliquity", Measure::Obliquity),
    ("stress", Measure::ContactStress),
    ("force", Measure::Force),
];

impl Measure {
    /// All of them.
    pub fn all() -> impl Iterator<Item = Self> {
        let listed = MEASURES.iter().chain(HISTOGRAMS);
        listed.map(|(_, measure)| *measure)
    }
}

/// What follows the first word.
#[derive(Clone, Copy)]
enum Rest {
    Range(fn(Option<ParticleRange>) -> Printout),
    Nothing(fn() -> Printout),
    Region(Measure),
    Histogram,
    Profile,
    Particle,
}

const REST: &[(&str, Rest)] = &[
    ("balls", Rest::Range(Printout::Balls)),
    ("contacts", Rest::Range(Printout::Contacts)),
    ("walls", Rest::Nothing(|| Printout::Walls)),
    ("types", Rest::Nothing(|| Printout::Types)),
    ("boundary", Rest::Nothing(|| Printout::Boundary)),
    ("energy", Rest::Nothing(|| Printout::Energy)),
    ("step", Rest::Nothing(|| Printout::Step)),
    ("histogram", Rest::Histogram),
    ("profile", Rest::Profile),
    ("polygon", Rest::Particle),
    ("averages", Rest::Nothing(|| Printout::Averages)),
    ("all", Rest::Nothing(|| Printout::All)),
];

fn parse(words: &mut Words<'_>) -> Result<Command, Mistake> {
    let measures = MEASURES
        .iter()
        .map(|(word, measure)| (*word, Rest::Region(*measure)));
    let options: Vec<(&'static str, Rest)> = REST.iter().copied().chain(measures).collect();
    let what = match words.choose(&options)? {
        Rest::Range(of) => of(range(words)?),
        Rest::Nothing(of) => of(),
        Rest::Region(measure) => Printout::Measure(measure, Where::parse(words)?),
        Rest::Histogram => {
            let measure = words.choose(HISTOGRAMS)?;
            Printout::Measure(measure, Where::parse(words)?)
        }
        Rest::Profile => {
            let (place, rings) = profile(words)?;
            Printout::Profile(place, rings)
        }
        Rest::Particle => Printout::Polygon(words.particle()?),
    };
    Ok(Command::Print(what))
}

fn range(words: &mut Words<'_>) -> Result<Option<ParticleRange>, Mistake> {
    if words.is_at_end() {
        return Ok(None);
    }
    words.particles().map(Some)
}

/// A place and a number of rings; either may be left out.
pub(super) fn profile(words: &mut Words<'_>) -> Result<(Where, Option<u64>), Mistake> {
    let place = if words.is_at_number() {
        Where::Default
    } else {
        Where::parse(words)?
    };
    if words.is_at_end() {
        return Ok((place, None));
    }
    let rings = words.count_up_to("the number of rings", MOST_RINGS)?;
    Ok((place, Some(rings)))
}

/// More rings than this are no table any more.
const MOST_RINGS: u64 = 10_000;

/// A place and a number of rings as a line holds them, a blank before each.
pub(super) fn profile_words(place: &Where, rings: Option<u64>) -> String {
    let rings = rings.map_or_else(String::new, |rings| format!(" {rings}"));
    place.to_string() + &rings
}

impl fmt::Display for Printout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = match self {
            Self::Balls(_) => "balls",
            Self::Contacts(_) => "contacts",
            Self::Walls => "walls",
            Self::Types => "types",
            Self::Boundary => "boundary",
            Self::Energy => "energy",
            Self::Step => "step",
            Self::Measure(measure, _) => return self.fmt_measure(*measure, f),
            Self::Profile(..) => "profile",
            Self::Polygon(_) => "polygon",
            Self::Averages => "averages",
            Self::All => "all",
        };
        f.write_str(word)?;
        match self {
            Self::Balls(Some(range)) | Self::Contacts(Some(range)) => write!(f, " {range}"),
            Self::Profile(place, rings) => f.write_str(&profile_words(place, *rings)),
            Self::Polygon(id) => write!(f, " {id}"),
            _ => Ok(()),
        }
    }
}

impl Printout {
    fn fmt_measure(&self, measure: Measure, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let of = |list: &'static [(&'static str, Measure)]| {
            let found = list.iter().find(|(_, known)| *known == measure);
            found.map(|(word, _)| *word)
        };
        match (of(MEASURES), of(HISTOGRAMS)) {
            (Some(word), _) => f.write_str(word)?,
            (None, word) => write!(f, "histogram {}", word.unwrap_or_default())?,
        }
        match self {
            Self::Measure(_, place) => write!(f, "{place}"),
            _ => Ok(()),
        }
    }
}
