//! `[start]`: a run that begins where another one ended.

mod boundaries;
mod cache;
mod keeping;
mod refusals;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use super::{names, said};

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
