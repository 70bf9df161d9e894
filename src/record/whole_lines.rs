//! A file that grows by whole lines: after a flush every line is in it completely or not at all,
//! even when the disk fills in the middle of one.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use super::error::{Attempt, RecordError};
use super::whole_file::sync_folder;

/// Lines are handed over in pieces of about this size [bytes]: large enough that a system call per
/// piece costs nothing, small enough that little is lost with a killed process.
const PIECE: usize = 1 << 16;

/// Where lines go.
pub(super) trait Medium: Write + Send {
    /// Shortens what has been written to `length` bytes and goes on from there.
    fn cut(&mut self, length: u64) -> io::Result<()>;
    /// Returns once everything written would survive a power cut.
    fn sync(&mut self) -> io::Result<()>;
}

/// Lines on their way to a file or to standard output.
pub(super) struct WholeLines {
    medium: Box<dyn Medium>,
    path: PathBuf,
    /// Bytes the medium holds.
    length: u64,
    /// Lines not handed over yet.
    waiting: Vec<u8>,
    /// Where each of them ends within `waiting`.
    ends: Vec<usize>,
}

impl WholeLines {
    /// A new or emptied file.
    pub(super) fn create(path: &Path) -> Result<Self, RecordError> {
        let failed = |error| RecordError::new(path, Attempt::Create, error);
        // Emptied only once nobody else is known to write it.
        let file = OpenOptions::new()
            .write(true)
            .create(true)
            .truncate(false)
            .open(path)
            .map_err(failed)?;
        let mut disk = Disk::new(file, path)?;
        if disk.regular {
            disk.cut(0).map_err(failed)?;
        }
        Ok(Self::on(Box::new(disk), path, 0))
    }

    /// An existing file, shortened to `length` bytes unless it is a device.
    pub(super) fn reopen(path: &Path, length: u64) -> Result<Self, RecordError> {
        let file = OpenOptions::new()
            .write(true)
            .open(path)
            .map_err(|error| RecordError::new(path, Attempt::Open, error))?;
        let mut disk = Disk::new(file, path)?;
        if disk.regular {
            disk.cut(length)
                .map_err(|error| RecordError::new(path, Attempt::Cut, error))?;
        }
        Ok(Self::on(Box::new(disk), path, length))
    }

    /// Standard output.
    pub(super) fn stdout() -> Self {
        Self::on(Box::new(io::stdout()), Path::new("standard output"), 0)
    }

    /// Any medium that holds `length` bytes so far.
    pub(super) fn on(medium: Box<dyn Medium>, path: &Path, length: u64) -> Self {
        Self {
            medium,
            path: path.to_path_buf(),
            length,
            waiting: Vec::new(),
            ends: Vec::new(),
        }
    }

    /// Takes one line, its line end included.
    pub(super) fn push(&mut self, line: &[u8]) -> Result<(), RecordError> {
        self.waiting.extend_from_slice(line);
        self.ends.push(self.waiting.len());
        if self.waiting.len() < PIECE {
            return Ok(());
        }
        self.flush()
    }

    /// Hands every line over. When that fails, the lines that fitted are kept, the torn one is
    /// removed again, and the rest waits for the next flush.
    pub(super) fn flush(&mut self) -> Result<(), RecordError> {
        let mut sent = 0;
        let mut outcome = Ok(());
        while sent < self.waiting.len() {
            match self.medium.write(&self.waiting[sent..]) {
                Ok(0) => outcome = Err(ErrorKind::WriteZero.into()),
                Ok(more) => sent += more,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => outcome = Err(error),
            }
            if outcome.is_err() {
                break;
            }
        }
        let outcome = outcome.and_then(|()| self.medium.flush());
        if outcome.is_err() {
            let whole = self.ends.iter().rev().find(|end| **end <= sent);
            let whole = whole.copied().unwrap_or(0);
            // What a pipe has taken cannot be taken back: there the next flush completes the line.
            if sent > whole && self.medium.cut(self.length + whole as u64).is_ok() {
                sent = whole;
            }
        }
        self.length += sent as u64;
        self.waiting.drain(..sent);
        self.ends.retain(|end| *end > sent);
        for end in &mut self.ends {
            *end -= sent;
        }
        outcome.map_err(|error| RecordError::new(&self.path, Attempt::Write, error))
    }

    /// Takes every line back. False where the medium cannot: then they stay.
    pub(super) fn clear(&mut self) -> Result<bool, RecordError> {
        match self.medium.cut(0) {
            Ok(()) => {}
            Err(error) if error.kind() == ErrorKind::Unsupported => return Ok(false),
            Err(error) => return Err(RecordError::new(&self.path, Attempt::Cut, error)),
        }
        self.length = 0;
        self.waiting.clear();
        self.ends.clear();
        Ok(true)
    }

    /// Flushes, and returns once the lines would survive a power cut.
    pub(super) fn sync(&mut self) -> Result<(), RecordError> {
        self.flush()?;
        self.medium
            .sync()
            .map_err(|error| RecordError::new(&self.path, Attempt::Sync, error))
    }
}

impl Drop for WholeLines {
    fn drop(&mut self) {
        // For an unwinding panic: its rows shall be in the file. Whoever must know that they are
        // has called `flush`; from here an error could reach nobody.
        let _ = self.flush();
    }
}

