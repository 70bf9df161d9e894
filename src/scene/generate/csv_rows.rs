//! Rows of a CSV file (RFC 4180) with a header; lines that begin with # are left out.

use super::MOST;
use crate::measure::columns::nearest;
use crate::scene::draft::Draft;
use crate::scene::enclosed;
use crate::scene::place::{Place, quoted};
use crate::scene::problem::Problem;
use crate::scene::reader::Reader;

/// The columns of a file that are read.
pub(super) struct Columns {
    /// Those it must have.
    pub(super) required: &'static [&'static str],
    /// Those it may have.
    pub(super) optional: &'static [&'static str],
    /// Those that may stand there and mean nothing here.
    pub(super) ignored: &'static [&'static str],
}

/// A file being read.
pub(super) struct Table<'t> {
    name: &'t str,
    place: Place,
    draft: &'t Draft<'t>,
}

/// One row: its line and the cells of required, then optional columns, where there are such.
pub(super) struct Row<'r> {
    line: u64,
    cells: &'r [Option<&'r str>],
}

/// Which of the columns a file has: required, then optional ones.
pub(super) struct Present(Vec<bool>);

impl Present {
    /// Whether it has column `k`.
    pub(super) fn has(&self, k: usize) -> bool {
        self.0.get(k).copied().unwrap_or(false)
    }
}

/// Reads the file that a key names, row by row; answers which columns it has if all of it could be read.
pub(super) fn read<'a>(
    reader: &Reader<'a>,
    key: &'static str,
    columns: &Columns,
    draft: &mut Draft<'a>,
    mut take: impl FnMut(&Table<'_>, &Row<'_>) -> Option<()>,
) -> Option<Present> {
    let (name, place) = reader.text(key)?;
    let text = enclosed::text(draft, name, place)?;
    let table = Table { name, place, draft };
    let mut rows = csv::ReaderBuilder::new()
        .comment(Some(b'#'))
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let header = match rows.headers() {
        Ok(header) => header.clone(),
        Err(error) => return table.broken(&error),
    };
    let places = table.places(&header, columns)?;
    let mut record = csv::StringRecord::new();
    let mut sound = true;
    for count in 0.. {
        match rows.read_record(&mut record) {
            Ok(false) => break,
            Err(error) => return table.broken(&error),
            Ok(true) => {}
        }
        let cells: Vec<Option<&str>> = places
            .iter()
            .map(|place| place.and_then(|place| record.get(place)))
            .collect();
        let line = record.position().map_or(0, csv::Position::line);
        let row = Row {
            line,
            cells: &cells,
        };
        if count == MOST {
            return table.refuse(
                line,
                &format!("this is the {}th row", MOST + 1),
                &format!("expected {MOST} at most"),
                "leave some out",
            );
        }
        if take(&table, &row).is_none() {
            sound = false;
        }
        if draft_is_full(&table) {
            return None;
        }
    }
    sound.then(|| Present(places.iter().map(Option::is_some).collect()))
}

fn draft_is_full(table: &Table<'_>) -> bool {
    table.draft.report.is_full()
}

impl Table<'_> {
    /// Reports what is wrong with a line.
    pub(super) fn refuse<T>(
        &self,
        line: u64,
        what: &str,
        expected: &str,
        remedy: &str,
    ) -> Option<T> {
        let message = format!("{}, line {line}: {what}", quoted(self.name));
        self.draft.report.add(
            Problem::new(message, self.place)
                .expected(expected)
                .remedy(remedy),
        );
        None
    }

    /// A number of a row: column `k` of this name.
    pub(super) fn number(&self, row: &Row<'_>, k: usize, name: &str) -> Option<f64> {
        let text = row.cells.get(k).copied().flatten().unwrap_or_default();
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Some(number),
            _ => self.refuse(
                row.line,
                &format!("`{name}` cannot be {}", quoted(text)),
                "expected finite numbers in this column",
                "write numbers like 0.5, -3 or 1e-3",
            ),
        }
    }

    /// A radius.
    pub(super) fn radius(&self, row: &Row<'_>, k: usize) -> Option<f64> {
        let radius = self.number(row, k, "radius")?;
        if radius > 0.0 {
            return Some(radius);
        }
        self.refuse(
            row.line,
            &format!("`radius` cannot be {radius}"),
            "expected radii > 0 [m]",
            "lengths are in metres",
        )
    }

    /// What the scene knows.
    pub(super) fn draft(&self) -> &Draft<'_> {
        self.draft
    }

    fn broken<T>(&self, error: &csv::Error) -> Option<T> {
        let line = error.position().map_or(1, csv::Position::line);
        let what = match error.kind() {
            csv::ErrorKind::UnequalLengths {
                expected_len, len, ..
            } => format!("{len} cells under a header of {expected_len}"),
            _ => error.to_string(),
        };
        self.refuse(
            line,
            &what,
            "expected a CSV file with a header row",
            "separate cells with commas, as many in each row as in the header",
        )
    }

    fn places(&self, header: &csv::StringRecord, columns: &Columns) -> Option<Vec<Option<usize>>> {
        let known = || columns.required.iter().chain(columns.optional).copied();
        for cell in header {
            if !known()
                .chain(columns.ignored.iter().copied())
                .any(|name| name == cell)
            {
                return self.refuse(
                    1,
                    &format!("there is no column {}", quoted(cell)),
                    &format!("expected {}", list(columns)),
                    &nearest(cell, known()),
                );
            }
        }
        let place = |name: &str| header.iter().position(|cell| cell == name);
        if let Some(missing) = columns.required.iter().find(|name| place(name).is_none()) {
            return self.refuse(
                1,
                &format!("the header has no `{missing}`"),
                &format!("expected {}", list(columns)),
                "the first row names the columns, separated by commas",
            );
        }
        Some(known().map(place).collect())
    }
}

impl Row<'_> {
    /// The text of column `k`, if the file has it.
    pub(super) fn text(&self, k: usize) -> Option<&str> {
        self.cells.get(k).copied().flatten()
    }

    /// Its line in the file, from 1.
    pub(super) fn line(&self) -> u64 {
        self.line
    }
}

fn list(columns: &Columns) -> String {
    let required = columns.required.join(", ");
    match columns.optional {
        [] => format!("the columns {required}"),
        more => format!("the columns {required}, and any of {}", more.join(", ")),
    }
}
