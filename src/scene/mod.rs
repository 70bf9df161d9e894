//! Presets: from a TOML text to a [`Scene`] in which everything is known to be there and in range.
//!
//! A preset is read whole before anything runs or any file is created, and what is wrong with it
//! comes back as one [`Rejection`] that shows each line, says what was expected and what to do.
//!
//! Adding a table: a file with its keys and its reading, a line in `SECTIONS`, and a field in
//! the draft that holds the result. Unknown keys, near names, `--set` and the reference follow.

pub mod catalogue;

mod about;
mod answer;
mod boundary;
mod cell;
mod damping;
mod define;
mod document;
mod draft;
mod dump;
mod enclosed;
mod expect;
mod file;
mod generate;
mod gravity;
mod history;
mod key;
mod material;
mod measure;
mod model;
mod overlap;
mod overrides;
mod pair;
mod particle;
mod phrase;
mod place;
mod problem;
mod reader;
mod reference;
mod rejection;
mod requirements;
mod section;
mod seeds;
mod stage;
mod start;
mod study;
mod wall;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use about::About;
pub use answer::Answer;
pub use dump::{Dump, Format as DumpFormat};
pub use expect::{Band, Differs, Expect};
pub(crate) use generate::order::{MANY as MANY_FOR_ORDER, order as order_along_curve};
pub use generate::{Around, Generated, SizeGenerated, places};
pub use history::History;
pub use reference::{reference_table, reference_text};
pub use rejection::Rejection;
pub use seeds::Seeds;
pub use stage::Stage;
pub use start::{Keep, Sample, Source, Start, Trouble};
pub use study::{Question, Reference, Study, Sweep, elements};

use crate::engine::restart::Brought;
use crate::engine::setup::Setup;
use crate::language::{Command, Definitions, Expression, Quantity};
use crate::measure::region::Region;
use draft::Draft;
use problem::Report;
use section::Section;
use start::Given;

/// The tables of a preset, in the order they are read: later ones name what earlier ones declare.
const SECTIONS: &[Section] = &[
    about::SECTION,
    model::SECTION,
    damping::SECTION,
    material::SECTION,
    pair::SECTION,
    start::SECTION,
    particle::SECTION,
    wall::SECTION,
    enclosed::SECTION,
    generate::SECTION,
    boundary::SECTION,
    cell::SECTION,
    measure::SECTION,
    stage::SECTION,
    history::SECTION,
    dump::SECTION,
    expect::SECTION,
    answer::SECTION,
    study::SECTION,
];

/// A preset that has been read and checked.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// Name of the embedded preset, or of the file without its ending.
    pub name: String,
    /// Where the text comes from.
    pub origin: Origin,
    /// The preset as written.
    pub text: String,
    /// Options `--set`, as written.
    pub overrides: Vec<String>,
    /// What the preset says about itself.
    pub about: About,
    /// What the world is built from; without particles once it has been built.
    pub setup: Setup,
    /// What each `[[generate]]` placed.
    pub generated: Vec<Generated>,
    /// Regions that measures are taken over; the first is the default.
    pub regions: Vec<Region>,
    /// What is recorded.
    pub history: History,
    /// Columns that the preset makes itself.
    pub definitions: Definitions,
    /// Tables that are written in the course of a run.
    pub dump: Option<Dump>,
    /// What is done, in order.
    pub stages: Vec<Stage>,
    /// What must come out.
    pub expects: Vec<Expect>,
    /// What an exact run would give.
    pub answers: Vec<Answer>,
    /// What a study varies and measures.
    pub study: Study,
    /// Seed of everything random.
    pub seed: u64,
    /// The same if the preset gives it.
    pub own_seed: Option<u64>,
    /// The sample that it starts from, by name.
    pub start: Option<Start>,
    /// That sample, once it was found: its particles and walls are part of the setup.
    pub sample: Option<Arc<Sample>>,
    /// Conditions that read columns are tested every so many cycles; `None`: as `history.every`.
    pub check_every: Option<u64>,
}

/// Where the text of a scene comes from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Origin {
    /// A preset that is part of the program, by name.
    Embedded(String),
    /// A file.
    File(PathBuf),
    /// A text handed over by the program itself, such as the one in a checkpoint.
    Text,
}

impl Scene {
    /// Reads a preset by the name of an embedded one or by its path, and applies overrides.
    pub fn load(path_or_name: &str, overrides: &[String]) -> Result<Self, Rejection> {
        let (origin, text) = file::open(path_or_name)?;
        let name = Path::new(path_or_name)
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        let scene = Self::read([&name, path_or_name], text, overrides, Given::Nothing)?;
        Ok(Self { origin, ..scene })
    }

