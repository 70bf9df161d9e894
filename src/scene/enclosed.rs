//! `[file.NAME]`: the text of a file that a preset names. A preset that was read takes the texts of
//! its files along in this form, so that journals and checkpoints need no other file.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::draft::Draft;
use super::key::{Absent, Form, Key};
use super::place::{Place, quoted};
use super::problem::Problem;
use super::reader::Reader;
use super::section::{Section, Shape};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "file",
    shape: Shape::Named,
    required: false,
    summary: "the text of a file that the preset names, instead of the file itself; journals and \
              checkpoints hold files so",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[Key {
    name: "text",
    form: Form::Text,
    unit: "-",
    absent: Absent::Wrong,
    summary: "all of it",
}];

/// Largest file that a preset may name [bytes]: some million particles.
const LARGEST: u64 = 256 << 20;

/// The texts of files by name.
#[derive(Debug, Default)]
pub(crate) struct Enclosed<'a> {
    /// Those in the preset.
    within: Vec<(&'a str, &'a str)>,
    /// Those that were read from files.
    taken: Vec<(String, String)>,
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    if let (Some(entry), Some((text, _))) = (reader.entry, reader.text("text")) {
        draft.enclosed.within.push((&entry.key, text));
    }
}

/// The text of the file of this name: from the preset, else from beside the preset.
pub(crate) fn text(draft: &mut Draft<'_>, name: &str, place: Place) -> Option<String> {
    let enclosed = &mut draft.enclosed;
    let within = enclosed.within.iter().find(|(known, _)| *known == name);
    let taken = enclosed.taken.iter().find(|(known, _)| known == name);
    let known = within.map(|(_, text)| (*text).to_owned());
    if let Some(text) = known.or_else(|| taken.map(|(_, text)| text.clone())) {
        return Some(text);
    }
    let preset = draft.report.sources.first().map(|source| &source.title);
    let folder = preset.and_then(|title| Path::new(title).parent());
    let path = folder.unwrap_or(Path::new("")).join(name);
    let refuse = |message: String, remedy: &str| {
        draft.report.add(
            Problem::new(message, place)
                .expected("expected a text file beside the preset")
                .remedy(remedy),
        );
    };
    let mut bytes = Vec::new();
    let read = File::open(&path).and_then(|file| {
        if file.metadata()?.is_dir() {
            return Err(std::io::ErrorKind::IsADirectory.into());
        }
        file.take(LARGEST + 1).read_to_end(&mut bytes)
    });
    if let Err(error) = read {
        let path = quoted(&path.display().to_string());
        refuse(
            format!("{path} cannot be read: {error}"),
            "give a path relative to the folder of the preset, or an absolute one",
        );
        return None;
    }
    if bytes.len() as u64 > LARGEST {
        let message = format!("{} is larger than {} MiB", quoted(name), LARGEST >> 20);
        refuse(message, "is this the right file?");
        return None;
    }
    let Ok(text) = String::from_utf8(bytes) else {
        refuse(
            format!("{} is not UTF-8 text", quoted(name)),
            "save it as UTF-8",
        );
        return None;
    };
    // Editors of other systems put a byte order mark in front, and TOML knows no lone carriage return.
    let text = text.trim_start_matches('\u{feff}').replace('\r', "");
    draft.enclosed.taken.push((name.to_owned(), text.clone()));
    Some(text)
}

/// The preset with the files that it named.
pub(crate) fn with_files(mut text: String, enclosed: &Enclosed<'_>) -> String {
    for (name, content) in &enclosed.taken {
        if !text.ends_with('\n') {
            text.push('\n');
        }
        text.push_str(&format!("\n[file.{}]\ntext = ", escaped(name)));
        let plain = |c: char| c == '\n' || c == '\t' || !c.is_control();
        if content.contains("'''") || content.ends_with('\'') || !content.chars().all(plain) {
            text.push_str(&escaped(content));
        } else {
            // The first line end after the quotes is no part of it.
            text.push_str("'''\n");
            text.push_str(content);
            text.push_str("'''");
        }
        text.push('\n');
    }
    text
}

/// As a basic string of TOML.
fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len() + 2);
    escaped.push('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => escaped.extend(['\\', c]),
            c if c.is_control() => escaped.push_str(&format!("\\u{:04X}", c as u32)),
            c => escaped.push(c),
        }
    }
    escaped.push('"');
    escaped
}
