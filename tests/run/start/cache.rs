//! Where samples come from: cache, journals, checkpoints and other samples.

use std::fs;
use std::process::Command;

use super::super::{assert_same, bytes, said, text};
use super::{after, ballast, cached, put, run, write};

#[test]
fn the_cache_changes_nothing_but_the_time_it_takes() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write(folder, "preset = \"sample.toml\"\n");
    run(folder, "p.toml --csv first.csv --no-cache");
    assert!(cached(folder).is_empty());
    let first = bytes(folder, "first.csv");
    run(folder, "p.toml --csv a.csv");
    let [name] = cached(folder).try_into().expect("one sample is kept");
    assert!(name.starts_with("sample-"), "{name}");
    assert_same(&bytes(folder, "a.csv"), &first, "prepared");
    let path = folder.join("cache/ballast/samples").join(&name);
    let kept = fs::read(&path).expect("it is there");
    // Used: a sample that is another one shows.
    let other = "sample.toml --set material.grain.friction=0.1 --checkpoint o.ballast";
    run(folder, other);
    for (what, held) in [
        ("damaged", [&kept[..kept.len() / 2], &kept[..]].concat()),
        ("cut short", kept[..kept.len() - 7].to_vec()),
        ("empty", Vec::new()),
        ("of another run", bytes(folder, "o.ballast")),
    ] {
        fs::write(&path, held).expect("it can be written");
        run(folder, "p.toml --csv b.csv");
        assert_same(&bytes(folder, "b.csv"), &first, what);
        assert_same(&fs::read(&path).expect("it is there"), &kept, what);
    }
    // Another seed, stage, setting: another sample.
    run(folder, "p.toml --seeds 4..6 --threads 2 --csv e.csv");
    assert_eq!(cached(folder).len(), 4);
    run(folder, "p.toml --set start.stage=fall --csv f.csv");
    run(
        folder,
        "p.toml --set start.set=[\"material.grain.friction=0.1\"] --csv g.csv",
    );
    assert_eq!(cached(folder).len(), 6);
    for other in ["f.csv", "g.csv"] {
        assert!(bytes(folder, other) != first, "{other}");
    }
    // Where it cannot be kept, it is used all the same.
    let nowhere = |name: &str, value: &str| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ballast"));
        command
            .args(["run", "p.toml", "--csv", "h.csv"])
            .current_dir(folder);
        command
            .env("XDG_CACHE_HOME", folder.join("other"))
            .env(name, value);
        let output = command.output().expect("the program starts");
        assert_eq!(output.status.code(), Some(0), "{}", said(&output));
        assert_same(&bytes(folder, "h.csv"), &first, name);
        assert!(!folder.join("other").exists());
        said(&output)
    };
    assert!(!nowhere("BALLAST_CACHE", "off").contains("kept"));
    let file = folder.join("p.toml");
    let message = nowhere("XDG_CACHE_HOME", file.to_str().expect("it is text"));
    assert!(
        message.contains("the sample is not kept for the next time"),
        "{message}"
    );
}

#[test]
fn journals_and_checkpoints_know_what_the_run_began_with() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::create_dir(folder.join("deep")).expect("it can be made");
    let deep = folder.join("deep");
    for keep in ["particles", "all"] {
        write(
            &deep,
            &format!("preset = \"sample.toml\"\nstage = \"fall\"\nkeep = \"{keep}\"\n"),
        );
        run(folder, "deep/p.toml --csv whole.csv");
        let whole = bytes(folder, "whole.csv");
        fs::copy(folder.join("whole.journal"), folder.join("j.journal")).expect("it is there");
        run(folder, "j.journal --csv again.csv");
        assert_same(
            &bytes(folder, "again.csv"),
            &whole,
            "replayed from another folder",
        );
        run(folder, "deep/p.toml --csv part.csv --cycles 123");
        // What is in the checkpoint needs no sample.
        fs::rename(deep.join("sample.toml"), deep.join("gone.toml")).expect("it is there");
        run(folder, "deep/p.toml --resume part.ballast --csv part.csv");
        assert_same(&bytes(folder, "part.csv"), &whole, "resumed");
        let output = ballast(folder, "run j.journal");
        assert_eq!(output.status.code(), Some(2), "{}", said(&output));
        // Another sample under the same name is noticed.
        let other = text(&deep, "gone.toml").replace("-9.81", "-9.8");
        put(&deep, "sample.toml", &other);
        let message = said(&run(folder, "j.journal"));
        assert!(
            message.contains("sample or settings are others now"),
            "{message}"
        );
    }
}

#[test]
fn a_sample_may_start_from_a_sample_and_studies_compare_laws_on_one() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write(folder, "preset = \"second.toml\"\n");
    put(
        folder,
        "second.toml",
        &after("preset = \"sample.toml\"\nstage = \"fall\"\n"),
    );
    let words = "--set stage.press.do=[]";
    run(folder, &format!("p.toml {words} --csv a.csv"));
    assert_eq!(cached(folder).len(), 2);
    run(folder, &format!("p.toml {words} --csv b.csv"));
    assert_same(
        &bytes(folder, "b.csv"),
        &bytes(folder, "a.csv"),
        "both from the cache",
    );
    assert_eq!(cached(folder).len(), 2);
    run(folder, &format!("p.toml {words} --no-cache --csv c.csv"));
    assert_same(
        &bytes(folder, "c.csv"),
        &bytes(folder, "a.csv"),
        "both prepared",
    );
    let check = ballast(folder, &format!("check p.toml {words}"));
    let told = String::from_utf8_lossy(&check.stdout).into_owned();
    assert!(
        told.contains("24 particles") && !told.contains("prepared when"),
        "{told}"
    );
    // The law and nothing else differs: the particles begin at the same places.
    let laws = "--law linear,hertz-mindlin,hertz --frac 0.1 --for kinetic";
    let study = ballast(folder, &format!("study p.toml {words} {laws}"));
    assert_eq!(study.status.code(), Some(0), "{}", said(&study));
    let told = String::from_utf8_lossy(&study.stdout).into_owned();
    for law in ["linear", "hertz-mindlin", "hertz"] {
        assert!(told.contains(law), "no {law} in {told}");
    }
}
