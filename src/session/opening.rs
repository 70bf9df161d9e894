//! Starting a session from a scene.

use std::path::Path;

use super::course::Course;
use super::{Recording, RunError, Session, start};
use crate::control::Control;
use crate::measure::reference::Reference;
use crate::record::history::History;
use crate::record::journal::{Journal, JournalWriter};
use crate::scene::{Generated, Scene};

/// How a session is started.
#[derive(Debug, Clone, Copy, Default)]
pub struct Options {
    /// Number of threads; 0: as many as suit the scene.
    pub threads: usize,
    /// Seed given instead of the preset's, for the journal.
    pub seed: Option<u64>,
    /// Keeps no state to go back to after a fault: for runs that are repeated anyway.
    pub expendable: bool,
    /// Neither looks for a prepared sample in the cache nor keeps one there.
    pub no_cache: bool,
}

impl Session {
    /// Builds the world of a scene. No file is touched but that of its sample.
    pub fn open(scene: Scene, options: Options) -> Result<Self, RunError> {
        Self::open_watched(scene, options, &mut |_| true)
    }

    /// The same, telling how far its sample is while that is being prepared.
    pub fn open_watched(
        scene: Scene,
        options: Options,
        beat: &mut start::Beat<'_>,
    ) -> Result<Self, RunError> {
        let started = start::resolve(scene, &options, beat)?;
        let (mut scene, mut notices) = (started.scene, started.notices);
        let world = start::world(&mut scene, &options)?;
        notices.extend(scene.generated.iter().filter_map(Generated::shortfall));
        notices.extend(start::another(&scene, &world));
        let read = scene
            .expects
            .iter()
            .flat_map(|expect| expect.what.columns())
            .collect();
        let recording = Recording::new(scene.history.every, &scene.history.columns, read);
        let journal = Journal {
            program: env!("CARGO_PKG_VERSION").to_owned(),
            preset_name: scene.name.clone(),
            preset_text: scene.text.clone(),
            seed: options.seed,
            overrides: start::noted(&scene, &world),
            ..Journal::default()
        };
        let reference = Reference::of(&world);
        Ok(Self {
            scene,
            world,
            control: Control::default(),
            course: Course::default(),
            recording,
            journal,
            csv: None,
            dump_stem: None,
            dumped: None,
            journal_file: None,
            notices,
            averages_only: false,
            follower: None,
            reference,
            safe: None,
            safe_due: None,
            safe_fault: None,
            urgent: None,
            expendable: options.expendable,
            panic_at: None,
        })
    }

    /// Rows go to this history from now on.
    pub fn write_history(&mut self, history: History) {
        self.csv = Some(history);
    }

    /// Rows go to the history in `path`, with those so far. A file that is there must be that of this
    /// run: it is cut back to the rows so far or completed.
    pub fn go_on_with_history(&mut self, path: &Path) -> Result<(), RunError> {
        let regular = std::fs::metadata(path).map(|file| file.is_file());
        // A device or pipe holds nothing to compare with, and reading it might never end.
        self.csv = Some(if regular.unwrap_or(false) {
            self.recording.go_on(path, &self.scene.stages)?
        } else {
            self.whole_history(path)?
        });
        Ok(())
    }

    /// Events go to this file from now on; those so far are written first.
    pub fn write_journal(&mut self, path: &Path) -> Result<(), RunError> {
        self.journal_file = Some(JournalWriter::create(path, &self.journal)?);
        Ok(())
    }

    /// Writes every row so far as CSV.
    pub fn export_csv(&self, path: &Path) -> Result<u64, RunError> {
        self.whole_history(path)?.sync()?;
        Ok(self.recording.rows().len() as u64)
    }

    /// Writes every row so far as CSV to standard output.
    pub fn export_stdout(&self) -> Result<(), RunError> {
        let history = History::to_stdout(&self.recording.names())?;
        Ok(self.with_rows(history)?.flush()?)
    }

    fn whole_history(&self, path: &Path) -> Result<History, RunError> {
        self.with_rows(History::create(path, &self.recording.names())?)
    }

    fn with_rows(&self, mut history: History) -> Result<History, RunError> {
        for row in self.recording.rows() {
            let stage = self.scene.stages.get(row.stage as usize);
            self.recording
                .write(row, stage.map_or("", |stage| &stage.name), &mut history)?;
        }
        Ok(history)
    }
}
