//! What of a sample is kept: the whole state to the same bits, or particles at rest.

use std::path::Path;

use super::super::{assert_same, bytes, said, text};
use super::{ballast, number, put, run, states, write};

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
