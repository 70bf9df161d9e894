//! Prepared samples, kept between runs: one checkpoint each, under a name that holds a hash of all
//! that decides it.
//!
//! A file that is damaged, or that holds another preset than its name promises, counts as none. Files
//! appear whole, so that runs at the same time do no harm to each other: both prepare, one is kept.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

use super::super::save::held;
use crate::record::error::{Attempt, RecordError};
use crate::record::whole_file;
use crate::scene::Scene;

/// Says where the cache is not wanted.
const SWITCH: &str = "BALLAST_CACHE";

/// A sample that was not used for so long goes.
const KEPT: Duration = Duration::from_secs(30 * 24 * 3600);

/// The place of one sample.
pub(super) struct Entry<'s> {
    /// The run that prepares it, up to the stage at whose end it is taken.
    run: &'s Scene,
    /// Where it is kept, if it is.
    path: Option<PathBuf>,
}

impl<'s> Entry<'s> {
    /// Of the run that ends where the sample is taken.
    pub(super) fn of(run: &'s Scene) -> Self {
        let path = folder().map(|folder| folder.join(name(run)));
        Self { run, path }
    }

    /// The sample, if it is there and whole.
    pub(super) fn read(&self) -> Option<Vec<u8>> {
        let path = self.path.as_deref()?;
        let state = std::fs::read(path).ok()?;
        let held = held(&state).ok()?;
        let same = held.journal.preset_text == self.run.text
            && held.stage + 1 == self.run.stages.len()
            && settings(&held.journal.overrides).eq(settings(&self.run.overrides));
        // Used again, it stays longer. Where that cannot be noted it goes some day, that is all.
        drop(std::fs::File::open(path).and_then(|file| file.set_modified(SystemTime::now())));
        same.then_some(state)
    }

    /// Keeps it.
    pub(super) fn write(&self, state: &[u8]) -> Result<(), RecordError> {
        let Some(path) = self.path.as_deref() else {
            return Ok(());
        };
        let folder = path.parent().unwrap_or(Path::new(""));
        std::fs::create_dir_all(folder)
            .map_err(|error| RecordError::new(folder, Attempt::Create, error))?;
        whole_file::write(path, state)?;
        tidy(folder);
        Ok(())
    }
}

/// Overrides less those about the sample's own sample, which journals write with whole paths.
fn settings(overrides: &[String]) -> impl Iterator<Item = &String> {
    let about = |set: &&String| set.trim_start().starts_with("start.");
    overrides.iter().filter(move |set| !about(set))
}

/// Everything that decides the sample, in one name. The program counts with its sources: a sample that
/// another build has prepared might differ in its last bits.
fn name(run: &Scene) -> String {
    let mut hash = DefaultHasher::new();
    env!("CARGO_PKG_VERSION").hash(&mut hash);
    env!("BALLAST_SOURCES").hash(&mut hash);
    run.text.hash(&mut hash);
    run.overrides.hash(&mut hash);
    run.seed.hash(&mut hash);
    run.stages.len().hash(&mut hash);
    run.setup.ledger.hash(&mut hash);
    run.sample
        .as_ref()
        .map(|sample| &sample.state)
        .hash(&mut hash);
    let plain = |c: char| if c.is_alphanumeric() { c } else { '-' };
    let title: String = run.name.chars().map(plain).take(40).collect();
    format!("{title}-{:016x}.ballast", hash.finish())
}

/// Whether samples are kept at all.
pub(super) fn is_on() -> bool {
    folder().is_some()
}

/// `$XDG_CACHE_HOME/ballast/samples` or `~/.cache/ballast/samples`; none if it is switched off or
/// there is no home.
fn folder() -> Option<PathBuf> {
    if std::env::var_os(SWITCH).is_some_and(|switch| switch == "off") {
        return None;
    }
    let own = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from);
    // A relative path there is to be ignored, says the XDG specification.
    let cache = own.filter(|path| path.is_absolute()).or_else(|| {
        let home = std::env::var_os("HOME").filter(|home| !home.is_empty())?;
        Some(PathBuf::from(home).join(".cache"))
    })?;
    Some(cache.join("ballast").join("samples"))
}

/// Removes samples that nobody has used for long. What cannot be removed stays.
fn tidy(folder: &Path) {
    let now = SystemTime::now();
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    for file in files {
        let path = file.path();
        let used = file.metadata().and_then(|data| data.modified());
        let old = used.is_ok_and(|used| now.duration_since(used).is_ok_and(|age| age > KEPT));
        if old && path.extension().is_some_and(|ending| ending == "ballast") {
            drop(std::fs::remove_file(path));
        }
    }
}
