//! `ballast export lammps`: the deck, read back as text, gives the forces of the scene; what LAMMPS lacks
//! is refused with its reason.

#[path = "program/mod.rs"]
mod program;

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use program::{ballast, said};

/// Spheres in a periodic cell that touch inside it and through its sides, one of them spinning.
const CELL: &str = r#"
[model]
law = "hertz-mindlin"
[damping]
contact = 0.1
[material.glass]
density = 2650.0
young = 70e9
poisson = 0.25
friction = 0.3
[cell]
size = [4e-3, 3e-3]
[[particle]]
at = [0.5e-3, 0.5e-3]
radius = 1e-3
material = "glass"
[[particle]]
at = [2.2e-3, 0.685e-3]
radius = 0.72e-3
material = "glass"
[[particle]]
at = [3.05652e-3, 2.44146e-3]
radius = 0.8e-3
material = "glass"
spin = 3.5
[[stage]]
name = "still"
max_cycles = 7
"#;

/// Discs of two materials between walls, under linear springs.
const DISCS: &str = r#"
[model]
law = "linear"
body = "disc"
gravity = [0.0, -9.81]
[damping]
contact = 0.2
[material.soft]
density = 1000.0
normal_stiffness = 1e6
shear_stiffness = 5e5
friction = 0.5
[material.hard]
density = 2000.0
normal_stiffness = 3e6
shear_stiffness = 3e6
friction = 0.2
[[particle]]
at = [0.0, 0.99]
radius = 1.0
material = "soft"
[[particle]]
at = [1.7788, 0.79]
radius = 0.8
material = "hard"
velocity = [0.25, -0.125]
[[wall]]
name = "floor"
from = [-3, 0]
to = [3, 0]
material = "soft"
[[wall]]
name = "slope"
from = [3, 0]
to = [5, 4]
material = "soft"
[[stage]]
name = "fall"
max_cycles = 5
"#;

fn deck(folder: &Path, preset: &str, words: &[&str]) -> BTreeMap<String, String> {
    fs::write(folder.join("scene.toml"), preset).expect("it can be written");
    let all = [&["export", "lammps", "scene.toml", "-o", "deck"], words].concat();
    let output = ballast(folder, &all);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let files = fs::read_dir(folder.join("deck")).expect("it is there");
    files
        .map(|file| {
            let path = file.expect("it can be listed").path();
            let name = path.file_name().expect("it has a name");
            let text = fs::read_to_string(&path).expect("it is text");
            (name.to_string_lossy().into_owned(), text)
        })
        .collect()
}

/// Rows of a section of the data file.
fn rows(data: &str, section: &str) -> Vec<Vec<f64>> {
    let (_, rest) = data.split_once(section).expect("the section is there");
    let lines = rest.lines().skip(2).take_while(|line| !line.is_empty());
    lines
        .map(|line| {
            line.split(' ')
                .map(|word| word.parse().expect("a number"))
                .collect()
        })
        .collect()
}

/// Forces that the words of `pair_coeff` give to particles at rest: springs along the line of centres.
fn forces(data: &str, law: &str) -> Vec<[f64; 2]> {
    let atoms = rows(data, "Atoms # sphere");
    let edge = |axis: &str| -> f64 {
        let line = data
            .lines()
            .find(|line| line.ends_with(&format!("{axis}lo {axis}hi")));
        let numbers = line.expect("the box is there").split(' ').take(2);
        let ends: Vec<f64> = numbers
            .map(|word| word.parse().expect("a number"))
            .collect();
        ends[1] - ends[0]
    };
    let edges = [edge("x"), edge("y")];
    let mut sums = vec![[0.0; 2]; atoms.len()];
    for i in 0..atoms.len() {
        for j in i + 1..atoms.len() {
            let kinds = format!(
                "pair_coeff {} {} ",
                atoms[i][1].min(atoms[j][1]),
                atoms[i][1].max(atoms[j][1])
            );
            let line = law.lines().find_map(|line| line.strip_prefix(&kinds));
            let words: Vec<&str> = line.expect("the pair is there").split(' ').collect();
            let stiffness: f64 = words[1].parse().expect("a number");
            for shift in [-1.0, 0.0, 1.0]
                .into_iter()
                .flat_map(|a| [-1.0, 0.0, 1.0].map(|b| [a, b]))
            {
                let d = [0, 1].map(|k| atoms[j][4 + k] + shift[k] * edges[k] - atoms[i][4 + k]);
                let (a, b) = (0.5 * atoms[i][2], 0.5 * atoms[j][2]);
                let distance = d[0].hypot(d[1]);
                let overlap = a + b - distance;
                if overlap <= 0.0 {
                    continue;
                }
                let force = match words[0] {
                    "hertz" => stiffness * (a * b / (a + b)).sqrt() * overlap.powf(1.5),
                    "hooke" => stiffness * overlap,
                    other => panic!("{other} is no normal law"),
                };
                for k in 0..2 {
                    sums[i][k] -= force * d[k] / distance;
                    sums[j][k] += force * d[k] / distance;
                }
            }
        }
    }
    sums
}

