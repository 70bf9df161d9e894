//! Dumps: the same files however a run is cut up, and what stands in them.

use std::fs;
use std::path::Path;

use ballast::scene::catalogue;

use super::{assert_same, ballast, bytes, names, run, said, text};

/// The pile of the embedded preset with dumps.
fn preset() -> String {
    let pile = catalogue::find("disc-pile").expect("it is there");
    let (bodies, _) = pile.text.split_once("[history]").expect("it has a history");
    bodies.to_owned()
        + r#"
        [history]
        every = 50
        columns = ["contacts", "kinetic", "max_force", "mean_force"]
        [dump]
        every = 40
        what = ["particles", "contacts"]
        [[stage]]
        name = "fall"
        max_cycles = 90
        [[stage]]
        name = "nothing"
        do = ["zero"]
        until = "cycle > 0"
        [[stage]]
        name = "on"
        max_cycles = 60
        "#
}

/// Names of the dumps in a folder.
fn dumps(folder: &Path) -> Vec<String> {
    let mut names = names(folder);
    names.retain(|name| name.contains(".particles.") || name.contains(".contacts."));
    names
}

#[test]
fn dumps_are_the_same_however_a_run_is_cut_up() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), preset()).expect("it can be written");
    run(folder, "p.toml --csv whole.csv");
    // Cycle 0, multiples, and the ends of stages: the stage of no cycles ends where one has ended.
    let cycles = [0, 40, 80, 90, 120, 150];
    let expected = |stem: &str| -> Vec<String> {
        let of = |what: &str| cycles.map(|cycle| format!("{stem}.{what}.{cycle:010}.csv"));
        [of("contacts"), of("particles")].concat()
    };
    assert_eq!(dumps(folder), expected("whole"));
    for cycle in [0, 39, 40, 90, 119] {
        run(folder, &format!("p.toml --csv part.csv --cycles {cycle}"));
        run(folder, "--resume part.ballast --csv part.csv --threads 2");
        for (a, b) in expected("part").iter().zip(expected("whole")) {
            assert_same(&bytes(folder, a), &bytes(folder, &b), a);
            fs::remove_file(folder.join(a)).expect("it is there");
        }
    }
    run(folder, "whole.journal --csv again.csv");
    for (a, b) in expected("again").iter().zip(expected("whole")) {
        assert_same(&bytes(folder, a), &bytes(folder, &b), a);
    }
    // Where the history goes to no file, they stand in the current folder under the preset's name.
    run(folder, "p.toml --csv - --cycles 40");
    assert!(folder.join("p.particles.0000000040.csv").exists());
    assert!(!folder.join("p.particles.0000000080.csv").exists());
    // Before and after: velocities at the end of the first stage are not yet zero.
    let kinetic = text(folder, "whole.particles.0000000090.csv");
    assert!(kinetic.lines().skip(1).any(|row| cell(row, 6) != 0.0));
    let report = ballast(folder, &["check", "p.toml"]);
    let report = String::from_utf8_lossy(&report.stdout).into_owned();
    let line = "p.particles.CYCLE.csv and p.contacts.CYCLE.csv every 40 cycles";
    assert!(report.contains(line), "{report}");
    // Whoever measures only writes nothing.
    let before = names(folder);
    let verified = ballast(folder, &["verify", "p.toml"]);
    assert_eq!(names(folder), before, "{}", said(&verified));
}

#[test]
fn a_dump_that_failed_is_made_good() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), preset()).expect("it can be written");
    run(folder, "p.toml --csv whole.csv");
    // One that every so many cycles asks for, the end of a stage, and that of the run.
    for cycle in [40, 90, 150] {
        let blocked = format!("part.particles.{cycle:010}.csv");
        fs::create_dir(folder.join(&blocked)).expect("a folder in its way");
        let failed = ballast(folder, &["run", "p.toml", "--csv", "part.csv"]);
        assert!(!failed.status.success(), "{}", said(&failed));
        fs::remove_dir(folder.join(&blocked)).expect("it is there");
        run(folder, "--resume part.ballast --csv part.csv");
        let whole: Vec<String> = dumps(folder)
            .into_iter()
            .filter(|name| name.starts_with("whole"))
            .collect();
        assert_eq!(whole.len(), 12);
        for name in whole {
            let part = name.replace("whole", "part");
            assert_same(&bytes(folder, &part), &bytes(folder, &name), &part);
            fs::remove_file(folder.join(part)).expect("it is there");
        }
    }
}

fn cell(row: &str, k: usize) -> f64 {
    let cell = row.split(',').nth(k).expect("a cell");
    cell.parse().expect("a number")
}

#[test]
fn dumps_hold_what_histories_count() {
    let folder = tempfile::tempdir().expect("a folder");
    let folder = folder.path();
    fs::write(folder.join("p.toml"), preset()).expect("it can be written");
    run(
        folder,
        "p.toml --csv whole.csv --set dump.every=50 --set stage.on.max_cycles=4000",
    );
    let history = text(folder, "whole.csv");
    let mut seen = 0.0;
    for row in history.lines().skip(1) {
        let cycle = cell(row, 0);
        let table = |what: &str| {
            let text = text(folder, &format!("whole.{what}.{cycle:010}.csv"));
            text.lines().skip(1).map(str::to_owned).collect::<Vec<_>>()
        };
        let particles = table("particles");
        assert_eq!(particles.len(), 105);
        let ends: f64 = particles.iter().map(|row| cell(row, 12)).sum();
        let contacts = table("contacts");
        let pressing: Vec<&String> = contacts.iter().filter(|row| cell(row, 6) > 0.0).collect();
        assert_eq!(pressing.len() as f64, cell(row, 3), "cycle {cycle}");
        let number = |row: &str| {
            row.split(',')
                .nth(1)
                .expect("a cell")
                .parse::<u32>()
                .is_ok()
        };
        let at_walls = pressing.iter().filter(|row| !number(row)).count();
        assert_eq!(ends, 2.0 * pressing.len() as f64 - at_walls as f64);
        let force = |row: &&String| {
            let (n, t) = (cell(row, 6), cell(row, 7));
            (n * n + t * t).sqrt()
        };
        let most = pressing.iter().map(force).fold(0.0, f64::max);
        assert_eq!(most, cell(row, 5), "cycle {cycle}");
        seen += most;
        for row in &contacts {
            let (n1, n2) = (cell(row, 4), cell(row, 5));
            assert!((n1 * n1 + n2 * n2 - 1.0).abs() < 1e-15, "{row}");
            assert!(cell(row, 8) > 0.0 && cell(row, 11) > 0.0, "{row}");
        }
    }
    assert!(seen > 0.0, "something must have touched");
}
