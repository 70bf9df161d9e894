//! Forces along prescribed paths: the reference files and the closed forms of Mindlin & Deresiewicz.

use std::fs;

use crate::{FRICTION, Rig, overlap_at, reference};

/// Rows of a reference file as text.
pub(crate) fn rows(name: &str) -> Vec<csv::StringRecord> {
    let text = fs::read_to_string(format!("data/reference/{name}.csv")).expect("the file is there");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map(|row| row.expect("a row")).collect()
}

pub(crate) fn number(row: &csv::StringRecord, k: usize) -> f64 {
    row[k].parse().expect("a number")
}

#[test]
fn histories_of_both_forces() {
    let mut rig = Rig::new(reference());
    let (mut name, mut worst) = (String::new(), [0.0_f64; 2]);
    for row in rows("md_varying_normal") {
        if row[0] != *name {
            name = row[0].to_owned();
            rig = Rig::new(reference());
            continue;
        }
        rig.to(number(&row, 2), number(&row, 3));
        let error = (rig.force - number(&row, 5)).abs() / (FRICTION * number(&row, 4));
        if error > worst[0] {
            eprintln!("{name} {} {error}", &row[1]);
        }
        worst[0] = worst[0].max(error);
    }
    eprintln!("{worst:?}");
}

#[test]
fn constant() {
    let mut rig = Rig::new(reference());
    rig.to(overlap_at(88.0), 0.0);
    let mut worst = 0.0_f64;
    for row in rows("md_constant_normal") {
        rig.to(rig.at[0], number(&row, 4));
        let error = (rig.force - number(&row, 2)).abs() / (FRICTION * 88.0);
        if error > worst {
            eprintln!("{} {} {error}", &row[0], &row[1]);
        }
        worst = worst.max(error);
    }
    eprintln!("{worst:?} {} {} {}", rig.work, rig.lost, rig.energy());
}
