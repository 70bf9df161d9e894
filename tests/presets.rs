//! Every embedded preset that is quick replays against its expectations; and the test can fail.

mod processor;
mod program;

use std::time::Duration;

use ballast::scene::{About, Scene, catalogue};
use ballast::study::verify::{Verdict, verify};
use program::{ballast, said};

/// Most processor time for all of them together.
const ALL: Duration = Duration::from_secs(90);

#[test]
fn quick_presets_meet_their_expectations() {
    let start = processor::time();
    let mut quick = 0;
    for preset in catalogue::PRESETS {
        if !About::of(preset.text).quick {
            continue;
        }
        let scene = Scene::load(preset.name, &[]).expect("embedded presets are accepted");
        quick += 1;
        assert!(
            scene.expects.len() >= 2,
            "{} expects too little",
            preset.name
        );
        let outcome = verify(&scene, 1, &|_| true).expect("it runs");
        let bad: Vec<_> = outcome
            .findings
            .iter()
            .filter(|finding| finding.verdict == Verdict::Fail)
            .collect();
        assert!(
            outcome.is_good(),
            "{}: {bad:#?} {:?}",
            preset.name,
            outcome.cut_short
        );
    }
    assert!(quick >= 19, "{quick} quick presets");
    let took = processor::time().saturating_sub(start);
    assert!(took < ALL, "they took {took:?}");
}

#[test]
fn half_the_stiffness_is_noticed() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = [
        "verify",
        "nine-disc-compression",
        "--set",
        "material.disc.normal_stiffness=0.675e9",
    ];
    let output = ballast(folder.path(), &words);
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    for hint in ["FAIL", "F_eq = k v N dt/2", "5 FAIL"] {
        assert!(table.contains(hint), "no {hint} in\n{table}");
    }
    let good = ballast(folder.path(), &words[..2]);
    assert_eq!(good.status.code(), Some(0), "{}", said(&good));
}

/// Contact laws that are nearly right must not pass: what each gives instead is known.
#[test]
fn another_law_is_noticed() {
    let folder = tempfile::tempdir().expect("a folder");
    for (preset, law, hints) in [
        // The mean restitution of Randall's own law.
        (
            "oblique-impact",
            "mindlin-deresiewicz",
            ["FAIL", "0.936487"],
        ),
        // Full stick: T = k_t delta at a quarter of delta*, up to 9.9 N.
        ("oblique-loading", "hertz-mindlin", ["FAIL", "9.9"]),
        ("chung-ooi-5", "hertz-mindlin", ["FAIL", "PASS"]),
    ] {
        let set = format!("model.law={law}");
        let output = ballast(folder.path(), &["verify", preset, "--set", &set]);
        assert_eq!(output.status.code(), Some(3), "{}", said(&output));
        let table = String::from_utf8_lossy(&output.stdout).into_owned();
        for hint in hints {
            assert!(table.contains(hint), "no {hint} in\n{table}");
        }
    }
}

#[test]
fn a_condition_that_never_comes_true_fails() {
    let folder = tempfile::tempdir().expect("a folder");
    let set = "stage.press.until=kinetic > 1e9";
    let output = ballast(folder.path(), &["verify", "two-discs", "--set", set]);
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(table.contains("stage press reached max_cycles"), "{table}");
}

