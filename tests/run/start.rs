//! `[start]`: a run that begins where another one ended.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::{assert_same, bytes, names, said, text};

/// Discs that fall into a box, and a wall that presses them. Radii differ.
const SAMPLE: &str = r#"
[model]
body = "disc"
gravity = [0.0, -9.81]
[damping]
contact = 0.2
[material.grain]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 8e5
young = 2e7
poisson = 0.2
friction = 0.4
[[wall]]
name = "floor"
material = "grain"
from = [-0.01, 0.0]
to = [0.2, 0.0]
[[wall]]
name = "left"
material = "grain"
from = [0.0, 1.0]
to = [0.0, 0.0]
[[wall]]
name = "right"
material = "grain"
from = [0.105, 0.0]
to = [0.105, 1.0]
[history]
every = 10
columns = [COLUMNS]
[[stage]]
name = "fall"
do = ["delete 2"]
max_cycles = 3000
[[stage]]
name = "press"
do = ["wall left velocity 0.1 0"]
max_cycles = 400
"#;

const COLUMNS: &str = r#""particle:1:x", "particle:7:y", "particle:25:vx", "particle:25:spin", "kinetic", "wall:floor:f2", "contact:1-floor:n", "contact:1-floor:t", "contact:1-floor:alpha", "energy_error", "friction_loss""#;

/// What follows in a preset that starts from it.
const AFTER: &str = r#"
[model]
body = "disc"
gravity = [0.0, -9.81]
seed = 3
[damping]
contact = 0.2
[material.grain]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 8e5
young = 2e7
poisson = 0.2
friction = 0.4
[history]
every = 10
columns = [COLUMNS]
[[stage]]
name = "press"
do = ["wall left velocity 0.1 0"]
max_cycles = 400
[start]
"#;

/// The sample, and a preset `p.toml` that starts as told.
fn write(folder: &Path, start: &str) {
    let mut sample = SAMPLE.replace("COLUMNS", COLUMNS);
    for k in 0..25 {
        let (column, row) = (f64::from(k % 5), f64::from(k / 5));
        let radius = 0.01 * (1.0 - 0.03 * f64::from(k * 7 % 5));
        let shift = 0.001 * (row % 2.0);
        let (x, y) = (0.0105 + 0.0209 * column + shift, 0.0102 + 0.0203 * row);
        sample += &format!(
            "[[particle]]\nat = [{x:?}, {y:?}]\nradius = {radius:?}\nmaterial = \"grain\"\n"
        );
    }
    put(folder, "sample.toml", &sample);
    put(folder, "p.toml", &after(start));
}

fn after(start: &str) -> String {
    AFTER.replace("COLUMNS", COLUMNS) + start
}

fn put(folder: &Path, name: &str, text: &str) {
    fs::write(folder.join(name), text).expect("it can be written");
}

/// The program with a cache of its own.
fn ballast(folder: &Path, words: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ballast"));
    command
        .args(words.split_whitespace())
        .current_dir(folder)
        .env("XDG_CACHE_HOME", folder.join("cache"))
        .env_remove("BALLAST_CACHE");
    command.output().expect("the program starts")
}

#[track_caller]
fn run(folder: &Path, words: &str) -> Output {
    let output = ballast(folder, &format!("run {words}"));
    assert_eq!(output.status.code(), Some(0), "{words}: {}", said(&output));
    output
}

/// Rows without the cells that count from the start of the run: cycle, time, stage, energies.
fn states(text: &str) -> Vec<String> {
    let state = |row: &str| {
        let cells: Vec<&str> = row.split(',').collect();
        cells[3..12].join(",")
    };
    text.lines().skip(1).map(state).collect()
}

fn number(table: &str, row: usize, column: &str) -> f64 {
    let mut reader = csv::Reader::from_reader(table.as_bytes());
    let header = reader.headers().expect("there is one").clone();
    let place = header.iter().position(|name| name == column);
    let row = reader.records().nth(row).expect("there is such a row");
    let row = row.expect("it is whole");
    row[place.expect("there is such a column")]
        .parse()
        .expect("a number")
}

fn cached(folder: &Path) -> Vec<String> {
    let samples = folder.join("cache/ballast/samples");
    if samples.exists() {
        names(&samples)
    } else {
        Vec::new()
    }
}

#[test]
fn a_whole_state_goes_on_to_the_same_bits() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for law in [
        "linear",
        "hertz-mindlin",
        "mindlin-deresiewicz",
        "mindlin-deresiewicz-exact",
    ] {
        goes_on(folder, law);
    }
}

