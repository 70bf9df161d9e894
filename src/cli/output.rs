//! The two streams.

use std::io::{IsTerminal, Write};

use crate::scene::{Rejection, Scene};

/// Data, to standard output. A reader that has gone away needs no more of it.
pub(super) fn print(text: &str) {
    let mut out = std::io::stdout().lock();
    drop(out.write_all(text.as_bytes()).and_then(|()| out.flush()));
}

/// A message, to standard error.
pub(super) fn tell(text: &str) {
    let mut out = std::io::stderr().lock();
    drop(writeln!(out, "{text}"));
}

/// An error, to standard error.
pub(super) fn complain(text: &str) {
    tell(&format!("ballast: {text}"));
}

/// A rejected preset, in colour on a terminal.
pub(super) fn reject(rejection: &Rejection) {
    let colour = std::io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none();
    tell(&rejection.render(colour));
}

/// Loads a scene, or says what is wrong with it.
pub(super) fn load(preset: &str, set: &[String]) -> Option<Scene> {
    match Scene::load(preset, set) {
        Ok(scene) => Some(scene),
        Err(rejection) => {
            reject(&rejection);
            None
        }
    }
}
