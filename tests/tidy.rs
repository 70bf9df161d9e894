//! Rules of the house that the compiler does not check. Each rule is a function over the path and
//! the text of a file that returns complaints with their reason, and is shown to bite beside it.

#[path = "tidy/code_rules.rs"]
mod code_rules;
#[path = "tidy/file_rules.rs"]
mod file_rules;
#[path = "tidy/text.rs"]
mod text;

use std::fs;
use std::path::Path;

fn hold(complaints: impl Iterator<Item = String>) {
    let complaints: Vec<String> = complaints.collect();
    assert!(complaints.is_empty(), "\n{}\n", complaints.join("\n"));
}

/// All files below a folder, by their path from the root of the project, in order.
fn files_below(folder: &str) -> Vec<String> {
    let mut files = Vec::new();
    let mut folders = vec![Path::new(folder).to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let name = entry.file_name();
            if entry.path().is_dir() {
                if name != "target" && name != ".git" {
                    folders.push(entry.path());
                }
            } else if name != ".git" {
                let path = entry.path().to_string_lossy().replace('\\', "/");
                files.push(path.trim_start_matches("./").to_owned());
            }
        }
    }
    files.sort();
    files
}

/// The text of a file; nothing when it is missing or no text.
fn read(path: &str) -> Option<String> {
    fs::read_to_string(path).ok()
}

#[test]
fn every_rust_file_is_tidy() {
    let mut files = files_below("src");
    files.extend(files_below("tests"));
    files.retain(|path| text::is_rust(path));
    assert!(files.len() > 5, "the rules must see the sources: {files:?}");
    hold(files.iter().flat_map(|path| {
        let text = read(path).expect("a Rust file is text");
        code_rules::all(path, &text)
    }));
}

#[test]
fn no_file_mentions_a_private_place() {
    let files = files_below(".");
    assert!(files.iter().any(|path| path == "Cargo.toml"), "{files:?}");
    let texts = files.iter().filter_map(|path| Some((path, read(path)?)));
    hold(texts.flat_map(|(path, text)| file_rules::private_places(path, &text)));
}

#[test]
fn folders_are_modules_with_a_mod_file() {
    hold(file_rules::module_files(&files_below("src")).into_iter());
}

#[test]
fn descriptions_name_only_what_exists() {
    let files = files_below(".");
    hold(["README.md", "data/README.md"].iter().flat_map(|readme| {
        let text = read(readme).expect(readme);
        let mut complaints = file_rules::named_paths(readme, &text, &files);
        complaints.extend(file_rules::named_presets(readme, &text, &files));
        complaints
    }));
}

#[test]
fn every_data_file_is_described() {
    let description = read("data/README.md").expect("data/README.md is there");
    hold(file_rules::described(&description, &files_below("data")).into_iter());
}
