//! The two streams.

use std::cell::RefCell;
use std::io::{ErrorKind, IsTerminal, Write};
use std::path::Path;

use super::recorded::Recorded;
use super::{BAD_INPUT, FAILED};
use crate::record::error::{Attempt, RecordError};
use crate::scene::{Rejection, Scene};
use crate::session::RunError;

/// Data, to standard output; answers the exit status. A reader that has gone away needs no more of
/// it.
pub(super) fn print(text: &str) -> u8 {
    let mut out = std::io::stdout().lock();
    let written = out.write_all(text.as_bytes()).and_then(|()| out.flush());
    match written {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            let path = Path::new("standard output");
            complain(&RecordError::new(path, Attempt::Write, error).to_string());
            FAILED
        }
        _ => 0,
    }
}

thread_local! {
    /// Whose messages those of this thread are: runs that go on at the same time are told apart.
    static SPEAKER: RefCell<String> = const { RefCell::new(String::new()) };
}

/// Messages of this thread begin with this name from now on.
pub(super) fn speak_as(name: &str) {
    SPEAKER.set(format!("{name}: "));
}

/// A message, to standard error.
pub(super) fn tell(text: &str) {
    let text = SPEAKER.with_borrow(|speaker| format!("{speaker}{text}\n"));
    // In one piece: others may speak at the same time.
    drop(std::io::stderr().lock().write_all(text.as_bytes()));
}

/// An error, to standard error.
pub(super) fn complain(text: &str) {
    tell(&format!("ballast: {text}"));
}

/// A rejected preset, in colour on a terminal.
pub(super) fn reject(rejection: &Rejection) {
    let colour = coloured(&std::io::stderr());
    tell(&rejection.render(colour));
}

/// Whether a stream takes colours: a terminal whose user has not said no (no-color.org).
pub(super) fn coloured(stream: &impl IsTerminal) -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    stream.is_terminal() && !refused
}

/// Loads a scene, or says what is wrong with it.
pub(super) fn load(preset: &str, set: &[String]) -> Option<Scene> {
    if let Some(other) = Recorded::find(preset) {
        complain(&other.advice(preset));
        return None;
    }
    match Scene::load(preset, set) {
        Ok(scene) => Some(scene),
        Err(rejection) => {
            reject(&rejection);
            None
        }
    }
}

/// Says why a scene cannot be opened; answers the exit status.
pub(super) fn unopened(error: &RunError) -> u8 {
    if let RunError::Rejected(rejection) = error {
        reject(rejection);
        return BAD_INPUT;
    }
    complain(&error.to_string());
    FAILED
}
