//! `ballast bench`: how fast standard scenes and presets run.

use std::path::Path;

use super::aligned::aligned;
use super::output::{complain, load, print, tell};
use super::placed::placed;
use super::{BAD_INPUT, Bench, FAILED};
use crate::measure::columns::nearest;
use crate::record::whole_file;
use crate::scene::Scene;
use crate::scene::catalogue::PRESETS;
use crate::session::figure::rough;
use crate::session::{Place, Session};
use crate::study::bench::{
    Length, Measured, Memory, STANDARD, Standard, csv, find, machine, measure, rows,
};

/// Times them; answers the exit status.
pub(super) fn bench(options: &Bench) -> u8 {
    if options.list {
        let rows: Vec<Vec<String>> = (STANDARD.iter())
            .map(|scene| vec![scene.name.to_owned(), scene.summary.to_owned()])
            .collect();
        return print(&format!("{}\n", aligned(&rows, 1, 1).join("\n")));
    }
    let scenes = match chosen(options) {
        Ok(scenes) => scenes,
        Err(status) => return status,
    };
    // Before anything is timed that would be lost.
    let mut places = scenes.iter().filter_map(|timed| {
        let place = options.at.as_ref()?;
        place.stage_of(&timed.scene).err()
    });
    if let Some(refusal) = places.next() {
        complain(&refusal.to_string());
        return BAD_INPUT;
    }
    let file = options.csv.as_deref();
    if let Some(Err(error)) = file
        .filter(|path| path.as_os_str() != "-")
        .map(whole_file::probe)
    {
        complain(&error.to_string());
        return FAILED;
    }
    let length = options
        .cycles
        .map_or(Length::Seconds(options.seconds), Length::Cycles);
    let mut all: Vec<Measured> = Vec::new();
    for timed in scenes {
        let (name, summary) = (timed.name.clone(), timed.summary.clone());
        let threads = usize::from(options.threads);
        let mut session = match timed.session(options.at.as_ref(), threads, options.quiet) {
            Ok(session) => session,
            Err(status) => return status,
        };
        if !options.quiet {
            tell(&format!("{name}: {summary}"));
        }
        match measure(&name, &mut session, length) {
            Ok(measured) => all.push(measured),
            Err(fault) => {
                complain(&format!("{name}: {fault}"));
                return FAILED;
            }
        }
    }
    // After the scenes: their memory is given back by now.
    let memory = Memory::measured(all.first().map_or(1, |first| first.threads));
    let table = csv(&all, &memory, &machine());
    match &options.csv {
        Some(path) if path.as_os_str() == "-" => {
            return print(&String::from_utf8_lossy(table.bytes()));
        }
        Some(path) => {
            if let Err(error) = whole_file::write(path, table.bytes()) {
                complain(&error.to_string());
                return FAILED;
            }
        }
        None => {}
    }
    let gigabytes = rough(1e-9 * memory.copy);
    let mut text = format!("{}; a copy in memory: {gigabytes} GB/s\n\n", machine());
    let rows = rows(&all, &memory);
    text += &aligned(&rows, 3, rows[0].len()).join("\n");
    text += "\n\nrates are in wall time; busy: share of it with a processor for each thread, 1 on a quiet machine; updates \
             are of touching contacts; list lasts: cycles until pairs are looked for again; MB/cycle: what a cycle has to \
             read and write at least, and of copy: how near that comes to a copy of memory, for scenes that the caches \
             do not hold\n";
    print(&text)
}

/// What is timed, and where its clock starts.
pub(super) struct Timed {
    name: String,
    summary: String,
    scene: Scene,
    stage: Option<String>,
}

impl Timed {
    /// A standard scene with more overrides; or the exit status.
    pub(super) fn standard(standard: &Standard, set: &[String]) -> Result<Self, u8> {
        let own = standard.set.iter().map(|set| (*set).to_owned());
        let set: Vec<String> = own.chain(set.iter().cloned()).collect();
        Ok(Self {
            name: standard.name.to_owned(),
            summary: standard.summary.to_owned(),
            scene: load(standard.preset, &set).ok_or(BAD_INPUT)?,
            stage: Some(standard.stage.to_owned()),
        })
    }

    /// A preset, from where its last stage begins; or the exit status.
    fn preset(preset: &str, set: &[String]) -> Result<Self, u8> {
        let scene = load(preset, set).ok_or(BAD_INPUT)?;
        Ok(Self {
            name: scene.name.clone(),
            summary: scene.about.title.clone(),
            stage: scene.stages.last().map(|stage| stage.name.clone()),
            scene,
        })
    }

    /// Its run at `place`, or where its clock starts; or the exit status.
    pub(super) fn session(
        self,
        place: Option<&Place>,
        threads: usize,
        quiet: bool,
    ) -> Result<Session, u8> {
        let own = self.stage.map(|stage| Place { stage, cycles: 0 });
        placed(self.scene, place.or(own.as_ref()), threads, quiet)
    }
}

/// Whether it is the name of an embedded preset, or looks like that of a file.
fn is_preset(name: &str) -> bool {
    let embedded = PRESETS.iter().any(|preset| preset.name == name);
    let path = Path::new(name);
    embedded || path.is_file() || path.extension().is_some() || path.components().count() > 1
}

/// What these names mean; none: all standard scenes but the large ones.
fn chosen(options: &Bench) -> Result<Vec<Timed>, u8> {
    let set = &options.set;
    if options.scenes.is_empty() {
        let usual = STANDARD.iter().filter(|scene| !scene.large);
        return usual.map(|scene| Timed::standard(scene, set)).collect();
    }
    let named = |name: &String| match find(name) {
        Some(standard) => Timed::standard(standard, set),
        None if is_preset(name) => Timed::preset(name, set),
        None => {
            let known = STANDARD.iter().map(|scene| scene.name);
            let known = known.chain(PRESETS.iter().map(|preset| preset.name));
            let nearest = nearest(name, known);
            complain(&format!(
                "there is no standard scene or preset `{name}`; {nearest}"
            ));
            Err(BAD_INPUT)
        }
    };
    options.scenes.iter().map(named).collect()
}
