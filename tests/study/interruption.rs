//! A study that somebody ends before it is done.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use super::heeding::heeding_signals;
use super::program::said;

/// A study that is given two seconds.
#[track_caller]
fn interrupted(folder: &Path, line: &str) -> Output {
    let child = heeding_signals()
        .arg("study")
        .args(line.split(' '))
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts");
    let begun = Instant::now();
    std::thread::sleep(Duration::from_secs(2));
    let kill = format!("kill -INT {}", child.id());
    let done = Command::new("sh").args(["-c", &kill]).status();
    assert!(done.expect("there is a shell").success());
    let output = child.wait_with_output().expect("it ends");
    assert!(begun.elapsed() < Duration::from_secs(30));
    assert_eq!(output.status.code(), Some(130), "{}", said(&output));
    output
}

#[test]
fn an_interrupted_study_keeps_what_it_has() {
    let folder = tempfile::tempdir().expect("a folder");
    // The coarse variants take milliseconds, the finest an hour; the reference comes first.
    let line = "square-lattice --frac 0.00001,0.1,0.2 --reference 0.2 --for kinetic";
    let output = interrupted(folder.path(), line);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.contains("the run was not finished"), "{table}");
    let csv = fs::read_to_string(folder.path().join("square-lattice-study.csv"));
    let csv = csv.expect("the file is written");
    let row = csv.lines().nth(2).expect("three variants");
    assert!(
        row.starts_with("linear@0.1,") && row.contains(",stable,"),
        "{row}"
    );
    // Nobody knows how it would have gone on.
    let finest = csv.lines().find(|row| row.starts_with("linear@1e-5,"));
    assert!(
        finest.is_some_and(|row| row.contains(",not finished,")),
        "{csv}"
    );
    // Where a study is already, it stays.
    interrupted(folder.path(), line);
    let name = folder.path().join("square-lattice-study-partial.csv");
    assert_eq!(
        fs::read_to_string(name).expect("beside it").lines().count(),
        4
    );
    let kept = fs::read_to_string(folder.path().join("square-lattice-study.csv"));
    assert_eq!(kept.expect("it is still there"), csv);
}

#[test]
fn variants_that_were_not_run_take_one_line() {
    let folder = tempfile::tempdir().expect("a folder");
    // The first, which the others are compared with, takes hours.
    let line =
        "square-lattice --frac 0.00001,0.1,0.2,0.3 --reference 0.00001 --for kinetic,contacts";
    let output = interrupted(folder.path(), line);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(table.matches("not run").count(), 1, "{table}");
    assert!(table.contains("note: 3 of 4 variants not run"), "{table}");
    assert!(!table.contains("failed"), "{table}");
    let csv = fs::read_to_string(folder.path().join("square-lattice-study.csv"));
    let csv = csv.expect("the file is written");
    assert!(csv.contains(",not run,"), "{csv}");
}