fn goes_on(folder: &Path, law: &str) {
    write(folder, "from = \"s.ballast\"\nkeep = \"all\"\n");
    for name in ["sample.toml", "p.toml"] {
        let chosen = format!("[model]\nlaw = \"{law}\"\ntime_step = 2e-5");
        put(
            folder,
            name,
            &text(folder, name).replacen("[model]", &chosen, 1),
        );
    }
    run(folder, "sample.toml --csv whole.csv");
    let whole = text(folder, "whole.csv");
    let whole = states(&whole);
    run(folder, "sample.toml --cycles 3000 --checkpoint s.ballast");
    run(folder, "p.toml --csv a.csv");
    let a = text(folder, "a.csv");
    assert_eq!(states(&a), whole[300..], "from a checkpoint");
    let preset = "preset = \"sample.toml\"\nstage = \"fall\"";
    let changed = text(folder, "p.toml").replace("from = \"s.ballast\"", preset);
    put(folder, "p.toml", &changed);
    run(folder, "p.toml --csv b.csv --threads 2");
    assert_same(
        &bytes(folder, "b.csv"),
        a.as_bytes(),
        "prepared, then 2 threads",
    );
    run(folder, "p.toml --csv c.csv");
    assert_same(&bytes(folder, "c.csv"), a.as_bytes(), "from the cache");
    // Energies are counted from the start, and the ledger closes: what friction lost before is none
    // of this run's.
    assert_eq!(number(&a, 0, "friction_loss"), 0.0);
    assert!(number(&a, 40, "friction_loss") > 0.0);
    let error = number(&a, 40, "energy_error").abs();
    let of_sample = number(&text(folder, "whole.csv"), 340, "energy_error").abs();
    assert!(
        error < of_sample.max(1e-6),
        "{error}, and {of_sample} in one run"
    );
}

#[test]
fn particles_at_rest_take_the_law_of_the_preset() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    write(folder, "preset = \"sample.toml\"\nstage = \"fall\"\n");
    run(folder, "sample.toml --csv whole.csv --cycles 3000");
    let whole = text(folder, "whole.csv");
    let law = "--set material.grain.normal_stiffness=3e6";
    run(folder, &format!("p.toml {law} --csv stiff.csv"));
    let hertz = "--set model.law=hertz-mindlin";
    let message = said(&run(folder, &format!("p.toml {hertz} --csv hertz.csv")));
    assert!(message.contains("let it come to rest"), "{message}");
    assert!(!said(&run(folder, "p.toml")).contains("let it come to rest"));
    for name in ["stiff.csv", "hertz.csv"] {
        let table = text(folder, name);
        for column in ["particle:1:x", "particle:7:y", "contact:1-floor:alpha"] {
            let (here, there) = (number(&table, 0, column), number(&whole, 300, column));
            assert_eq!(here, there, "{name}: {column}");
        }
        for column in ["kinetic", "particle:25:spin", "contact:1-floor:t"] {
            assert_eq!(number(&table, 0, column), 0.0, "{name}: {column}");
        }
    }
    let alpha = number(&whole, 300, "contact:1-floor:alpha");
    assert!(alpha > 0.0, "it has come to lie on the floor");
    let n = number(&text(folder, "stiff.csv"), 0, "contact:1-floor:n");
    assert!((n / (3e6 * alpha) - 1.0).abs() < 1e-14, "k alpha: {n}");
    // Two equal materials, and a wall has no curvature: E* = E/(2 (1 - nu^2)), R* = R.
    let stiffness = 4.0 / 3.0 * 2e7 / (2.0 * (1.0 - 0.04)) * 0.01f64.sqrt();
    let expected = stiffness * alpha * alpha.sqrt();
    let n = number(&text(folder, "hertz.csv"), 0, "contact:1-floor:n");
    assert!(
        (n / expected - 1.0).abs() < 1e-13,
        "Hertz: {n} for {expected}"
    );
}

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
fn walls_and_particles_of_the_preset_join_those_of_the_sample() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let own = r#"preset = "sample.toml"
[[particle]]
at = [0.05, 0.3]
radius = 0.01
material = "grain"
[[wall]]
name = "bed"
material = "grain"
from = [-1, 0]
to = [1, 0]
"#;
    write(folder, own);
    let words = "--set stage.press.do=[] --set history.columns=[\"particle:26:y\",\"wall:bed:f2\"]";
    run(folder, &format!("p.toml {words} --csv x.csv"));
    let table = text(folder, "x.csv");
    assert_eq!(number(&table, 0, "particle:26:y"), 0.3);
    assert!(
        number(&table, 0, "wall:bed:f2") < 0.0,
        "the sample presses it down"
    );
    let output = ballast(folder, "run p.toml --csv y.csv");
    assert!(
        said(&output).contains("there is no wall `left`"),
        "{}",
        said(&output)
    );
    let output = ballast(folder, &format!("check p.toml {words}"));
    let told = String::from_utf8_lossy(&output.stdout).into_owned();
    for hint in [
        "starts from:   the end of sample.toml",
        "25 particles",
        "1 wall",
    ] {
        assert!(told.contains(hint), "no `{hint}` in {told}");
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
