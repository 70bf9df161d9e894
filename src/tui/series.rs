//! Histories for charts: every row up to a limit, then every second one, and so on.

use crate::language::Observable;
use crate::session::frames::{ChartRow, Frame};

/// Rows kept at most.
const MOST: usize = 8192;

/// What charts draw from.
#[derive(Debug, Default)]
pub struct Series {
    /// Columns of the rows.
    pub columns: Vec<Observable>,
    rows: Vec<ChartRow>,
    /// Only every so many rows is kept.
    stride: usize,
    /// Rows left out since the last one kept.
    skipped: usize,
}

impl Series {
    /// Takes the new rows of a frame.
    pub fn take(&mut self, frame: &mut Frame) {
        if frame.restarted || self.stride == 0 {
            *self = Self {
                columns: frame.columns.to_vec(),
                stride: 1,
                ..Self::default()
            };
        }
        for row in frame.rows.drain(..) {
            self.skipped += 1;
            if self.skipped < self.stride {
                continue;
            }
            self.skipped = 0;
            self.rows.push(row);
            if self.rows.len() > MOST {
                let mut keep = false;
                self.rows.retain(|_| {
                    keep = !keep;
                    keep
                });
                self.stride *= 2;
            }
        }
    }

    /// All rows kept.
    pub fn rows(&self) -> &[ChartRow] {
        &self.rows
    }

    /// Cycle and value of a column, row by row, undefined values left out.
    pub fn points(&self, column: usize) -> impl Iterator<Item = (u64, f64)> + '_ {
        self.rows
            .iter()
            .map(move |row| {
                (
                    row.cycle,
                    row.values.get(column).copied().unwrap_or(f64::NAN),
                )
            })
            .filter(|(_, value)| value.is_finite())
    }

    /// Place of a column by name.
    pub fn position(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name() == name)
    }
}
