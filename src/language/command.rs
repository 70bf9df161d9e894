//! A command as data, and its canonical line.

use super::Expression;
use super::definition::Definitions;
use super::list::{COMMANDS, Card};
use super::mistake::Mistake;
use super::verbs::{boundary, export};
use super::words::{Words, quoted};
use crate::engine::setup::{BoundarySetup, Gravity};
use crate::language::number::format as number;
use crate::measure::columns::Partner;
use std::fmt;
use std::str::FromStr;

pub use super::place::{Place, Where};
pub use super::verbs::bond::Bond;
pub use super::verbs::create::Create;
pub use super::verbs::damp::Damper;
pub use super::verbs::delete::ParticleRange;
pub use super::verbs::export::{ContactFile, DumpOf, Export, Layers, PictureOf};
pub use super::verbs::friction::FrictionOf;
pub use super::verbs::generate::{Generate, MOST_GENERATED};
pub use super::verbs::grow::Grow;
pub use super::verbs::history::HistoryChange;
pub use super::verbs::particle::ParticleChange;
pub use super::verbs::print::{Measure, Printout};
pub use super::verbs::property::Property;
pub use super::verbs::servo::ServoGoal;
pub use super::verbs::solve::{Goal, Solve};
pub use super::verbs::strain::{Continuum, Imposed};
pub use super::verbs::wall::WallChange;

/// Everything that can be asked of a session.
#[derive(Debug, Clone, PartialEq)]
pub enum Command {
    /// Adds a particle.
    Create(Create),
    /// Adds particles at random without contacts.
    Generate(Generate),
    /// Removes particles.
    Delete(ParticleRange),
    /// Changes the wall of this name.
    Wall(String, WallChange),
    /// Changes the particle of this number.
    Particle(u32, ParticleChange),
    /// Multiplies all radii; `None`: no further.
    Grow(Option<Grow>),
    /// Sets a property of the material of this name, in the unit of the property.
    Property(String, Property, f64),
    /// Bonds particles that touch.
    Bond(Bond),
    /// Sets the friction coefficient [-] of something.
    Friction(f64, FrictionOf),
    /// Sets FRAC, the multiple of the reference time step [-].
    Frac(f64),
    /// Keeps the step to this share of the stability bound.
    FracAuto(f64),
    /// Sets a kind of damping, in the unit of that kind.
    Damp(Damper, f64),
    /// Sets the factor on the velocities in each cycle [-].
    Con1(f64),
    /// Sets the body force; `None` switches it off.
    Gravity(Option<Gravity>),
    /// Chooses what strain and stress are imposed by; `None`: nothing.
    Boundary(Option<BoundarySetup>),
    /// Imposes a strain rate [1/s] by the boundary.
    Strain(Imposed),
    /// Lets every particle drift with a strain rate.
    Continuum(Continuum),
    /// Imposes a stress [Pa] by the boundary.
    Stress(Imposed),
    /// Steers the boundary to a stress; `None`: not any more.
    Servo(Option<ServoGoal>),
    /// Lets particles turn or not.
    Rotation(bool),
    /// Stops all motion.
    Zero,
    /// Measures state differences from now.
    Reference,
    /// Runs so many cycles.
    Cycle(u64),
    /// Runs until something holds.
    Solve(Solve),
    /// Runs so many cycles and shows each.
    Step(u64),
    /// Runs on.
    Go,
    /// Stops running.
    Pause,
    /// Shows tables.
    Print(Printout),
    /// Shows a contact: the lower particle number and its partner.
    InspectContact(u32, Partner),
    /// Follows no contact any more.
    InspectOff,
    /// Shows or changes what is recorded.
    History(HistoryChange),
    /// Writes a checkpoint to this file.
    Save(String),
    /// Reads the checkpoint in this file.
    Restore(String),
    /// Writes the history or a table to this file as CSV.
    Export(Export, String),
    /// Writes the commands so far to this file.
    Journal(String),
    /// Executes the commands in this file.
    Source(String),
    /// Shows all commands, or the page of one.
    Help(Option<&'static str>),
    /// Ends the session.
    Quit {
        /// Without asking whether to save.
        anyway: bool,
    },
}

impl Command {
    /// Reads a line: verb and keywords in any case, shortened as long as they stay unambiguous,
    /// with an optional comment after `#`.
    pub fn parse(line: &str) -> Result<Self, Mistake> {
        Self::parse_with(line, &Definitions::default())
    }

    /// The same in a preset that defines columns.
    pub fn parse_with(line: &str, definitions: &Definitions) -> Result<Self, Mistake> {
        let mut words = Words::new(line, definitions)?;
        let card = words.card()?;
        let command = (card.parse)(&mut words)?;
        words.end()?;
        Ok(command)
    }

    /// The condition it runs until.
    pub fn awaits(&self) -> Option<&Expression> {
        match self {
            Self::Solve(Solve {
                goal: Some(Goal::Until(condition)),
                ..
            }) => Some(condition),
            _ => None,
        }
    }

    /// The row of the list it belongs to.
    pub fn card(&self) -> &'static Card {
        let verb = self.verb();
        COMMANDS
            .iter()
            .find(|card| card.name == verb)
            .expect("every verb is in the list, a test walks through them")
    }

