//! What the program once did with its words and files.

use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use crate::program::{ballast, said};
use crate::{DISC, HEAD, PRESSED};

/// A file that each test has to itself, and what the program says of it.
fn preset(tables: &str) -> (tempfile::TempDir, String) {
    let folder = tempfile::tempdir().expect("a folder");
    let text = format!("{HEAD}{tables}");
    fs::write(folder.path().join("p.toml"), &text).expect("it can be written");
    (folder, text)
}

/// Stiffnesses of pairs belong to what contacts remember.
#[test]
fn a_state_does_not_go_on_under_other_stiffnesses_of_a_pair() {
    let pair = |k: &str| format!("[[pair]]\nmaterials = [\"m\", \"m\"]\nnormal_stiffness = {k}\n");
    let (folder, _) = preset(&format!("{}{DISC}", pair("1e6")));
    let folder = folder.path();
    let made = ballast(
        folder,
        &[
            "run",
            "p.toml",
            "--cycles",
            "1",
            "--checkpoint",
            "a.ballast",
        ],
    );
    assert!(made.status.success(), "{}", said(&made));
    let next = |k: &str| {
        let start = "[start]\nfrom = \"a.ballast\"\nkeep = \"all\"\n";
        fs::write(folder.join("n.toml"), format!("{HEAD}{}{start}", pair(k)))
            .expect("it is written");
        ballast(folder, &["run", "n.toml", "--cycles", "1"])
    };
    let same = next("1e6");
    assert!(same.status.success(), "{}", said(&same));
    let other = next("5e6");
    assert_eq!(other.status.code(), Some(2), "{}", said(&other));
    let why = "normal_stiffness of the [[pair]] m, m is another one";
    assert!(said(&other).contains(why), "{}", said(&other));
}

/// `check` compares the step that is used, which is not that of `frac` where it follows the bound.
#[test]
fn check_does_not_warn_of_a_step_that_follows_the_bound() {
    let two = PRESSED;
    let (folder, text) = preset(two);
    let folder = folder.path();
    let warns = |frac: &str| {
        let text = text.replace("frac = 0.1", &format!("frac = {frac}\ntime_step = 1e-2"));
        fs::write(folder.join("q.toml"), text).expect("it can be written");
        let check = ballast(folder, &["check", "q.toml"]);
        String::from_utf8_lossy(&check.stdout).contains("is above the limit")
    };
    assert!(warns("1.0"));
    assert!(!warns("\"auto\""));
}

/// `step` shows every boundary, `cycle` where it ends.
#[test]
fn step_shows_every_cycle() {
    let (folder, _) = preset(DISC);
    let shown = |line: &str| typed(folder.path(), line).matches("cycle ").count();
    assert_eq!(shown("step 7") - shown("cycle 7"), 6);
}

