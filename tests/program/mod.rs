//! The real program, run in a folder of its own.

use std::path::Path;
use std::process::{Command, Output};

/// Runs `ballast` with these words in a folder and waits for its end.
pub(crate) fn ballast(folder: &Path, words: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(words)
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

/// What it said on standard error.
pub(crate) fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
