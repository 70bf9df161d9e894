//! The workbench in a real terminal: started, typed to, resized, stopped, hung up.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

#[path = "terminal/keeping.rs"]
mod keeping;
#[path = "terminal/pty.rs"]
mod pty;

use std::process::Command;
use std::time::Duration;

use ballast::engine::Isa;
use pty::{LEAVES, Pty};
use rustix::process::Signal;

fn ballast(arguments: &[&str]) -> std::process::Output {
    Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(arguments)
        .output()
        .unwrap()
}

#[test]
fn a_newcomer_watches_pauses_changes_exports_and_finds_the_history_again() {
    let mut pty = Pty::start(
        120,
        40,
        &[
            "disc-pile",
            "--set",
            "history.columns=[\"state_hash\", \"coordination\", \"unbalanced\"]",
            "--set",
            "history.every=500",
        ],
    );
    pty.reaches(1000);
    pty.keys(" ");
    pty.shows("PAUSED");
    pty.keys(":fric");
    pty.keys("\t");
    pty.shows("friction X");
    pty.keys("0.5\r");
    pty.shows("friction 0.5 everywhere");
    pty.keys("nonsense\r");
    pty.shows("`nonsense` is no command");
    pty.leave_prompt();
    pty.keys("|");
    pty.keys(" ");
    pty.shows("DONE");
    // On by hand, beyond the stages: the journal has to tell how far.
    let last = pty.cycle().unwrap();
    pty.keys(" ");
    pty.reaches(last + 1);
    pty.keys(" ");
    pty.shows("DONE");
    pty.keys(":export csv pile.csv\r");
    pty.shows("rows in pile.csv");
    pty.leave_prompt();
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 0);
    assert!(pty.sent(LEAVES), "the terminal is given back");
    assert!(pty.screen().contains("journal"), "{}", pty.screen());

    let csv = pty.home.path().join("pile.csv");
    let exported = std::fs::read_to_string(csv).unwrap();
    assert!(exported.lines().count() > 30, "{exported}");
    let journal = pty.kept("journal");
    assert!(
        std::fs::read_to_string(&journal)
            .unwrap()
            .contains("friction 0.5")
    );
    // The workbench chose instructions and threads itself; whatever a replay takes, the bits are the same.
    let here = Isa::ALL.iter().filter(|isa| isa.is_here());
    for (isa, threads) in here.zip(["3", "1", "2"]) {
        let isa = isa.to_string();
        let run = ["run", journal.to_str().unwrap(), "--csv", "-", "-q"];
        let words = [&run[..], &["--isa", &isa, "--threads", threads]].concat();
        let again = ballast(&words);
        assert!(
            again.status.success(),
            "{isa}: {}",
            String::from_utf8_lossy(&again.stderr)
        );
        let again = String::from_utf8_lossy(&again.stdout).into_owned();
        // The replay ends with the row of the run's end, which an export before it lacks.
        assert!(
            again.starts_with(&exported),
            "the journal repeats the history bit for bit with {isa}"
        );
    }
}

#[test]
fn after_a_fault_it_goes_back_and_on() {
    let set = "history.columns=[\"state_hash\", \"kinetic\"]";
    let mut pty = Pty::start(120, 40, &["disc-pile", "--pace", "0", "--set", set]);
    pty.shows("DONE");
    pty.keys(":frac 20\r");
    pty.shows("dt =");
    pty.keys("cycle 5000\r");
    pty.shows("FAILED");
    pty.keys("friction 0.1\r");
    pty.shows("restore an earlier state");
    let kept = pty.kept("ballast");
    pty.keys(&format!("restore {}\r", kept.display()));
    pty.shows("back at cycle");
    pty.shows("PAUSED");
    let back = pty.cycle().unwrap();
    pty.keys("cycle 700\r");
    pty.reaches(back + 700);
    pty.keys("export csv pile.csv\r");
    pty.shows("rows in pile.csv");
    pty.leave_prompt();
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 0);

    // What was gone back to has been overwritten since; the replay goes back to it nevertheless.
    let exported = std::fs::read_to_string(pty.home.path().join("pile.csv")).unwrap();
    let journal = pty.kept("journal");
    let again = pty.home.path().join("again.csv");
    let [journal, csv] = [&journal, &again].map(|path| path.to_str().unwrap());
    let output = ballast(&["run", journal, "--csv", csv, "-q"]);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{said}");
    assert!(said.contains("the journal tells how it went on"), "{said}");
    let again = std::fs::read_to_string(again).unwrap();
    assert!(again.starts_with(&exported), "bit for bit");
}