/// What a teletype session prints.
fn typed(folder: &Path, lines: &str) -> String {
    let file = folder.join("lines");
    fs::write(&file, format!("{lines}\nquit!\n")).expect("it can be written");
    let output = Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(["p.toml", "--plain"])
        .current_dir(folder)
        .env("XDG_STATE_HOME", folder)
        .stdin(fs::File::open(file).expect("it is there"))
        .stderr(Stdio::null())
        .output()
        .expect("the program starts");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn commands_do_not_overwrite_presets() {
    let (folder, text) = preset(DISC);
    let folder = folder.path();
    fs::write(folder.join("other.toml"), "x").expect("it can be written");
    for line in ["export csv p.toml", "save ./p.toml", "journal other.toml"] {
        let printed = typed(folder, line);
        assert!(
            printed.contains("is a preset and would be overwritten"),
            "{printed}"
        );
    }
    let left = |name: &str| fs::read_to_string(folder.join(name)).expect("it is there");
    assert_eq!([left("p.toml"), left("other.toml")], [text, "x".to_owned()]);
    // A new name is nobody's.
    assert!(typed(folder, "export csv new.toml").contains("rows in new.toml"));
}

/// Two runs that write one file would mix their rows.
#[test]
fn a_file_that_is_being_written_is_left_alone() {
    let (folder, _) = preset(DISC);
    let folder = folder.path();
    let mut first = Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args([
            "run",
            "p.toml",
            "--csv",
            "a.csv",
            "--cycles",
            "1000000000000",
        ])
        .current_dir(folder)
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    while !folder.join("a.ballast").exists() {
        assert!(first.try_wait().expect("it can be asked").is_none());
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let second = ballast(
        folder,
        &["run", "p.toml", "--csv", "a.csv", "--cycles", "5"],
    );
    let resumed = ballast(
        folder,
        &[
            "run",
            "--resume",
            "a.ballast",
            "--csv",
            "a.csv",
            "--cycles",
            "9",
        ],
    );
    first.kill().expect("it runs");
    first.wait().expect("it ends");
    for output in [second, resumed] {
        assert!(!output.status.success());
        assert!(
            said(&output).contains("another run is writing it"),
            "{}",
            said(&output)
        );
    }
    let third = ballast(
        folder,
        &["run", "p.toml", "--csv", "a.csv", "--cycles", "5"],
    );
    assert!(third.status.success(), "{}", said(&third));
}

#[test]
fn endless_lines_are_no_tables_and_no_commands() {
    let (folder, _) = preset(DISC);
    let plot = ballast(
        folder.path(),
        &["plot", "/dev/zero", "--y", "a", "-o", "x.svg"],
    );
    assert_eq!(plot.status.code(), Some(2), "{}", said(&plot));
    assert!(
        said(&plot).contains("is longer than 16 MiB"),
        "{}",
        said(&plot)
    );
    let printed = typed(folder.path(), "source /dev/zero");
    assert!(printed.contains("is larger than 16 MiB"), "{printed}");
}

#[test]
fn what_a_stage_ends_with_is_said() {
    let stages = "[[stage]]\nname = \"none\"\nuntil = \"cycle < 5\"\n\
         [[stage]]\nname = \"some\"\nmax_cycles = 3\n";
    let stiff = format!("{PRESSED}{stages}");
    let (folder, text) = preset(&stiff);
    let ran = ballast(folder.path(), &["run", "p.toml"]);
    let printed = said(&ran);
    assert!(printed.contains("stage none ended at once"), "{printed}");
    assert!(!printed.contains("stage some ended at once"), "{printed}");
    assert!(!printed.contains("frac_limit"), "{printed}");
    assert!(!printed.contains("overlap"), "{printed}");
    assert!(!printed.contains("strains"), "{printed}");
    // The overlap of .004 m is .02 of the diameter.
    let deep = text.replace(
        "frac = 0.1",
        "frac = 0.1\n[damping]\noverlap_critical = 0.019",
    );
    fs::write(folder.path().join("p.toml"), deep).expect("it can be written");
    let printed = said(&ballast(folder.path(), &["run", "p.toml"]));
    assert!(
        printed.contains("at the end of stage some 2 of the contacts overlap by more than 1.9 %"),
        "{printed}"
    );
    let text = text.replace("frac = 0.1", "frac = 0.9");
    fs::write(folder.path().join("p.toml"), text).expect("it can be written");
    let printed = said(&ballast(folder.path(), &["run", "p.toml"]));
    assert!(
        printed.contains("at the end of stage some frac = 0.9 is above frac_limit"),
        "{printed}"
    );
}

/// Before there is anything to save a signal ends a run as it would end any program.
#[test]
fn a_run_that_still_reads_can_be_ended() {
    let (folder, _) = preset("[[generate]]\nmaterial = \"m\"\nimport = \"fifo\"\n");
    let folder = folder.path();
    let made = Command::new("mkfifo").arg(folder.join("fifo")).status();
    assert!(made.expect("there is a shell").success());
    let mut reading = Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(["run", "p.toml"])
        .current_dir(folder)
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    std::thread::sleep(std::time::Duration::from_millis(300));
    assert!(reading.try_wait().expect("it can be asked").is_none());
    let kill = Command::new("kill").arg(reading.id().to_string()).status();
    assert!(kill.expect("there is a shell").success());
    let begun = std::time::Instant::now();
    while reading.try_wait().expect("it can be asked").is_none() {
        if begun.elapsed().as_secs() > 20 {
            reading.kill().expect("it runs");
            panic!("it does not end");
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
}

#[test]
fn definitions_come_in_any_order() {
    let defined = |define: &str| {
        let tables = "[history]\ncolumns = [\"a\", \"b\"]\n[history.define]\n";
        let (folder, _) = preset(&format!("{DISC}{tables}{define}"));
        let ran = ballast(
            folder.path(),
            &["run", "p.toml", "--cycles", "2", "--csv", "-"],
        );
        assert!(ran.status.success(), "{}", said(&ran));
        String::from_utf8_lossy(&ran.stdout).into_owned()
    };
    let (first, second) = ("a = \"dt * 2\"\n", "b = \"a + 1\"\n");
    let rows = defined(&format!("{first}{second}"));
    assert_eq!(rows, defined(&format!("{second}{first}")));
    assert!(rows.starts_with("cycle,time,stage,a,b"), "{rows}");
}

/// An import may begin with remarks and blank lines, and quote its header.
#[test]
fn imports_have_headers_of_every_kind() {
    for header in [
        "x,y,radius,material",
        "# a remark\n\n\"x\",\"y\",\"radius\",\"material\"",
    ] {
        let (folder, _) = preset("[[generate]]\nimport = \"t.csv\"\n");
        fs::write(
            folder.path().join("t.csv"),
            format!("{header}\n0,0,0.1,m\n"),
        )
        .expect("it is written");
        let check = ballast(folder.path(), &["check", "p.toml"]);
        assert!(check.status.success(), "{header}: {}", said(&check));
    }
}
