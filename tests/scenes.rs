//! Presets that are right and presets that are wrong: the corpus in `data/scenes`.
//!
//! A file holds several presets between lines `+++`. In `bad`, lines that begin with `#^ ` say what
//! the report on the preset above has to contain; lines that begin with `#+ ` are options `--set`.

use std::fs;

use ballast::scene::{Scene, catalogue};

/// One preset of a corpus file.
struct Case {
    name: String,
    text: String,
    overrides: Vec<String>,
    fragments: Vec<String>,
}

fn corpus(folder: &str) -> Vec<Case> {
    let folder = format!("{}/data/scenes/{folder}", env!("CARGO_MANIFEST_DIR"));
    let mut cases = Vec::new();
    for file in fs::read_dir(&folder).expect("the corpus can be read") {
        let path = file.expect("the corpus can be read").path();
        let text = fs::read_to_string(&path).expect("the corpus can be read");
        let stem = path.file_stem().expect("the corpus can be read").to_str().expect("the corpus can be read");
        for (k, part) in text.split("+++\n").enumerate() {
            let starting = |mark: &str| -> Vec<String> {
                part.lines()
                    .filter_map(|line| line.strip_prefix(mark))
                    .map(str::to_owned)
                    .collect()
            };
            cases.push(Case {
                name: format!("{stem} {}", k + 1),
                text: part
                    .lines()
                    .filter(|line| !line.starts_with("#^ ") && !line.starts_with("#+ "))
                    .map(|line| format!("{line}\n"))
                    .collect(),
                overrides: starting("#+ "),
                fragments: starting("#^ "),
            });
        }
    }
    cases
}

/// Whether a line of the report names a place: `name:LINE:COLUMN`.
fn names_a_place(report: &str) -> bool {
    report.lines().any(|line| {
        let mut numbers = line.rsplit(':').map(|part| part.trim().parse::<usize>());
        line.trim_start().starts_with("--> ")
            && matches!(numbers.next(), Some(Ok(1..)))
            && matches!(numbers.next(), Some(Ok(1..)))
    })
}

#[test]
fn good_presets_are_accepted() {
    let cases = corpus("good");
    assert!(cases.len() >= 5);
    for case in cases {
        if let Err(rejection) = Scene::parse(&case.name, &case.text, &case.overrides) {
            panic!("{}:\n{rejection}", case.name);
        }
    }
}

#[test]
fn wrong_presets_are_refused_with_place_reason_and_remedy() {
    let cases = corpus("bad");
    assert!(cases.len() >= 60, "{} cases", cases.len());
    let mut failures = Vec::new();
    for case in cases {
        assert!(!case.fragments.is_empty(), "{} expects nothing", case.name);
        let Err(rejection) = Scene::parse("p.toml", &case.text, &case.overrides) else {
            failures.push(format!("{} was accepted", case.name));
            continue;
        };
        let report = rejection.to_string();
        let remedies = report.matches("= help: ").count();
        let mut missing: Vec<&str> = case
            .fragments
            .iter()
            .map(String::as_str)
            .filter(|fragment| !report.contains(fragment))
            .collect();
        if !names_a_place(&report) {
            missing.push("(a line and a column)");
        }
        if remedies != rejection.count().min(20) {
            missing.push("(a remedy for each problem)");
        }
        if !missing.is_empty() {
            failures.push(format!("{}: no {missing:?} in\n{report}", case.name));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}

#[test]
fn embedded_presets_are_accepted() {
    for preset in catalogue::PRESETS {
        if let Err(rejection) = Scene::load(preset.name, &[]) {
            panic!("{rejection}");
        }
    }
}
