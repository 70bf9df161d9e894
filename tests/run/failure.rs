//! Runs that cannot go on: exit status 1, what was recorded is kept, and the message says how to go
//! on.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::{assert_same, bytes, cycle_of, names, refused, run, said, text};

/// Runs a line of shell in which `$0` is the program.
fn shell(folder: &Path, line: &str) -> Output {
    Command::new("sh")
        .args(["-c", line])
        .arg(env!("CARGO_BIN_EXE_ballast"))
        .current_dir(folder)
        .output()
        .expect("there is a shell")
}

#[test]
fn a_reader_that_has_seen_enough_ends_the_run_quietly() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for words in [
        "run nine-disc-compression -q --csv -",
        // Rows so rare that the pipe is not full before the end.
        "run nine-disc-compression -q --csv - --set stage.rest.max_cycles=200000000 \
         --set history.every=10000",
        "presets",
        "columns",
        "completions bash",
        "verify two-discs rolling-disc",
    ] {
        let line = format!("{{ \"$0\" {words}; echo $? >status; }} | head -1");
        let output = shell(folder, &line);
        assert_eq!(said(&output), "", "{words}");
        assert_eq!(text(folder, "status"), "0\n", "{words}");
        assert_eq!(String::from_utf8_lossy(&output.stdout).lines().count(), 1);
    }
    assert_eq!(names(folder), ["status"]);
}

#[test]
fn a_full_disk_is_said() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for words in [
        "run nine-disc-compression --csv - >/dev/full",
        "run nine-disc-compression --csv /dev/full --checkpoint c",
        "presets >/dev/full",
        "show two-discs >/dev/full",
        "laws >/dev/full",
        "check two-discs >/dev/full",
        "verify two-discs >/dev/full",
        "man >/dev/full",
    ] {
        let output = shell(folder, &format!("\"$0\" {words}"));
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{words}: {said}");
        assert!(said.contains("the disk is full"), "{words}: {said}");
    }
}

#[test]
fn rows_that_fitted_are_kept_whole_and_the_checkpoint_holds_the_others() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    // Blocks of 512 or 1024 bytes; the whole history takes 1.7 MB.
    for limit in [200, 333, 1000] {
        let line = format!("ulimit -f {limit}; \"$0\" run nine-disc-compression --csv part.csv");
        let output = shell(folder, &line);
        let said = said(&output);
        assert_eq!(output.status.code(), Some(1), "{said}");
        for hint in [
            "part.csv cannot be written",
            "largest size of a file",
            "--resume part.ballast",
        ] {
            assert!(said.contains(hint), "no `{hint}` in {said}");
        }
        let whole = run(folder, "nine-disc-compression --csv -").stdout;
        let part = bytes(folder, "part.csv");
        assert!(
            whole.starts_with(&part) && part.ends_with(b"\n"),
            "whole rows"
        );
        assert!(
            part.len() > limit * 400,
            "as many as fitted: {}",
            part.len()
        );
        run(folder, "--resume part.ballast --csv part.csv");
        assert_same(&bytes(folder, "part.csv"), &whole, "after making room");
    }
    // Not even the header fits.
    let line = "ulimit -f 0; \"$0\" run nine-disc-compression --csv none.csv";
    assert_eq!(shell(folder, line).status.code(), Some(1));
}

/// The stage that fails begins at cycle 2540. States are kept by the clock too: on a busy machine it may
/// be a later one.
#[track_caller]
fn holds_a_state_of_the_stage(message: &str, file: &str) {
    let (_, cycle) = message
        .split_once(&format!("{file} holds cycle "))
        .expect("a state was kept");
    let cycle = cycle.split(',').next().expect("a number");
    let cycle: u64 = cycle.parse().expect("a number");
    assert!((2540..2600).contains(&cycle), "{message}");
}

#[test]
fn a_run_that_flies_apart_names_cycle_and_particle() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let words = "nine-disc-compression --set model.frac=5 --csv wild.csv";
    let message = refused(folder, words, 1, &["cycle 3", "particle 1", "reduce frac"]);
    assert!(message.contains("wild.ballast holds cycle 0"), "{message}");
    let rows = text(folder, "wild.csv");
    let cycles: Vec<u64> = rows.lines().skip(1).map(cycle_of).collect();
    assert_eq!(cycles, [0, 1, 2]);

    // In a later stage there is a state to go back to.
    let words = "nine-disc-compression --set stage.rub.do.0=\"frac\\u00205\" --csv late.csv";
    let message = refused(folder, words, 1, &["particle"]);
    holds_a_state_of_the_stage(&message, "late.ballast");
    let late = bytes(folder, "late.csv");
    assert!(text(folder, "late.csv").lines().last().map(cycle_of) > Some(2540));
    refused(
        folder,
        "--resume late.ballast --csv late.csv",
        1,
        &["particle"],
    );
    assert_same(&bytes(folder, "late.csv"), &late, "it fails alike");

    // Without a history the state is kept here.
    let words = "nine-disc-compression --set stage.rub.do.0=\"frac\\u00205\"";
    let message = refused(folder, words, 1, &["particle"]);
    holds_a_state_of_the_stage(&message, "nine-disc-compression.ballast");
    assert!(names(folder).contains(&"nine-disc-compression.journal".to_owned()));
}

#[test]
fn a_stage_whose_command_is_refused_by_then_fails() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = include_str!("../../presets/two-discs.toml");
    // The new disc would lie in another one, which only the run can know.
    let stage =
        "\n[[stage]]\nname = \"late\"\ndo = [\"create at 1 0 radius 0.5\"]\nmax_cycles = 5\n";
    fs::write(folder.join("late.toml"), format!("{preset}{stage}")).expect("it can be written");
    let hints = ["stage late", "create", "overlap particle 2"];
    refused(folder, "late.toml --csv late.csv", 1, &hints);
    assert_eq!(
        text(folder, "late.csv").lines().last().map(cycle_of),
        Some(2)
    );
}

#[test]
fn paths_that_cannot_be_written_are_said_before_the_first_cycle() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::create_dir(folder.join("inner")).expect("it can be made");
    fs::write(folder.join("file"), "text").expect("it can be written");
    for (words, hint) in [
        ("--csv none/x.csv", "there is no folder `none`"),
        ("--csv inner", "it is a folder"),
        ("--csv file/x.csv", "is a file, not a folder"),
        (
            "--csv ok.csv --checkpoint none/x",
            "there is no folder `none`",
        ),
        ("--checkpoint inner", "it is a folder"),
    ] {
        let words = format!("nine-disc-compression {words}");
        refused(folder, &words, 1, &[hint, "give"]);
    }
    let made = names(folder);
    assert!(
        !made.iter().any(|name| name.ends_with(".ballast")),
        "{made:?}"
    );
    assert_eq!(text(folder, "file"), "text");
}
