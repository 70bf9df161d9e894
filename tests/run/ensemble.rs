//! `--seeds A..B`: every seed as if it ran alone, and the numbers of all of them together.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Progress, Recording, Session};
use ballast::study::ensemble::table::table;

use super::{assert_same, attempt, bytes, names, refused, run, said, text};

/// Two discs and a wall; the words of the tests give them other speeds and other lengths.
const SCENE: &str = r#"
[model]
body = "disc"
[material.m]
density = 1000.0
normal_stiffness = 1e6
[[particle]]
at = [0.0, 1.0]
radius = 1.0
material = "m"
velocity = [0.3, -0.1]
[[wall]]
name = "floor"
material = "m"
from = [-9, 0]
to = [9, 0]
[history]
every = 10
columns = ["kinetic", "wall:floor:f2", "state_hash", "fracc"]
[[stage]]
name = "fall"
until = "stage_cycle >= 40"
[[stage]]
name = "rise"
max_cycles = 25
"#;

/// A table of text by its header: columns by name.
fn columns(text: &str) -> BTreeMap<String, Vec<String>> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("there is one").clone();
    let rows: Vec<_> = reader
        .records()
        .map(|row| row.expect("it is whole"))
        .collect();
    let cells = |k: usize| rows.iter().map(|row| row[k].to_owned()).collect();
    let names = header.iter().enumerate();
    names.map(|(k, name)| (name.to_owned(), cells(k))).collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().expect("a number")
}

#[test]
fn each_seed_gives_what_it_gives_alone_however_many_run_at_a_time() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), SCENE).expect("it can be written");
    for (threads, name) in [(1, "a"), (2, "b"), (7, "c")] {
        let words = format!("p.toml --seeds 3..=5 --threads {threads} --csv {name}.csv");
        let said = said(&run(folder, &words));
        for hint in [
            "seeds 3..5: 3 of 3 runs counted",
            "-seedK.csv",
            "nothing in this preset is random",
            "seed 4: 65 cycles",
        ] {
            assert!(said.contains(hint), "no `{hint}` in {said}");
        }
    }
    for seed in 3..=5 {
        run(folder, &format!("p.toml --seed {seed} --csv alone.csv"));
        for name in ["a", "b", "c"] {
            for ending in ["csv", "journal"] {
                let of = bytes(folder, &format!("{name}-seed{seed}.{ending}"));
                let alone = bytes(folder, &format!("alone.{ending}"));
                assert_same(&of, &alone, &format!("{name}, seed {seed}, {ending}"));
            }
            let file = format!("{name}-seed{seed}.ballast");
            run(folder, &format!("--resume {file} --csv again.csv"));
            let (again, alone) = (bytes(folder, "again.csv"), bytes(folder, "alone.csv"));
            assert_same(&again, &alone, &file);
        }
    }
    for name in ["b.csv", "c.csv"] {
        assert_same(&bytes(folder, name), &bytes(folder, "a.csv"), name);
    }
    let to_stdout = run(folder, "p.toml --seeds 3..5 --csv - --quiet");
    assert_same(
        &to_stdout.stdout,
        &bytes(folder, "a.csv"),
        "standard output",
    );
    assert_eq!(said(&to_stdout), "");
    assert!(names(folder).iter().all(|name| !name.starts_with('-')));
}

fn recorded(overrides: &[&str]) -> (Vec<String>, Recording) {
    let overrides: Vec<String> = overrides.iter().map(|text| (*text).to_owned()).collect();
    let scene = Scene::parse("p", SCENE, &overrides).expect("it is accepted");
    let names = scene.stages.iter().map(|stage| stage.name.clone());
    let names = names.collect();
    let mut session = Session::open(scene, Options::default()).expect("it opens");
    let budget = Budget::default();
    while session.advance(budget, false).expect("it runs") != Progress::Finished {}
    session.finish().expect("it ends");
    (names, session.into_recording())
}

