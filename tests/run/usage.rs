//! Options: what is refused, how far a run goes, and which files it may not touch.

use std::fs;

use super::{assert_same, bytes, cycle_of, names, refused, run, said, text};

#[test]
fn wrong_usage_exits_2_and_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for (words, hint) in [
        ("", "--resume"),
        ("nine-disc-compression --threads 0", "1..=64"),
        ("nine-disc-compression --threads 65", "1..=64"),
        ("nine-disc-compression --threads -1", "1..=64"),
        ("nine-disc-compression --threads two", "invalid digit"),
        ("nine-disc-compression --every 0", "above 0"),
        ("nine-disc-compression --every -1", "above 0"),
        ("nine-disc-compression --every nan", "above 0"),
        ("nine-disc-compression --every soon", "above 0"),
        ("nine-disc-compression --cycles -5", "--cycles"),
        (
            "nine-disc-compression --cycles 1.5",
            "whole number of cycles",
        ),
        ("nine-disc-compression --every inf", "above 0"),
        ("nine-disc-compression --set frac=0.1", "`model.frac`"),
        ("nine-disc-compression --seed x", "--seed"),
        ("nine-disc-compression --checkpont x", "--checkpoint"),
        ("nine-disc-compression --csv", "--csv"),
        ("nine-disc-compression two-discs", "two-discs"),
        ("nine-disc-compresion --csv x.csv", "nine-disc-compression"),
        ("nothing.toml --csv x.csv", "there is no preset"),
        (". --csv x.csv", "is a folder"),
    ] {
        refused(folder, words, 2, &[hint]);
    }
    assert!(names(folder).is_empty());
}

#[test]
fn a_run_ends_at_the_cycle_it_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = "nine-disc-compression --set history.every=7";
    let whole = String::from_utf8(run(folder, &format!("{preset} --csv -")).stdout);
    let whole = whole.expect("it is text");
    let exponent = run(folder, &format!("{preset} --csv - --cycles 4.1e1"));
    let plain = run(folder, &format!("{preset} --csv - --cycles 41"));
    assert_same(&exponent.stdout, &plain.stdout, "4.1e1 is 41");
    for cycles in [0, 1, 7, 39, 40, 41, 1040, 2000, 4940, 4941, 1_000_000] {
        let rows = run(folder, &format!("{preset} --csv - --cycles {cycles}")).stdout;
        let rows = String::from_utf8(rows).expect("it is text");
        let last = rows.lines().last().expect("there are rows");
        assert_eq!(cycle_of(last), cycles.min(4940));
        // All but the last row, which ends the run, are rows of the whole.
        let before = &rows[..rows.len() - last.len() - 1];
        assert!(whole.starts_with(before), "{cycles}");
        let unlike = !whole.contains(&format!("\n{last}\n"));
        let due = cycles % 7 == 0 || [40, 1040, 4940].contains(&cycles.min(4940));
        assert_eq!(unlike && cycles > 0, !due && cycles > 0, "{cycles}: {last}");
    }
}

#[test]
fn standard_output_holds_rows_only() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    assert!(run(folder, "two-discs").stdout.is_empty());
    assert!(run(folder, "two-discs --csv x.csv").stdout.is_empty());
    let output = run(folder, "two-discs --csv -");
    let rows = String::from_utf8_lossy(&output.stdout).into_owned();
    assert_eq!(rows.lines().count(), 4);
    assert!(said(&output).contains("2 cycles"));
    assert_eq!(said(&run(folder, "two-discs --csv - --quiet")), "");
}

#[test]
fn a_run_writes_only_what_it_says() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "two-discs --csv -");
    run(folder, "two-discs");
    assert!(names(folder).is_empty());
    run(folder, "two-discs --csv - --checkpoint keep.me");
    assert_eq!(names(folder), ["keep.me"]);
    run(folder, "two-discs --csv run.two.csv");
    let files = [
        "keep.me",
        "run.two.ballast",
        "run.two.csv",
        "run.two.journal",
    ];
    assert_eq!(names(folder), files);
    run(folder, "two-discs --csv run.csv --checkpoint state");
    assert!(!names(folder).contains(&"run.ballast".to_owned()));
    let output = run(folder, "two-discs --csv - --every 1");
    assert!(said(&output).contains("--every is without effect"));
    run(folder, "two-discs --csv late.csv --every 1e300");
}

#[test]
fn no_file_takes_the_place_of_another() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = include_str!("../../presets/two-discs.toml");
    fs::write(folder.join("own.toml"), preset).expect("it can be written");
    std::os::unix::fs::symlink("own.toml", folder.join("link.csv")).expect("it can be made");
    run(folder, "own.toml --csv a.csv");
    let before: Vec<(String, Vec<u8>)> = names(folder)
        .into_iter()
        .map(|name| (name.clone(), bytes(folder, &name)))
        .collect();
    for words in [
        "own.toml --csv own.toml",
        "own.toml --csv ./own.toml",
        "own.toml --csv link.csv",
        "own.toml --checkpoint own.toml",
        "own.toml --csv b.journal",
        "own.toml --csv b.ballast",
        "own.toml --csv b.csv --checkpoint b.csv",
        "own.toml --csv b.csv --checkpoint b.journal",
        "--resume a.ballast --csv a.ballast",
    ] {
        refused(folder, words, 2, &["would be", "another name"]);
    }
    let after: Vec<(String, Vec<u8>)> = names(folder)
        .into_iter()
        .map(|name| (name.clone(), bytes(folder, &name)))
        .collect();
    assert!(before == after, "nothing has changed");
    assert_same(&bytes(folder, "own.toml"), preset.as_bytes(), "the preset");
    assert!(text(folder, "a.csv").lines().count() == 4);
}
