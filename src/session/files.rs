//! Commands about files: checkpoints, histories, journals, commands from a file.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use super::execute::{Reply, Request};
use super::places::{region_at, regions_of};
use super::{Refusal, RunError, Session, tables};
use crate::language::command::Export;
use crate::language::{Command, Known};
use crate::measure::sample::Sample;
use crate::record::error::{Attempt, RecordError};
use crate::record::journal::{Event, EventKind};
use crate::scene::Origin;

impl Session {
    pub(super) fn keep(&mut self, command: &Command) -> Result<Reply, Refusal> {
        let failed =
            |error: RunError| Refusal::new(error.to_string(), "the run itself is not affected");
        let cycle = self.world.cycle_number();
        if let Command::Save(file) | Command::Journal(file) | Command::Export(_, file) = command {
            self.spare_presets(Path::new(file))?;
        }
        match command {
            Command::Save(file) => {
                self.save(Path::new(file)).map_err(failed)?;
                Ok(Reply::line(format!("saved cycle {cycle} in {file}")))
            }
            Command::Restore(file) => {
                self.restore(file).map_err(failed)?;
                let back = self.world.cycle_number();
                Ok(Reply::line(format!("back at cycle {back}")))
            }
            Command::Export(Export::History, file) => {
                let rows = self.export_csv(Path::new(file)).map_err(failed)?;
                Ok(Reply::line(format!("{rows} rows in {file}")))
            }
            Command::Export(Export::All(of), file) => {
                let table = tables::all(&self.sample(), *of);
                write(table.bytes(), file, cycle)
            }
            Command::Export(Export::Vtk(of), file) => {
                let bytes = tables::polydata(&self.sample(), *of).bytes();
                write(&bytes, file, cycle)
            }
            Command::Export(Export::Picture(of), file) => {
                let svg = self.picture(*of)?;
                write(svg.as_bytes(), file, cycle)
            }
            Command::Export(Export::Lammps(nearest), folder) => {
                let deck = self.lammps(*nearest)?;
                deck.write(Path::new(folder))?;
                let mut reply = Reply::line(format!("cycle {cycle} in {folder}"));
                reply.lines.extend(deck.notices);
                Ok(reply)
            }
            Command::Export(Export::Profile(place, rings), file) => {
                let regions = regions_of(place, &self.scene.regions);
                let sample = Sample::over(&mut self.world, &regions, Some(&self.reference));
                let table = tables::profile(region_at(&sample, place), *rings);
                write(table.bytes(), file, cycle)
            }
            Command::Journal(file) => {
                let mut journal = self.journal.clone();
                let count = journal.events.len();
                // Otherwise a replay would run all stages to their end, not to this cycle.
                let kind = EventKind::End;
                journal.events.push(Event { cycle, kind });
                let text = journal.to_string();
                crate::record::whole_file::write(Path::new(file), text.as_bytes())?;
                Ok(Reply::line(format!("{count} events in {file}")))
            }
            Command::Source(file) => self.source(file),
            _ => Ok(Reply::default()),
        }
    }

    /// What is written by hand is not overwritten by a slip.
    fn spare_presets(&self, path: &Path) -> Result<(), Refusal> {
        // What is not there yet is not overwritten.
        let Ok(file) = path.canonicalize() else {
            return Ok(());
        };
        let own = match &self.scene.origin {
            Origin::File(preset) => preset.canonicalize().is_ok_and(|preset| preset == file),
            Origin::Embedded(_) | Origin::Text => false,
        };
        if own || file.extension().is_some_and(|ending| ending == "toml") {
            return Err(Refusal::new(
                format!("{} is a preset and would be overwritten", path.display()),
                "give another name",
            ));
        }
        Ok(())
    }

    /// All lines are read, and checked as far as they can be, before the first takes effect.
    fn source(&mut self, file: &str) -> Result<Reply, Refusal> {
        let mut reading = Reading {
            known: self.known(),
            lines: Vec::new(),
            open: Vec::new(),
        };
        reading.file(Path::new(file))?;
        let count = reading.lines.len();
        if count == 0 {
            return Ok(Reply::line(format!("no commands in {file}")));
        }
        // What ran for an earlier command has been interrupted by this one.
        self.course.user_errand = None;
        self.course.user_lines = reading.lines.into();
        Ok(Reply::asking(
            format!("{count} commands from {file}"),
            Request::Run,
        ))
    }
}

fn write(bytes: &[u8], file: &str, cycle: u64) -> Result<Reply, Refusal> {
    crate::record::whole_file::write(Path::new(file), bytes)?;
    Ok(Reply::line(format!("cycle {cycle} in {file}")))
}

/// Largest file of commands [bytes].
const LARGEST: u64 = 16 << 20;

/// A file of commands being read, and those it names.
struct Reading {
    known: Known,
    lines: Vec<String>,
    open: Vec<PathBuf>,
}

impl Reading {
    fn file(&mut self, path: &Path) -> Result<(), Refusal> {
        let failed = |error| Refusal::from(RecordError::new(path, Attempt::Read, error));
        // One name for each file, whichever way it is written.
        let file = path.canonicalize().map_err(failed)?;
        if self.open.contains(&file) {
            return Err(Refusal::new(
                format!("{} is being read already", path.display()),
                "files cannot source each other in a circle",
            ));
        }
        let mut text = String::new();
        File::open(path)
            .and_then(|file| file.take(LARGEST + 1).read_to_string(&mut text))
            .map_err(failed)?;
        if text.len() as u64 > LARGEST {
            return Err(Refusal::new(
                format!("{} is larger than {} MiB", path.display(), LARGEST >> 20),
                "is this the right file? One command stands in a line",
            ));
        }
        self.open.push(file);
        for (number, line) in text.lines().enumerate() {
            let bare = line.trim_start();
            if bare.is_empty() || bare.starts_with('#') {
                continue;
            }
            let place = |refusal: Refusal| Refusal {
                message: format!(
                    "{}, line {}: {}",
                    path.display(),
                    number + 1,
                    refusal.message
                ),
                ..refusal
            };
            self.line(line).map_err(place)?;
        }
        self.open.pop();
        Ok(())
    }

    fn line(&mut self, line: &str) -> Result<(), Refusal> {
        let command = Command::parse_with(line, &self.known.definitions)?;
        self.known.check(&command, line)?;
        self.known.follow(&command);
        match &command {
            Command::Source(file) => return self.file(Path::new(file)),
            Command::Go => {
                return Err(Refusal::new(
                    "`go` says not how far",
                    "write `cycle N` or `solve` in a file",
                ));
            }
            Command::Quit { .. } => {
                return Err(Refusal::new(
                    "`quit` has no place in a file of commands",
                    "type it when they are done",
                ));
            }
            _ => self.lines.push(command.to_string()),
        }
        Ok(())
    }
}
