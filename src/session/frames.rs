//! Frames: everything a screen shows, taken at a cycle boundary.

use std::sync::Arc;

use super::Session;
use super::inspect::Inspection;
use super::kept::{Kept, Moment};
use crate::engine::ledger::{Bookings, Energies};
use crate::engine::world::FraccMonitor;
use crate::language::{Known, Observable};
use crate::measure::assembly::Assembly;
use crate::measure::columns::Kind;
use crate::measure::frame::Picture;
use crate::measure::polygon::ForcePolygon;
use crate::measure::sample::Sample;
use crate::measure::sight::Sight;
use crate::measure::survey::{Parts, Survey};

/// Which costly parts of a frame are wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(
    clippy::struct_excessive_bools,
    reason = "each part is wanted or not, whatever the others"
)]
pub struct Wants {
    /// Discs, contacts and walls.
    pub picture: bool,
    /// What is seen of them, where they are too many to be seen all.
    pub sight: Option<Sight>,
    /// Number of a particle that is there with its contacts whether it can be seen or not.
    pub selected: Option<u32>,
    /// Velocities also in a picture of part of the particles; the selected one has it anyway.
    pub velocities: bool,
    /// The stability bound.
    pub limit: bool,
    /// Energies, if they are booked or not.
    pub energies: bool,
    /// Measures of the first region.
    pub survey: Parts,
    /// The polygon of the forces on the particle of this number.
    pub polygon: Option<u32>,
}

impl Default for Wants {
    fn default() -> Self {
        Self {
            picture: true,
            sight: None,
            selected: None,
            velocities: true,
            limit: true,
            energies: true,
            survey: Parts::default(),
            polygon: None,
        }
    }
}

impl Wants {
    /// Whether who wants this is served by what these ask for: an assembly that falls or shakes moves what
    /// is seen of it by less than a dot, and nobody sees the difference.
    pub fn serve(&self, wanted: &Self) -> bool {
        let same = |asked: &Sight| {
            let of = Self {
                sight: Some(*asked),
                ..*wanted
            };
            *self == of
                && wanted
                    .sight
                    .is_some_and(|sight| asked.is_within_a_dot(&sight))
        };
        self == wanted || self.sight.as_ref().is_some_and(same)
    }

    /// Whether they ask for measures of the first region.
    pub fn measures(&self) -> bool {
        self.energies || self.survey != Parts::default() || self.polygon.is_some()
    }
}

/// A row of the history for charts.
#[derive(Debug, Clone, PartialEq)]
pub struct ChartRow {
    /// Cycles done.
    pub cycle: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Index of the stage.
    pub stage: u32,
    /// Values of the columns in [`Frame::columns`].
    pub values: Vec<f64>,
}

/// What a screen shows.
#[derive(Debug, Clone)]
pub struct Frame {
    /// Counts up from frame to frame.
    pub serial: u64,
    /// Title of the preset.
    pub title: String,
    /// Name of the preset.
    pub preset: String,
    /// Cycles done.
    pub cycle: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Time step [s].
    pub dt: f64,
    /// FRAC.
    pub frac: f64,
    /// Largest stable FRAC by the stiffness bound; NaN if it is not wanted.
    pub frac_limit: f64,
    /// Cycle that this belongs to: of a large assembly it may be an earlier one.
    pub frac_limit_of: u64,
    /// Name of the stage.
    pub stage: String,
    /// Stage number from 1, and how many there are.
    pub stages: (usize, usize),
    /// Cycles done in the stage, and its greatest length if known.
    pub stage_cycles: (u64, Option<u64>),
    /// Whether all stages are done.
    pub finished: bool,
    /// Whether cycles are running.
    pub running: bool,
    /// Cycles per second of wall clock, lately.
    pub rate: f64,
    /// Cycle that contact statistics, energies, survey and polygon belong to: while cycles of a large
    /// assembly run it may be an earlier one.
    pub measures_of: u64,
    /// Contact statistics.
    pub assembly: Assembly,
    /// What the FRACC monitor saw.
    pub fracc: FraccMonitor,
    /// The assembly, if wanted.
    pub picture: Picture,
    /// Energies, if wanted.
    pub energies: Option<Energies>,
    /// Losses and work, if wanted and booked.
    pub bookings: Option<Bookings>,
    /// The contact that is followed, if one is.
    pub contact: Option<Inspection>,
    /// Measures of the first region, those wanted.
    pub survey: Survey,
    /// Forces on a particle, if wanted and there.
    pub polygon: Option<ForcePolygon>,
    /// Columns that are recorded and are numbers.
    pub columns: Arc<[Observable]>,
    /// Rows recorded since the last frame.
    pub rows: Vec<ChartRow>,
    /// Whether `rows` begins the history anew.
    pub restarted: bool,
    /// Friction of each material by name.
    pub friction: Vec<(String, f64)>,
    /// Every so many cycles a row.
    pub every: u64,
    /// Names for completion.
    pub known: Arc<Known>,
}