#[test]
fn rows_meet_by_their_place_in_the_stage() {
    let speeds = [-0.1, -0.2, -0.4];
    // The last one falls for 57 cycles: two rows more, and it rises from there.
    let (stages, a) = recorded(&[]);
    let (_, b) = recorded(&["particle.1.velocity=[0.3, -0.2]"]);
    let (_, c) = recorded(&[
        "particle.1.velocity=[0.3, -0.4]",
        "stage.fall.until=\"stage_cycle >= 57\"",
    ]);
    let table = table(&stages, &[&a, &b, &c]);
    let table = columns(std::str::from_utf8(table.bytes()).expect("it is text"));
    let of = |name: &str| table[name].clone();
    let fall = "fall ".repeat(7) + &"rise ".repeat(4);
    assert_eq!(of("stage").join(" "), fall.trim());
    // Rows at 0, 10, ... 40, then 50 and 57 of the last alone; later at 50, 60, 65 against 60, 70,
    // 80, 82.
    assert_eq!(of("row").join(" "), "0 1 2 3 4 5 6 0 1 2 3");
    assert_eq!(of("n").join(" "), "3 3 3 3 3 1 1 3 3 3 1");
    let cycles: Vec<f64> = of("cycle").iter().map(|cell| number(cell)).collect();
    let third = |a: f64, b: f64| (2.0 * a + b) / 3.0;
    assert_eq!(
        cycles[..8],
        [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 57.0, third(50.0, 60.0)]
    );
    assert_eq!(cycles[8..], [third(60.0, 70.0), third(65.0, 80.0), 82.0]);
    // At the start the kinetic energy of a disc of 1000 pi kg is known.
    let kinetic = speeds.map(|v: f64| 0.5 * 1000.0 * std::f64::consts::PI * (0.09 + v * v));
    let mean = kinetic.iter().sum::<f64>() / 3.0;
    let sd = (kinetic.map(|x| (x - mean) * (x - mean)).iter().sum::<f64>() / 2.0).sqrt();
    for (told, expected) in [
        ("mean", mean),
        ("sd", sd),
        ("min", kinetic[0]),
        ("max", kinetic[2]),
    ] {
        let got = number(&table[&format!("kinetic:{told}")][0]);
        assert!(
            (got / expected - 1.0).abs() < 1e-14,
            "{told}: {got} for {expected}"
        );
    }
    // One value has no spread, a hash no mean, and FRACC is not defined where nothing touches.
    assert_eq!(table["kinetic:sd"][6], "nan");
    assert!(table.keys().all(|name| !name.starts_with("state_hash")));
    assert!(table["fracc:mean"].iter().any(|cell| cell != "nan"));
}

#[test]
fn a_seed_that_fails_loses_no_other() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), SCENE).expect("it can be written");
    // A folder where the file of seed 2 should be.
    fs::create_dir(folder.join("x-seed2.csv")).expect("it can be made");
    let message = refused(
        folder,
        "p.toml --seeds 1..3 --csv x.csv",
        1,
        &[
            "seed 2: ballast: ",
            "it is a folder",
            "2 of 3 runs counted, failed: 2",
        ],
    );
    assert!(!message.contains("panicked"), "{message}");
    for name in ["x-seed1.csv", "x-seed3.csv"] {
        assert!(text(folder, name).lines().count() > 5, "{name}");
    }
    let n = &columns(&text(folder, "x.csv"))["n"];
    assert!(!n.is_empty() && n.iter().all(|n| n == "2"), "{n:?}");
}

#[test]
fn what_makes_no_sense_is_refused_before_any_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    let preset = "nine-disc-compression --csv x.csv";
    for (words, hints) in [
        ("--seeds 5..2", &["write 2..5"][..]),
        ("--seeds 5", &["1..10"]),
        ("--seeds 1..3 --seed 4", &["--seed"]),
        ("--seeds 1..3 --checkpoint y", &["leave it out"]),
        ("--seeds 1..3 --resume y", &["FILE-seedK.ballast"]),
        ("--seeds 1..3 --set model.frak=1", &["frac"]),
        ("--seeds 1..3 --threads 0", &["1..=64"]),
    ] {
        refused(folder, &format!("{preset} {words}"), 2, hints);
    }
    assert!(names(folder).is_empty());
    let output = attempt(folder, "nine-disc-compression --seeds 1..2 --csv no/x.csv");
    assert_eq!(output.status.code(), Some(1), "{}", said(&output));
    super::scenes::write_open(folder);
    refused(folder, "open.toml --seeds 1..2", 2, &["--cycles N"]);
    run(folder, "open.toml --seeds 1..2 --cycles 30 --csv o.csv");
    let own = Path::new("open.toml");
    refused(
        folder,
        "open.toml --seeds 1..2 --cycles 3 --csv open.toml",
        2,
        &["input"],
    );
    assert!(folder.join(own).exists());
}

