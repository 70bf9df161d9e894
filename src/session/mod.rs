//! A run: a scene, its world, where it stands in its stages, its history and its journal.
//!
//! Whoever runs it, headless, workbench or test, does the same: [`Session::advance`] in batches,
//! [`Session::execute`] between them. Everything that changes a world is a `Command`, so a key, a
//! typed line, a stage and a journal cannot drift apart.

mod advance;
mod change;
mod clock;
mod course;
mod dump;
mod error;
mod execute;
pub mod figure;
mod files;
pub mod frames;
mod generate;
pub mod inspect;
mod kept;
pub mod lammps;
mod opening;
mod pacing;
pub(crate) mod pictures;
mod places;
mod print;
mod queue;
mod rate;
mod reach;
mod recording;
mod replay;
mod room;
pub mod run_folder;
mod save;
mod save_clock;
pub mod saves;
mod stage_end;
pub mod start;
mod steer;
mod tables;
mod turns;
mod verdict;
pub mod worker;

pub use advance::{Budget, Progress};
pub use course::Errand;
pub use error::{Refusal, RunError};
pub use execute::{By, Reply, Request};
pub use opening::Options;
pub use print::boundary_itself;
pub use reach::{Place, Reached};
pub use recording::{Recording, Row};
pub use replay::Replay;

use std::path::PathBuf;

use crate::control::Control;
use crate::engine::World;
use crate::measure::columns::Names;
use crate::measure::reference::Reference;
use crate::measure::sample::Sample;
use crate::record::checkpoint::{Aside, CheckpointFault};
use crate::record::history::History;
use crate::record::journal::{Event, EventKind, Journal, JournalWriter};
use crate::scene::Scene;
use course::Course;

/// A run.
pub struct Session {
    scene: Scene,
    world: World,
    control: Control,
    course: Course,
    recording: Recording,
    journal: Journal,
    /// Where rows go besides memory.
    csv: Option<History>,
    /// Path that the names of dumps begin with, if any are written; a large state to go back to is put
    /// in its folder.
    dump_stem: Option<PathBuf>,
    /// Cycle of the last dump: of several states of one cycle the first is kept, as in the history.
    dumped: Option<u64>,
    /// Where events go besides memory.
    journal_file: Option<JournalWriter>,
    /// Things the user should know, in order.
    notices: Vec<String>,
    /// Whether PRINT BALLS and PRINT CONTACTS show only largest, smallest and mean.
    averages_only: bool,
    /// Follows the contact that is inspected.
    follower: Option<inspect::Follower>,
    /// State that displacements are measured from.
    reference: Reference,
    /// Cycle and checkpoint of a good state, for a run that goes wrong.
    safe: Option<(u64, Aside)>,
    /// When the next such state is due.
    safe_due: Option<std::time::Instant>,
    /// Why the last one that could not be kept was not.
    safe_fault: Option<CheckpointFault>,
    /// What such a state is put off for.
    urgent: Option<Box<dyn Fn() -> bool + Send>>,
    /// No such state is wanted.
    expendable: bool,
    /// For tests of what happens then: panic at this cycle.
    panic_at: Option<u64>,
}

impl Session {
    /// The scene it runs.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// The world as it is.
    pub fn world(&self) -> &World {
        &self.world
    }

    /// The world, for measuring: sums of forces may be made.
    pub fn world_mut(&mut self) -> &mut World {
        &mut self.world
    }

    /// The world, its regions and its reference at this boundary, ready to be measured.
    pub fn sample(&mut self) -> Sample<'_> {
        let regions = &self.scene.regions;
        Sample::over(&mut self.world, regions, Some(&self.reference))
    }

    /// What was recorded.
    pub fn recording(&self) -> &Recording {
        &self.recording
    }

    /// What was recorded, when nothing else is wanted any more.
    pub fn into_recording(self) -> Recording {
        self.recording
    }

    /// What was done.
    pub fn journal(&self) -> &Journal {
        &self.journal
    }

    /// Name of the stage being run, or run last.
    pub fn stage_name(&self) -> &str {
        self.scene
            .stages
            .get(self.course.stage)
            .map_or("", |stage| &stage.name)
    }

    /// Number of the stage being run, from 0, and how many there are.
    pub fn stage_number(&self) -> (usize, usize) {
        (self.course.stage, self.scene.stages.len())
    }

    /// How many stages have ended.
    pub fn stages_done(&self) -> usize {
        self.course.done(self.scene.stages.len())
    }

    /// Cycles done in the stage.
    pub fn stage_cycle(&self) -> u64 {
        self.world.cycle_number() - self.course.started_at
    }

    /// Length of the present stage as far as it is known [cycles].
    pub fn stage_length(&self) -> Option<u64> {
        self.scene
            .stages
            .get(self.course.stage)
            .and_then(|stage| stage.max_cycles)
    }

    /// Whether all stages are done.
    pub fn is_finished(&self) -> bool {
        self.course.is_finished(self.scene.stages.len())
    }

    /// Whether a stage ended at its `max_cycles` although it has a condition.
    pub fn cut_short(&self) -> &[String] {
        &self.course.cut_short
    }

    /// Takes what the user should know.
    pub fn take_notices(&mut self) -> Vec<String> {
        std::mem::take(&mut self.notices)
    }

    /// What names refer to now.
    pub fn names(&self) -> Names {
        Names {
            walls: self
                .world
                .walls()
                .iter()
                .map(|wall| wall.name.clone())
                .collect(),
            particles: self.world.particles().id.clone(),
            regions: self.scene.region_names(),
            materials: self
                .world
                .model()
                .materials
                .iter()
                .map(|material| material.name.clone())
                .collect(),
            open: false,
        }
    }

    /// For tests of what happens then: panics when this cycle is reached, or at a command there.
    pub fn panic_at(&mut self, cycle: Option<u64>) {
        self.panic_at = cycle;
    }

    fn panic_if_asked(&self) {
        let asked = self.panic_at == Some(self.world.cycle_number());
        assert!(!asked, "asked to panic here");
    }

    fn note(&mut self, kind: EventKind) -> Result<(), RunError> {
        self.note_at(self.world.cycle_number(), kind)
    }

    fn note_at(&mut self, cycle: u64, kind: EventKind) -> Result<(), RunError> {
        let event = Event { cycle, kind };
        let written = self
            .journal_file
            .as_mut()
            .map_or(Ok(()), |file| file.append(&event));
        self.journal.events.push(event);
        Ok(written?)
    }
}
