//! A journal repeats its run to the bit.

use std::fs;
use std::path::Path;

use super::{assert_same, attempt, bytes, cycle_of, refused, run, said, scenes, text};

#[test]
fn a_journal_gives_the_bytes_of_its_run() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    scenes::write_block(folder);
    for (preset, name) in [
        ("nine-disc-compression", "whole"),
        ("nine-disc-compression --cycles 777", "stopped"),
        ("nine-disc-compression --cycles 0", "not-begun"),
        (
            "nine-disc-compression --set model.frac=0.08 --set history.every=7",
            "other",
        ),
        ("block.toml --threads 2", "block"),
        ("nine-disc-compression --seed 7", "seed"),
    ] {
        run(folder, &format!("{preset} --csv {name}.csv"));
        let first = bytes(folder, &format!("{name}.csv"));
        let again = run(folder, &format!("{name}.journal --csv -"));
        assert_same(&again.stdout, &first, preset);
        // Beside the history itself nothing is overwritten by half a journal.
        let journal = bytes(folder, &format!("{name}.journal"));
        run(folder, &format!("{name}.journal --csv {name}.csv"));
        assert_same(&bytes(folder, &format!("{name}.csv")), &first, preset);
        assert_same(&bytes(folder, &format!("{name}.journal")), &journal, preset);
        // And the journal of the replay repeats it once more.
        run(folder, &format!("{name}.journal --csv copy.csv"));
        let copy = run(folder, "copy.journal --csv -");
        assert_same(&copy.stdout, &first, preset);
    }
}

/// A journal in which somebody typed.
fn write_typed(folder: &Path) {
    run(folder, "nine-disc-compression --csv plain.csv --cycles 777");
    let journal = text(folder, "plain.journal");
    let typed = "@777 friction 0.4\n@777 cycle 100\n@900 damp contact 0.3\n\
                 @1500 wall left velocity 0.01 0\n@1600 frac 0.05\n@2222 end\n";
    let journal = journal.replace("@777 end\n", typed);
    assert!(journal.contains("@1600 frac 0.05"));
    fs::write(folder.join("typed.journal"), journal).expect("it can be written");
}

#[test]
fn typed_commands_take_effect_where_they_did() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write_typed(folder);
    run(folder, "typed.journal --csv whole.csv");
    let whole = text(folder, "whole.csv");
    assert_eq!(whole.lines().last().map(cycle_of), Some(2222));
    let plain = run(folder, "nine-disc-compression --csv -").stdout;
    let same = whole.bytes().zip(plain).take_while(|(a, b)| a == b).count();
    let row = whole[..same].lines().last().map(cycle_of);
    assert_eq!(row, Some(778), "the first cycle with another friction");

    let again = run(folder, "whole.journal --csv -");
    assert_same(&again.stdout, whole.as_bytes(), "a replay of the replay");

    // A replay that is stopped goes on with what is left of the journal.
    for cycle in [5, 777, 778, 1600, 2222] {
        run(
            folder,
            &format!("typed.journal --csv part.csv --cycles {cycle}"),
        );
        run(folder, "typed.journal --resume part.ballast --csv part.csv");
        assert_same(&bytes(folder, "part.csv"), whole.as_bytes(), "a cut replay");
    }
    refused(
        folder,
        "plain.journal --resume whole.ballast",
        2,
        &["plain.journal", "leave it out"],
    );
}

#[test]
fn a_journal_with_other_settings_may_not_take_its_own_place() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv a.csv --cycles 10");
    let (rows, journal) = (bytes(folder, "a.csv"), bytes(folder, "a.journal"));
    let words = "a.journal --csv a.csv --set model.frac=0.05";
    refused(folder, words, 2, &["a.journal", "another name"]);
    assert_same(&bytes(folder, "a.csv"), &rows, "the history");
    assert_same(&bytes(folder, "a.journal"), &journal, "the journal");
    run(folder, "a.journal --csv b.csv --set model.frac=0.05");
    let direct = "nine-disc-compression --csv - --cycles 10 --set model.frac=0.05";
    let direct = run(folder, direct).stdout;
    assert_same(&bytes(folder, "b.csv"), &direct, "other settings");
}

