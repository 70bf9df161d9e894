//! The text of a preset: an embedded one by name, or a file that can be trusted to be text of a
//! sensible size.

use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use super::Origin;
use super::catalogue::{self, PRESETS};
use super::place::{Place, Source, quoted};
use super::problem::Problem;
use super::rejection::Rejection;
use crate::measure::columns::near;

/// Largest preset [bytes]: more than a hundred thousand particles. Reading takes up to fifty times
/// as much memory, so that a larger one would be felt.
const LARGEST: u64 = 16 << 20;

/// The text that a name on the command line stands for. An embedded name comes first, so that it
/// means the same in every folder; a file of that name is meant by `./NAME`.
pub(crate) fn open(name: &str) -> Result<(Origin, String), Rejection> {
    if let Some(preset) = catalogue::find(name) {
        return Ok((Origin::Embedded(name.to_owned()), preset.text.to_owned()));
    }
    let path = Path::new(name);
    let mut bytes = Vec::new();
    // NOTE: never trust the size that a device or a pipe claims to have.
    let read = File::open(path).and_then(|file| {
        if file.metadata()?.is_dir() {
            return Err(std::io::ErrorKind::IsADirectory.into());
        }
        file.take(LARGEST + 1).read_to_end(&mut bytes)
    });
    let refuse = |problem: Problem, text: String| {
        let title = name.to_owned();
        Rejection::one(Source { title, text }, problem)
    };
    if let Err(error) = read {
        return Err(refuse(unreadable(name, &error), String::new()));
    }
    if bytes.len() as u64 > LARGEST {
        let message = format!("the preset is larger than {} MiB", LARGEST >> 20);
        let problem = Problem::nowhere(message).remedy(
            "is this the right file? A preset lists walls, materials and particles as text",
        );
        return Err(refuse(problem, String::new()));
    }
    let text = String::from_utf8(bytes).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
        let problem = Problem::new("the preset is not UTF-8 text", Place::new(0, at..at + 3))
            .expected("this is no character")
            .remedy("save it as UTF-8; if it is not a preset at all, name another file");
        refuse(problem, text)
    })?;
    Ok((Origin::File(path.to_owned()), text))
}

fn unreadable(name: &str, error: &std::io::Error) -> Problem {
    use std::io::ErrorKind;
    let problem = |message: String| Problem::nowhere(message);
    match error.kind() {
        ErrorKind::NotFound | ErrorKind::NotADirectory => {
            let path = Path::new(name);
            let journal = path.with_extension("journal");
            if path.extension().is_some_and(|ending| ending == "ballast") {
                return problem(format!("there is no file {}", quoted(name))).remedy(
                    if journal.exists() {
                        format!(
                            "{} is there: ballast run replays it",
                            quoted(&journal.display().to_string())
                        )
                    } else {
                        "a run keeps its state a minute after it has begun, and at its end".into()
                    },
                );
            }
            problem(format!("there is no preset {}", quoted(name))).remedy(suggestion(name))
        }
        ErrorKind::IsADirectory => problem(format!("{} is a folder", quoted(name))).remedy(
            format!("name a preset in it; {}", suggestion(&format!("{name}/x"))),
        ),
        _ => problem(format!("{} cannot be read: {error}", quoted(name)))
            .remedy("check its permissions, or copy it to where it can be read"),
    }
}

/// Near names among the embedded presets and the files beside the wrong one.
fn suggestion(name: &str) -> String {
    let path = Path::new(name);
    let folder = match path.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let embedded: Vec<String> = PRESETS
        .iter()
        .map(|preset| preset.name.to_owned())
        .collect();
    // A folder may hold a million files; the first thousand presets are enough to guess from.
    let files = fs::read_dir(folder)
        .into_iter()
        .flatten()
        .take(10_000)
        .flatten()
        .map(|file| file.path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "toml"))
        .take(1000);
    let files: Vec<String> = files
        .map(|path| {
            path.strip_prefix("./")
                .unwrap_or(&path)
                .display()
                .to_string()
        })
        .collect();
    if let Some(name) = near(name, files.iter().chain(&embedded).map(String::as_str)) {
        return format!("did you mean `{name}`?");
    }
    let files = match files.as_slice() {
        [] => String::new(),
        few if few.len() <= 5 => format!("; files here: {}", few.join(", ")),
        many => format!("; files here: {}, ...", many[..5].join(", ")),
    };
    format!("embedded presets: {}{files}", embedded.join(", "))
}

/// Refuses a text that no parser has to look at.
pub(crate) fn check_text(text: &str) -> Option<Problem> {
    if text.trim().is_empty() {
        return Some(
            Problem::new("the preset is empty", Place::new(0, 0..0))
                .expected("expected [model], a [material.NAME] and a [[particle]]")
                .remedy("`ballast show two-discs` prints a preset to start from"),
        );
    }
    let unprintable = |c: char| c.is_control() && !matches!(c, '\n' | '\r' | '\t');
    let at = text.find(unprintable)?;
    let c = text[at..].chars().next()?;
    Some(
        Problem::new(
            format!("the preset holds the control character U+{:04X}", c as u32),
            Place::new(0, at..at + c.len_utf8()),
        )
        .expected("this cannot be in a TOML text")
        .remedy("delete it; if the file is not a preset at all, name another file"),
    )
}