    /// Reads the text of a preset and applies overrides.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, Rejection> {
        Self::read([name, name], text.to_owned(), overrides, Given::Nothing)
    }

    /// The same with another seed, as `--seed` gives it; its sample is another one too.
    pub fn with_seed(&self, seed: u64) -> Result<Self, Rejection> {
        let seed = format!("model.seed={seed}");
        self.again(&[&self.overrides[..], &[seed]].concat(), Given::Nothing)
    }

    /// The same with other overrides, starting from the same sample.
    pub fn overridden(&self, overrides: &[String]) -> Result<Self, Rejection> {
        let Some(sample) = &self.sample else {
            return self.again(overrides, Given::Nothing);
        };
        let scene = self.again(overrides, Given::Sample(sample))?;
        let sample = self.sample.clone();
        Ok(Self { sample, ..scene })
    }

    /// The same with the sample that it starts from: names and materials are checked against it.
    pub fn started(&self, sample: Arc<Sample>) -> Result<Self, Rejection> {
        let scene = self.again(&self.overrides, Given::Sample(&sample))?;
        let sample = Some(sample);
        Ok(Self { sample, ..scene })
    }

    /// The report on a scene that has nothing to start from.
    pub fn refused(&self, trouble: &Trouble) -> Rejection {
        let read = self.again(&self.overrides, Given::Trouble(trouble));
        read.err().unwrap_or_else(|| {
            let title = self.title();
            let text = String::new();
            let problem = problem::Problem::nowhere(&trouble.message).remedy(&trouble.remedy);
            Rejection::one(place::Source { title, text }, problem)
        })
    }

    /// What a sample brings besides its particles and walls.
    pub fn brought(&self) -> Brought {
        let Some(sample) = &self.sample else {
            return Brought::default();
        };
        let numbers = sample.particles.iter().map(|(number, _)| *number);
        let kept = sample.boundary.as_ref();
        Brought {
            numbers: numbers.collect(),
            // One that the preset itself names is another.
            boundary: kept
                .filter(|kept| self.setup.boundary == Some(kept.setup()))
                .cloned(),
        }
    }

    /// What the world is built from, with the particles, which the scene does not keep.
    pub fn take_setup(&mut self) -> Setup {
        let particles = std::mem::take(&mut self.setup.particles);
        Setup {
            particles,
            ..self.setup.clone()
        }
    }

    fn again(&self, overrides: &[String], given: Given<'_>) -> Result<Self, Rejection> {
        let scene = Self::read(
            [&self.name, &self.title()],
            self.text.clone(),
            overrides,
            given,
        )?;
        let origin = self.origin.clone();
        Ok(Self { origin, ..scene })
    }

    /// What messages call its text.
    fn title(&self) -> String {
        match &self.origin {
            Origin::File(path) => path.display().to_string(),
            Origin::Embedded(_) | Origin::Text => self.name.clone(),
        }
    }

    fn read(
        [name, title]: [&str; 2],
        text: String,
        overrides: &[String],
        given: Given<'_>,
    ) -> Result<Self, Rejection> {
        // Editors of other systems put a byte order mark in front.
        let bare = text.strip_prefix('\u{feff}').map(str::to_owned);
        let source = place::Source {
            title: title.to_owned(),
            text: bare.unwrap_or(text),
        };
        if let Some(problem) = file::check_text(&source.text) {
            return Err(Rejection::one(source, problem));
        }
        let mut document = match document::read(&source) {
            Ok(document) => document,
            Err(problem) => return Err(Rejection::one(source, problem)),
        };
        let mut sources = vec![source];
        sources.extend(overrides.iter().map(|text| place::Source {
            title: study::option(text).unwrap_or("--set".to_owned()),
            text: text.clone(),
        }));
        let report = Report::new(sources);
        for (index, source) in report.sources.iter().enumerate().skip(1) {
            if let Err(problem) = overrides::apply(&mut document, source, index) {
                report.add(problem);
            }
        }
        let draft = section::read_all(&document, &report, given);
        requirements::check(&draft);
        overlap::check(&draft);
        if report.count() > 0 {
            drop(draft);
            return Err(Rejection::all(report));
        }
        let text = enclosed::with_files(report.sources[0].text.clone(), &draft.enclosed);
        Ok(Self::finished(name, text, overrides, draft))
    }

    fn finished(name: &str, text: String, overrides: &[String], draft: Draft<'_>) -> Self {
        let stages: Vec<Stage> = draft.stages.into_iter().map(|(stage, _)| stage).collect();
        let mut scene = Self {
            name: name.to_owned(),
            origin: Origin::Text,
            text,
            overrides: overrides.to_vec(),
            about: draft.about,
            setup: draft.setup,
            check_every: draft.check_every,
            generated: draft.generated,
            regions: draft.regions,
            history: draft.history,
            definitions: draft.known.definitions,
            dump: draft.dump,
            stages,
            expects: draft.expects,
            answers: draft.answers,
            study: draft.study,
            seed: draft.seed,
            own_seed: draft.own_seed,
            start: draft.start,
            sample: None,
        };
        scene.setup.ledger = !scene.booked_for().is_empty();
        scene
    }

    /// Columns that energies are booked for in every cycle: those that are recorded, or that conditions and
    /// expectations read.
    pub fn booked_for(&self) -> Vec<String> {
        let mut names = Vec::new();
        let mut add = |name: String| {
            if !names.contains(&name) {
                names.push(name);
            }
        };
        let shown = self.history.columns.iter();
        shown
            .filter(|column| column.needs_ledger())
            .for_each(|column| add(column.name()));
        let commands = self.stages.iter().flat_map(|stage| &stage.commands);
        let until = self.stages.iter().filter_map(|stage| stage.until.as_ref());
        let conditions = until.chain(commands.filter_map(Command::awaits));
        let expected = self.expects.iter().map(|expect| &expect.what);
        (conditions.flat_map(Expression::columns))
            .chain(expected.flat_map(Quantity::columns))
            .filter(|column| column.card().ledger)
            .for_each(|column| add(column.name()));
        names
    }

    /// Names of the regions, in order.
    pub fn region_names(&self) -> Vec<String> {
        let names = self.regions.iter().map(|region| region.name.clone());
        names.collect()
    }
}
