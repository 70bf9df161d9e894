//! A CSV file as text: the history of a run or of an ensemble, or marks for a chart.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use csv::{ErrorKind, ReaderBuilder, StringRecord, Trim};

use crate::measure::columns::nearest;
use crate::record::error::{Attempt, RecordError};
use crate::record::history::FIRST_COLUMNS;
use crate::session::Refusal;

/// What the names of an ensemble's columns end with.
const TOLD: [&str; 4] = [":mean", ":sd", ":min", ":max"];

/// The cells of a file.
pub struct Table {
    /// Path of the file.
    pub name: String,
    header: StringRecord,
    /// With the line they are from.
    rows: Vec<(u64, StringRecord)>,
}

/// Where a quantity stands in a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// A column of this name.
    Single(usize),
    /// Mean over an ensemble; standard deviation, minimum and maximum where they are there.
    Spread(usize, [Option<usize>; 3]),
}

/// Longest first line [bytes].
const LONGEST: u64 = 16 << 20;

impl Table {
    /// Reads a file with a header; lines that begin with # are left out.
    pub fn read(path: &Path) -> Result<Self, Refusal> {
        let name = path.display().to_string();
        let unread = |attempt| {
            let name = name.clone();
            move |error| {
                let said = RecordError::new(path, attempt, error).to_string();
                let (message, remedy) = said.rsplit_once("; ").unwrap_or((&said, "check the path"));
                debug_assert!(message.contains(&name));
                Refusal::new(message, remedy)
            }
        };
        let file = File::open(path).map_err(unread(Attempt::Open))?;
        // A folder opens as well as a file does.
        let folder = file.metadata().is_ok_and(|file| file.is_dir());
        if folder {
            return Err(unread(Attempt::Read)(
                std::io::ErrorKind::IsADirectory.into(),
            ));
        }
        // What never ends a line is no table, and would be read until memory is full.
        let mut start = Vec::new();
        let mut file = BufReader::new(file);
        (&mut file)
            .take(LONGEST)
            .read_until(b'\n', &mut start)
            .map_err(unread(Attempt::Read))?;
        if start.len() as u64 == LONGEST {
            return Err(Refusal::new(
                format!(
                    "the first line of {name} is longer than {} MiB",
                    LONGEST >> 20
                ),
                "is this the right file? A history has a header with the names of its columns",
            ));
        }
        let mut reader = ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(Trim::All)
            .from_reader(start.as_slice().chain(file));
        let header = reader.headers().map_err(|error| broken(&name, &error))?;
        let header = header.clone();
        let mut rows = Vec::new();
        for row in reader.into_records() {
            let row = row.map_err(|error| broken(&name, &error))?;
            let line = row.position().map_or(0, csv::Position::line);
            rows.push((line, row));
        }
        let table = Self { name, header, rows };
        if table.header.is_empty() {
            return Err(table.refuse(
                "is empty",
                "a history has a header with the names of its columns: `ballast run --csv` writes one",
            ));
        }
        if table.rows.is_empty() {
            return Err(table.refuse(
                "has a header and no rows: there is nothing to draw",
                "run longer, or with a smaller history.every",
            ));
        }
        Ok(table)
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.rows.len()
    }

    /// The cell of a row.
    pub fn text(&self, row: usize, column: usize) -> &str {
        self.rows[row].1.get(column).unwrap_or_default()
    }

    /// The number in a cell of a row.
    pub fn number(&self, row: usize, column: usize) -> Result<f64, Refusal> {
        let text = self.text(row, column);
        text.parse().map_err(|_| {
            let (line, column) = (self.rows[row].0, &self.header[column]);
            Refusal::new(
                format!(
                    "{}, line {line}: `{column}` is `{text}`, which is no number",
                    self.name
                ),
                "numbers are written like 0.5, -3, 1e-3 or nan",
            )
        })
    }

    /// The column of exactly this name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|cell| cell == name)
    }

    /// Where a quantity stands: in a column of its name, or spread over those of an ensemble.
    pub fn find(&self, name: &str) -> Result<Place, Refusal> {
        if name == FIRST_COLUMNS[2] {
            return Err(self.refuse(
                "the column `stage` holds names, not numbers",
                "draw another; `--stage NAME` takes the rows of one stage",
            ));
        }
        if let Some(single) = self.column(name) {
            return Ok(Place::Single(single));
        }
        let told = TOLD.map(|told| self.column(&format!("{name}{told}")));
        if let [Some(mean), spread @ ..] = told {
            return Ok(Place::Spread(mean, spread));
        }
        let mut known: Vec<&str> = self.header.iter().map(without_told).collect();
        known.dedup();
        known.retain(|known| *known != FIRST_COLUMNS[2]);
        Err(self.refuse(
            &format!("there is no column `{name}`"),
            &nearest(name, known.into_iter()),
        ))
    }

    /// What is wrong with this file.
    pub fn refuse(&self, message: &str, remedy: &str) -> Refusal {
        Refusal::new(format!("{}: {message}", self.name), remedy)
    }
}

/// The name of a quantity without what is told of it over an ensemble.
pub(super) fn without_told(name: &str) -> &str {
    let found = TOLD.iter().find_map(|told| name.strip_suffix(told));
    found.unwrap_or(name)
}

fn broken(name: &str, error: &csv::Error) -> Refusal {
    let line = error.position().map_or(1, csv::Position::line);
    let what = match error.kind() {
        ErrorKind::UnequalLengths {
            expected_len, len, ..
        } => format!("{len} cells under a header of {expected_len}"),
        ErrorKind::Utf8 { .. } => "this is no text".to_owned(),
        _ => error.to_string(),
    };
    Refusal::new(
        format!("{name}, line {line}: {what}"),
        "a history is a CSV file with a header row, as `ballast run --csv` writes it",
    )
}
