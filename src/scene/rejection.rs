//! The report on a preset that cannot be used: every problem with its line, a caret, what was
//! expected and the remedy.

use std::fmt;

use annotate_snippets::{Annotation, AnnotationKind, Group, Level, Origin, Renderer, Snippet};

use super::place::{Place, Source};
use super::problem::{Problem, Report};

/// Why there is no scene. Its text is the whole report, for people.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Rejection {
    /// What it is about, for a problem without a place.
    title: String,
    sources: Vec<Source>,
    problems: Vec<Problem>,
    /// All that were found; a report keeps the first thousand.
    count: usize,
}

/// Problems shown: a reader mends these first and asks again.
const SHOWN: usize = 20;
/// Longest stretch of a line shown on each side of the caret [characters].
const REACH: usize = 120;

impl Rejection {
    /// A report on one problem.
    pub(crate) fn one(source: Source, problem: Problem) -> Self {
        Self {
            title: source.title.clone(),
            sources: vec![source],
            problems: vec![problem],
            count: 1,
        }
    }

    /// A report on all problems found, in the order of the text.
    pub(crate) fn all(report: Report) -> Self {
        let (sources, mut problems, count) = report.into_parts();
        // Stable: a problem that explains the next one was found first.
        problems.sort_by_key(|problem| problem.place.map(|place| (place.source, place.start)));
        Self {
            title: sources
                .first()
                .map_or_else(String::new, |s| s.title.clone()),
            sources,
            problems,
            count,
        }
    }

    /// How many problems were found.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The report, with colours for a terminal or without.
    pub fn render(&self, colour: bool) -> String {
        let renderer = if colour {
            Renderer::styled()
        } else {
            Renderer::plain()
        };
        let shown = self.problems.iter().take(SHOWN);
        let mut parts: Vec<String> = shown
            .map(|problem| renderer.render(&[self.group(problem)]))
            .collect();
        if self.count > SHOWN {
            parts.push(format!("... and {} more", self.count - SHOWN));
        }
        if self.count > 1 {
            parts.push(format!("{} errors in {}", self.count, self.title));
        }
        parts.join("\n\n")
    }

    fn group<'a>(&'a self, problem: &'a Problem) -> Group<'a> {
        let title = Level::ERROR.primary_title(problem.message.as_str());
        let help = Level::HELP.message(problem.remedy.as_str());
        let Some(place) = problem.place else {
            return title
                .element(Origin::path(self.title.as_str()))
                .element(help);
        };
        let mut group = Group::with_title(title);
        let label = AnnotationKind::Primary;
        group = self.point(group, place, label, problem.expected.as_str());
        if let Some((place, what)) = problem.also.as_deref() {
            group = self.point(group, *place, AnnotationKind::Primary, what);
        }
        group.element(help)
    }

    /// Adds the line of a place and the caret under it.
    fn point<'a>(
        &'a self,
        group: Group<'a>,
        place: Place,
        kind: AnnotationKind,
        label: &'a str,
    ) -> Group<'a> {
        let Some(source) = self.sources.get(place.source) else {
            return group;
        };
        let line = Line::around(&source.text, place);
        let caret: Annotation<'a> = kind.span(line.caret.clone());
        let caret = if label.is_empty() {
            caret
        } else {
            caret.label(label)
        };
        let snippet = Snippet::source(line.text)
            .line_start(line.number)
            .annotation(caret);
        let title = source.title.as_str();
        if line.cut {
            // The snippet would count columns from where the line was cut.
            let origin = Origin::path(title).line(line.number);
            return group
                .element(origin.char_column(line.column))
                .element(snippet);
        }
        group.element(snippet.path(title))
    }
}

/// The line a place is on, or the stretch of it that is worth showing: a line of noise may have
/// ten million characters.
struct Line {
    /// From 1.
    number: usize,
    /// Of the caret, in characters from 1.
    column: usize,
    /// The line, or the stretch around the caret.
    text: String,
    /// Whether `text` leaves out the beginning of the line.
    cut: bool,
    /// The caret's stretch within `text` [bytes].
    caret: std::ops::Range<usize>,
}

impl Line {
    fn around(text: &str, place: Place) -> Self {
        let start = floor(text, place.start);
        let before = &text[..start];
        let number = before.bytes().filter(|&byte| byte == b'\n').count() + 1;
        let first = before.rfind('\n').map_or(0, |at| at + 1);
        let rest = &text[start..];
        let last = start + rest.find('\n').unwrap_or(rest.len());
        let last = first.max(first + text[first..last].trim_end_matches('\r').len());
        let start = start.min(last);
        let column = text[first..start].chars().count() + 1;
        let end = floor(text, place.end).clamp(start, last);

        let left = text[first..start]
            .char_indices()
            .rev()
            .nth(REACH)
            .map_or(first, |(at, _)| first + at);
        let right = text[start..last]
            .char_indices()
            .nth(REACH)
            .map_or(last, |(at, _)| start + at);
        let cut_left = if left > first { "... " } else { "" };
        let cut_right = if right < last { " ..." } else { "" };
        let shift = left - cut_left.len().min(left);
        let shown = format!("{cut_left}{}{cut_right}", &text[left..right]);
        Self {
            number,
            column,
            text: shown,
            cut: left > first,
            caret: start - shift..end.min(right) - shift,
        }
    }
}

/// The nearest character boundary at or before a position.
fn floor(text: &str, at: usize) -> usize {
    let mut at = at.min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

impl fmt::Display for Rejection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.render(false))
    }
}

impl std::error::Error for Rejection {}

#[cfg(test)]
mod tests {
    use super::*;

    fn rejection(text: &str, span: std::ops::Range<usize>) -> Rejection {
        let source = Source {
            title: "nine.toml".into(),
            text: text.into(),
        };
        let problem = Problem::new("something is wrong", Place::new(0, span))
            .expected("expected number > 0")
            .remedy("mend it");
        Rejection::one(source, problem)
    }

    #[test]
    fn the_caret_stands_under_the_place() {
        let text = "[model]\r\n# µ µ\r\nfrac = -0.2 # µ\r\n";
        let at = text.find("-0.2").unwrap();
        let shown = rejection(text, at..at + 4).to_string();
        insta::assert_snapshot!(shown, @r"
        error: something is wrong
         --> nine.toml:3:8
          |
        3 | frac = -0.2 # µ
          |        ^^^^ expected number > 0
          |
          = help: mend it
        ");
    }

    #[test]
    fn a_long_line_is_cut_around_the_caret() {
        let text = format!(
            "a = 1\n{}!!{}",
            "x".repeat(1_000_000),
            "y".repeat(1_000_000)
        );
        let shown = rejection(&text, 1_000_006..1_000_008).to_string();
        assert!(shown.contains("nine.toml:2:1000001"), "{shown}");
        assert!(shown.contains("!!"), "{shown}");
        assert!(shown.len() < 2000, "{shown}");
    }

    #[test]
    fn any_place_can_be_shown() {
        let text = "é = 1\n\n\u{1b}x\n";
        for start in 0..=text.len() + 2 {
            for end in start..=text.len() + 2 {
                let shown = rejection(text, start..end).to_string();
                assert!(shown.contains("nine.toml:"), "{shown}");
                assert!(!shown.contains('\u{1b}'), "{shown}");
            }
        }
    }
}