#[test]
fn every_size_is_survived() {
    let mut pty = Pty::start(120, 40, &["disc-pile"]);
    pty.shows("RUN");
    for (columns, rows) in [
        (80, 24),
        (40, 12),
        (20, 5),
        (7, 2),
        (1, 1),
        (200, 60),
        (3, 60),
        (200, 2),
        (100, 30),
    ] {
        // Time to draw each of them: less means only that some were skipped.
        pty.resize(columns, rows);
        std::thread::sleep(Duration::from_millis(150));
        pty.keys("z");
        std::thread::sleep(Duration::from_millis(50));
        pty.keys("z");
        std::thread::sleep(Duration::from_millis(50));
    }
    pty.shows("cycle");
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 0);
}

#[test]
fn signals_give_the_terminal_back_and_keep_the_run() {
    for (signal, status) in [(Signal::TERM, 143), (Signal::HUP, 129), (Signal::QUIT, 131)] {
        let mut pty = Pty::start(100, 30, &["disc-pile"]);
        pty.reaches(1000);
        pty.signal(signal);
        assert_eq!(pty.end(), status);
        assert!(pty.sent(LEAVES));
        let checkpoint = pty.kept("ballast");
        let resumed = ballast(&[
            "run",
            "--resume",
            checkpoint.to_str().unwrap(),
            "--cycles",
            "3000",
            "-q",
        ]);
        assert!(
            resumed.status.success(),
            "{}",
            String::from_utf8_lossy(&resumed.stderr)
        );
    }
}

#[test]
fn a_terminal_that_goes_away_ends_it() {
    let mut pty = Pty::start(100, 30, &["disc-pile"]);
    pty.reaches(1000);
    pty.hang_up();
    pty.end();
    let checkpoint = pty.kept("ballast");
    assert!(checkpoint.exists());
    let resumed = ballast(&[
        "run",
        "--resume",
        checkpoint.to_str().unwrap(),
        "--cycles",
        "100",
        "-q",
    ]);
    assert!(
        resumed.status.success(),
        "{}",
        String::from_utf8_lossy(&resumed.stderr)
    );
}

#[test]
fn it_can_be_suspended_and_continued() {
    let mut pty = Pty::start(100, 30, &["disc-pile"]);
    pty.shows("RUN");
    pty.signal(Signal::TSTP);
    pty.until("a stop", |pty| pty.process_state() == 'T');
    pty.until("the shell's screen", |pty| pty.sent(LEAVES));
    let before = pty.bytes();
    pty.signal(Signal::CONT);
    pty.until("a new picture", |pty| pty.bytes() >= before + 500);
    pty.shows("cycle");
    pty.keys(":q!\r");
    assert_eq!(pty.end(), 0);
}

#[test]
fn a_panic_in_the_engine_leaves_a_clean_terminal_and_a_journal() {
    let mut pty = Pty::start(100, 30, &["disc-pile", "--panic-at", "1500", "--pace", "0"]);
    assert_eq!(pty.end(), 1);
    assert!(pty.sent(LEAVES));
    assert!(
        pty.screen().contains("asked to panic here"),
        "{}",
        pty.screen()
    );
    let journal = std::fs::read_to_string(pty.kept("journal")).unwrap();
    assert!(journal.contains("stage stand"), "{journal}");
}

#[test]
fn a_panic_in_a_command_does_so_too() {
    let mut pty = Pty::start(100, 30, &["disc-pile", "--panic-at", "0", "--paused"]);
    pty.shows("PAUSED");
    pty.keys(":friction 0.2\r");
    assert_eq!(pty.end(), 1);
    assert!(pty.sent(LEAVES));
    let screen = pty.screen();
    assert!(screen.contains("asked to panic here"), "{screen}");
    assert!(pty.kept("journal").exists());
}

#[test]
fn idle_means_idle() {
    let mut pty = Pty::start(120, 40, &["disc-pile", "--paused"]);
    pty.shows("PAUSED");
    pty.settles();
    let (bytes, time) = (pty.bytes(), pty.processor_time());
    std::thread::sleep(Duration::from_secs(2));
    assert!(
        pty.bytes() - bytes < 200,
        "{} bytes in two seconds of nothing",
        pty.bytes() - bytes
    );
    // Clock ticks are 10 ms; a spinning thread would use 2 s.
    assert!(pty.processor_time() - time < 0.3);
    pty.keys("q");
    assert_eq!(pty.end(), 0);
}

#[test]
fn without_a_terminal_it_says_what_to_do() {
    let output = ballast(&["disc-pile"]);
    assert_eq!(output.status.code(), Some(2));
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(
        text.contains("ballast run disc-pile") && text.contains("--plain"),
        "{text}"
    );
}
