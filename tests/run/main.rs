//! `ballast run` from outside: the same bytes however a run is cut up, and nothing lost however it
//! ends.

mod definitions;
mod dumps;
mod ensemble;
mod failure;
#[path = "../program/heeding.rs"]
mod heeding;
mod interruption;
mod overrides;
#[path = "../program/mod.rs"]
mod program;
mod repetition;
mod replay;
mod resumption;
mod resumption_told;
mod scenes;
mod start;
mod usage;
mod words;

use std::fs;
use std::path::Path;
use std::process::Output;

use program::{ballast, said};

/// Runs `ballast run` with the words of one line, and asserts that it succeeds.
#[track_caller]
fn run(folder: &Path, words: &str) -> Output {
    let output = attempt(folder, words);
    assert_eq!(output.status.code(), Some(0), "{words}: {}", said(&output));
    output
}

/// Runs `ballast run` with the words of one line.
fn attempt(folder: &Path, words: &str) -> Output {
    let mut all = vec!["run"];
    all.extend(words.split_whitespace());
    ballast(folder, &all)
}

/// Asserts an exit status and that every hint is in the message; answers the message.
#[track_caller]
fn refused(folder: &Path, words: &str, status: i32, hints: &[&str]) -> String {
    let output = attempt(folder, words);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(status), "{words}: {said}");
    for hint in hints {
        assert!(said.contains(hint), "{words}: no `{hint}` in {said}");
    }
    said
}

fn bytes(folder: &Path, name: &str) -> Vec<u8> {
    fs::read(folder.join(name)).expect("the file is there")
}

fn text(folder: &Path, name: &str) -> String {
    String::from_utf8(bytes(folder, name)).expect("it is text")
}

/// Asserts that two files or outputs are the same, without printing megabytes if they are not.
#[track_caller]
fn assert_same(a: &[u8], b: &[u8], what: &str) {
    let at = a.iter().zip(b).take_while(|(a, b)| a == b).count();
    assert!(
        a == b,
        "{what}: {} and {} bytes, which differ from byte {at} on",
        a.len(),
        b.len()
    );
}

/// Cycle of a row.
fn cycle_of(row: &str) -> u64 {
    let cell = row.split(',').next().expect("a row has cells");
    cell.parse().expect("the first cell is the cycle")
}

/// Names of the files in a folder, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("it can be read").file_name())
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}