/// Columns of the table of particles.
fn column(csv: &str, name: &str) -> Vec<f64> {
    let mut reader = csv::Reader::from_reader(csv.as_bytes());
    let headers = reader.headers().expect("there are some").clone();
    let at = headers
        .iter()
        .position(|header| header == name)
        .expect("the column is there");
    let records = reader.records();
    records
        .map(|row| row.expect("it is whole")[at].parse().expect("a number"))
        .collect()
}

#[test]
fn the_deck_of_a_cell_gives_its_forces() {
    let folder = tempfile::tempdir().expect("a folder");
    let deck = deck(folder.path(), CELL, &[]);
    let names: Vec<&str> = deck.keys().map(String::as_str).collect();
    let expected = [
        "README.md",
        "in.scene",
        "law.classic",
        "law.granular",
        "scene.csv",
        "scene.data",
    ];
    assert_eq!(names, expected);
    let sums = forces(&deck["scene.data"], &deck["law.granular"]);
    let own = [
        column(&deck["scene.csv"], "fx"),
        column(&deck["scene.csv"], "fy"),
    ];
    let scale = sums
        .iter()
        .flatten()
        .fold(0.0, |most: f64, f| most.max(f.abs()));
    // Three contacts, two of them through the sides; overlaps of some 1e-5 m keep ten digits.
    assert!(
        scale > 0.1 && sums.iter().all(|f| *f != [0.0; 2]),
        "{sums:?}"
    );
    for (k, sum) in sums.iter().enumerate() {
        for axis in 0..2 {
            assert!(
                (sum[axis] - own[axis][k]).abs() < 1e-9 * scale,
                "{k}: {sum:?}"
            );
        }
    }
    assert_eq!(
        rows(&deck["scene.data"], "Velocities")[2],
        [3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 3.5]
    );
    // 4/3 E*, 8 G* and the restitution of a fraction of 0.1 (data/reference).
    let classic: Vec<f64> = (deck["law.classic"]
        .lines()
        .next()
        .expect("a line")
        .split(' ')
        .skip(2))
    .filter_map(|word| word.parse().ok())
    .collect();
    let (e, g) = (70e9 / (2.0 * 0.9375), 70e9 / (2.5 * 2.0 * 1.75));
    assert!((classic[0] / (4.0 / 3.0 * e) - 1.0).abs() < 1e-15);
    assert!((classic[1] / (8.0 * g) - 1.0).abs() < 1e-15);
    assert!(
        deck["law.granular"].contains(" 0.70735128"),
        "{}",
        deck["law.granular"]
    );
    assert!(
        deck["in.scene"].contains("boundary p p p")
            && deck["in.scene"].contains("variable steps index 7")
    );
}

#[test]
fn walls_and_materials_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    let deck = deck(folder.path(), DISCS, &[]);
    let (data, law, script) = (
        &deck["scene.data"],
        &deck["law.granular"],
        &deck["in.scene"],
    );
    let sums = forces(data, law);
    // Springs of 1e6 and 3e6 N/m in series, twice: 1.5e6 N/m.
    assert!(law.contains("pair_coeff 1 2 hooke 1500000.0 "), "{law}");
    let own = column(&deck["scene.csv"], "fx");
    // The second one moves away from the first: its dashpot pulls less than the spring pushes.
    assert!(sums[1][0] > own[1] && own[1] > 0.0, "{sums:?} {own:?}");
    // A disc of 1 m has the mass of its circle, written as the density of a sphere.
    let atom = &rows(data, "Atoms # sphere")[0];
    let mass = atom[3] * 4.0 / 3.0 * std::f64::consts::PI;
    assert!((mass / (1000.0 * std::f64::consts::PI) - 1.0).abs() < 1e-15);
    assert!(script.contains("nve/sphere disc") && script.contains("vector 0.0 -9.81 0"));
    assert!(script.contains("region wall1 block -3.0 3.0 "), "{script}");
    let slope = script
        .lines()
        .find(|line| line.starts_with("region wall2 prism "));
    let numbers: Vec<f64> = (slope.expect("it is there").split(' ').skip(3).take(9))
        .map(|word| word.parse().expect("a number"))
        .collect();
    assert!((numbers[0] - 3.0).abs() < 1e-8 && numbers[1] > numbers[0] && numbers[1] - 3.0 < 1e-8);
    assert_eq!([numbers[2], numbers[3], numbers[6]], [0.0, 4.0, 2.0]);
    assert!(!deck.contains_key("law.classic") && deck["README.md"].contains("several materials"));
}

