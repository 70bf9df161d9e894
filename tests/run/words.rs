//! Words of the line and the variable for instructions: what is wrong is said before anything begins.

use std::path::Path;
use std::process::{Command, Output};

use super::said;

fn with_variable(folder: &Path, value: &str, words: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_ballast"))
        .args(words.split(' '))
        .env("BALLAST_ISA", value)
        .current_dir(folder)
        .output()
        .expect("the program starts")
}

#[test]
fn a_wrong_variable_stops_only_what_computes() {
    let folder = tempfile::tempdir().expect("a folder");
    for (value, words, status) in [
        ("", "run two-discs", 0),
        ("baseline", "run two-discs", 0),
        ("nonsense", "run two-discs", 2),
        ("nonsense", "run two-discs --isa baseline", 0),
        ("nonsense", "presets", 0),
        ("nonsense", "commands friction", 0),
    ] {
        let output = with_variable(folder.path(), value, words);
        let said = said(&output);
        assert_eq!(
            output.status.code(),
            Some(status),
            "{value}, {words}: {said}"
        );
        assert_eq!(said.contains("BALLAST_ISA"), status == 2, "{said}");
    }
}

#[test]
fn a_command_with_a_wrong_letter_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = super::ballast(folder.path(), &["runn", "disc-pile"]);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert!(said.contains("did you mean `ballast run`?"), "{said}");
}

#[test]
fn a_bench_looks_for_its_folder_first() {
    let folder = tempfile::tempdir().expect("a folder");
    let words = [
        "bench",
        "two-discs",
        "--csv",
        "none/x.csv",
        "--seconds",
        "3000",
    ];
    let output = super::ballast(folder.path(), &words);
    let said = said(&output);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("there is no folder `none`"), "{said}");
}
