//! Histories: one CSV table (RFC 4180, line ends LF), a header, then one row per sample. The first
//! columns are always `cycle`, `time` and `stage`.

use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;

use super::error::{Attempt, RecordError};
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

    /// Goes on with a history that a run with the same columns left behind: cuts it back to
    /// `position`, which a [`History::position`] of that run has reported.
    pub fn resume(path: &Path, columns: &[String], position: u64) -> Result<Self, RecordError> {
        check_header(path, columns)?;
        check_boundary(path, position)?;
        Ok(Self {
            lines: WholeLines::reopen(path, position)?,
            width: columns.len(),
            line: Vec::new(),
        })
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
        let first = [Cell::Count(cycle), Cell::Real(time), Cell::name(stage)];
        self.line.clear();
        encode(&mut self.line, first.iter().chain(cells).map(Cell::text));
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

    /// Bytes after the last row taken: where a checkpoint made now will want to go on. Only what
    /// [`History::flush`] or [`History::sync`] returned for is in the file.
    pub fn position(&self) -> u64 {
        self.lines.position()
    }
}

fn header(columns: &[String]) -> Vec<u8> {
    let mut line = Vec::new();
    let names = columns.iter().map(String::as_str);
    encode(&mut line, FIRST_COLUMNS.into_iter().chain(names));
    line
}

fn encode<T: AsRef<str>>(line: &mut Vec<u8>, mut fields: impl Iterator<Item = T>) {
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

/// Whether the file starts with the header of these columns.
fn check_header(path: &Path, columns: &[String]) -> Result<(), RecordError> {
    // A header of a million characters is no header.
    let start = open(path)?.take(1 << 20);
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .from_reader(start);
    let mut found = csv::ByteRecord::new();
    match reader.read_byte_record(&mut found) {
        Ok(true) => {}
        Ok(false) => return Err(misfit(path, "the file is empty".into())),
        Err(error) => match error.into_kind() {
            csv::ErrorKind::Io(error) => {
                return Err(RecordError::new(path, Attempt::Read, error));
            }
            other => {
                return Err(misfit(
                    path,
                    format!("its header cannot be read ({other:?})"),
                ));
            }
        },
    }
    let names = columns.iter().map(String::as_str);
    let wanted: Vec<&str> = FIRST_COLUMNS.into_iter().chain(names).collect();
    for (k, wanted) in wanted.iter().enumerate() {
        let is = found.get(k).map(String::from_utf8_lossy);
        if is.as_deref() != Some(wanted) {
            let is = is.map_or("missing".into(), |name| format!("`{}`", clip(&name)));
            let message = format!("its column {} is {is}, not `{wanted}`", k + 1);
            return Err(misfit(path, message));
        }
    }
    if found.len() > wanted.len() {
        let more = found.len() - wanted.len();
        return Err(misfit(
            path,
            format!("it has {more} more columns than the run"),
        ));
    }
    Ok(())
}

/// Whether a row ends at `position`: a line end, and not one inside quotes.
fn check_boundary(path: &Path, position: u64) -> Result<(), RecordError> {
    let mut reader = BufReader::new(open(path)?.take(position));
    let (mut length, mut quoted, mut last) = (0, false, 0);
    loop {
        let piece = reader
            .fill_buf()
            .map_err(|error| RecordError::new(path, Attempt::Read, error))?;
        let Some(end) = piece.last() else { break };
        last = *end;
        quoted = piece
            .iter()
            .fold(quoted, |quoted, byte| quoted ^ (*byte == b'"'));
        let taken = piece.len();
        length += taken as u64;
        reader.consume(taken);
    }
    if length < position {
        let message = format!("it has {length} bytes, and the checkpoint was made at {position}");
        return Err(misfit(path, message));
    }
    if last != b'\n' || quoted {
        let message = format!("no row ends at byte {position}, where the checkpoint was made");
        return Err(misfit(path, message));
    }
    Ok(())
}

fn open(path: &Path) -> Result<File, RecordError> {
    File::open(path).map_err(|error| RecordError::new(path, Attempt::Open, error))
}

fn misfit(path: &Path, message: String) -> RecordError {
    RecordError::Resume {
        path: path.to_path_buf(),
        message,
        remedy: "give --csv the file of the run that made the checkpoint, or - for the later rows \
                 alone"
            .into(),
    }
}

fn clip(name: &str) -> String {
    name.chars().take(40).collect()
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::io::ErrorKind;

    use super::super::own_process;
    use super::super::whole_lines::tests::Small;
    use super::*;

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
        assert_eq!(history.position(), text.len() as u64);
    }

    #[test]
    fn a_resumed_history_has_the_bytes_of_an_uninterrupted_one() {
        let folder = tempfile::tempdir().unwrap();
        let (whole, broken) = (folder.path().join("whole"), folder.path().join("broken"));
        let mut history = History::create(&whole, &columns()).unwrap();
        (0..9).for_each(|cycle| sample(&mut history, cycle, "two\nlines"));
        drop(history);

        let mut history = History::create(&broken, &columns()).unwrap();
        (0..4).for_each(|cycle| sample(&mut history, cycle, "two\nlines"));
        let position = history.position();
        (4..7).for_each(|cycle| sample(&mut history, cycle, "two\nlines"));
        drop(history);
        let mut history = History::resume(&broken, &columns(), position).unwrap();
        (4..9).for_each(|cycle| sample(&mut history, cycle, "two\nlines"));
        history.flush().unwrap();
        assert_eq!(fs::read(&whole).unwrap(), fs::read(&broken).unwrap());
    }

    #[test]
    fn a_history_of_another_run_is_refused_and_left_as_it_is() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        let text = "cycle,time,stage,kinetic\n0,0.0,\"a\nb\",1.5\n5,1.0,b,2.5\n";
        fs::write(&path, text).unwrap();
        let names = |list: &[&str]| {
            list.iter()
                .map(|&name| name.into())
                .collect::<Vec<String>>()
        };
        let (same, end) = (names(&["kinetic"]), text.len() as u64);
        let after = |what: &str| (text.find(what).unwrap() + what.len()) as u64;
        let (inside, row) = (after("\"a\n"), after("1.5\n"));
        for (columns, position, hint) in [
            (
                names(&["potential"]),
                end,
                "column 4 is `kinetic`, not `potential`",
            ),
            (names(&["kinetic", "dt"]), end, "column 5 is missing"),
            (names(&[]), end, "1 more columns"),
            (same.clone(), end + 1, "has 53 bytes"),
            (same.clone(), end - 1, "no row ends at byte 52"),
            // The line end between the quotes.
            (
                same.clone(),
                inside,
                &format!("no row ends at byte {inside}"),
            ),
            (same.clone(), 0, "no row ends at byte 0"),
        ] {
            let error = History::resume(&path, &columns, position)
                .err()
                .unwrap()
                .to_string();
            assert!(error.contains(hint), "{error}");
            assert!(error.contains("--csv"), "{error}");
            assert_eq!(fs::read_to_string(&path).unwrap(), text);
        }
        History::resume(&path, &same, row).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), text[..row as usize]);
    }

    #[test]
    fn noise_and_nothing_are_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.csv");
        let missing = History::resume(&path, &columns(), 10)
            .err()
            .unwrap()
            .to_string();
        assert!(missing.contains("there is no such file"), "{missing}");
        for noise in [Vec::new(), vec![0xff; 3 << 20]] {
            fs::write(&path, &noise).unwrap();
            assert!(History::resume(&path, &columns(), 10).is_err());
            assert_eq!(fs::read(&path).unwrap(), noise);
        }
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
