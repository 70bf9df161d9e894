//! Signals: everything is saved, the message says how to go on, and going on gives the same bytes.

use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant, SystemTime};

use super::heeding::heeding_signals;
use super::{assert_same, bytes, names, run, said, scenes, text};

/// Longest wait for anything. It only ends a test that hangs: the machine may be very busy.
const PATIENCE: Duration = Duration::from_secs(300);

/// Starts `ballast run` in the background.
fn start(folder: &Path, words: &[&str]) -> Child {
    heeding_signals()
        .arg("run")
        .args(scenes::LONG.split_whitespace())
        .args(words)
        .current_dir(folder)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the program starts")
}

/// Waits until something is so, or the child has ended.
pub(super) fn until(child: &mut Child, is_so: impl Fn() -> bool) {
    let begun = Instant::now();
    while !is_so() && child.try_wait().expect("it can be asked").is_none() {
        assert!(begun.elapsed() < PATIENCE, "it never begins");
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Starts the long run, sends a signal at some moment after the file has appeared, and waits for the
/// end. A run that came to its own end before, on a busy machine, is begun anew.
fn interrupted(folder: &Path, words: &[&str], signal: &str, file: &str) -> Output {
    for _ in 0..100 {
        drop(fs::remove_file(folder.join(file)));
        let mut child = start(folder, words);
        until(&mut child, || folder.join(file).exists());
        // Any moment of the run will do, and another in every run of the test.
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        let moment = now.expect("the clock is right").subsec_micros() % 250;
        std::thread::sleep(Duration::from_millis(u64::from(moment)));
        kill(&child, signal);
        let output = child.wait_with_output().expect("it ends");
        if !output.status.success() {
            return output;
        }
    }
    panic!("a hundred runs ended before the signal came");
}

/// Whether a process catches a signal.
pub(super) fn catches(process: u32, signal: u32) -> bool {
    let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask & (1 << (signal - 1)) != 0)
}

pub(super) fn kill(child: &Child, signal: &str) {
    let line = format!("kill -{signal} {}", child.id());
    let done = Command::new("sh").args(["-c", &line]).status();
    assert!(done.expect("there is a shell").success());
}

/// Runs the command that a message ends with, as its reader would.
#[track_caller]
fn obey(folder: &Path, message: &str, more: &str) -> Output {
    let line = message.lines().last().expect("there is a message");
    let words = line.strip_prefix("  ballast ").expect("a command to go on");
    let output = Command::new("sh")
        .args(["-c", &format!("\"$0\" {words} {more}")])
        .arg(env!("CARGO_BIN_EXE_ballast"))
        .current_dir(folder)
        .output()
        .expect("there is a shell");
    assert_eq!(output.status.code(), Some(0), "{line}: {}", said(&output));
    output
}

#[test]
fn each_signal_is_answered_with_everything_saved() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, &format!("{} --csv whole.csv", scenes::LONG));
    for (signal, status) in [("INT", 130), ("TERM", 143), ("HUP", 129), ("QUIT", 131)] {
        let csv = format!("{signal}.csv");
        let output = interrupted(folder, &["--csv", &csv], signal, &csv);
        let message = said(&output);
        assert_eq!(output.status.code(), Some(status), "{message}");
        assert!(output.stdout.is_empty());
        for hint in ["everything is saved", "--resume", &format!("SIG{signal}")] {
            assert!(message.contains(hint), "no `{hint}` in {message}");
        }
        assert!(text(folder, &csv).ends_with('\n'));
        assert!(bytes(folder, &csv).len() < bytes(folder, "whole.csv").len());
        obey(folder, &message, "");
        assert_same(&bytes(folder, &csv), &bytes(folder, "whole.csv"), signal);
    }
}

#[test]
fn without_a_history_state_and_journal_go_to_the_current_folder() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    // A checkpoint shows that it has begun, wherever it goes.
    let mark = folder.join("mark");
    let output = interrupted(folder, &["--checkpoint", "mark"], "TERM", "mark");
    assert_eq!(output.status.code(), Some(143), "{}", said(&output));
    assert!(mark.exists());
    assert_eq!(names(folder), ["mark", "nine-disc-compression.journal"]);
    fs::remove_file(mark).expect("it is there");

    let mut child = start(folder, &[]);
    let number = child.id();
    until(&mut child, || catches(number, 2));
    kill(&child, "INT");
    let output = child.wait_with_output().expect("it ends");
    let message = said(&output);
    assert_eq!(output.status.code(), Some(130), "{message}");
    let files = [
        "nine-disc-compression.ballast",
        "nine-disc-compression.journal",
    ];
    assert_eq!(names(folder), files);
    let rest = obey(folder, &message, "--csv end.csv");
    assert!(rest.stdout.is_empty());
    run(folder, &format!("{} --csv whole.csv", scenes::LONG));
    assert_same(
        &bytes(folder, "end.csv"),
        &bytes(folder, "whole.csv"),
        "a history asked for afterwards",
    );
}

