//! What whoever goes on with a run is told: what is kept, what is made anew, what is done already.

use std::fs;
use std::process::Command;

use super::{assert_same, bytes, names, refused, run, said};

#[test]
fn a_run_that_keeps_nothing_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv part.csv --cycles 100");
    let before = names(folder);
    let nothing = "nothing of what follows is kept";
    let message = said(&run(folder, "--resume part.ballast --cycles 200"));
    for hint in [nothing, "--csv", "--checkpoint"] {
        assert!(message.contains(hint), "no `{hint}` in {message}");
    }
    assert_eq!(names(folder), before);
    for kept in ["--csv -", "--csv x.csv", "--checkpoint y.ballast", "-q"] {
        let message = said(&run(folder, &format!("--resume part.ballast {kept}")));
        assert!(!message.contains(nothing), "{kept}: {message}");
    }
}

#[test]
fn stages_that_are_done_are_counted() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = "nine-disc-compression --csv run.csv";
    for (cycles, done) in [(39, "0 of 5"), (500, "1 of 5"), (1040, "2 of 5")] {
        let message = said(&run(folder, &format!("{preset} --cycles {cycles}")));
        assert!(
            message.contains(&format!("{done} stages done")),
            "{message}"
        );
    }
    let message = said(&run(folder, preset));
    assert!(message.contains("\n5 stages done"), "{message}");
    let message = said(&run(folder, "--resume run.ballast"));
    assert!(message.contains("nothing is left to run"), "{message}");
}

#[test]
fn rows_that_are_made_anew_are_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv run.csv --cycles 100");
    fs::copy(folder.join("run.ballast"), folder.join("early.ballast")).expect("it is there");
    run(folder, "nine-disc-compression --csv run.csv --cycles 200");
    let whole = bytes(folder, "run.csv");
    let words = "--resume early.ballast --csv run.csv --cycles 200";
    let message = said(&run(folder, words));
    let hint = "run.csv: rows after cycle 100 are made anew";
    assert!(message.contains(hint), "{message}");
    assert_same(&bytes(folder, "run.csv"), &whole, "the same rows again");
    let message = said(&run(
        folder,
        "--resume run.ballast --csv run.csv --cycles 300",
    ));
    assert!(!message.contains("anew"), "{message}");
}

#[test]
fn what_a_run_left_behind_is_no_preset_and_says_what_to_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "two-discs --csv run.csv");
    let hints = ["is a checkpoint", "run --resume run.ballast --csv"];
    refused(folder, "run.ballast", 2, &hints);
    for (command, file, hint) in [
        ("check", "run.ballast", "ballast run --resume run.ballast"),
        ("check", "run.journal", "is a journal"),
        ("study", "run.journal", "ballast run run.journal --csv"),
    ] {
        let output = super::ballast(folder, &[command, file]);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(hint), "{said}");
    }
}

#[test]
fn a_checkpoint_that_cannot_be_replaced_is_still_there() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    // Blocks of 512 or 1024 bytes. Rows come seldom and the first checkpoint fits; with the rows it grows.
    let line = "ulimit -f 40; exec \"$0\" run nine-disc-compression --csv run.csv --every 0.001 \
                --set history.every=1";
    let output = Command::new("sh")
        .args(["-c", line])
        .arg(env!("CARGO_BIN_EXE_ballast"))
        .current_dir(folder)
        .output()
        .expect("there is a shell");
    let message = said(&output);
    assert_eq!(output.status.code(), Some(1), "{message}");
    assert!(message.contains("run.ballast holds cycle "), "{message}");
    assert!(!message.contains("start anew"), "{message}");
    let mut lines: Vec<&str> = message.lines().collect();
    let all = lines.len();
    lines.dedup();
    assert_eq!(lines.len(), all, "nothing is said twice: {message}");
    run(folder, "--resume run.ballast --csv run.csv");
}
