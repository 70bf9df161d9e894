//! What the worker reports.

use super::{App, Effect, Said, words};
use crate::language::Command;
use crate::language::command::Export;
use crate::session::worker::Report;
use crate::session::{Refusal, Reply, Request};
use crate::tui::panes::PaneId;

impl App {
    /// Takes a report of the worker.
    pub fn take_report(&mut self, report: Report) -> Effect {
        match report {
            Report::Said { line, reply } => self.take_reply(&line, reply),
            Report::Notice(text) => self.say(Said::Notice(text)),
            Report::Failed(text) => {
                self.failure = Some(text.clone());
                self.answer(vec![Said::Error(text)]);
            }
            Report::Pace(pace) => {
                self.pace = pace;
                self.dirty = true;
            }
            Report::Quit(anyway) => return self.quit(anyway),
        }
        Effect::None
    }

    fn take_reply(&mut self, line: &str, reply: Result<Reply, Refusal>) {
        self.say(Said::Line(line.to_owned()));
        let reply = match reply {
            Ok(reply) => reply,
            Err(refusal) => return self.answer(vec![Said::Error(refusal.to_string())]),
        };
        // A definition of the preset can stand in expressions only, which none of these have.
        let command = Command::parse(line.trim_start_matches(':')).ok();
        let restored = matches!(command, Some(Command::Restore(_)));
        if restored || reply.request == Some(Request::Run) {
            self.failure = None;
        }
        // Pictures and tables leave the history where it was.
        let keeps = matches!(
            command,
            Some(Command::Export(Export::History, _) | Command::Save(_))
        );
        if keeps && let Some(frame) = &self.frame {
            self.kept_cycle = frame.cycle;
        }
        let mut lines: Vec<Said> = reply.lines.into_iter().map(Said::Answer).collect();
        if command == Some(Command::Help(None)) {
            lines.extend(words::listing().map(Said::Answer));
        }
        if matches!(command, Some(Command::InspectContact(..))) {
            // The pane shows all that the answer says, and goes on showing it.
            for said in lines {
                self.say(said);
            }
            self.zoomed = Some(PaneId::Contact);
        } else {
            self.answer(lines);
        }
    }
}