#[test]
fn a_difference_that_is_explained_does_not_fail() {
    let folder = tempfile::tempdir().expect("a folder");
    let preset = include_str!("../presets/two-discs.toml");
    let expect = |value: &str, more: &str| {
        format!(
            "{preset}\n[[expect]]\nwhat = \"last(cycle)\"\nvalue = {value}\nwithin = 0.5\n{more}"
        )
    };
    let differs = "source = \"a book\"\ndiffers = \"the book counts from zero\"\n\
                   ours = 2\nours_within = 0.5\n";
    let wrong = &differs.replace("ours = 2", "ours = 4");
    for (text, status, hint, right) in [
        (expect("2", ""), 0, "6 PASS, 0 DIFFERS, 0 FAIL", false),
        (expect("3", ""), 3, "5 PASS, 0 DIFFERS, 1 FAIL", false),
        (expect("3", differs), 0, "5 PASS, 1 DIFFERS, 0 FAIL", false),
        // The book is right after all.
        (expect("2", differs), 0, "6 PASS, 0 DIFFERS, 0 FAIL", true),
        (expect("2", wrong), 0, "6 PASS, 0 DIFFERS, 0 FAIL", true),
        (expect("3", wrong), 3, "5 PASS, 0 DIFFERS, 1 FAIL", false),
    ] {
        std::fs::write(folder.path().join("own.toml"), text).expect("it can be written");
        let output = ballast(folder.path(), &["verify", "own.toml"]);
        let table = String::from_utf8_lossy(&output.stdout).into_owned();
        assert_eq!(
            output.status.code(),
            Some(status),
            "{table}{}",
            said(&output)
        );
        assert!(table.contains(hint), "{table}");
        let gone = table.contains("the difference that is explained is not there");
        assert_eq!(gone, right, "{table}");
    }
    // A preset that expects nothing verifies nothing.
    let nothing = preset.replace("[[expect]]", "[[stage]]");
    assert!(nothing.contains("[[stage]]"));
    let bare = preset
        .split("[[expect]]")
        .next()
        .expect("it has a beginning");
    std::fs::write(folder.path().join("bare.toml"), bare).expect("it can be written");
    let output = ballast(folder.path(), &["verify", "bare.toml"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(said(&output).contains("no [[expect]]"));
}

#[test]
fn the_table_is_plain_where_there_is_no_terminal() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = ballast(folder.path(), &["verify", "two-discs"]);
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(!table.contains('\u{1b}'), "{table}");
    assert_eq!(said(&output), "");
    // Figures stand below each other.
    let rows: Vec<&str> = table
        .lines()
        .filter(|row| row.contains("contact:"))
        .collect();
    let columns: Vec<_> = rows
        .iter()
        .map(|row| row.find("at(").or_else(|| row.find("last(")))
        .collect();
    assert_eq!(rows.len(), 5);
    assert!(
        columns.iter().all(|column| *column == columns[0]),
        "{table}"
    );
}

#[test]
fn the_findings_can_be_had_as_csv() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = ["verify", "two-discs", "rolling-disc", "--csv"];
    let to_file = ballast(folder.path(), &[&words[..], &["findings.csv"]].concat());
    assert_eq!(to_file.status.code(), Some(0), "{}", said(&to_file));
    let table = String::from_utf8_lossy(&to_file.stdout).into_owned();
    assert!(table.contains("11 PASS, 0 DIFFERS, 0 FAIL"), "{table}");
    let csv = std::fs::read(folder.path().join("findings.csv")).expect("it is written");
    let to_stdout = ballast(folder.path(), &[&words[..], &["-"]].concat());
    assert!(to_stdout.stdout == csv, "the same bytes");
    let mut reader = csv::Reader::from_reader(csv.as_slice());
    let header = reader.headers().expect("there is one").clone();
    let names = [
        "preset", "stage", "what", "value", "expected", "within", "verdict", "source", "remark",
        "seeds", "sd", "min", "max",
    ];
    assert_eq!(header.iter().collect::<Vec<_>>(), names);
    let rows: Vec<_> = reader
        .records()
        .map(|row| row.expect("it is whole"))
        .collect();
    assert_eq!(rows.len(), 11);
    for row in &rows {
        let number = |k: usize| -> f64 { row[k].parse().expect("a number") };
        assert!((number(3) - number(4)).abs() <= number(5), "{row:?}");
        assert_eq!(&row[6], "PASS");
    }
    let nowhere = ballast(folder.path(), &[&words[..], &["no/file"]].concat());
    assert_eq!(nowhere.status.code(), Some(1));
    assert!(nowhere.stdout.is_empty() && said(&nowhere).contains("there is no folder"));
}

#[test]
fn a_run_that_fails_is_a_failed_preset() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = ["verify", "square-lattice", "two-discs", "--csv", "f.csv"];
    // Far beyond the limit the lattice flies apart; the other preset is run all the same.
    let set = ["--set", "model.frac=4"];
    let output = ballast(folder.path(), &[&words[..], &set].concat());
    assert_eq!(output.status.code(), Some(3), "{}", said(&output));
    let table = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(
        table.contains("reduce frac") && table.contains("two-discs ("),
        "{table}"
    );
    let csv = std::fs::read_to_string(folder.path().join("f.csv")).expect("it is written");
    assert!(
        csv.contains("square-lattice,,the run,nan,nan,nan,FAIL,"),
        "{csv}"
    );
}

#[test]
fn an_ensemble_is_judged_by_its_mean() {
    let folder = tempfile::tempdir().expect("a folder");
    let preset = include_str!("../presets/two-discs.toml");
    let expect = |seeds: &str, value: &str| {
        format!(
            "{preset}\n[[expect]]\nwhat = \"last(cycle)\"\nseeds = \"{seeds}\"\nvalue = {value}\nwithin = 0.5\n"
        )
    };
    let verify = |text: &str, words: &[&str]| {
        std::fs::write(folder.path().join("own.toml"), text).expect("it can be written");
        let output = ballast(folder.path(), &[&["verify", "own.toml"], words].concat());
        let table = String::from_utf8_lossy(&output.stdout).into_owned();
        (output.status.code(), table + &said(&output))
    };
    for threads in ["1", "2"] {
        let (status, table) = verify(&expect("5..7", "2"), &["--threads", threads]);
        assert_eq!(status, Some(0), "{table}");
        for hint in [
            "mean over seeds 5..7 of last(cycle)",
            "3 seeds: standard deviation 0, from 2 to 2",
            // The preset's own seed is run besides: four runs of two cycles.
            "own (8 cycles",
            "6 PASS, 0 DIFFERS, 0 FAIL",
        ] {
            assert!(table.contains(hint), "no `{hint}` in\n{table}");
        }
    }
    let (status, table) = verify(&expect("1..3", "3"), &[]);
    assert_eq!(status, Some(3), "{table}");
    assert!(table.contains("5 PASS, 0 DIFFERS, 1 FAIL"), "{table}");
    let (status, table) = verify(&expect("1..3", "2"), &["--csv", "-"]);
    assert_eq!(status, Some(0), "{table}");
    assert!(table.contains(",3,0.0,2.0,2.0\n"), "{table}");
    let (status, table) = verify(&expect("1-3", "2"), &[]);
    assert_eq!(status, Some(2), "{table}");
    for hint in ["own.toml:", "no range of seeds", "seeds = \"1..10\""] {
        assert!(table.contains(hint), "no `{hint}` in\n{table}");
    }
}
