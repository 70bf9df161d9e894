//! Columns that a preset makes itself: in histories, conditions and expectations, resumed, replayed.

use std::fs;
use std::path::Path;

use ballast::scene::Scene;
use ballast::session::{Budget, Options, Replay, Session};

use super::{assert_same, ballast, bytes, run, said, text};

/// The pile of the embedded preset, with columns of its own.
fn preset() -> String {
    let pile = ballast::scene::catalogue::find("disc-pile").expect("it is there");
    let (bodies, _) = pile.text.split_once("[history]").expect("it has a history");
    bodies.to_owned()
        + r#"
        [history]
        every = 50
        columns = ["Share", "kinetic", "per_disc"]
        [history.define]
        total = "kinetic + rotational"
        share = "kinetic / total - 1"
        per_disc = "total / 105 + 0 * stage_cycle + friction_loss * 0"
        [[stage]]
        name = "fall"
        until = "per_disc > 1e-3 or cycle >= 800"
        check_every = 7
        [[stage]]
        name = "on"
        max_cycles = 300
        [[expect]]
        what = "max(share) + min(total)"
        value = 0
        within = 1e9
        "#
}

fn with_preset() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("p.toml"), preset()).expect("it can be written");
    folder
}

fn cells(row: &str) -> Vec<f64> {
    let cells = row.split(',').skip(3);
    cells.map(|cell| cell.parse().expect("a number")).collect()
}

#[test]
fn defined_columns_are_columns() {
    let folder = with_preset();
    let folder: &Path = folder.path();
    run(folder, "p.toml --csv whole.csv");
    let whole = text(folder, "whole.csv");
    let mut rows = whole.lines();
    assert_eq!(rows.next(), Some("cycle,time,stage,share,kinetic,per_disc"));
    let mut fell = false;
    for row in rows {
        let [share, kinetic, per_disc] = cells(row)[..] else {
            panic!("three columns: {row}");
        };
        // 0/0 before anything moves; losses are booked because the definition reads them.
        assert_eq!(share.is_nan(), kinetic == 0.0, "{row}");
        assert!(
            kinetic == 0.0 || (per_disc * 105.0 * (1.0 + share) - kinetic).abs() < 1e-12 * kinetic
        );
        fell |= row.contains(",fall,") && per_disc > 1e-3;
    }
    assert!(fell, "the stage ends by its condition:\n{whole}");
    let verified = ballast(folder, &["verify", "p.toml"]);
    assert_eq!(verified.status.code(), Some(0), "{}", said(&verified));
    for cycle in [0, 49, 50, 301] {
        run(folder, &format!("p.toml --csv part.csv --cycles {cycle}"));
        run(folder, "--resume part.ballast --csv part.csv");
        assert_same(&bytes(folder, "part.csv"), whole.as_bytes(), "resumed");
    }
    run(folder, "whole.journal --csv again.csv");
    assert_same(&bytes(folder, "again.csv"), whole.as_bytes(), "replayed");
    // On the command line too.
    let set = "p.toml --csv set.csv --cycles 50 --set history.define.share=kinetic*2";
    run(folder, &format!("{set} --set history.define.more=share+1"));
    let row = text(folder, "set.csv");
    let [share, kinetic, _] = cells(row.lines().last().expect("a row"))[..] else {
        panic!("three columns: {row}");
    };
    assert_eq!(share, 2.0 * kinetic);
}

#[test]
fn a_prompt_knows_them() {
    let scene = || Scene::parse("p", &preset(), &[]).expect("it is sound");
    let mut session = Session::open(scene(), Options::default()).expect("it opens");
    for line in [
        "history columns per_disc,SHARE",
        "solve until total > 1e-4 max 500",
        "cycle 20",
    ] {
        session.type_line(line).expect(line);
        session.advance(Budget::default(), false).expect(line);
    }
    assert_eq!(session.recording().names(), ["per_disc", "share"]);
    assert!(session.world().cycle_number() < 520);
    let refusal = session
        .type_line("history columns totl")
        .expect_err("no such column");
    assert!(
        refusal.to_string().contains("did you mean `total`?"),
        "{refusal}"
    );
    let completion = ballast::language::complete::complete("history columns per", &session.known());
    assert_eq!(completion.candidates, ["per_disc"]);
    session.finish().expect("it ends");
    // The journal holds the name of the column, and the condition in full.
    let journal = session.journal().clone();
    let text = journal.to_string();
    assert!(text.contains("history columns per_disc,share"), "{text}");
    assert!(
        text.contains("solve until kinetic + rotational > 0.0001 max 500"),
        "{text}"
    );
    let mut replay = Replay::new(&journal, &scene());
    replay.check().expect("every line can be read");
    assert!(replay.changes_columns());
    let mut again = Session::open(scene(), Options::default()).expect("it opens");
    again
        .advance_replay(&mut replay, Budget::default())
        .expect("it runs");
    again.finish().expect("it ends");
    assert_eq!(again.world().state_hash(), session.world().state_hash());
    assert_eq!(again.recording().names(), session.recording().names());
    assert_eq!(again.recording().rows(), session.recording().rows());
}
