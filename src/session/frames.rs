//! Frames: everything a screen shows, taken at a cycle boundary.

use std::sync::Arc;
use std::time::Duration;

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

/// While cycles run the stability bound shown may be so old.
const LIMIT_AGE: Duration = Duration::from_secs(1);

/// Which costly parts of a frame are wanted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Wants {
    /// Discs, contacts and walls.
    pub picture: bool,
    /// What is seen of them, where they are too many to be seen all.
    pub sight: Option<Sight>,
    /// Number of a particle that is there with its contacts whether it can be seen or not.
    pub selected: Option<u32>,
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
            energies: true,
            survey: Parts::default(),
            polygon: None,
        }
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
    /// Largest stable FRAC by the stiffness bound.
    pub frac_limit: f64,
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
    /// The stability bound: it costs more than the rest of a frame.
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
        let none = Duration::ZERO;
        let names = || Arc::new(self.known());
        let known = Arc::clone(Kept::get(&mut shown.known, now, none, |_| true, names));
        let sample = Sample::over(&mut self.world, &self.scene.regions, Some(&self.reference));
        let suit = |measures: &Measures| measures.suit(wants);
        let measures = || Measures::of(&sample, wants);
        let measures = Kept::get(&mut shown.measures, now, none, suit, measures);
        let picture = if wants.picture {
            Picture::seen(sample.world(), wants.sight.as_ref(), wants.selected)
        } else {
            Picture::default()
        };
        let world = &self.world;
        let limit = || world.frac_limit();
        let frac_limit = *Kept::get(&mut shown.limit, now, LIMIT_AGE, |_| true, limit);
        Frame {
            serial: shown.serial,
            title: self.scene.about.title.clone(),
            preset: self.scene.name.clone(),
            cycle: world.cycle_number(),
            time: world.time(),
            dt: world.dt(),
            frac: world.frac(),
            frac_limit,
            stage: self.stage_name().to_owned(),
            stages: ((stage + 1).min(stages), stages),
            stage_cycles,
            finished: self.is_finished(),
            running,
            rate,
            assembly: measures.assembly,
            fracc: world.fracc_monitor().clone(),
            picture,
            energies: measures.energies,
            bookings: measures.bookings,
            contact: self.inspection(),
            survey: measures.survey.clone(),
            polygon: measures.polygon.clone(),
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
