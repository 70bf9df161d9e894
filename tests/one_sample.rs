//! One sample under every law (`laws-compared`): how little the tangential law matters to slow shear.
//!
//! The sample itself is one of many, and any change of last bits makes another; so laws are held to each
//! other, not to numbers.
#![expect(
    clippy::unwrap_used,
    reason = "a test that cannot go on has failed; its panic says where"
)]

use std::path::Path;
use std::process::Command;

/// sin Φ at deviator strains of 0.05, 0.1 and 0.2 %, and the mean stress at the last [Pa].
fn sheared(law: &str, cache: &Path) -> [f64; 4] {
    let set = format!("model.law=\"{law}\"");
    let done = Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(["run", "laws-compared", "--csv", "-", "-q", "--set", &set])
        .env("XDG_CACHE_HOME", cache)
        .current_dir(cache)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert!(done.status.success(), "{law}: {said}");
    let mut rows = csv::Reader::from_reader(done.stdout.as_slice());
    let names = rows.headers().unwrap().clone();
    let rows: Vec<csv::StringRecord> = rows.records().map(Result::unwrap).collect();
    let at = |strain: f64, column: &str| {
        let place = |name: &str| names.iter().position(|other| other == name).unwrap();
        let number = |row: &csv::StringRecord, name: &str| row[place(name)].parse::<f64>();
        let sheared = |row: &&csv::StringRecord| {
            &row[place("stage")] == "shear"
                && number(row, "deviator_strain").is_ok_and(|reached| reached >= strain)
        };
        number(rows.iter().find(sheared).unwrap(), column).unwrap()
    };
    [
        at(0.0005, "sin_phi"),
        at(0.001, "sin_phi"),
        at(0.002, "sin_phi"),
        at(0.002, "isotropic_stress"),
    ]
}

#[test]
fn tangential_laws_agree_on_one_sample() {
    let cache = tempfile::tempdir().unwrap();
    let exact = sheared("mindlin-deresiewicz-exact", cache.path());
    for law in ["mindlin-deresiewicz", "hertz-mindlin"] {
        let other = sheared(law, cache.path());
        for (a, b) in exact.iter().zip(other).take(3) {
            // Twice what README says that no tangential law moves it by.
            assert!((a - b).abs() < 0.001, "{law}: {exact:?} {other:?}");
        }
        assert!(
            (exact[3] / other[3] - 1.0).abs() < 0.005,
            "{law}: {exact:?} {other:?}"
        );
    }
    // That they could differ: without friction the sample has no strength to speak of.
    let smooth = sheared("hertz", cache.path());
    assert!(smooth[2] < 0.5 * exact[2], "{smooth:?} {exact:?}");
}
