//! Commands about files: checkpoints, histories, journals, commands from a file.

use std::path::{Path, PathBuf};

use super::execute::{Reply, Request};
use super::{Refusal, RunError, Session};
use crate::language::{Command, Known};
use crate::record::journal::{Event, EventKind};

/// Files that name each other go no deeper.
const DEEPEST: usize = 8;

impl Session {
    pub(super) fn keep(&mut self, command: &Command) -> Result<Reply, Refusal> {
        let failed =
            |error: RunError| Refusal::new(error.to_string(), "the run itself is not affected");
        let cycle = self.world.cycle_number();
        match command {
            Command::Save(file) => {
                self.save(Path::new(file)).map_err(failed)?;
                Ok(Reply::line(format!("saved cycle {cycle} in {file}")))
            }
            Command::Restore(file) => {
                self.restore(Path::new(file)).map_err(failed)?;
                let back = self.world.cycle_number();
                Ok(Reply::line(format!("back at cycle {back}")))
            }
            Command::ExportCsv(file) => {
                let rows = self.export_csv(Path::new(file)).map_err(failed)?;
                Ok(Reply::line(format!("{rows} rows in {file}")))
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

/// A file of commands being read, and those it names.
struct Reading {
    known: Known,
    lines: Vec<String>,
    open: Vec<PathBuf>,
}

impl Reading {
    fn file(&mut self, path: &Path) -> Result<(), Refusal> {
        if self.open.len() == DEEPEST {
            return Err(Refusal::new(
                format!("{}: files name each other too deeply", path.display()),
                format!("at most {DEEPEST} files within each other"),
            ));
        }
        let text = std::fs::read_to_string(path).map_err(|error| {
            Refusal::new(
                format!("{} cannot be read: {error}", path.display()),
                "give the path of a text file",
            )
        })?;
        self.open.push(path.to_path_buf());
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
        let command = Command::parse(line)?;
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
