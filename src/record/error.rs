//! What can go wrong with a file, said so that a user can put it right.

use std::fmt;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

use super::checkpoint::CheckpointFault;

/// A record that could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum RecordError {
    /// The operating system refused.
    // The reason first: the path may be longer than a line of the screen.
    #[error("{}, so {} cannot be {attempt}; {}", reason(error, *attempt, path), path.display(), remedy(error, *attempt))]
    File {
        /// The file.
        path: PathBuf,
        /// What was tried.
        attempt: Attempt,
        /// What the operating system said.
        error: io::Error,
    },
    /// The program that read our output has ended, as `head` does: no failure, a reason to stop.
    #[error("{}: its reader has ended; nothing more can be written to it", path.display())]
    ClosedPipe {
        /// The pipe, or `standard output`.
        path: PathBuf,
    },
    /// A history that does not belong to the run that wants to go on with it.
    #[error("{}: cannot go on with this history: {message}; {remedy}", path.display())]
    Resume {
        /// The history.
        path: PathBuf,
        /// What does not fit.
        message: String,
        /// What to do.
        remedy: String,
    },
    /// A file that is no checkpoint this program can use, or a state that cannot become one.
    #[error("{fault}: {}; {}", path.display(), fault.remedy())]
    Checkpoint {
        /// The checkpoint.
        path: PathBuf,
        /// What is wrong with it.
        fault: CheckpointFault,
    },
}

impl RecordError {
    /// Names the file and the attempt that `error` belongs to.
    pub fn new(path: &Path, attempt: Attempt, error: io::Error) -> Self {
        let path = path.to_path_buf();
        if error.kind() == ErrorKind::BrokenPipe {
            Self::ClosedPipe { path }
        } else {
            Self::File {
                path,
                attempt,
                error,
            }
        }
    }

    /// Whether it only says that nobody reads any more: a program ends quietly then.
    pub fn is_closed_pipe(&self) -> bool {
        matches!(self, Self::ClosedPipe { .. })
    }
}

/// What was being done with a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Attempt {
    /// Make it, or empty it.
    Create,
    /// Open one that must exist.
    Open,
    /// Read it.
    Read,
    /// Add to it.
    Write,
    /// Shorten it.
    Cut,
    /// Put it on the disk for good.
    Sync,
    /// Put a new version in its place.
    Replace,
}

impl fmt::Display for Attempt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Create => "created",
            Self::Open => "opened",
            Self::Read => "read",
            Self::Write => "written",
            Self::Cut => "shortened",
            Self::Sync => "saved to disk",
            Self::Replace => "replaced",
        })
    }
}

fn reason(error: &io::Error, attempt: Attempt, path: &Path) -> String {
    let folder = folder_of(path).display();
    match error.kind() {
        ErrorKind::NotFound if makes(attempt) => format!("there is no folder `{folder}`"),
        ErrorKind::NotFound => "there is no such file".into(),
        ErrorKind::PermissionDenied if makes(attempt) => {
            format!("no permission to write it or its folder `{folder}`")
        }
        ErrorKind::AlreadyExists => "it is a file".into(),
        ErrorKind::PermissionDenied => "no permission".into(),
        ErrorKind::ResourceBusy => "another run is writing it".into(),
        ErrorKind::StorageFull => "the disk is full".into(),
        ErrorKind::QuotaExceeded => "your disk quota is used up".into(),
        ErrorKind::FileTooLarge => "it would pass the largest size of a file here".into(),
        ErrorKind::ReadOnlyFilesystem => "the disk is mounted read-only".into(),
        ErrorKind::IsADirectory => "it is a folder".into(),
        ErrorKind::NotADirectory => format!("a part of `{folder}` is a file, not a folder"),
        ErrorKind::InvalidFilename => "the name is too long or holds a forbidden character".into(),
        ErrorKind::OutOfMemory => "it does not fit into memory".into(),
        _ => error.to_string(),
    }
}

fn remedy(error: &io::Error, attempt: Attempt) -> &'static str {
    match error.kind() {
        ErrorKind::NotFound if makes(attempt) => "make the folder, or give another path",
        ErrorKind::NotFound => "check the path",
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
            "free some space or give a path on another disk; what was recorded before is kept"
        }
        ErrorKind::PermissionDenied if !makes(attempt) => "check who owns it and its mode",
        ErrorKind::ResourceBusy => "wait until that one has ended, or give another path",
        ErrorKind::IsADirectory if makes(attempt) => "give the name of a file in it",
        ErrorKind::IsADirectory => "give the name of a file",
        ErrorKind::OutOfMemory => "use a machine with more memory",
        _ if makes(attempt) => "give another path",
        _ => "check the disk and the path",
    }
}

fn makes(attempt: Attempt) -> bool {
    matches!(
        attempt,
        Attempt::Create | Attempt::Write | Attempt::Replace | Attempt::Sync
    )
}

/// The folder a path lies in: `.` for a bare name.
pub(super) fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(path: &str, attempt: Attempt, kind: ErrorKind) -> String {
        RecordError::new(Path::new(path), attempt, kind.into()).to_string()
    }

    #[test]
    fn a_message_names_reason_file_attempt_and_remedy() {
        assert_eq!(
            said("out/run.csv", Attempt::Create, ErrorKind::NotFound),
            "there is no folder `out`, so out/run.csv cannot be created; \
             make the folder, or give another path"
        );
        assert_eq!(
            said("run.ballast", Attempt::Open, ErrorKind::NotFound),
            "there is no such file, so run.ballast cannot be opened; check the path"
        );
        assert!(said("run.csv", Attempt::Write, ErrorKind::StorageFull).contains("disk is full"));
    }

    #[test]
    fn a_bare_name_lies_in_this_folder() {
        assert_eq!(folder_of(Path::new("run.csv")), Path::new("."));
        assert_eq!(folder_of(Path::new("a/run.csv")), Path::new("a"));
    }

    #[test]
    fn a_closed_pipe_is_told_apart() {
        let closed = RecordError::new(
            Path::new("standard output"),
            Attempt::Write,
            ErrorKind::BrokenPipe.into(),
        );
        assert!(closed.is_closed_pipe());
        let full = RecordError::new(
            Path::new("run.csv"),
            Attempt::Write,
            ErrorKind::StorageFull.into(),
        );
        assert!(!full.is_closed_pipe());
    }
}
