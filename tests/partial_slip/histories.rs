//! Forces along prescribed paths: the reference files and the closed forms of Mindlin & Deresiewicz.

use std::fs;

use crate::rig::{Pair, Rig};

/// Rows of a reference file as text.
pub(crate) fn rows(name: &str) -> Vec<csv::StringRecord> {
    let text = fs::read_to_string(format!("data/reference/{name}.csv")).expect("the file is there");
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map(|row| row.expect("a row")).collect()
}

pub(crate) fn number(row: &csv::StringRecord, k: usize) -> f64 {
    row[k].parse().expect("a number")
}

/// Seven histories of both forces: T and the slip annulus. None of them slides.
#[test]
fn both_forces_vary() {
    let pair = Pair::reference();
    let mut rig = Rig::new(pair.law());
    let (mut name, mut vanished) = (String::new(), 0);
    for row in rows("md_varying_normal") {
        let [alpha, delta, load, force, ratio, path] = [2, 3, 4, 5, 6, 7].map(|k| number(&row, k));
        if row[0] != *name {
            name = row[0].to_owned();
            rig = Rig::new(pair.law());
            continue;
        }
        let place = format!("{name}, leg {} at {alpha}, {delta}", &row[1]);
        assert_eq!(rig.to(alpha, delta), path > 0.0, "{place}");
        // The file is printed to 12 digits.
        let error = (rig.force - force).abs() / (pair.friction * load);
        assert!(error < 2e-11, "{place}: {}", rig.force);
        let is_right = (rig.stick_ratio() - ratio).abs() < 1e-9;
        vanished += usize::from(!is_right && ratio == 1.0);
        assert!(is_right || ratio == 1.0, "{place}: {}", rig.stick_ratio());
    }
    // R_down and RU_down end just when their slip annulus vanishes and an older one inside becomes
    // the edge.
    assert!(vanished <= 2, "{vanished}");
}

/// Straight lines need no more than one step each.
#[test]
fn corners_in_one_step_each() {
    let pair = Pair::reference();
    let mut rig = Rig::new(pair.law());
    let mut name = String::new();
    for row in rows("md_varying_normal_knots") {
        let [alpha, delta, load, force] = [2, 3, 4, 5].map(|k| number(&row, k));
        if row[0] != *name {
            name = row[0].to_owned();
            rig = Rig::new(pair.law());
        }
        rig.to(alpha * pair.overlap(), delta * pair.star());
        let error = (rig.force - force).abs() / (pair.friction * load);
        // The file is printed to 11 digits.
        assert!(error < 1e-11, "{row:?}: {}", rig.force);
    }
}

#[test]
fn constant_normal_force() {
    let pair = Pair::reference();
    let mut rig = Rig::loaded(&pair);
    for row in rows("md_constant_normal") {
        rig.to(rig.at[0], number(&row, 4));
        let error = (rig.force - number(&row, 2)).abs();
        assert!(error < 1e-14 * pair.limit(), "{row:?}: {}", rig.force);
    }
}

/// T/(μN) of virgin loading at δ/δ*, (3.53) of Randall 1989.
fn virgin(x: f64) -> f64 {
    1.0 - (1.0 - x).powf(1.5)
}

/// δ/δ* of virgin loading at T/(μN).
fn displacement(t: f64) -> f64 {
    1.0 - (1.0 - t).powf(2.0 / 3.0)
}

/// Pairs of other sizes, materials, friction and loads.
fn pairs() -> [Pair; 4] {
    [
        Pair::reference(),
        Pair::spheres(0.001, 70e9, 0.2, 0.12, 3.0),
        Pair::spheres(0.25, 5e6, 0.49, 1.4, 40.0),
        Pair::spheres(2e-5, 1e9, 0.0, 0.05, 1e-6),
    ]
}

/// Load, unload, reload and load beyond, in steps of no special size.
#[test]
fn curves_of_mindlin_and_deresiewicz() {
    for pair in pairs() {
        let (star, limit) = (pair.star(), pair.limit());
        let holds = |rig: &Rig, t: f64, place: &str| {
            let error = rig.force / limit - t;
            assert!(
                error.abs() < 1e-12,
                "{place}: {} for {t}",
                rig.force / limit
            );
        };
        for turn in [0.1, 0.5, 0.75, 0.9, 0.999] {
            let top = displacement(turn);
            // Back to T** from the other side, from 0, and from this side.
            for back in [-turn, -0.3 * turn, 0.0, 0.4 * turn] {
                let mut rig = Rig::loaded(&pair);
                for k in 1..=7 {
                    let x = top * f64::from(k) / 7.0;
                    rig.to(rig.at[0], x * star);
                    holds(&rig, virgin(x), "load");
                }
                let bottom = top - 2.0 * displacement(0.5 * (turn - back));
                for k in 1..=7 {
                    let x = top + (bottom - top) * f64::from(k) / 7.0;
                    rig.to(rig.at[0], x * star);
                    holds(&rig, turn - 2.0 * virgin(0.5 * (top - x)), "unload");
                }
                holds(&rig, back, "turn");
                for k in 1..=7 {
                    let x = bottom + (top - bottom) * f64::from(k) / 7.0;
                    rig.to(rig.at[0], x * star);
                    holds(&rig, back + 2.0 * virgin(0.5 * (x - bottom)), "reload");
                }
                // The loop is closed: nothing of it is left.
                for k in 1..=7 {
                    let x = top + (1.0 - top) * f64::from(k) / 7.0;
                    rig.to(rig.at[0], x * star);
                    holds(&rig, virgin(x), "virgin again");
                }
                assert_eq!(rig.memory.len(), 1, "slid through");
            }
        }
    }
}

/// The numbers of the textbook example: 88 N.
#[test]
fn the_example() {
    let pair = Pair::reference();
    for (x, force) in [(0.25, 9.2527), (0.5, 17.0662), (0.75, 23.1), (0.9, 25.5652)] {
        let mut rig = Rig::loaded(&pair);
        rig.to(rig.at[0], x * pair.star());
        assert!((rig.force - force).abs() < 6e-5, "{}", rig.force);
    }
    for (turn, reached, left) in [
        (0.5, 0.54321, 0.030_832),
        (0.75, 0.8854, 0.095_651),
        (0.9, 1.1517, 0.18662),
    ] {
        let mut rig = Rig::loaded(&pair);
        let top = displacement(turn) * pair.star();
        assert!((top * 1e6 - reached).abs() < 6e-5, "{top}");
        rig.to(rig.at[0], top);
        rig.to(rig.at[0], left * 1e-6);
        // The displacement is given to 5 digits, the stiffness is 8 G* a there.
        assert!(rig.force.abs() < 1e-5 * pair.limit(), "{}", rig.force);
        rig.to(rig.at[0], -top);
        assert!((rig.force / pair.limit() + turn).abs() < 1e-14);
    }
}