#[test]
fn a_damaged_journal_is_refused_with_its_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv a.csv --cycles 10");
    let journal = text(folder, "a.journal");
    let lines = journal.lines().count();
    for (held, hint) in [
        (journal.replace("@0 stage", "@zero stage"), "line"),
        (journal.replace("journal 1", "journal 99"), "line 1"),
        (journal[..200].to_owned(), "line"),
        (
            journal.replace("@10 end", "@5 frictoin 0.3\n@10 end"),
            "frictoin",
        ),
        (format!("{journal}@11 friction 0.3\n"), "end"),
    ] {
        assert!(lines > 100, "the preset is in it");
        fs::write(folder.join("bad.journal"), held).expect("it can be written");
        refused(folder, "bad.journal --csv never.csv", 2, &[hint]);
        assert!(!folder.join("never.csv").exists());
    }
    // Without its end it still runs, to the end of its preset.
    let open = journal.replace("@10 end\n", "");
    fs::write(folder.join("open.journal"), open).expect("it can be written");
    let whole = run(folder, "nine-disc-compression --csv -").stdout;
    let again = run(folder, "open.journal --csv -").stdout;
    assert_same(&again, &whole, "a journal without its end");
}

#[test]
fn a_run_that_failed_fails_again_at_the_same_cycle() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let words = "nine-disc-compression --set model.frac=5 --csv wild.csv";
    refused(folder, words, 1, &["cycle 3", "particle 1"]);
    let journal = text(folder, "wild.journal");
    assert!(
        journal.contains("\n@3 fault cycle 3: particle 1"),
        "{journal}"
    );
    let again = attempt(folder, "wild.journal --csv again.csv");
    assert_eq!(again.status.code(), Some(1), "{}", said(&again));
    assert!(said(&again).contains("cycle 3: particle 1"));
    for ending in ["csv", "journal"] {
        let [first, again] =
            ["wild", "again"].map(|name| bytes(folder, &format!("{name}.{ending}")));
        assert_same(&again, &first, ending);
    }
}

/// A journal in which somebody went back from cycle 777 to cycle 100, without the file.
#[test]
fn states_that_were_gone_back_to_are_kept_on_the_way() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    run(folder, "nine-disc-compression --csv plain.csv --cycles 777");
    let journal = text(folder, "plain.journal");
    let early = journal.lines().filter_map(|line| line.strip_prefix('@'));
    let early = early.filter(|event| {
        let cycle = event.split(' ').next().expect("an event has a cycle");
        cycle.parse::<u64>().expect("a number") <= 100
    });
    let back = format!(
        "@777 friction 0.1\n@777 back 100 {} gone.ballast\n@2222 end\n",
        early.count()
    );
    let journal = journal.replace("@777 end\n", &back);
    fs::write(folder.join("back.journal"), journal).expect("it can be written");
    run(
        folder,
        "nine-disc-compression --csv whole.csv --cycles 2222",
    );
    let whole = bytes(folder, "whole.csv");
    for (journal, csv) in [("back", "again"), ("again", "more")] {
        run(folder, &format!("{journal}.journal --csv {csv}.csv"));
        assert_same(
            &bytes(folder, &format!("{csv}.csv")),
            &whole,
            "the change is gone",
        );
    }

    // Half a replay has lost what it would go back to, unless that is still to come or behind it.
    for (cycle, lost) in [(99, false), (100, false), (101, true), (776, true)] {
        run(
            folder,
            &format!("back.journal --csv part.csv --cycles {cycle}"),
        );
        let rest = "back.journal --resume part.ballast --csv part.csv";
        if lost {
            let hints = [
                "at cycle 777",
                "goes back to cycle 100",
                "from the beginning",
            ];
            refused(folder, rest, 2, &hints);
        } else {
            run(folder, rest);
            assert_same(&bytes(folder, "part.csv"), &whole, "resumed");
        }
    }
}
