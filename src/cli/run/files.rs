//! The files of a run: none may overwrite another, and all can be written before the first cycle.

use std::path::{Path, PathBuf};
use std::time::Duration;

use super::conclude::home;
use super::prepare::Prepared;
use crate::cli::Run;
use crate::cli::output::tell;
use crate::record::history::History;
use crate::session::{Replay, RunError, Session};

/// With `--csv FILE` a checkpoint is kept beside it this often unless `--every` says otherwise.
const USUAL: Duration = Duration::from_secs(60);

/// Which files a run writes.
pub(super) struct Files {
    /// The history.
    pub(super) csv: Option<PathBuf>,
    /// Whether the history goes to standard output.
    pub(super) stdout: bool,
    /// The journal beside the history; not where it is the journal being replayed.
    pub(super) journal: Option<PathBuf>,
    /// The last checkpoint.
    pub(super) checkpoint: Option<PathBuf>,
    /// Time between checkpoints.
    pub(super) period: Duration,
    /// Cycle of the last checkpoint written.
    pub(super) saved: Option<u64>,
    /// Whether the history is written at the end: its columns change on the way.
    pub(super) late: bool,
}

impl Files {
    /// Chooses the files; or says which two would be one.
    pub(super) fn choose(options: &Run, prepared: &Prepared) -> Result<Self, String> {
        let stdout = options
            .csv
            .as_ref()
            .is_some_and(|csv| csv.as_os_str() == "-");
        let csv = options.csv.clone().filter(|_| !stdout);
        let beside = |ending| csv.as_ref().map(|csv: &PathBuf| csv.with_extension(ending));
        let mut files = Self {
            stdout,
            journal: beside("journal"),
            checkpoint: options.checkpoint.clone().or_else(|| beside("ballast")),
            period: options.every.map_or(USUAL, Duration::from_secs_f64),
            csv,
            saved: None,
            late: prepared
                .replay
                .as_ref()
                .is_some_and(Replay::changes_columns),
        };
        let input = options.preset.as_ref().map(PathBuf::from);
        if let (Some(journal), Some(_), Some(input)) = (&files.journal, &prepared.replay, &input)
            && same(journal, input)
        {
            // A replay repeats what is in it already, unless it was told to do otherwise.
            if !options.set.is_empty() || options.seed.is_some() {
                return Err(format!(
                    "{} is being replayed with other settings and would be overwritten; \
                     give --csv another name",
                    journal.display()
                ));
            }
            files.journal = None;
        }
        files.check(input.as_deref(), options.resume.as_deref())?;
        Ok(files)
    }

    fn check(&self, input: Option<&Path>, resume: Option<&Path>) -> Result<(), String> {
        let written = [
            (&self.csv, "--csv"),
            (&self.journal, "the journal"),
            (&self.checkpoint, "the checkpoint"),
        ];
        let written: Vec<(&Path, &str)> = written
            .into_iter()
            .filter_map(|(path, what)| Some((path.as_deref()?, what)))
            .collect();
        let clash = |path: &Path, a: &str, b: &str| {
            Err(format!(
                "{} would be {a} and {b}; give another name",
                path.display()
            ))
        };
        for (k, (path, what)) in written.iter().enumerate() {
            if let Some((_, other)) = written[..k].iter().find(|(other, _)| same(path, other)) {
                return clash(path, other, what);
            }
            if input.is_some_and(|input| same(path, input)) {
                return clash(path, "the input", what);
            }
            if *what != "the checkpoint" && resume.is_some_and(|resume| same(path, resume)) {
                return clash(path, "the file to resume from", what);
            }
        }
        Ok(())
    }

    /// Makes them. A checkpoint is written at once: a path that cannot be written is better known
    /// now than after a night.
    pub(super) fn open(&mut self, prepared: &mut Prepared, options: &Run) -> Result<(), RunError> {
        let session = &mut prepared.session;
        let names = session.recording().names();
        if self.late {
            // A file that cannot be written is better known now.
            self.csv
                .as_ref()
                .map(|csv| History::create(csv, &names))
                .transpose()?;
        } else if let Some(csv) = &self.csv {
            if prepared.resumed {
                let length = || std::fs::metadata(csv).map_or(0, |file| file.len());
                let before = length();
                session.go_on_with_history(csv)?;
                if length() < before && !options.quiet {
                    let cycle = session.world().cycle_number();
                    tell(&format!(
                        "{}: rows after cycle {cycle} are made anew",
                        csv.display()
                    ));
                }
            } else {
                session.write_history(History::create(csv, &names)?);
            }
        } else if self.stdout {
            session.write_history(History::to_stdout(&names)?);
        }
        if let Some(journal) = &self.journal {
            session.write_journal(journal)?;
        }
        let beside = self.csv.clone();
        session.write_dumps(&beside.unwrap_or_else(|| home(session, options, "csv")));
        self.save(session)
    }

    /// Writes the history as a whole, where it could not be written row by row.
    pub(super) fn write_late(&self, session: &Session) -> Result<(), RunError> {
        match &self.csv {
            _ if !self.late => Ok(()),
            Some(csv) => session.export_csv(csv).map(drop),
            None if self.stdout => session.export_stdout(),
            None => Ok(()),
        }
    }

    /// Writes the checkpoint, if one is kept.
    pub(super) fn save(&mut self, session: &mut Session) -> Result<(), RunError> {
        if let Some(checkpoint) = &self.checkpoint {
            session.save(checkpoint)?;
            self.saved = Some(session.world().cycle_number());
        }
        Ok(())
    }
}

/// Whether two paths are one file. Devices may be named as often as you like.
pub(in crate::cli) fn same(a: &Path, b: &Path) -> bool {
    let is_device = |path: &Path| path.metadata().is_ok_and(|file| !file.is_file());
    !is_device(a) && whole(a) == whole(b)
}

/// The path without links and dots, as far as it exists.
fn whole(path: &Path) -> PathBuf {
    if let Ok(path) = path.canonicalize() {
        return path;
    }
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let folder = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    path.file_name()
        .map_or(folder.clone(), |name| folder.join(name))
}
