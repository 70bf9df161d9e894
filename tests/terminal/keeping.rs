//! Where a run is kept, how it is gone on with, and what is said when it is lost.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Output, Stdio};

use super::ballast;
use super::pty::Pty;

/// A dialogue of these lines, with the words of a shell before the program.
fn talk(state: &Path, before: &str, words: &str, lines: &str) -> Output {
    let mut child = std::process::Command::new("sh")
        .args(["-c", &format!("{before} exec \"$0\" {words} --plain")])
        .arg(env!("CARGO_BIN_EXE_ballast"))
        .env("XDG_STATE_HOME", state)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut input = child.stdin.take().unwrap();
    std::io::Write::write_all(&mut input, lines.as_bytes()).unwrap();
    drop(input);
    child.wait_with_output().unwrap()
}

/// What came on standard output, and on standard error.
fn said(output: &Output) -> [String; 2] {
    [&output.stdout, &output.stderr].map(|bytes| String::from_utf8_lossy(bytes).into_owned())
}

/// The checkpoint that a farewell names.
fn checkpoint(farewell: &str) -> PathBuf {
    let (_, path) = farewell.split_once("with: ballast ").unwrap();
    PathBuf::from(path.trim())
}

#[test]
fn the_workbench_goes_on_from_a_checkpoint() {
    let mut first = Pty::start(120, 40, &["disc-pile", "--set", "history.every=500"]);
    first.reaches(1000);
    first.keys(":q!\r");
    assert_eq!(first.end(), 0);
    let kept = first.kept("ballast");

    let mut pty = Pty::start(120, 40, &[kept.to_str().unwrap(), "--paused"]);
    pty.shows("PAUSED");
    pty.shows("goes on from cycle");
    let begun = pty.cycle().unwrap();
    assert!(begun >= 1000);
    pty.keys(":cycle 700\r");
    pty.reaches(begun + 700);
    pty.keys("export csv pile.csv\r");
    pty.shows("rows in pile.csv");
    pty.leave_prompt();
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 0);
    assert!(pty.screen().contains("go on with: ballast"));

    // Rows from before the checkpoint are among them, and the new journal tells all of it.
    let exported = fs::read_to_string(pty.home.path().join("pile.csv")).unwrap();
    assert!(exported.lines().nth(1).unwrap().starts_with("0,"));
    let journal = pty.kept("journal");
    let again = ballast(&["run", journal.to_str().unwrap(), "--csv", "-", "-q"]);
    let again = String::from_utf8_lossy(&again.stdout).into_owned();
    assert!(again.starts_with(&exported), "bit for bit");
}

#[test]
fn a_dialogue_goes_on_as_its_farewell_says() {
    let folder = tempfile::tempdir().unwrap();
    let first = talk(folder.path(), "", "nine-disc-compression", "cycle 50\n");
    assert_eq!(first.status.code(), Some(0));
    let [_, farewell] = said(&first);
    let kept = checkpoint(&farewell);
    let second = talk(folder.path(), "", &kept.display().to_string(), "cycle 7\n");
    let [dialogue, farewell] = said(&second);
    assert!(dialogue.contains("cycle 50,"), "{dialogue}");
    assert!(farewell.starts_with("cycle 57; journal"), "{farewell}");
    assert_ne!(checkpoint(&farewell), kept, "each has a folder of its own");

    let words = format!("{} --set model.frac=0.2", kept.display());
    let refused = talk(folder.path(), "", &words, "");
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused)[1].contains("keeps its preset"));
}

#[test]
fn a_last_state_that_does_not_fit_is_told() {
    let folder = tempfile::tempdir().unwrap();
    // Blocks of 512 or 1024 bytes: the journal fits.
    let limit = "ulimit -f 26;";
    let output = talk(folder.path(), limit, "disc-pile", "cycle 500\n");
    let [_, farewell] = said(&output);
    assert_eq!(output.status.code(), Some(1), "{farewell}");
    for hint in ["last state could not be saved", "no earlier one"] {
        assert!(farewell.contains(hint), "{farewell}");
    }
}

#[test]
fn the_workbench_tells_of_a_last_state_that_is_lost() {
    let mut pty = Pty::start(120, 40, &["disc-pile"]);
    pty.reaches(1000);
    let ballast = pty.home.path().join("ballast");
    fs::rename(&ballast, pty.home.path().join("elsewhere")).unwrap();
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 1);
    let screen = pty.screen();
    assert!(screen.contains("last state could not be saved"), "{screen}");
    assert!(!screen.contains("go on with"), "{screen}");
}

#[test]
fn where_nothing_can_be_kept_it_is_said_at_once_and_again() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "").unwrap();
    let output = talk(&file, "", "nine-disc-compression", "cycle 50\n");
    for text in said(&output) {
        assert!(text.contains("nothing of this run is kept"), "{text}");
    }
    let homeless = "unset HOME XDG_STATE_HOME;";
    let output = talk(folder.path(), homeless, "nine-disc-compression", "");
    let [dialogue, _] = said(&output);
    assert!(dialogue.contains("neither $XDG_STATE_HOME"), "{dialogue}");
}

#[test]
fn a_fault_of_the_program_keeps_a_dialogue_too() {
    let folder = tempfile::tempdir().unwrap();
    let words = "nine-disc-compression --panic-at 3000";
    let output = talk(folder.path(), "", words, "go\n");
    assert_eq!(output.status.code(), Some(1));
    let [_, farewell] = said(&output);
    // Stages begin at cycles 40, 1040 and 2540.
    assert!(farewell.contains("internal error\n"), "{farewell}");
    assert!(farewell.contains("go on from cycle "), "{farewell}");
    assert!(checkpoint(&farewell).exists());
}
