//! Keeping a journal while the run goes on.

use std::path::Path;

use super::super::error::RecordError;
use super::super::whole_file;
use super::super::whole_lines::WholeLines;
use super::{Event, Journal};

/// A journal that grows by one line per event. Each line is handed over at once, so that a killed
/// process loses at most the line it was writing.
pub struct JournalWriter {
    lines: WholeLines,
}

impl JournalWriter {
    /// Puts a new journal in the place of whatever `path` held, with the events so far: after a
    /// resume those that the checkpoint carries.
    pub fn create(path: &Path, journal: &Journal) -> Result<Self, RecordError> {
        let text = journal.to_string();
        // Whole or not at all: a journal without its preset could replay nothing.
        whole_file::write(path, text.as_bytes())?;
        let lines = WholeLines::reopen(path, text.len() as u64)?;
        Ok(Self { lines })
    }

    /// Adds one event. After an error the event waits, and is written before the next one.
    pub fn append(&mut self, event: &Event) -> Result<(), RecordError> {
        self.lines.push(format!("{event}\n").as_bytes())?;
        self.lines.flush()
    }

    /// Returns once every event would survive a power cut.
    pub fn sync(&mut self) -> Result<(), RecordError> {
        self.lines.sync()
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::super::EventKind;
    use super::*;

    #[test]
    fn every_event_is_in_the_file_as_soon_as_it_is_added() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.journal");
        fs::write(&path, "an older and much longer journal".repeat(100)).unwrap();
        let mut journal = Journal {
            program: "0.1.0".into(),
            preset_text: "[model]\n".into(),
            ..Journal::default()
        };
        let mut writer = JournalWriter::create(&path, &journal).unwrap();
        for cycle in 0..3 {
            let kind = EventKind::Typed(format!("friction 0.{cycle}"));
            journal.events.push(Event { cycle, kind });
            writer.append(&journal.events[cycle as usize]).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), journal.to_string());
        }
        writer.sync().unwrap();

        // A resumed run goes on from the events its checkpoint carries.
        journal.events.truncate(1);
        let mut writer = JournalWriter::create(&path, &journal).unwrap();
        let end = Event {
            cycle: 9,
            kind: EventKind::End,
        };
        writer.append(&end).unwrap();
        journal.events.push(end);
        let read = Journal::parse(&fs::read_to_string(&path).unwrap()).unwrap();
        assert_eq!(read, journal);
        assert!(read.is_complete());
    }

    #[test]
    fn a_journal_may_go_nowhere() {
        let mut writer =
            JournalWriter::create(Path::new("/dev/null"), &Journal::default()).unwrap();
        let kind = EventKind::End;
        writer.append(&Event { cycle: 0, kind }).unwrap();
        writer.sync().unwrap();
    }
}
