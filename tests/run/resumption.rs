//! A run that was stopped goes on as if it had not been.

use std::fs;
use std::path::Path;

use super::{assert_same, attempt, bytes, cycle_of, refused, run, scenes, text};

/// The header and the rows after a cycle.
fn later(whole: &str, cycle: u64) -> String {
    let mut lines = whole.split_inclusive('\n');
    let header = lines.next().expect("a history has a header").to_owned();
    header
        + &lines
            .filter(|row| cycle_of(row) > cycle)
            .collect::<String>()
}

/// Asserts that a run stopped at a cycle and resumed gives the file and the rows of the whole run.
#[track_caller]
fn assert_goes_on(folder: &Path, preset: &str, whole: &str, cycle: u64, threads: [u8; 2]) {
    let what = format!("{preset} at {cycle} with {threads:?} threads");
    let [first, second] = threads;
    run(
        folder,
        &format!("{preset} --csv part.csv --cycles {cycle} --threads {first}"),
    );
    fs::copy(folder.join("part.ballast"), folder.join("kept.ballast")).expect("it is there");
    let rest = run(
        folder,
        &format!("--resume kept.ballast --csv - --threads {second}"),
    );
    // The row of cycle 0 belongs to the run that comes after its checkpoint.
    let expected = if cycle == 0 {
        whole.to_owned()
    } else {
        later(whole, cycle)
    };
    assert_same(&rest.stdout, expected.as_bytes(), &what);
    run(
        folder,
        &format!("--resume part.ballast --csv part.csv --threads {second}"),
    );
    assert_same(&bytes(folder, "part.csv"), whole.as_bytes(), &what);
    run(folder, "--resume kept.ballast --csv new.csv");
    assert_same(&bytes(folder, "new.csv"), whole.as_bytes(), &what);
    fs::remove_file(folder.join("new.csv")).expect("it is there");
}

#[test]
fn nine_discs_go_on_from_any_cycle() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv whole.csv");
    let whole = text(folder, "whole.csv");
    // Beginning, end and both sides of the ends of stages, and odd ones.
    for cycle in [0, 1, 39, 40, 41, 777, 1040, 2539, 2541, 4939, 4940] {
        assert_goes_on(folder, "nine-disc-compression", &whole, cycle, [1, 1]);
    }
}

#[test]
fn rows_between_the_multiples_of_every_do_not_remain() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = "nine-disc-compression --set history.every=100";
    run(folder, &format!("{preset} --csv whole.csv"));
    let whole = text(folder, "whole.csv");
    for cycle in [0, 33, 40, 100, 1041] {
        // A run that ends writes its last row; one that goes on from there has none.
        assert_goes_on(folder, preset, &whole, cycle, [1, 2]);
    }
}

#[test]
fn a_scene_with_conditions_goes_on_with_other_threads() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    scenes::write_block(folder);
    run(folder, "block.toml --csv whole.csv");
    let whole = text(folder, "whole.csv");
    for (cycle, threads) in [(0, [1, 3]), (123, [3, 2]), (400, [2, 1])] {
        assert_goes_on(folder, "block.toml", &whole, cycle, threads);
    }
}

#[test]
fn a_run_may_be_cut_many_times() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv whole.csv");
    run(folder, "nine-disc-compression --csv part.csv --cycles 7");
    for cycle in [8, 8, 39, 40, 1500, 1501, 4000] {
        run(
            folder,
            &format!("--resume part.ballast --csv part.csv --cycles {cycle}"),
        );
    }
    run(folder, "--resume part.ballast --csv part.csv");
    assert_same(
        &bytes(folder, "part.csv"),
        &bytes(folder, "whole.csv"),
        "seven cuts",
    );
    assert_eq!(
        text(folder, "part.journal"),
        text(folder, "whole.journal").replace("whole", "part"),
        "the journal goes on too"
    );
}

#[test]
fn a_file_that_lost_its_end_is_completed() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv whole.csv");
    run(folder, "nine-disc-compression --csv part.csv --cycles 2000");
    let part = bytes(folder, "part.csv");
    for kept in [0, 10, part.len() / 3, part.len() - 1] {
        fs::write(folder.join("part.csv"), &part[..kept]).expect("it can be written");
        run(
            folder,
            "--resume part.ballast --checkpoint other.ballast --csv part.csv",
        );
        assert_same(
            &bytes(folder, "part.csv"),
            &bytes(folder, "whole.csv"),
            &format!("{kept} bytes left"),
        );
    }
}

#[test]
fn what_does_not_fit_is_refused_and_left_as_it_is() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv part.csv --cycles 100");
    run(
        folder,
        "nine-disc-compression --set model.frac=0.1 --csv other.csv --cycles 200",
    );
    let other = bytes(folder, "other.csv");
    refused(
        folder,
        "--resume part.ballast --csv other.csv",
        2,
        &["other.csv", "its row 2 has", "--csv"],
    );
    assert_same(
        &bytes(folder, "other.csv"),
        &other,
        "a history of another run",
    );

    let good = bytes(folder, "part.ballast");
    let mut broken = good.clone();
    broken[good.len() / 2] ^= 1;
    let mut newer = good.clone();
    newer[8] += 1;
    for (name, held, hint) in [
        (
            "noise",
            b"this is no checkpoint at all".to_vec(),
            "checkpoint",
        ),
        ("empty", Vec::new(), "empty"),
        ("broken", broken, "checksum"),
        ("short", good[..good.len() - 5].to_vec(), "short"),
        ("long", [good.as_slice(), b"more"].concat(), "follow"),
        ("newer", newer, "version"),
        ("text", bytes(folder, "part.csv"), "checkpoint"),
    ] {
        fs::write(folder.join(name), held).expect("it can be written");
        let before = bytes(folder, "part.csv");
        let message = refused(
            folder,
            &format!("--resume {name} --csv part.csv"),
            2,
            &[name],
        );
        assert!(message.contains(hint), "{name}: {message}");
        assert_same(&bytes(folder, "part.csv"), &before, name);
    }
    refused(
        folder,
        "--resume none.ballast",
        2,
        &["there is no such file"],
    );
    refused(folder, "--resume .", 2, &["folder"]);
    refused(
        folder,
        "two-discs --resume part.ballast",
        2,
        &["nine-disc-compression", "leave the preset out"],
    );
    refused(
        folder,
        "--resume part.ballast --set model.frac=0.2",
        2,
        &["keeps its preset"],
    );
    run(folder, "nine-disc-compression --resume part.ballast");
}

#[test]
fn a_preset_without_stages_goes_on_as_far_as_it_is_told() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    scenes::write_open(folder);
    refused(folder, "open.toml", 2, &["[[stage]]", "--cycles"]);
    run(folder, "open.toml --csv whole.csv --cycles 500");
    run(folder, "open.toml --csv part.csv --cycles 123");
    refused(
        folder,
        "--resume part.ballast",
        2,
        &["[[stage]]", "--cycles"],
    );
    run(folder, "--resume part.ballast --csv part.csv --cycles 500");
    assert_same(
        &bytes(folder, "part.csv"),
        &bytes(folder, "whole.csv"),
        "without stages",
    );
    let last = text(folder, "whole.csv");
    assert_eq!(last.lines().last().map(cycle_of), Some(500));
    // Behind it already: nothing to do, nothing lost.
    let before = bytes(folder, "whole.csv");
    let output = attempt(folder, "--resume whole.ballast --csv whole.csv --cycles 10");
    assert_eq!(output.status.code(), Some(0));
    assert_same(&bytes(folder, "whole.csv"), &before, "cycles in the past");
}