    /// Whether it changes the world itself, rather than running, showing or keeping it.
    pub fn changes_world(&self) -> bool {
        self.card().changes_world
    }

    /// Whether cycles run because of it.
    pub fn runs_cycles(&self) -> bool {
        matches!(
            self,
            Self::Cycle(_) | Self::Solve(_) | Self::Step(_) | Self::Go
        )
    }

    fn verb(&self) -> &'static str {
        match self {
            Self::Create(_) => "create",
            Self::Generate(_) => "generate",
            Self::Grow(_) => "grow",
            Self::Delete(_) => "delete",
            Self::Boundary(_) => "boundary",
            Self::Strain(_) => "strain",
            Self::Continuum(_) => "continuum",
            Self::Stress(_) => "stress",
            Self::Servo(_) => "servo",
            Self::Wall(..) => "wall",
            Self::Particle(..) => "particle",
            Self::Property(..) => "property",
            Self::Bond(_) => "bond",
            Self::Friction(..) => "friction",
            Self::Frac(_) | Self::FracAuto(_) => "frac",
            Self::Damp(..) => "damp",
            Self::Con1(_) => "con1",
            Self::Gravity(_) => "gravity",
            Self::Rotation(_) => "rotation",
            Self::Zero => "zero",
            Self::Reference => "reference",
            Self::Cycle(_) => "cycle",
            Self::Solve(_) => "solve",
            Self::Step(_) => "step",
            Self::Go => "go",
            Self::Pause => "pause",
            Self::Print(_) => "print",
            Self::InspectContact(..) | Self::InspectOff => "inspect",
            Self::History(_) => "history",
            Self::Save(_) => "save",
            Self::Restore(_) => "restore",
            Self::Export(..) => "export",
            Self::Journal(_) => "journal",
            Self::Source(_) => "source",
            Self::Help(_) => "help",
            Self::Quit { .. } => "quit",
        }
    }
}

/// The canonical line: it reads back as an equal command, with the same definitions.
impl fmt::Display for Command {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.verb())?;
        match self {
            Self::Create(create) => write!(f, " {create}"),
            Self::Generate(generate) => write!(f, " {generate}"),
            Self::Grow(Some(grow)) => write!(f, " {grow}"),
            Self::Delete(range) => write!(f, " {range}"),
            Self::Wall(name, change) => write!(f, " {name} {change}"),
            Self::Particle(id, change) => write!(f, " {id} {change}"),
            Self::Property(material, key, value) => {
                write!(f, " {} {key} {}", quoted(material), number(*value))
            }
            Self::Bond(bond) => write!(f, "{bond}"),
            Self::Friction(value, of) => write!(f, " {}{of}", number(*value)),
            Self::FracAuto(share) => write!(f, " auto {}", number(*share)),
            Self::Frac(value) | Self::Con1(value) => write!(f, " {}", number(*value)),
            Self::Damp(damper, value) => write!(f, " {damper} {}", number(*value)),
            Self::Gravity(None) => f.write_str(" none"),
            Self::Gravity(Some(Gravity::Uniform(g))) => write!(f, " {}", vector(*g)),
            Self::Gravity(Some(Gravity::Centripetal { towards, g })) => {
                write!(f, " towards {} {}", vector(*towards), number(*g))
            }
            Self::Boundary(boundary) => write!(f, " {}", boundary::line(boundary.as_ref())),
            Self::Strain(imposed) => write!(f, " rate {imposed}"),
            Self::Continuum(continuum) => write!(f, " {continuum}"),
            Self::Stress(imposed) => write!(f, " {imposed}"),
            Self::Servo(Some(goal)) => write!(f, " {goal}"),
            Self::Rotation(on) => f.write_str(if *on { " on" } else { " off" }),
            Self::Cycle(count) | Self::Step(count) => write!(f, " {count}"),
            Self::Solve(solve) => write!(f, "{solve}"),
            Self::Print(what) => write!(f, " {what}"),
            Self::InspectContact(i, Partner::Particle(j)) => write!(f, " contact {i}-{j}"),
            Self::InspectContact(i, Partner::Wall(wall)) => write!(f, " contact {i}-{wall}"),
            Self::InspectOff | Self::Grow(None) | Self::Servo(None) => f.write_str(" off"),
            Self::History(change) => write!(f, "{change}"),
            Self::Export(what, file) => write!(f, " {}", export::line(what, file)),
            Self::Save(file) | Self::Restore(file) | Self::Journal(file) | Self::Source(file) => {
                write!(f, " {}", quoted(file))
            }
            Self::Help(Some(verb)) => write!(f, " {verb}"),
            Self::Quit { anyway: true } => f.write_str("!"),
            Self::Quit { anyway: false }
            | Self::Help(None)
            | Self::Zero
            | Self::Reference
            | Self::Go
            | Self::Pause => Ok(()),
        }
    }
}

impl FromStr for Command {
    type Err = Mistake;

    fn from_str(line: &str) -> Result<Self, Mistake> {
        Self::parse(line)
    }
}

/// Two numbers as a line holds them.
pub(crate) fn vector(v: [f64; 2]) -> String {
    format!("{} {}", number(v[0]), number(v[1]))
}
