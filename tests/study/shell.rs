//! `ballast study` and what it says, as a user sees it.

use std::fs;
use std::path::Path;

use super::Bounce;
use super::program::{ballast, said};

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).expect("the folder is there");
    let names = entries.map(|entry| entry.expect("it can be read").file_name());
    let mut names: Vec<String> = names.map(|name| name.to_string_lossy().into()).collect();
    names.sort();
    names
}

fn words(line: &str) -> Vec<&str> {
    std::iter::once("study").chain(line.split(' ')).collect()
}

/// A folder with the bouncing disc in it.
fn folder() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    let text = Bounce::new().answered(12, 0.0);
    fs::write(folder.path().join("bounce.toml"), text).expect("it can be written");
    folder
}

#[test]
fn the_tables_are_data_and_the_files_are_written() {
    let folder = folder();
    let line = "bounce.toml --frac 0.2,0.1,0.05 --within 1e-2";
    let output = ballast(folder.path(), &words(line));
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let table = String::from_utf8(output.stdout.clone()).expect("it is text");
    for hint in [
        "particle-steps/s",
        "contact updates/s",
        "frac limit",
        "energy error",
        "*  on the Pareto front",
        "<  the fastest with an error within 0.01",
        "height = 0.9085",
        "closed form",
        "order",
        "2.00",
    ] {
        assert!(table.contains(hint), "no {hint} in\n{table}");
    }
    assert!(!table.contains('\u{1b}') && table.ends_with('\n'));
    let message = "wrote bounce-study.csv and bounce-study.svg\n";
    assert_eq!(said(&output), message);
    let files = ["bounce-study.csv", "bounce-study.svg", "bounce.toml"];
    assert_eq!(names(folder.path()), files);
    // Again, quietly, under another name; a full stop in it is no ending.
    let output = ballast(folder.path(), &words(&format!("{line} -q -o run-0.5")));
    assert_eq!(
        (output.status.code(), said(&output)),
        (Some(0), String::new())
    );
    assert!(names(folder.path()).contains(&"run-0.5.svg".to_owned()));
}

#[test]
fn a_bare_study_takes_what_the_preset_says() {
    let folder = tempfile::tempdir().expect("a folder");
    for name in ["two-discs", "square-lattice", "rolling-disc"] {
        let output = ballast(folder.path(), &["study", name, "-q"]);
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        let table = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(
            table.contains("frac limit") && table.contains("Pareto"),
            "{table}"
        );
    }
    let text = Bounce::new().answered(12, 0.0) + "[study]\nfrac = [0.4, 0.2]\nwithin = 0.03\n";
    fs::write(folder.path().join("own.toml"), text).expect("it can be written");
    let output = ballast(folder.path(), &["study", "own.toml", "-q"]);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    let rows = table
        .lines()
        .filter(|line| line.starts_with("linear"))
        .count();
    assert_eq!(rows, 2, "{table}");
    assert!(table.contains("within 0.03"), "{table}");
}

#[test]
fn keys_can_be_swept() {
    let folder = folder();
    let line = "bounce.toml --frac 0.1 --sweep damping.contact=0,0.1,0.2 --for last(kinetic)";
    let output = ballast(folder.path(), &words(line));
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    let head = table.lines().nth(2).expect("a head");
    let labels: Vec<&str> = head.split_whitespace().take(3).collect();
    assert_eq!(labels, ["law", "damping.contact", "frac"]);
    assert!(
        table.contains("against linear@0.1 damping.contact=0"),
        "{table}"
    );
}

#[test]
fn wrong_words_are_refused_with_near_ones_and_nothing_is_written() {
    let folder = folder();
    for (line, status, hints) in [
        ("bounce.toml --frac 0", 2, &["--frac", "above 0"][..]),
        ("bounce.toml --frac 0.1,x", 2, &["--frac"]),
        ("bounce.toml --law liner", 2, &["did you mean `linear`?"]),
        (
            "bounce.toml --for kinetc",
            2,
            &["--> --for:1:", "did you mean `kinetic`?"],
        ),
        ("bounce.toml --for last(kinetic", 2, &["last(kinetic"]),
        (
            "bounce.toml --for particle:2:y",
            2,
            &["there is no particle 2"],
        ),
        (
            "bounce.toml --sweep damping.contct=1",
            2,
            &["did you mean `contact`?"],
        ),
        ("bounce.toml --sweep damping.contact", 2, &["PATH=VALUE"]),
        (
            "bounce.toml --sweep model.frac=1",
            2,
            &["list its values in `frac`"],
        ),
        ("bounce.toml --reference fine@0", 2, &["names no run"]),
        (
            "bounce.toml --reference hertzian",
            2,
            &["there is no contact law"],
        ),
        ("bounce.toml --within 0", 2, &["--within", "above 0"]),
        (
            "bounce.toml --frac 0.4,9",
            2,
            &["frac = 9 does not fit", "12 cycles", "1.2"],
        ),
        (
            "bounce.toml --stability --frac 0.1",
            2,
            &["cannot be used with"],
        ),
        ("bounce.tom", 2, &["did you mean `bounce.toml`?"]),
        (
            "bounce.toml --set model.frc=1",
            2,
            &["did you mean `frac`?"],
        ),
        ("bounce.toml --frc 1", 2, &["--frac"]),
        ("bounce.toml -o no/where", 1, &["there is no folder `no`"]),
    ] {
        let output = ballast(folder.path(), &words(line));
        let message = said(&output);
        assert_eq!(output.status.code(), Some(status), "{line}: {message}");
        assert!(output.stdout.is_empty(), "{line}");
        for hint in hints {
            assert!(message.contains(hint), "{line}: no `{hint}` in {message}");
        }
    }
    assert_eq!(names(folder.path()), ["bounce.toml"]);
    // Without an end there is no study.
    let text = Bounce::preset(12, "");
    let endless = text.split("[[stage]]").next().expect("it has a beginning");
    fs::write(folder.path().join("endless.toml"), endless).expect("it can be written");
    let output = ballast(folder.path(), &words("endless.toml"));
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("no [[stage]]"), "{}", said(&output));
}

#[test]
fn the_limit_is_printed_beside_the_bound() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = ballast(folder.path(), &words("square-lattice --stability"));
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    let row = table.lines().last().expect("a row");
    let cells: Vec<&str> = row.split_whitespace().take(4).collect();
    let numbers: Vec<f64> = cells[1..]
        .iter()
        .map(|cell| cell.parse().expect("a number"))
        .collect();
    let [stable, unstable, bound] = numbers.as_slice() else {
        panic!("{table}");
    };
    assert!(
        bound < stable && stable < unstable && *unstable < 0.27,
        "{table}"
    );
    assert!(names(folder.path()).is_empty());
}

#[test]
fn a_reference_that_fails_fails_the_study() {
    let folder = tempfile::tempdir().expect("a folder");
    let line = "square-lattice --frac 0.2 --reference 3 --for kinetic -q";
    let output = ballast(folder.path(), &words(line));
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.contains("was not finished"), "{table}");
}
