//! What cannot be started from, and what takes long.

use std::process::{Command, Stdio};

use super::super::interruption::{catches, kill, until};
use super::super::{names, said, text};
use super::{ballast, cached, put, write};

#[test]
fn what_does_not_go_together_is_told_with_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let all = "preset = \"sample.toml\"\nkeep = \"all\"\n";
    for (start, set, hints) in [
        (
            "from = \"none.ballast\"\n",
            "",
            &["p.toml:", "there is no such file", "--checkpoint"][..],
        ),
        (
            "from = \"sample.toml\"\n",
            "",
            &["this is no checkpoint", "p.toml:"],
        ),
        (
            "preset = \"nine-disc-compresion\"\n",
            "",
            &["did you mean `nine-disc-compression`"],
        ),
        (
            "preset = \"sample.toml\"\nstage = \"fal\"\n",
            "",
            &["did you mean `fall`", "p.toml:"],
        ),
        ("preset = \"p.toml\"\n", "", &["starts from itself"]),
        (
            all,
            "--set model.law=hertz-mindlin",
            &["model.law is another one", "keep = \"particles\""],
        ),
        (
            all,
            "--set material.grain.normal_stiffness=2e6",
            &["material.grain.normal_stiffness is another one"],
        ),
        (
            "preset = \"two-discs\"\n",
            "",
            &["material `disc`", "add [material.disc]"],
        ),
        (
            "preset = \"sample.toml\"\n",
            "--set history.columns=[\"particle:2:x\"]",
            &["there is no particle 2"],
        ),
        (
            "preset = \"sample.toml\"\n",
            "--set history.columns=[\"wall:roof:f1\"]",
            &["there is no wall `roof`"],
        ),
        (
            "preset = \"sample.toml\"\nset = [\"model.frak=1\"]\n",
            "",
            &["`frac`"],
        ),
    ] {
        write(folder, start);
        let output = ballast(folder, &format!("run p.toml {set} --csv x.csv"));
        let message = said(&output);
        assert_eq!(output.status.code(), Some(2), "{start}{set}: {message}");
        for hint in hints {
            assert!(
                message.contains(hint),
                "{start}{set}: no `{hint}` in {message}"
            );
        }
        assert!(!folder.join("x.csv").exists(), "{start}{set}");
    }
}

#[test]
fn bookings_go_on_only_from_a_run_that_has_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write(folder, "from = \"s.ballast\"\nkeep = \"all\"\n");
    let sample = "run sample.toml --cycles 50 --checkpoint s.ballast";
    let unbooked = "--set history.columns=[\"kinetic\"]";
    let made = ballast(folder, &format!("{sample} {unbooked}"));
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    let refused = ballast(folder, "run p.toml --csv x.csv");
    let message = said(&refused);
    assert_eq!(refused.status.code(), Some(2), "{message}");
    for hint in [
        "p.toml:",
        "asks for energy_error, friction_loss",
        "[history] columns of the run",
    ] {
        assert!(message.contains(hint), "no `{hint}` in {message}");
    }
    // Who asks for none may go on, and who has them, too.
    let on = ballast(folder, &format!("run p.toml --csv x.csv {unbooked}"));
    assert_eq!(on.status.code(), Some(0), "{}", said(&on));
    let made = ballast(folder, sample);
    assert_eq!(made.status.code(), Some(0), "{}", said(&made));
    let on = ballast(folder, "run p.toml --csv y.csv");
    assert_eq!(on.status.code(), Some(0), "{}", said(&on));
}

#[test]
fn a_sample_that_takes_long_holds_up_nobody() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write(folder, "preset = \"sample.toml\"\n");
    let sample = text(folder, "sample.toml").replace("3000", "30_000_000_000");
    put(folder, "sample.toml", &sample);
    let check = ballast(folder, "check p.toml");
    let told = String::from_utf8_lossy(&check.stdout).into_owned();
    assert_eq!(check.status.code(), Some(0), "{}", said(&check));
    for hint in [
        "the end of sample.toml",
        "prepared when it is first run",
        "history:",
    ] {
        assert!(told.contains(hint), "no `{hint}` in {told}");
    }
    // Ended on the way there is nothing to save, and nothing is left.
    let before = names(folder);
    for words in [&[][..], &["--seeds", "1..2"]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_ballast"))
            .args(["run", "p.toml", "--csv", "x.csv"])
            .args(words)
            .current_dir(folder)
            .env("XDG_CACHE_HOME", folder.join("cache"))
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let number = child.id();
        until(&mut child, || catches(number, 15));
        kill(&child, "TERM");
        let output = child.wait_with_output().expect("it ends");
        let message = said(&output);
        assert_eq!(output.status.code(), Some(143), "{message}");
        assert!(!message.contains("--resume"), "{message}");
        let hint = match words {
            [] => "ended while the sample",
            _ => "not begun: 1, 2",
        };
        assert!(message.contains(hint), "{message}");
        assert_eq!(names(folder), before);
    }
    assert!(cached(folder).is_empty());
}
