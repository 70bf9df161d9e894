//! A folder of its own for each run of a workbench, under the state folder of the user. One that nobody
//! has gone on with for long goes, as samples of the cache do.

use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use crate::record::error::{Attempt, RecordError};

/// A run that nothing was written of for so long goes.
const KEPT: Duration = Duration::from_secs(30 * 24 * 3600);

/// Where the state is kept.
#[derive(Debug, Clone)]
pub struct Keep {
    /// Checkpoint.
    pub checkpoint: PathBuf,
    /// Journal.
    pub journal: PathBuf,
}

impl Keep {
    /// Makes the folder for a run of this preset; or says why there is none.
    pub fn make(preset: &str) -> Result<Self, String> {
        let runs = runs()?;
        tidy(&runs, SystemTime::now());
        let now = SystemTime::now().duration_since(UNIX_EPOCH);
        let millis = now.unwrap_or_default().as_millis();
        let folder = runs.join(format!("{preset}-{millis}-{}", std::process::id()));
        std::fs::create_dir_all(&folder).map_err(|error| {
            let error = RecordError::new(&folder, Attempt::Create, error);
            format!("{error}, or set XDG_STATE_HOME to a folder that you may write")
        })?;
        Ok(Self::within(&folder))
    }

    /// The files of a run in its folder.
    pub fn within(folder: &Path) -> Self {
        Self {
            checkpoint: folder.join("run.ballast"),
            journal: folder.join("run.journal"),
        }
    }
}

/// `$XDG_STATE_HOME/ballast/runs` or `~/.local/state/ballast/runs`.
fn runs() -> Result<PathBuf, String> {
    let named = |name| std::env::var_os(name).map(PathBuf::from);
    // A relative path there is to be ignored, says the XDG specification.
    let own = named("XDG_STATE_HOME").filter(|path| path.is_absolute());
    let home = || named("HOME").filter(|home| !home.as_os_str().is_empty());
    own.or_else(|| Some(home()?.join(".local/state")))
        .map(|state| state.join("ballast").join("runs"))
        .ok_or_else(|| {
            "there is neither $XDG_STATE_HOME nor $HOME; set one of them to a folder".into()
        })
}

/// Removes runs that nothing was written of for long. What cannot be removed stays.
fn tidy(runs: &Path, now: SystemTime) {
    let folders = std::fs::read_dir(runs).into_iter().flatten().flatten();
    for folder in folders.map(|folder| folder.path()) {
        // Whatever else somebody put there is not ours to remove.
        let is_run = !folder.is_symlink() && Keep::within(&folder).journal.is_file();
        if is_run && is_old(&folder, now) && !is_open(&folder) {
            drop(std::fs::remove_dir_all(folder));
        }
    }
}

/// Whether folder and files were written long ago, all of them.
fn is_old(folder: &Path, now: SystemTime) -> bool {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut times = files
        .map(|file| file.metadata())
        .chain([std::fs::metadata(folder)])
        .map(|data| data.and_then(|data| data.modified()));
    times.all(|time| time.is_ok_and(|time| now.duration_since(time).is_ok_and(|age| age > KEPT)))
}

/// Whether the process is there that the folder is named after: a workbench may stand paused for weeks.
fn is_open(folder: &Path) -> bool {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let process = name.rsplit('-').next().and_then(|id| id.parse().ok());
    let process = process.and_then(rustix::process::Pid::from_raw);
    process.is_some_and(|process| rustix::process::test_kill_process(process).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_old_runs_that_nobody_has_open_go() {
        let runs = tempfile::tempdir().unwrap();
        let own = std::process::id();
        // No process has a number like this: Linux ends at 2^22.
        let gone = 999_999_999;
        let made = |name: String, file: &str| {
            let folder = runs.path().join(name);
            std::fs::create_dir(&folder).unwrap();
            std::fs::write(folder.join(file), "").unwrap();
            folder
        };
        let open = made(format!("a-1-{own}"), "run.journal");
        let closed = made(format!("a-1-{gone}"), "run.journal");
        let foreign = made(format!("b-1-{gone}"), "thesis.tex");
        let link = runs.path().join(format!("c-1-{gone}"));
        std::os::unix::fs::symlink(&closed, &link).unwrap();

        let now = SystemTime::now();
        tidy(runs.path(), now + KEPT - Duration::from_secs(60));
        assert!(closed.exists(), "not yet old");
        tidy(runs.path(), now + KEPT + Duration::from_secs(60));
        assert!(!closed.exists(), "nobody wants it");
        assert!(open.exists() && foreign.exists() && link.is_symlink());
    }
}