/// Discs at random that fall: every seed another heap.
const RANDOM: &str = r#"
[model]
body = "disc"
gravity = [0, -9.81]
[material.m]
density = 1000.0
normal_stiffness = 1e6
[[generate]]
in = { rectangle = { min = [0, 0], max = [1, 1] } }
material = "m"
grading = [{ radius = 0.05, count = 20 }]
[[wall]]
name = "floor"
material = "m"
from = [-1, 0]
to = [2, 0]
[history]
every = 50
columns = ["kinetic", "contacts"]
[[stage]]
name = "fall"
until = "contacts >= 4"
max_cycles = 5000
check_every = 10
[[stage]]
name = "on"
max_cycles = 120
"#;

#[test]
fn the_table_is_what_the_files_of_the_seeds_give() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), RANDOM).expect("it can be written");
    let message = said(&run(folder, "p.toml --seeds 1..5 --csv x.csv"));
    assert!(!message.contains("nothing in this preset is random"));
    // Stage and row within it: the values of the seeds that have it.
    let mut values: BTreeMap<(String, usize), Vec<f64>> = BTreeMap::new();
    let mut lengths = Vec::new();
    for seed in 1..=5 {
        let own = columns(&text(folder, &format!("x-seed{seed}.csv")));
        let mut row = BTreeMap::new();
        for (stage, kinetic) in own["stage"].iter().zip(&own["kinetic"]) {
            let k = row.entry(stage.clone()).or_insert(0);
            let place = values.entry((stage.clone(), *k)).or_default();
            place.push(number(kinetic));
            *k += 1;
        }
        lengths.push(row["fall"]);
    }
    lengths.sort_unstable();
    assert!(lengths[0] < lengths[4], "the heaps differ: {lengths:?}");
    let table = columns(&text(folder, "x.csv"));
    assert_eq!(table["row"].len(), values.len());
    for (k, stage) in table["stage"].iter().enumerate() {
        let of = |name: &str| number(&table[name][k]);
        let place = (stage.clone(), of("row") as usize);
        let x = &values[&place];
        let n = x.len() as f64;
        let mean = x.iter().sum::<f64>() / n;
        let squares: f64 = x.iter().map(|x| (x - mean) * (x - mean)).sum();
        let sd = (squares / (n - 1.0)).sqrt();
        let smallest = x.iter().copied().fold(f64::INFINITY, f64::min);
        let largest = x.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        assert_eq!(
            (of("n"), of("kinetic:min"), of("kinetic:max")),
            (n, smallest, largest)
        );
        assert!(
            (of("kinetic:mean") - mean).abs() <= 1e-14 * largest,
            "{place:?}"
        );
        let spread = of("kinetic:sd");
        assert!(
            (spread - sd).abs() <= 1e-13 * largest || spread.is_nan() && n < 2.0,
            "{place:?}"
        );
    }
    // The mean over seeds of an expectation is that of the last rows; its band decides.
    let last = |seed: u64| {
        let own = columns(&text(folder, &format!("x-seed{seed}.csv")));
        number(own["kinetic"].last().expect("there are rows"))
    };
    let mean = (2..=4).map(last).sum::<f64>() / 3.0;
    for (value, status, verdict) in [(mean, 0, "1 PASS"), (1.001 * mean, 3, "1 FAIL")] {
        let expect = format!(
            "{RANDOM}[[expect]]\nwhat = \"last(kinetic)\"\nseeds = \"2..4\"\nvalue = {value:?}\n\
             within_rel = 1e-12\n"
        );
        fs::write(folder.join("q.toml"), expect).expect("it can be written");
        let output = super::ballast(folder, &["verify", "q.toml", "--threads", "2"]);
        let told = String::from_utf8_lossy(&output.stdout).into_owned() + &said(&output);
        assert_eq!(output.status.code(), Some(status), "{told}");
        assert!(told.contains(verdict), "{told}");
    }
}

#[test]
fn each_seed_starts_from_a_sample_of_its_own() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("sample.toml"), RANDOM).expect("it can be written");
    let (head, _) = RANDOM.split_once("[[generate]]").expect("it generates");
    let (_, tail) = RANDOM.split_once("[history]").expect("it has a history");
    let start = format!("{head}[start]\npreset = \"sample.toml\"\n[history]{tail}");
    fs::write(folder.join("p.toml"), start).expect("it can be written");
    run(folder, "p.toml --no-cache --seeds 1..2 --csv x.csv");
    let (a, b) = (text(folder, "x-seed1.csv"), text(folder, "x-seed2.csv"));
    assert!(a != b, "other seeds, other samples");
    run(folder, "p.toml --no-cache --seed 2 --csv alone.csv");
    assert_same(&bytes(folder, "alone.csv"), b.as_bytes(), "seed 2 alone");
}
