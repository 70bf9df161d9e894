//! A scene while its preset is being read: the values so far, and where those were written that
//! are checked against each other at the end.

use super::answer::Answer;
use super::dump::Dump;
use super::enclosed::Enclosed;
use super::expect::Expect;
use super::generate::Generated;
use super::history::History;
use super::phrase;
use super::place::{Place, quoted};
use super::problem::{Problem, Report};
use super::stage::Stage;
use super::start::{Given, Start};
use super::study::Study;
use super::{about::About, reader::Reader};
use crate::engine::setup::{
    Body, BoundarySetup, Damping, LawChoice, NormalForm, Setup, TimeStepChoice, Unloading,
};
use std::sync::Arc;

use crate::language::{Command, Definition, Known, Observable};
use crate::measure::columns::{Names, nearest};
use crate::measure::region::Region;

/// The scene so far. A table in which something is wrong is kept with what could be read, so that
/// names and numbers of the others stay right; a draft with problems never becomes a scene.
pub(crate) struct Draft<'a> {
    /// Texts and problems.
    pub(crate) report: &'a Report,
    /// `[about]`.
    pub(crate) about: About,
    /// Random seed.
    pub(crate) seed: u64,
    /// The same if it was given.
    pub(crate) own_seed: Option<u64>,
    /// Which tables were written.
    pub(crate) wrote: Wrote,
    /// What is known of the sample.
    pub(crate) given: Given<'a>,
    /// `[start]`.
    pub(crate) start: Option<Start>,
    /// Particles and walls that came from the sample: the first of all.
    pub(crate) sampled: [usize; 2],
    /// What the world will be built from.
    pub(crate) setup: Setup,
    /// `[file]`.
    pub(crate) enclosed: Enclosed<'a>,
    /// `[[generate]]`.
    pub(crate) generated: Vec<Generated>,
    /// `[[measure]]`.
    pub(crate) regions: Vec<Region>,
    /// Where the name of each region was written.
    pub(crate) region_places: Vec<Place>,
    /// `[history]`.
    pub(crate) history: History,
    /// `[dump]`.
    pub(crate) dump: Option<Dump>,
    /// Cycles between tests of conditions that read columns.
    pub(crate) check_every: Option<u64>,
    /// `[[stage]]`, each with the place of its name.
    pub(crate) stages: Vec<(Stage, Place)>,
    /// `[[expect]]`.
    pub(crate) expects: Vec<Expect>,
    /// `[history.define]`, each with its text and place.
    pub(crate) definitions: Vec<(Arc<Definition>, &'a str, Place)>,
    /// `[[answer]]`.
    pub(crate) answers: Vec<Answer>,
    /// `[study]`.
    pub(crate) study: Study,
    /// What commands may name; follows the commands of the stages.
    pub(crate) known: Known,
    /// Every wall, region and particle that is there at some time: columns may name them all.
    pub(crate) ever: Names,
    /// Where the law and the time step were chosen.
    pub(crate) model: Mark,
    /// Where each material was written.
    pub(crate) materials: Vec<Mark>,
    /// Where each particle was written.
    pub(crate) particles: Vec<Mark>,
    /// Where each wall was written.
    pub(crate) walls: Vec<Mark>,
}

/// Which tables were written: a sample takes the place of some.
#[derive(Debug, Clone, Copy, Default)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "which tables were written is a list of yes and no"
)]
pub(crate) struct Wrote {
    /// `[start]`.
    pub(crate) start: bool,
    /// `[[particle]]` or `[[generate]]`.
    pub(crate) particles: bool,
    /// `[[wall]]`.
    pub(crate) walls: bool,
    /// `[boundary]` or `[cell]`.
    pub(crate) boundary: bool,
}

/// Where a table was written and whether all of it could be read.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Mark {
    /// The header, or the value a check is about.
    pub(crate) place: Place,
    /// Whether its values are those of the preset.
    pub(crate) sound: bool,
}

impl<'a> Draft<'a> {
    /// Nothing read yet.
    pub(crate) fn new(report: &'a Report) -> Self {
        Self {
            report,
            about: About::default(),
            seed: 0,
            own_seed: None,
            wrote: Wrote::default(),
            given: Given::Nothing,
            start: None,
            sampled: [0; 2],
            setup: Setup {
                body: Body::Sphere,
                law: LawChoice::linear(),
                normal: NormalForm::Total,
                unloading: Unloading::Rescale,
                nodes: 16,
                time_step: TimeStepChoice::Critical,
                frac: 0.0,
                frac_auto: None,
                rotation: true,
                gravity: None,
                damping: Damping::default(),
                materials: Vec::new(),
                pairs: Vec::new(),
                particles: Vec::new(),
                walls: Vec::new(),
                boundary: None,
                strain_rate: [[0.0; 2]; 2],
                tol: None,
                fracc_every: 1,
                overlap_allowed: false,
                ledger: false,
            },
            enclosed: Enclosed::default(),
            generated: Vec::new(),
            regions: Vec::new(),
            region_places: Vec::new(),
            history: History::default(),
            dump: None,
            check_every: None,
            stages: Vec::new(),
            expects: Vec::new(),
            definitions: Vec::new(),
            answers: Vec::new(),
            study: Study::default(),
            known: Known::default(),
            ever: Names::default(),
            model: Mark {
                place: Place::new(0, 0..0),
                sound: false,
            },
            materials: Vec::new(),
            particles: Vec::new(),
            walls: Vec::new(),
        }
    }

