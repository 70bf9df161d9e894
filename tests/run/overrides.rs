//! `--set` gives what editing the preset would.

use std::fs;

use super::{assert_same, refused, run};

const PRESET: &str = include_str!("../../presets/nine-disc-compression.toml");

#[test]
fn every_form_of_path_gives_the_bytes_of_the_edited_preset() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let plain = run(folder, "nine-disc-compression --csv -").stdout;
    let first_disc = "at = [50.0, 50.0]\nradius = 50.0\n";
    for (set, old, new) in [
        ("model.frac=0.05", "frac = 0.0946", "frac = 0.05"),
        // A key that the preset does not have.
        (
            "model.rotation=false",
            "frac = 0.0946",
            "frac = 0.0946\nrotation = false",
        ),
        (
            "damping.contact=0.1",
            "[material.disc]",
            "[damping]\ncontact = 0.1\n[material.disc]",
        ),
        (
            "material.disc.friction=0.5",
            "density = 1000.0",
            "density = 1000.0\nfriction = 0.5",
        ),
        (
            "material.\"disc\".density=2e3",
            "density = 1000.0",
            "density = 2e3",
        ),
        (
            "particle.1.radius=49",
            first_disc,
            "at = [50.0, 50.0]\nradius = 49\n",
        ),
        (
            "particle.1.at=[51,50]",
            first_disc,
            "at = [51, 50.0]\nradius = 50.0\n",
        ),
        (
            "particle.1.at.0=51",
            first_disc,
            "at = [51, 50.0]\nradius = 50.0\n",
        ),
        (
            "wall.left.from=[-1,0]",
            "name = \"left\"\nmaterial = \"disc\"\nfrom = [0.0, 0.0]",
            "name = \"left\"\nmaterial = \"disc\"\nfrom = [-1, 0]",
        ),
        (
            "wall.0.from.0=-1",
            "name = \"left\"\nmaterial = \"disc\"\nfrom = [0.0, 0.0]",
            "name = \"left\"\nmaterial = \"disc\"\nfrom = [-1, 0]",
        ),
        (
            "stage.ring.max_cycles=99",
            "max_cycles = 1000",
            "max_cycles = 99",
        ),
        (
            "stage.1.max_cycles=99",
            "max_cycles = 1000",
            "max_cycles = 99",
        ),
        (
            "stage.settle.do=[]",
            "do = [\"damp contact 0.2\"]",
            "do = []",
        ),
        ("stage.settle.do.0=zero", "damp contact 0.2", "zero"),
        (
            "stage.ring.until=stage_cycle>=77",
            "max_cycles = 1000",
            "max_cycles = 1000\nuntil = \"stage_cycle >= 77\"",
        ),
        ("history.every=3", "every = 1", "every = 3"),
        (
            "expect.0.within_rel=0.5",
            "within_rel = 0.01",
            "within_rel = 0.5",
        ),
    ] {
        assert!(PRESET.contains(old), "{old}");
        // The file has the name of the preset, so that nothing but the change can differ.
        let edited = PRESET.replacen(old, new, 1);
        fs::write(folder.join("edited.toml"), edited).expect("it can be written");
        let by_file = run(folder, "edited.toml --csv -").stdout;
        let by_option = run(
            folder,
            &format!("nine-disc-compression --csv - --set {set}"),
        )
        .stdout;
        assert_same(&by_option, &by_file, set);
        // A stage that is cut by cycles, a band and a disc that does not turn anyway show nothing.
        let silent = ["model.rotation", "expect"];
        if !silent.iter().any(|path| set.starts_with(path)) {
            assert!(by_option != plain, "{set} shows nothing");
        }
    }
}

#[test]
fn columns_come_in_the_order_asked() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let words = "nine-disc-compression --csv - --set history.columns=[\"kinetic\",\"dt\"]";
    let rows = String::from_utf8(run(folder, words).stdout).expect("it is text");
    assert_eq!(rows.lines().next(), Some("cycle,time,stage,kinetic,dt"));
    assert_eq!(
        rows.lines().nth(1),
        Some("0,0.0,load,0.0,0.014431091771485424")
    );
}

#[test]
fn the_last_of_two_settings_counts() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let two = "nine-disc-compression --csv - --set model.frac=0.2 --set model.frac=0.05";
    let one = "nine-disc-compression --csv - --set model.frac=0.05";
    assert_same(&run(folder, two).stdout, &run(folder, one).stdout, "frac");
}

#[test]
fn wrong_settings_name_what_is_near() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for (set, hints) in [
        ("model.frca=0.1", ["frca", "did you mean `frac`"]),
        ("modle.frac=0.1", ["modle", "did you mean"]),
        ("material.disk.friction=1", ["disk", "disc"]),
        ("wall.lefft.from=[0,0]", ["lefft", "left"]),
        ("stage.rong.max_cycles=1", ["rong", "ring"]),
        ("particle.10.radius=1", ["10", "9"]),
        ("model.frac", ["=", "--set model.frac=0.2"]),
        ("model.frac=fast", ["fast", "number"]),
        ("model.frac=-1", ["-1", "--set"]),
        ("=3", ["--set", "="]),
    ] {
        let words = format!("nine-disc-compression --csv x.csv --set {set}");
        refused(folder, &words, 2, &hints);
    }
    assert!(super::names(folder).is_empty());
}
