//! Rules for the tree of files and for what is said about it.

use std::collections::BTreeSet;

use crate::text::{find, is_rust};

/// What no file mentions: places that exist on one machine only. In pieces, for this file is read
/// like any other.
const PRIVATE_PLACES: [&str; 3] = [
    concat!("../", "shared"),
    concat!("/wo", "rk/"),
    concat!(".lib", "rary/"),
];

/// Names that say nothing about what is inside.
const VAGUE: [&str; 8] = [
    "utils", "util", "helpers", "common", "misc", "manager", "types", "base",
];

pub(crate) fn private_places(path: &str, text: &str) -> Vec<String> {
    let found = find(text, &PRIVATE_PLACES).into_iter();
    found
        .map(|(line, place)| format!("{path}:{line}: `{place}` exists on one machine only"))
        .collect()
}

pub(crate) fn module_files(files: &[String]) -> Vec<String> {
    let mut complaints = Vec::new();
    let folders: BTreeSet<&str> = files
        .iter()
        .filter(|path| is_rust(path))
        .filter_map(|path| Some(path.rsplit_once('/')?.0))
        .filter(|folder| *folder != "src")
        .collect();
    for folder in folders {
        if !files.contains(&format!("{folder}/mod.rs")) {
            complaints.push(format!(
                "{folder}: has no mod.rs, where a reader looks for the contract of the folder"
            ));
        }
        if files.contains(&format!("{folder}.rs")) {
            complaints.push(format!(
                "{folder}.rs: belongs into {folder}/mod.rs: there is one way to lay out modules"
            ));
        }
    }
    for path in files {
        let mut nouns = path.trim_end_matches(".rs").split('/');
        if let Some(noun) = nouns.find(|noun| VAGUE.contains(noun)) {
            complaints.push(format!(
                "{path}: `{noun}` could hold anything: name it after what it holds"
            ));
        }
    }
    complaints
}

pub(crate) fn named_paths(readme: &str, text: &str, files: &[String]) -> Vec<String> {
    let roots = ["src/", "tests/", "data/", "presets/", "benches/"];
    // Line by line, so that a mark without its partner spoils one line only.
    let quoted = text
        .lines()
        .flat_map(|line| line.split('`').skip(1).step_by(2));
    quoted
        .filter(|name| roots.iter().any(|root| name.starts_with(root)))
        .filter(|name| !name.contains(|c: char| c.is_whitespace() || "*<{".contains(c)))
        .filter(|name| {
            let folder = format!("{}/", name.trim_end_matches('/'));
            let mut files = files.iter();
            !files.any(|file| file == name || file.starts_with(&folder))
        })
        .map(|name| {
            format!("{readme}: `{name}` does not exist: a description must not outlive its object")
        })
        .collect()
}

/// Presets are the first cells, in backticks, of tables under a heading that says so.
pub(crate) fn named_presets(readme: &str, text: &str, files: &[String]) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut under_presets = false;
    for line in text.lines() {
        if line.starts_with('#') {
            under_presets = line.to_lowercase().contains("preset");
        }
        let cell = line.strip_prefix("| `").filter(|_| under_presets);
        let Some((name, _)) = cell.and_then(|cell| cell.split_once('`')) else {
            continue;
        };
        let file = format!("/{name}.toml");
        let mut presets = files.iter().filter(|path| path.starts_with("presets/"));
        if !presets.any(|path| path.ends_with(&file)) {
            complaints.push(format!(
                "{readme}: there is no preset `{name}`: whoever tries it must find it"
            ));
        }
    }
    complaints
}

pub(crate) fn described(description: &str, files: &[String]) -> Vec<String> {
    let names = files.iter().map(|path| path.trim_start_matches("data/"));
    names
        .filter(|name| *name != "README.md" && !description.contains(&format!("`{name}`")))
        .map(|name| {
            format!("data/{name}: data/README.md must say what it is, in what units, and whence")
        })
        .collect()
}

#[cfg(test)]
fn list(files: &[&str]) -> Vec<String> {
    files.iter().map(|&file| file.to_owned()).collect()
}

#[test]
fn private_places_bite() {
    for place in PRIVATE_PLACES {
        let text = format!("first line\nsee {place}/x");
        assert_eq!(private_places("README.md", &text).len(), 1, "{text}");
    }
    assert!(private_places("README.md", "shared work in a library").is_empty());
}

#[test]
fn module_files_bite() {
    let good = ["src/lib.rs", "src/a/mod.rs", "src/a/b.rs", "src/main.rs"];
    assert!(module_files(&list(&good)).is_empty());
    for (bad, hint) in [
        (["src/a/b.rs", "src/a/c.rs"], "no mod.rs"),
        (["src/a.rs", "src/a/mod.rs"], "belongs into"),
        (["src/a/mod.rs", "src/a/utils.rs"], "anything"),
        (["src/helpers/mod.rs", "src/main.rs"], "anything"),
    ] {
        let complaints = module_files(&list(&bad));
        assert_eq!(complaints.len(), 1, "{complaints:?}");
        assert!(complaints[0].contains(hint), "{complaints:?}");
    }
}

#[test]
fn named_paths_bite() {
    let files = list(&["src/engine/step.rs", "src/lib.rs"]);
    let good =
        "`src/engine/step.rs`, `src/engine`, `src/engine/`, `src/*.rs`, src/gone.rs, `cargo`";
    assert!(named_paths("README.md", good, &files).is_empty());
    for bad in [
        "`src/engine/stop.rs`",
        "an odd `\n`src/eng`",
        "`tests/gone.rs`",
    ] {
        assert_eq!(named_paths("README.md", bad, &files).len(), 1, "{bad}");
    }
}

#[test]
fn named_presets_bite() {
    let files = list(&["presets/two-discs.toml", "presets/flow/hopper.toml"]);
    let table =
        |heading: &str, name: &str| format!("## {heading}\n\n| name |\n|---|\n| `{name}` |\n");
    for name in ["two-discs", "hopper"] {
        assert!(named_presets("README.md", &table("Presets", name), &files).is_empty());
    }
    assert!(named_presets("README.md", &table("Commands", "go"), &files).is_empty());
    let bad = table("The presets", "discs");
    assert_eq!(named_presets("README.md", &bad, &files).len(), 1);
}

#[test]
fn described_bites() {
    let files = list(&["data/README.md", "data/reference/a.csv"]);
    assert!(described("| `reference/a.csv` |", &files).is_empty());
    assert_eq!(described("reference", &files).len(), 1);
}
