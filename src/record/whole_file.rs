//! A file that appears whole or not at all: written under another name in the same folder, put on
//! the disk, then given its name. Whoever looks finds the old version or the new one.

use std::fs::{self, File, Permissions};
use std::io::{self, Cursor, Seek, Write};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

use super::error::{Attempt, RecordError, folder_of};

/// Puts `bytes` in the place of whatever `path` held, as [`write_with`] does.
pub fn write(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    write_with(path, |to| {
        to.write_all(bytes)
            .map_err(|error| RecordError::new(path, Attempt::Write, error))
    })
}

/// Where a file is written: positions count from its beginning.
pub trait Target: Write + Seek {}

impl<T: Write + Seek> Target for T {}

/// Puts what `fill` writes in the place of whatever `path` held.
///
/// A link is followed. A device or pipe is written to, not replaced. A file that is replaced keeps
/// its mode; a new one gets the usual mode of this user, not the secretive one of temporary files.
pub fn write_with(
    path: &Path,
    fill: impl FnOnce(&mut dyn Target) -> Result<(), RecordError>,
) -> Result<(), RecordError> {
    // Through a link to the file it stands for; a path that leads nowhere yet is taken as it is.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let old = fs::metadata(&target).ok();
    let special = old
        .as_ref()
        .is_some_and(|old| !old.is_file() && !old.is_dir());
    if special {
        let mut bytes = Cursor::new(Vec::new());
        fill(&mut bytes)?;
        return File::options()
            .write(true)
            .open(&target)
            .and_then(|mut device| device.write_all(bytes.get_ref()))
            .map_err(|error| RecordError::new(path, Attempt::Write, error));
    }
    if old.as_ref().is_some_and(fs::Metadata::is_dir) {
        let error = io::ErrorKind::IsADirectory.into();
        return Err(RecordError::new(path, Attempt::Create, error));
    }

    let name = target.file_name().unwrap_or_default().to_string_lossy();
    let failed = |attempt| move |error| RecordError::new(path, attempt, error);
    let mut file = tempfile::Builder::new()
        .prefix(&format!(".{name}."))
        .suffix(".part")
        // Less the umask.
        .permissions(Permissions::from_mode(0o666))
        .tempfile_in(folder_of(&target))
        .map_err(failed(Attempt::Create))?;
    if let Some(old) = old {
        file.as_file()
            .set_permissions(old.permissions())
            .map_err(failed(Attempt::Replace))?;
    }
    fill(file.as_file_mut())?;
    // Before the rename: else a power cut could leave the new name on an empty file.
    file.as_file().sync_all().map_err(failed(Attempt::Sync))?;
    file.persist(&target)
        .map_err(|error| RecordError::new(path, Attempt::Replace, error.error))?;
    sync_folder(&target).map_err(failed(Attempt::Sync))
}

/// Whether a file could be written there, by making one beside it for a moment.
pub fn probe(path: &Path) -> Result<(), RecordError> {
    let failed = |error| RecordError::new(path, Attempt::Create, error);
    if path.is_dir() {
        return Err(failed(io::ErrorKind::IsADirectory.into()));
    }
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    if fs::metadata(&target).is_ok_and(|old| !old.is_file()) {
        return Ok(());
    }
    let made = tempfile::Builder::new().tempfile_in(folder_of(&target));
    made.map(drop).map_err(failed)
}

/// Returns once the name of `path` in its folder would survive a power cut.
pub(super) fn sync_folder(path: &Path) -> io::Result<()> {
    match File::open(folder_of(path)).and_then(|folder| folder.sync_all()) {
        // Some network file systems cannot sync a folder, and a folder may be writable but not
        // readable: the file itself is safe, only its name is not known to be.
        Err(error)
            if matches!(
                error.kind(),
                io::ErrorKind::InvalidInput
                    | io::ErrorKind::Unsupported
                    | io::ErrorKind::PermissionDenied
            ) =>
        {
            Ok(())
        }
        outcome => outcome,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names_in(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).unwrap();
        entries
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect()
    }

    #[test]
    fn a_file_is_made_replaced_and_left_alone_in_its_folder() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("picture.svg");
        write(&path, b"one").unwrap();
        write(&path, b"two").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"two");
        assert_eq!(names_in(folder.path()), ["picture.svg"]);
    }

    #[test]
    fn a_new_file_has_the_mode_any_new_file_has_and_an_old_one_keeps_its_own() {
        let folder = tempfile::tempdir().unwrap();
        let mode = |path: &Path| fs::metadata(path).unwrap().permissions().mode();
        let path = folder.path().join("new");
        write(&path, b"").unwrap();
        let usual = folder.path().join("usual");
        File::create(&usual).unwrap();
        assert_eq!(mode(&path), mode(&usual));

        fs::set_permissions(&path, Permissions::from_mode(0o640)).unwrap();
        write(&path, b"again").unwrap();
        assert_eq!(mode(&path) & 0o777, 0o640);
    }

    #[test]
    fn a_link_is_followed() {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("file");
        let link = folder.path().join("link");
        fs::write(&file, "old").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        write(&link, b"new").unwrap();
        assert_eq!(fs::read(&file).unwrap(), b"new");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
    }

    #[test]
    fn a_device_is_written_to_and_stays_a_device() {
        let folder = tempfile::tempdir().unwrap();
        let link = folder.path().join("nowhere");
        std::os::unix::fs::symlink("/dev/null", &link).unwrap();
        write(&link, b"gone").unwrap();
        assert!(!fs::metadata("/dev/null").unwrap().is_file());
    }

    #[test]
    fn a_failure_leaves_nothing_behind_and_says_why() {
        let folder = tempfile::tempdir().unwrap();
        let missing = write(&folder.path().join("no/file"), b"").unwrap_err();
        assert!(
            missing.to_string().contains("there is no folder"),
            "{missing}"
        );
        let taken = write(folder.path(), b"").unwrap_err();
        assert!(taken.to_string().contains("it is a folder"), "{taken}");
        for path in [folder.path().join("no/file"), folder.path().to_owned()] {
            let foreseen = probe(&path).unwrap_err();
            let happened = write(&path, b"").unwrap_err();
            assert_eq!(foreseen.to_string(), happened.to_string());
        }
        probe(&folder.path().join("file")).unwrap();
        assert!(names_in(folder.path()).is_empty());
    }
}