/// What is measured for a frame.
#[derive(Debug)]
struct Measures {
    wants: Wants,
    assembly: Assembly,
    survey: Survey,
    polygon: Option<ForcePolygon>,
    energies: Option<Energies>,
    bookings: Option<Bookings>,
}

impl Measures {
    fn of(sample: &Sample<'_>, wants: Wants) -> Self {
        let drawn = wants
            .polygon
            .and_then(|id| sample.world().particles().index(id));
        let booked = wants.energies && sample.world().ledger().is_some();
        Self {
            wants,
            assembly: *sample.assembly(),
            survey: Survey::of(sample, wants.survey),
            polygon: drawn.map(|p| ForcePolygon::of(sample.world(), p)),
            energies: wants.energies.then(|| *sample.energies()),
            bookings: booked.then(|| *sample.bookings()),
        }
    }

    /// Whether they are what is wanted.
    fn suit(&self, wants: Wants) -> bool {
        let of = |wants: Wants| (wants.survey, wants.energies, wants.polygon);
        of(self.wants) == of(wants)
    }
}

/// What has been shown already.
#[derive(Debug, Default)]
pub struct Shown {
    serial: u64,
    rows: usize,
    columns: Arc<[Observable]>,
    measures: Option<Kept<Measures>>,
    limit: Option<Kept<f64>>,
    known: Option<Kept<Arc<Known>>>,
}

impl Shown {
    /// A command may have changed anything: nothing is kept.
    pub fn forget(&mut self) {
        (self.measures, self.limit, self.known) = (None, None, None);
    }
}

impl Session {
    /// Takes a frame.
    pub fn frame(&mut self, wants: Wants, rate: f64, running: bool, shown: &mut Shown) -> Frame {
        let columns: Vec<Observable> = self
            .recording()
            .shown()
            .filter(|c| c.kind() != Kind::Hash)
            .cloned()
            .collect();
        let rows = self.recording().rows().len();
        let restarted = rows < shown.rows || *shown.columns != *columns || shown.serial == 0;
        if restarted {
            shown.rows = 0;
            shown.columns = columns.into();
        }
        let places: Vec<Option<usize>> = shown
            .columns
            .iter()
            .map(|column| self.recording().position(column))
            .collect();
        let new = (shown.rows..rows).map(|row| {
            let of = &self.recording().rows()[row];
            let value =
                |place: &Option<usize>| place.map_or(f64::NAN, |k| self.recording().value(row, k));
            ChartRow {
                cycle: of.cycle,
                time: of.time,
                stage: of.stage,
                values: places.iter().map(value).collect(),
            }
        });
        let new: Vec<ChartRow> = new.collect();
        shown.rows = rows;
        shown.serial += 1;
        let (stage, stages) = self.stage_number();
        let stage_cycles = (self.stage_cycle(), self.stage_length());
        let now = Moment {
            cycle: self.world.cycle_number(),
            events: self.journal.events.len(),
            running,
        };
        // Names change by commands only.
        let unmoved = Moment { cycle: 0, ..now };
        let names = || Arc::new(self.known());
        let known = Arc::clone(&Kept::get(&mut shown.known, unmoved, |_| true, names).value);
        let suit = |measures: &Measures| measures.suit(wants);
        let measures = || {
            let (regions, reference) = (&self.scene.regions, Some(&self.reference));
            Measures::of(&Sample::over(&mut self.world, regions, reference), wants)
        };
        let measures = Kept::get(&mut shown.measures, now, suit, measures);
        let picture = if wants.picture {
            let shows_velocities = wants.velocities || wants.selected.is_some();
            if shows_velocities || !Picture::is_of_part(&self.world) {
                self.world.settle();
            }
            Picture::seen(&self.world, wants.sight.as_ref(), wants.selected)
        } else {
            Picture::default()
        };
        let world = &self.world;
        let (frac_limit, frac_limit_of) = if wants.limit {
            let limit = Kept::get(&mut shown.limit, now, |_| true, || world.frac_limit());
            (limit.value, limit.cycle)
        } else {
            (f64::NAN, now.cycle)
        };
        Frame {
            serial: shown.serial,
            title: self.scene.about.title.clone(),
            preset: self.scene.name.clone(),
            cycle: world.cycle_number(),
            time: world.time(),
            dt: world.dt(),
            frac: world.frac(),
            frac_limit,
            frac_limit_of,
            stage: self.stage_name().to_owned(),
            stages: ((stage + 1).min(stages), stages),
            stage_cycles,
            finished: self.is_finished(),
            running,
            rate,
            measures_of: measures.cycle,
            assembly: measures.value.assembly,
            fracc: world.fracc_monitor().clone(),
            picture,
            energies: measures.value.energies,
            bookings: measures.value.bookings,
            contact: self.inspection(),
            survey: measures.value.survey.clone(),
            polygon: measures.value.polygon.clone(),
            columns: Arc::clone(&shown.columns),
            rows: new,
            restarted,
            friction: world
                .model()
                .materials
                .iter()
                .map(|m| (m.name.clone(), m.friction))
                .collect(),
            every: self.recording.every,
            known,
        }
    }
}