#[test]
fn what_lammps_lacks_is_refused_or_replaced() {
    let folder = tempfile::tempdir().expect("a folder");
    let partial = CELL.replace("\"hertz-mindlin\"", "\"mindlin-deresiewicz-exact\"");
    fs::write(folder.path().join("partial.toml"), &partial).expect("it can be written");
    let words = ["export", "lammps", "partial.toml", "-o", "deck"];
    let output = ballast(folder.path(), &words);
    assert_eq!(output.status.code(), Some(2));
    for hint in [
        "mindlin-deresiewicz-exact",
        "no slip inside a contact",
        "--nearest",
        "hertz-mindlin",
    ] {
        assert!(
            said(&output).contains(hint),
            "no {hint} in {}",
            said(&output)
        );
    }
    assert!(!folder.path().join("deck").exists(), "nothing is written");
    let deck = deck(folder.path(), &partial, &["--nearest"]);
    assert!(deck["law.granular"].contains("mindlin_rescale/force"));
    assert!(deck["README.md"].contains("What LAMMPS lacks, and what stands in its place"));

    let ring = ballast(
        folder.path(),
        &["export", "lammps", "graded-shear", "-o", "ring"],
    );
    assert_eq!(ring.status.code(), Some(2));
    assert!(
        said(&ring).contains("a ring of boundary particles"),
        "{}",
        said(&ring)
    );
    let cohesive = CELL.replace("friction = 0.3", "friction = 0.3\ncohesion = 0.1");
    fs::write(folder.path().join("cohesive.toml"), cohesive).expect("it can be written");
    let words = ["export", "lammps", "cohesive.toml", "-o", "no", "--nearest"];
    let output = ballast(folder.path(), &words);
    assert_eq!(output.status.code(), Some(2));
    assert!(
        said(&output).contains("nothing comes near that"),
        "{}",
        said(&output)
    );
}

#[test]
fn a_deck_is_written_at_a_place_in_the_stages() {
    let folder = tempfile::tempdir().expect("a folder");
    let first = deck(folder.path(), DISCS, &[]);
    let later = deck(folder.path(), DISCS, &["--at", "fall/3"]);
    assert!(later["in.scene"].contains("cycle 3"));
    assert!(first["scene.data"] != later["scene.data"]);
    // What rubs by then cannot be handed over, and that is said.
    assert!(
        later["README.md"].contains("carry shear now"),
        "{}",
        later["README.md"]
    );
    for (at, hint) in [
        ("fal", "did you mean `fall`?"),
        ("fall/99", "was over before 99 cycles"),
        ("fall/x", "STAGE/CYCLES is expected"),
    ] {
        let words = ["export", "lammps", "scene.toml", "-o", "no", "--at", at];
        let output = ballast(folder.path(), &words);
        assert_eq!(output.status.code(), Some(2), "{at}");
        assert!(said(&output).contains(hint), "{at}: {}", said(&output));
    }
    let run = [
        "run",
        "scene.toml",
        "--cycles",
        "3",
        "--checkpoint",
        "s.ballast",
        "-q",
    ];
    assert_eq!(ballast(folder.path(), &run).status.code(), Some(0));
    let output = ballast(
        folder.path(),
        &["export", "lammps", "s.ballast", "-o", "third"],
    );
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    let same = fs::read_to_string(folder.path().join("third/scene.data"));
    assert_eq!(same.expect("it is written"), later["scene.data"]);
    let words = ["export", "lammps", "s.ballast", "-o", "no", "--at", "fall"];
    let output = ballast(folder.path(), &words);
    assert!(
        said(&output).contains("--at is about presets"),
        "{}",
        said(&output)
    );
}
