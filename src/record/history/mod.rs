//! Histories: one CSV table (RFC 4180, line ends LF), a header, then one row per sample. The first
//! columns are always `cycle`, `time` and `stage`.

mod resuming;

use std::path::Path;

pub use resuming::Resuming;

use super::error::RecordError;
use super::number::Cell;
use super::whole_lines::WholeLines;

/// The columns every history starts with.
pub const FIRST_COLUMNS: [&str; 3] = ["cycle", "time", "stage"];

/// A history being written.
pub struct History {
    lines: WholeLines,
    /// Columns after the first three.
    width: usize,
    /// The row being encoded.
    line: Vec<u8>,
}

impl History {
    /// A new history in a file; whatever the file held is gone. `columns` are the names after
    /// [`FIRST_COLUMNS`].
    pub fn create(path: &Path, columns: &[String]) -> Result<Self, RecordError> {
        Self::start(WholeLines::create(path)?, columns)
    }

    /// A history on standard output. After a resume it too starts with the header, and the rows
    /// that follow are the later ones.
    pub fn to_stdout(columns: &[String]) -> Result<Self, RecordError> {
        Self::start(WholeLines::stdout(), columns)
    }

    fn start(lines: WholeLines, columns: &[String]) -> Result<Self, RecordError> {
        let mut history = Self {
            lines,
            width: columns.len(),
            line: header(columns),
        };
        history.lines.push(&history.line)?;
        // At once, so that whoever waits for the file sees that it is the right one.
        history.lines.flush()?;
        Ok(history)
    }

    /// Takes one row: `time` in seconds, and a cell for each column.
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
        assert_eq!(cells.len(), self.width, "one cell for each column");
        encode_row(&mut self.line, cycle, time, stage, cells);
        self.lines.push(&self.line)
    }

    /// Starts over in the same place: takes every row back and writes the header again. False where
    /// nothing can be taken back, as on standard output: then nothing has changed.
    pub fn restart(&mut self, columns: &[String]) -> Result<bool, RecordError> {
        if !self.lines.clear()? {
            return Ok(false);
        }
        self.width = columns.len();
        self.line = header(columns);
        self.lines.push(&self.line)?;
        Ok(true)
    }

    /// Hands all rows to the operating system: from there a killed process loses none of them.
    /// When the disk is full the rows that fit are kept whole, and the others wait.
    pub fn flush(&mut self) -> Result<(), RecordError> {
        self.lines.flush()
    }

    /// Flushes, and returns once the rows would survive a power cut.
    pub fn sync(&mut self) -> Result<(), RecordError> {
        self.lines.sync()
    }
}

fn header(columns: &[String]) -> Vec<u8> {
    let mut line = Vec::new();
    let names = columns.iter().map(String::as_str);
    encode(&mut line, FIRST_COLUMNS.into_iter().chain(names));
    line
}

fn encode_row(line: &mut Vec<u8>, cycle: u64, time: f64, stage: &str, cells: &[Cell<'_>]) {
    let first = [Cell::Count(cycle), Cell::Real(time), Cell::name(stage)];
    line.clear();
    encode(line, first.iter().chain(cells).map(Cell::text));
}

pub(super) fn encode<T: AsRef<str>>(line: &mut Vec<u8>, mut fields: impl Iterator<Item = T>) {
    let mut writer = csv::WriterBuilder::new()
        .terminator(csv::Terminator::Any(b'\n'))
        .buffer_capacity(512)
        .from_writer(line);
    fields
        .try_for_each(|field| writer.write_field(field.as_ref()))
        .and_then(|()| writer.write_record(None::<&[u8]>))
        .and_then(|()| Ok(writer.flush()?))
        .expect("a Vec takes every byte");
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::ErrorKind;

    use super::*;
    use crate::record::own_process;
    use crate::record::whole_lines::tests::Small;

    fn columns() -> Vec<String> {
        vec!["kinetic".into(), "state_hash".into()]
    }

    fn sample(history: &mut History, cycle: u64, stage: &str) {
        let cells = [Cell::Real(cycle as f64 * 0.1), Cell::Hash(cycle)];
        history
            .row(cycle, cycle as f64 * 1e-9, stage, &cells)
            .unwrap();
    }

    #[test]
    fn rows_are_written_as_contracted() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        let mut history = History::create(&path, &columns()).unwrap();
        let header = "cycle,time,stage,kinetic,state_hash\n";
        assert_eq!(fs::read_to_string(&path).unwrap(), header);
        sample(&mut history, 0, "load");
        history
            .row(
                3,
                3e-9,
                "a \"b\", c",
                &[Cell::Real(f64::NAN), Cell::Hash(255)],
            )
            .unwrap();
        history.sync().unwrap();
        let text = fs::read_to_string(&path).unwrap();
        let rows = "0,0.0,load,0.0,0000000000000000\n\
                    3,3e-9,\"a \"\"b\"\", c\",nan,00000000000000ff\n";
        assert_eq!(text, format!("{header}{rows}"));
    }

    #[test]
    fn a_file_that_may_not_grow_ends_with_a_whole_row() {
        let name = "history::tests::a_file_that_may_not_grow_ends_with_a_whole_row";
        if let Some(path) = own_process::value() {
            let mut history = History::create(Path::new(&path), &columns()).unwrap();
            (0..100).for_each(|cycle| sample(&mut history, cycle, "load"));
            let error = history.flush().unwrap_err().to_string();
            assert!(error.contains("largest size of a file"), "{error}");
            return;
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        // One block, of 512 or 1024 bytes; without the trap the signal of that limit would kill.
        let limit = "trap '' XFSZ; ulimit -f 1;";
        own_process::assert_passed(&own_process::run(name, limit, path.to_str().unwrap()));
        let text = fs::read_to_string(&path).unwrap();
        // A row is shorter than 40 bytes, so the last one that fits ends near the limit.
        assert!((470..=512).contains(&text.len()) || (980..=1024).contains(&text.len()));
        assert!(text.ends_with('\n'), "{text}");
        let cells = |line: &str| line.split(',').count();
        assert!(text.lines().all(|line| cells(line) == 5), "{text}");
    }

    #[test]
    fn a_closed_pipe_is_told_apart_from_a_full_disk() {
        for (refusal, closed) in [
            (ErrorKind::BrokenPipe, true),
            (ErrorKind::StorageFull, false),
        ] {
            let small = Small::with(60, refusal);
            let lines = WholeLines::on(Box::new(small.clone()), Path::new("x"), 0);
            let mut history = History::start(lines, &columns()).unwrap();
            (0..3).for_each(|cycle| sample(&mut history, cycle, "load"));
            assert_eq!(history.flush().unwrap_err().is_closed_pipe(), closed);
            let whole = small.text().ends_with('\n');
            assert_eq!(whole, !closed, "{}", small.text());
        }
    }
}
