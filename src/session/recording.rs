//! The history in memory: every row of the run, for expectations, charts and export.

use std::path::Path;

use serde::{Deserialize, Serialize};

use crate::language::{Observable, Term};
use crate::measure::columns::{Column, Kind};
use crate::measure::sample::Sample;
use crate::record::error::RecordError;
use crate::record::history::{History, Resuming};
use crate::record::number::Cell;
use crate::scene::Stage;

/// One row.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Cycles done.
    pub cycle: u64,
    /// Simulated time [s].
    pub time: f64,
    /// Index of the stage just run.
    pub stage: u32,
    /// Cycles done in that stage.
    pub stage_cycle: u64,
    /// Bits of the values, one per recorded column.
    bits: Vec<u64>,
}

/// All rows, and which columns they have.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Recording {
    /// A row every so many cycles.
    pub every: u64,
    /// Columns that are shown and exported, in order.
    shown: Vec<usize>,
    /// All recorded columns: those shown, and those only expectations read.
    columns: Vec<Observable>,
    rows: Vec<Row>,
}

impl Recording {
    /// Records `shown` and, unseen, `read`.
    pub(super) fn new(every: u64, shown: &[Observable], read: Vec<Column>) -> Self {
        let mut recording = Self {
            every,
            ..Self::default()
        };
        recording.show(shown);
        for column in read {
            recording.place(Observable::Column(column));
        }
        recording
    }

    /// Whether it is one that this program has written: rows and columns belong together.
    pub(super) fn is_sound(&self) -> bool {
        let columns = self.columns.len();
        self.every > 0
            && self.shown.iter().all(|&k| k < columns)
            && self.rows.iter().all(|row| row.bits.len() <= columns)
    }

    fn place(&mut self, column: Observable) -> usize {
        self.columns
            .iter()
            .position(|known| *known == column)
            .unwrap_or_else(|| {
                self.columns.push(column);
                self.columns.len() - 1
            })
    }

    /// Shows other columns from now on; rows before a column was recorded hold NaN.
    pub(super) fn show(&mut self, columns: &[Observable]) {
        self.shown = columns
            .iter()
            .map(|column| self.place(column.clone()))
            .collect();
    }

    /// Columns that are shown.
    pub fn shown(&self) -> impl Iterator<Item = &Observable> {
        self.shown.iter().map(|&k| &self.columns[k])
    }

    /// All rows.
    pub fn rows(&self) -> &[Row] {
        &self.rows
    }

    /// Names of the columns that are shown.
    pub fn names(&self) -> Vec<String> {
        self.shown().map(Observable::name).collect()
    }

    /// Place of a recorded column.
    pub fn position(&self, column: &Observable) -> Option<usize> {
        self.columns.iter().position(|known| known == column)
    }

    /// Value in a row; NaN where it was not recorded.
    pub fn value(&self, row: usize, column: usize) -> f64 {
        self.rows[row]
            .bits
            .get(column)
            .map_or(f64::NAN, |&bits| f64::from_bits(bits))
    }

    /// Value of a term of an expression in a row.
    pub fn term(&self, row: usize, term: &Term) -> f64 {
        let of = &self.rows[row];
        match term {
            Term::Cycle => of.cycle as f64,
            Term::Time => of.time,
            Term::StageCycle => of.stage_cycle as f64,
            Term::Column(column) => {
                let mut known = self.columns.iter();
                known
                    .position(|known| matches!(known, Observable::Column(own) if own == column))
                    .map_or(f64::NAN, |place| self.value(row, place))
            }
        }
    }

    /// Measures a row.
    pub(super) fn take(&mut self, sample: &Sample<'_>, stage: u32, stage_cycle: u64) {
        let bits = self
            .columns
            .iter()
            .map(|column| column.value(sample, stage_cycle).to_bits())
            .collect();
        let world = sample.world();
        let (cycle, time) = (world.cycle_number(), world.time());
        self.rows.push(Row {
            cycle,
            time,
            stage,
            stage_cycle,
            bits,
        });
    }

    /// Cells of a row: one for each column that is shown.
    fn cells(&self, row: &Row) -> Vec<Cell<'static>> {
        self.shown
            .iter()
            .map(|&k| {
                // The column is younger than the row.
                let Some(&bits) = row.bits.get(k) else {
                    return Cell::Real(f64::NAN);
                };
                let value = f64::from_bits(bits);
                match self.columns[k].kind() {
                    Kind::Hash => Cell::Hash(bits),
                    Kind::Count if value >= 0.0 => Cell::Count(value as u64),
                    Kind::Count | Kind::Real => Cell::Real(value),
                }
            })
            .collect()
    }

    /// Writes a row to a history.
    pub fn write(&self, row: &Row, stage: &str, to: &mut History) -> Result<(), RecordError> {
        to.row(row.cycle, row.time, stage, &self.cells(row))
    }

    /// Goes on with the history in `path`, which must be that of these rows; `stages` are the names
    /// of the stages.
    pub(super) fn go_on(&self, path: &Path, stages: &[Stage]) -> Result<History, RecordError> {
        let mut resuming = Resuming::open(path, &self.names())?;
        for row in &self.rows {
            let stage = stages.get(row.stage as usize);
            let name = stage.map_or("", |stage| &stage.name);
            resuming.row(row.cycle, row.time, name, &self.cells(row))?;
        }
        resuming.finish()
    }
}
