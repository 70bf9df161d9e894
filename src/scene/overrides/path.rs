//! The path of an override: parts between full stops, up to the `=`.

use crate::scene::place::{Place, Source, quoted};
use crate::scene::problem::Problem;

/// A part of a path.
pub(super) struct Part {
    /// Without quotes.
    pub(super) text: String,
    /// Where it stands in the option.
    pub(super) place: Place,
}

/// The parts before the `=` and the byte after it.
pub(super) fn parts(source: &Source, index: usize) -> Result<(Vec<Part>, usize), Problem> {
    let text = &source.text;
    let whole = Place::new(index, 0..text.len());
    let mut parts = Vec::new();
    let mut start = 0;
    let mut quote = None;
    for (at, c) in text.char_indices() {
        match (quote, c) {
            (Some(open), _) if open == c => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, '.' | '=') => {
                parts.push(part(source, index, start, at)?);
                start = at + 1;
                if c == '=' {
                    return Ok((parts, start));
                }
            }
            _ => {}
        }
    }
    Err(Problem::new("the option has no `=`", whole)
        .expected("expected PATH=VALUE")
        .remedy("write for instance --set model.frac=0.2"))
}

fn part(source: &Source, index: usize, start: usize, end: usize) -> Result<Part, Problem> {
    let written = &source.text[start..end];
    let text = written.trim();
    let place = Place::new(index, start..end);
    let bare = |text: &str| {
        !text.is_empty()
            && text
                .chars()
                .all(|c| c.is_alphanumeric() || c == '_' || c == '-')
    };
    let inner = text
        .strip_prefix('"')
        .and_then(|rest| rest.strip_suffix('"'))
        .or_else(|| {
            text.strip_prefix('\'')
                .and_then(|rest| rest.strip_suffix('\''))
        });
    match inner {
        Some(inner) => Ok(Part {
            text: inner.to_owned(),
            place,
        }),
        None if bare(text) => Ok(Part {
            text: text.to_owned(),
            place,
        }),
        None => Err(
            Problem::new(format!("{} is no part of a path", quoted(text)), place)
                .expected("expected a name or a number")
                .remedy("write for instance --set material.glass.friction=0.5"),
        ),
    }
}