#[test]
fn rows_on_standard_output_go_on_where_they_stopped() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let words = ["--csv", "-", "--checkpoint", "mark", "--threads", "2"];
    let output = interrupted(folder, &words, "TERM", "mark");
    let message = said(&output);
    assert_eq!(output.status.code(), Some(143), "{message}");
    assert!(
        message.contains("--csv - --checkpoint mark --threads 2"),
        "{message}"
    );
    let rest = obey(folder, &message, "");
    let mut both = output.stdout;
    let header = both
        .iter()
        .position(|byte| *byte == b'\n')
        .expect("a header")
        + 1;
    assert_eq!(both[..header], rest.stdout[..header]);
    both.extend_from_slice(&rest.stdout[header..]);
    let whole = run(folder, &format!("{} --csv -", scenes::LONG)).stdout;
    assert_same(&both, &whole, "the two parts");
}

#[test]
fn a_killed_process_leaves_whole_rows_a_journal_and_a_checkpoint() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, &format!("{} --csv whole.csv", scenes::LONG));
    let whole = text(folder, "whole.csv");
    let words = ["--csv", "part.csv", "--every", "0.05"];
    let output = interrupted(folder, &words, "KILL", "part.csv");
    assert_eq!(output.status.code(), None, "{}", said(&output));

    let part = text(folder, "part.csv");
    assert!(
        part.ends_with('\n') && whole.starts_with(&part),
        "whole rows"
    );
    let again = run(folder, "part.journal --csv -");
    assert_same(&again.stdout, whole.as_bytes(), "the journal");
    run(folder, "--resume part.ballast --csv part.csv");
    assert_same(
        &bytes(folder, "part.csv"),
        whole.as_bytes(),
        "the checkpoint",
    );
    // A checkpoint that was being written may leave its part, but never under its own name.
    let files = ["part.ballast", "part.csv", "part.journal"];
    let left: Vec<String> = names(folder)
        .into_iter()
        .filter(|name| !name.starts_with("whole"))
        .collect();
    assert!(
        left.iter()
            .all(|name| files.contains(&name.as_str()) || name.starts_with(".part.ballast."))
    );
}

#[test]
fn names_with_blanks_come_back_quoted() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let inner = folder.join("my runs");
    fs::create_dir(&inner).expect("it can be made");
    let csv = "my runs/it's.csv";
    let output = interrupted(folder, &["--csv", csv], "INT", csv);
    obey(folder, &said(&output), "");
    run(folder, &format!("{} --csv whole.csv", scenes::LONG));
    assert_same(
        &bytes(&inner, "it's.csv"),
        &bytes(folder, "whole.csv"),
        "blanks and quotes",
    );
}

#[test]
fn an_interrupted_ensemble_saves_every_run_and_counts_none() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(
        folder,
        &format!("{} --seed 1 --csv whole.csv", scenes::LONG),
    );
    let words = ["--seeds", "1..3", "--threads", "2", "--csv", "x.csv"];
    let output = interrupted(folder, &words, "TERM", "x-seed1.csv");
    let message = said(&output);
    assert_eq!(output.status.code(), Some(143), "{message}");
    for hint in [
        "seed 1: SIGTERM",
        "seed 2: SIGTERM",
        "0 of 3 runs counted",
        "stopped: 1, 2",
        "not begun: 3",
    ] {
        assert!(message.contains(hint), "no `{hint}` in {message}");
    }
    assert!(!folder.join("x.csv").exists(), "no means of nothing");
    assert!(!message.contains("nothing in this preset is random"));
    let line = message
        .lines()
        .find(|line| line.contains("x-seed1.ballast"));
    obey(folder, line.expect("it says how to go on"), "");
    let (a, b) = (bytes(folder, "x-seed1.csv"), bytes(folder, "whole.csv"));
    assert_same(&a, &b, "seed 1 goes on");
}