    /// Number of the next particle.
    pub(crate) fn next_number(&self) -> u32 {
        self.ever.particles.last().map_or(1, |last| last + 1)
    }

    /// The index of a material by name; reports a name that no material has.
    pub(crate) fn material(&self, name: &str, place: Place, of: &Reader<'_>) -> Option<usize> {
        let known = self.setup.materials.iter().map(|m| m.name.as_str());
        let found = known.clone().position(|material| material == name);
        if found.is_none() {
            let message = format!("there is no material {} for {}", quoted(name), of.title);
            self.report.add(
                Problem::new(message, place)
                    .expected("expected the name of a [material.NAME]")
                    .remedy(match self.setup.materials.len() {
                        0 => format!("add [material.{name}] with its density and stiffness"),
                        _ => nearest(name, known),
                    }),
            );
        }
        found
    }

    /// Strain and stress are imposed by this.
    pub(crate) fn set_boundary(&mut self, boundary: BoundarySetup) {
        self.setup.boundary = Some(boundary);
        self.known.boundary = Some(boundary);
    }

    /// Reports the name of a stage that is not there.
    pub(crate) fn check_stage(&self, name: &str, place: Place) {
        let stages = self.stages.iter().map(|(stage, _)| stage.name.as_str());
        if stages.clone().any(|stage| stage == name) {
            return;
        }
        self.report.add(
            Problem::new(format!("there is no stage {}", quoted(name)), place)
                .expected("expected the name of a [[stage]]")
                .remedy(nearest(name, stages)),
        );
    }

    /// Reports a column that names what is not there.
    pub(crate) fn check_column(&self, column: &Observable, text: &str, place: Place) {
        let checked = column.check(&self.ever, 0..text.len());
        phrase::accept(self.report, checked, text, place);
    }

    /// Reports a command that names what is not there; else what it makes is there from now on.
    pub(crate) fn follow(&mut self, command: &Command, text: &str, place: Place) {
        let checked = self.known.check(command, text);
        phrase::accept(self.report, checked, text, place);
        self.known.follow(command);
        let Known { names, .. } = &self.known;
        match command {
            Command::Create(_) | Command::Generate(_) => {
                // Numbers may have been other particles' that were deleted: new ones are above all.
                let before = self.ever.particles.last().copied().unwrap_or(0);
                let from = names.particles.partition_point(|&number| number <= before);
                self.ever
                    .particles
                    .extend_from_slice(&names.particles[from..]);
            }
            Command::Wall(name, _) if !self.ever.walls.contains(name) => {
                self.ever.walls.push(name.clone());
            }
            _ => {}
        }
    }

    /// Reports a name that commands and --set could not spell without quotes.
    pub(crate) fn check_name(&self, name: &str, place: Place) {
        let mut letters = name.chars();
        let first = letters.next().is_some_and(char::is_alphabetic);
        if first && letters.all(|c| c.is_alphanumeric() || c == '_' || c == '-') {
            return;
        }
        self.report.add(
            Problem::new(format!("{} cannot be a name", quoted(name)), place)
                .expected("expected a letter, then letters, digits, `_` and `-`")
                .remedy("rename it: commands and --set spell it without quotes"),
        );
    }

    /// Reports a name that could not stand within an expression, in a column such as `example`.
    pub(crate) fn check_column_name(&self, name: &str, place: Place, what: &str, example: &str) {
        if crate::language::name::is_name(name) {
            return;
        }
        self.report.add(
            Problem::new(format!("{} cannot name a {what}", quoted(name)), place)
                .expected("expected a letter, then letters, digits and `_`")
                .remedy(format!("rename it: `{example}` stands in expressions")),
        );
    }

    /// Reports a name that is taken; commands do not tell upper from lower case.
    pub(crate) fn check_unique<'n>(
        &self,
        name: &str,
        place: Place,
        taken: impl Iterator<Item = (&'n str, Place)>,
    ) {
        let lower = name.to_lowercase();
        for (other, there) in taken {
            if other.to_lowercase() == lower {
                self.report.add(
                    Problem::new(format!("the name {} is taken", quoted(name)), place)
                        .expected("a second one of this name")
                        .also(there, "the first one")
                        .remedy("rename one of them; upper and lower case are the same here"),
                );
                return;
            }
        }
    }
}
