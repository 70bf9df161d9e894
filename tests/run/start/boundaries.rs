//! The boundary of a sample comes along: a ring with its particles, walls, a cell.

use std::fs;
use std::path::Path;

use super::super::{assert_same, bytes, text};
use super::{number, put, run};

/// Discs at random that a boundary presses together, and what is done with them then.
const SAMPLE: &str = r#"
[model]
body = "disc"
overlap = "allow"         # random discs know nothing of a cell that leans
[damping]
contact = 0.2
global = 5.0
[material.m]
density = 1000.0
normal_stiffness = 1e6
[[generate]]
in = { rectangle = { min = [0, 0], max = [1, 1] } }
material = "m"
grading = [{ radius = 0.05, count = 55 }]
PERIODIC
[history]
every = 10
columns = ["particle:1:x", "particle:55:y", "kinetic", "stress_11", "mean_force", "strain_11"]
[[stage]]
name = "press"
do = ["strain rate 0.29 0 0 0.29 over 100"]
max_cycles = 2000
[[stage]]
name = "shear"
do = ["strain rate -0.05 0 0 0.05"]
max_cycles = 300
"#;

fn write(folder: &Path, boundary: &str) {
    let periodic = if boundary.contains("[cell]") {
        format!("periodic = true\n{boundary}")
    } else {
        boundary.to_owned()
    };
    let sample = SAMPLE.replace("PERIODIC", &periodic);
    put(folder, "sample.toml", &sample);
    let (head, rest) = sample.split_once("[[generate]]").expect("it generates");
    let (_, tail) = rest.split_once("[history]").expect("it has a history");
    let (tail, stages) = tail.split_once("[[stage]]").expect("it has stages");
    let (_, shear) = stages.split_once("[[stage]]").expect("it has two");
    for keep in ["all", "particles"] {
        let start =
            format!("[start]\npreset = \"sample.toml\"\nstage = \"press\"\nkeep = \"{keep}\"");
        let text = format!("{head}{start}\n[history]{tail}[[stage]]{shear}");
        put(folder, &format!("{keep}.toml"), &text);
    }
}

/// Cells of one column, from a row on.
fn cells(table: &str, column: &str, from: usize, rows: usize) -> Vec<f64> {
    let number = |row| number(table, row, column);
    (from..from + rows).map(number).collect()
}

#[test]
fn every_boundary_comes_along() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    for boundary in [
        "[boundary]\nkind = \"circle\"\nradius = 0.45\ncentre = [0.5, 0.5]\n",
        "[cell]\nsize = [1, 1]\nlean = [0.1, 0]\n",
    ] {
        write(folder, boundary);
        run(folder, "sample.toml --csv whole.csv");
        let whole = text(folder, "whole.csv");
        run(folder, "all.toml --csv all.csv");
        let all = text(folder, "all.csv");
        for column in [
            "particle:1:x",
            "particle:55:y",
            "kinetic",
            "stress_11",
            "mean_force",
        ] {
            let there = cells(&whole, column, 200, 31);
            assert_eq!(cells(&all, column, 0, 31), there, "{boundary}{column}");
        }
        // Strain is counted from the start.
        assert_eq!(number(&all, 0, "strain_11"), 0.0);
        let strain = number(&whole, 230, "strain_11") - number(&whole, 200, "strain_11");
        let own = number(&all, 30, "strain_11");
        assert!((own / strain - 1.0).abs() < 1e-9, "{own} for {strain}");
        // At rest, without dashpots: the same places, the same elastic forces, the same boundary.
        run(folder, "particles.toml --csv rest.csv");
        let rest = text(folder, "rest.csv");
        for column in ["particle:1:x", "particle:55:y"] {
            let (here, there) = (number(&rest, 0, column), number(&whole, 200, column));
            assert_eq!(here, there, "{boundary}{column}");
        }
        assert_eq!(number(&rest, 0, "kinetic"), 0.0);
        assert!(
            number(&rest, 0, "mean_force") > 0.0,
            "{boundary}: pressed together"
        );
        assert!(
            number(&rest, 30, "strain_11") < 0.0,
            "{boundary}: it is sheared"
        );
        run(folder, "particles.toml --csv again.csv");
        assert_same(&bytes(folder, "again.csv"), rest.as_bytes(), boundary);
        fs::remove_dir_all(folder.join("cache")).expect("it is there");
    }
}
