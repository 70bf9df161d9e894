//! Going on with the history of an earlier run.

use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

use super::{History, encode_row, header};
use crate::record::error::{Attempt, RecordError};
use crate::record::number::Cell;
use crate::record::whole_lines::WholeLines;

/// A history that an earlier run left behind, compared with the rows up to a checkpoint of that
/// run: what the file has beyond them is cut off, what it lacks of them is written.
///
/// Nothing in the file says to which run it belongs; comparing all rows does, for the price of
/// reading it once. It also mends a file that ends in a torn row or lacks the rows that a full disk
/// had no room for.
pub struct Resuming {
    path: PathBuf,
    width: usize,
    /// The file, as long as it agrees.
    reader: BufReader<File>,
    /// Bytes that agree, whole rows.
    agreed: u64,
    /// Rows that agree, header included.
    rows: u64,
    /// Where rows go that the file lacks.
    writing: Option<History>,
    line: Vec<u8>,
    found: Vec<u8>,
}

impl Resuming {
    /// Opens the file for comparison; `columns` are the names after
    /// [`FIRST_COLUMNS`](super::FIRST_COLUMNS).
    pub fn open(path: &Path, columns: &[String]) -> Result<Self, RecordError> {
        let file =
            File::open(path).map_err(|error| RecordError::new(path, Attempt::Open, error))?;
        let mut resuming = Self {
            path: path.to_path_buf(),
            width: columns.len(),
            reader: BufReader::new(file),
            agreed: 0,
            rows: 0,
            writing: None,
            line: header(columns),
            found: Vec::new(),
        };
        resuming.compare()?;
        Ok(resuming)
    }