struct Disk {
    file: File,
    /// Not a pipe or device, which can be neither shortened nor synced.
    regular: bool,
    /// The path, until its folder has been synced once.
    unsynced_name: Option<PathBuf>,
}

impl Disk {
    fn new(file: File, path: &Path) -> Result<Self, RecordError> {
        let failed = |error| RecordError::new(path, Attempt::Open, error);
        let regular = file.metadata().map_err(failed)?.is_file();
        // Two runs that write the same file would mix their lines. Where a file system knows no locks there
        // is none.
        if regular && let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(failed(ErrorKind::ResourceBusy.into()));
        }
        Ok(Self {
            file,
            regular,
            unsynced_name: Some(path.to_path_buf()),
        })
    }
}

impl Write for Disk {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Medium for Disk {
    fn cut(&mut self, length: u64) -> io::Result<()> {
        if !self.regular {
            return Err(ErrorKind::Unsupported.into());
        }
        self.file.set_len(length)?;
        self.file.seek(SeekFrom::Start(length)).map(drop)
    }

    fn sync(&mut self) -> io::Result<()> {
        if !self.regular {
            return Ok(());
        }
        self.file.sync_data()?;
        if let Some(path) = &self.unsynced_name {
            sync_folder(path)?;
            self.unsynced_name = None;
        }
        Ok(())
    }
}

impl Medium for io::Stdout {
    fn cut(&mut self, _length: u64) -> io::Result<()> {
        Err(ErrorKind::Unsupported.into())
    }

    fn sync(&mut self) -> io::Result<()> {
        self.flush()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use std::sync::{Arc, Mutex};

    use super::*;

    /// A disk with room for so many bytes, or a pipe with so many left to read.
    #[derive(Clone)]
    pub(in crate::record) struct Small {
        pub(in crate::record) held: Arc<Mutex<Vec<u8>>>,
        pub(in crate::record) room: Arc<Mutex<usize>>,
        pub(in crate::record) refusal: ErrorKind,
    }

    impl Small {
        pub(in crate::record) fn with(room: usize, refusal: ErrorKind) -> Self {
            Self {
                held: Arc::default(),
                room: Arc::new(Mutex::new(room)),
                refusal,
            }
        }

        pub(in crate::record) fn text(&self) -> String {
            String::from_utf8(self.held.lock().unwrap().clone()).unwrap()
        }

        pub(in crate::record) fn make_room(&self, room: usize) {
            *self.room.lock().unwrap() = room;
        }
    }

    impl Write for Small {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            let mut held = self.held.lock().unwrap();
            let taken = bytes.len().min(*self.room.lock().unwrap() - held.len());
            if taken == 0 {
                return Err(self.refusal.into());
            }
            held.extend_from_slice(&bytes[..taken]);
            Ok(taken)
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    impl Medium for Small {
        fn cut(&mut self, length: u64) -> io::Result<()> {
            if self.refusal != ErrorKind::StorageFull {
                return Err(ErrorKind::Unsupported.into());
            }
            self.held.lock().unwrap().truncate(length as usize);
            Ok(())
        }

        fn sync(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_keeps_whole_lines_only_and_the_rest_follows_when_there_is_room() {
        for room in 0..21 {
            let disk = Small::with(room, ErrorKind::StorageFull);
            let mut lines = WholeLines::on(Box::new(disk.clone()), Path::new("run.csv"), 0);
            for line in ["first\n", "second\n", "third\n"] {
                lines.push(line.as_bytes()).unwrap();
            }
            let all = "first\nsecond\nthird\n";
            let outcome = lines.flush();
            assert_eq!(outcome.is_ok(), room >= all.len(), "room {room}");
            let kept = disk.text();
            assert!(all.starts_with(&kept), "room {room}: {kept}");
            assert!(
                kept.is_empty() || kept.ends_with('\n'),
                "room {room}: {kept}"
            );
            assert!(
                room < 6 || kept.starts_with("first\n"),
                "room {room}: {kept}"
            );

            disk.make_room(1000);
            lines.flush().unwrap();
            assert_eq!(disk.text(), all, "room {room}");
        }
    }

    #[test]
    fn a_pipe_that_cannot_be_cut_gets_the_rest_of_its_line_later() {
        let pipe = Small::with(9, ErrorKind::WouldBlock);
        let mut lines = WholeLines::on(Box::new(pipe.clone()), Path::new("pipe"), 0);
        lines.push(b"first\n").unwrap();
        lines.push(b"second\n").unwrap();
        lines.flush().unwrap_err();
        assert_eq!(pipe.text(), "first\nsec");
        pipe.make_room(1000);
        lines.flush().unwrap();
        assert_eq!(pipe.text(), "first\nsecond\n");
    }

    #[test]
    fn a_real_full_device_is_an_error_in_plain_words() {
        if !Path::new("/dev/full").exists() {
            return;
        }
        let mut lines = WholeLines::create(Path::new("/dev/full")).unwrap();
        lines.push(b"first\n").unwrap();
        let error = lines.flush().unwrap_err().to_string();
        assert!(error.contains("disk is full"), "{error}");
    }

    #[test]
    fn a_large_piece_goes_out_by_itself() {
        let disk = Small::with(usize::MAX, ErrorKind::StorageFull);
        let mut lines = WholeLines::on(Box::new(disk.clone()), Path::new("run.csv"), 0);
        lines.push(&vec![b'x'; PIECE]).unwrap();
        assert_eq!(disk.text().len(), PIECE);
    }
}