    /// The next row that the file should have.
    ///
    /// # Panics
    /// If there are more or fewer cells than columns.
    pub fn row(
        &mut self,
        cycle: u64,
        time: f64,
        stage: &str,
        cells: &[Cell<'_>],
    ) -> Result<(), RecordError> {
        if let Some(history) = &mut self.writing {
            return history.row(cycle, time, stage, cells);
        }
        assert_eq!(cells.len(), self.width, "one cell for each column");
        encode_row(&mut self.line, cycle, time, stage, cells);
        self.compare()
    }

    /// All rows have been given: cuts off what the file has beyond them.
    pub fn finish(self) -> Result<History, RecordError> {
        match self.writing {
            Some(history) => Ok(history),
            None => self.cut(),
        }
    }

    /// Compares `line` with what comes next in the file; writes it if the file ends there.
    fn compare(&mut self) -> Result<(), RecordError> {
        let expected = self.line.len();
        self.found.clear();
        let mut next = (&mut self.reader).take(expected as u64);
        next.read_to_end(&mut self.found)
            .map_err(|error| RecordError::new(&self.path, Attempt::Read, error))?;
        if !self.line.starts_with(&self.found) {
            return Err(self.misfit());
        }
        if self.found.len() == expected {
            self.agreed += expected as u64;
            self.rows += 1;
            return Ok(());
        }
        let mut history = self.cut()?;
        history.lines.push(&self.line)?;
        self.writing = Some(history);
        Ok(())
    }

    /// The history from where the two agree.
    fn cut(&self) -> Result<History, RecordError> {
        Ok(History {
            lines: WholeLines::reopen(&self.path, self.agreed)?,
            width: self.width,
            line: Vec::new(),
        })
    }

    fn misfit(&self) -> RecordError {
        // The cell around the first byte that differs.
        let pairs = self.line.iter().zip(&self.found);
        let at = pairs.take_while(|(a, b)| a == b).count();
        let start = self.line[..at].iter().rposition(|byte| *byte == b',');
        let cell = |line: &[u8]| -> String {
            let rest = String::from_utf8_lossy(&line[start.map_or(0, |comma| comma + 1)..]);
            let end = rest.find([',', '\n']).unwrap_or(rest.len());
            rest[..end].chars().take(40).collect()
        };
        let place = match self.rows {
            0 => "its header".to_owned(),
            row => format!("its row {row}"),
        };
        let (is, wanted) = (cell(&self.found), cell(&self.line));
        RecordError::Resume {
            path: self.path.clone(),
            message: format!("{place} has `{is}` where the run has `{wanted}`"),
            remedy:
                "give --csv the file of the run that made the checkpoint, a new file, or - for \
                     the later rows alone"
                    .into(),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    const HEADER: &str = "cycle,time,stage,kinetic\n";

    fn names(list: &[&str]) -> Vec<String> {
        list.iter().map(|&name| name.into()).collect()
    }

    /// Line ends and quotes within a cell are where counting lines would go wrong.
    fn row(cycle: u64) -> (u64, f64, &'static str, [Cell<'static>; 1]) {
        let cells = [Cell::Real(cycle as f64 * 0.1)];
        (cycle, cycle as f64 * 1e-9, "two\n\"lines\"", cells)
    }

    fn text(cycles: std::ops::Range<u64>) -> String {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("whole");
        let mut history = History::create(&path, &names(&["kinetic"])).unwrap();
        for cycle in cycles {
            let (cycle, time, stage, cells) = row(cycle);
            history.row(cycle, time, stage, &cells).unwrap();
        }
        history.flush().unwrap();
        fs::read_to_string(path).unwrap()
    }

    /// Goes on from cycle 4 to cycle 9 with what the file holds.
    fn resumed(held: &str) -> Result<String, RecordError> {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        fs::write(&path, held).unwrap();
        let outcome = go_on(&path);
        let now = fs::read_to_string(&path).unwrap();
        if outcome.is_err() {
            assert_eq!(now, held, "a file that does not fit is left alone");
        }
        outcome.map(|()| now)
    }

    fn go_on(path: &Path) -> Result<(), RecordError> {
        let mut resuming = Resuming::open(path, &names(&["kinetic"]))?;
        for (cycle, time, stage, cells) in (0..4).map(row) {
            resuming.row(cycle, time, stage, &cells)?;
        }
        let mut history = resuming.finish()?;
        for (cycle, time, stage, cells) in (4..9).map(row) {
            history.row(cycle, time, stage, &cells)?;
        }
        history.flush()
    }

    #[test]
    fn wherever_the_file_ends_it_becomes_that_of_an_uninterrupted_run() {
        let whole = text(0..9);
        for end in 0..=whole.len() {
            assert_eq!(resumed(&whole[..end]).unwrap(), whole, "cut at {end}");
        }
        // A later end of the run, a torn row after the checkpoint, another continuation.
        for more in ["9,1.0,b,2.5\n", "12"] {
            assert_eq!(resumed(&(whole.clone() + more)).unwrap(), whole);
        }
    }

    #[test]
    fn a_history_of_another_run_is_refused_and_left_as_it_is() {
        let whole = text(0..4);
        for (held, hint) in [
            (whole.replace("kinetic", "potential"), "its header has"),
            (whole.replace("kinetic", "kinetic,dt"), "its header has"),
            (whole.replace("0.2\n", "0.3\n"), "its row 3 has `0.3"),
            (
                whole.replace("0,0.0,", "0,0.5,"),
                "its row 1 has `0.5` where the run has `0.0`",
            ),
            (HEADER.to_owned() + "5,1.0,b,2.5\n", "its row 1 has `5`"),
            ("\u{1}\u{2}".into(), "its header has"),
        ] {
            assert_ne!(held, whole);
            let error = resumed(&held).unwrap_err().to_string();
            assert!(error.contains(hint), "{error}");
            assert!(error.contains("--csv"), "{error}");
        }
    }

    #[test]
    fn a_file_that_is_not_there_is_not_made() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("none.csv");
        let error = Resuming::open(&path, &names(&[])).err().unwrap();
        assert!(error.to_string().contains("there is no such file"));
        assert!(!path.exists());
    }
}
