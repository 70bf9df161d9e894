//! `[study]`: what `ballast study` varies and what it measures, unless told otherwise.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::phrase;
use super::place::{Place, quoted};
use super::problem::Problem;
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::contact::laws::LAWS;
use crate::language::{Expression, Mistake, Quantity};
use crate::measure::columns::nearest;

/// What a study varies and measures; what is empty is left to the study.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Study {
    /// Multiples of the time step (FRAC) to run with.
    pub frac: Vec<f64>,
    /// Contact laws to run with.
    pub law: Vec<String>,
    /// Other keys to vary; every combination is run.
    pub sweep: Vec<Sweep>,
    /// What errors are of.
    pub questions: Vec<Question>,
    /// The run that the others are compared with.
    pub reference: Option<Reference>,
    /// Largest error that is good enough.
    pub within: Option<f64>,
}

/// A key of the preset and the values it gets.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sweep {
    /// Dotted path, as in `--set`.
    pub path: String,
    /// Values, as written.
    pub values: Vec<String>,
}

/// What an error is of.
#[derive(Debug, Clone, PartialEq)]
pub enum Question {
    /// The course of a number over the rows of the history, and the text it was written as.
    Course(String, Expression),
    /// One number made of the rows, and the text it was written as.
    Number(String, Quantity),
    /// What the `[[answer]]`s of this name measure.
    Answered(String),
}

/// A run by its law and FRAC.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Reference {
    /// Contact law; `None`: the first.
    pub law: Option<String>,
    /// Multiple of the time step; `None`: the smallest.
    pub frac: Option<f64>,
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "study",
    shape: Shape::Single,
    required: false,
    summary: "what `ballast study` varies and measures; its options have the same names",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    key(
        "frac",
        Form::Numbers(Bounds::POSITIVE),
        "the preset's own, its half, quarter and eighth",
        "list of multiples of `time_step` to run with (FRAC)",
    ),
    key(
        "law",
        Form::Texts,
        "the preset's own",
        "list of contact laws to run with",
    ),
    key(
        "sweep",
        Form::Texts,
        "nothing else",
        "list of further keys to vary, \"PATH=VALUE,VALUE\"; every combination is run",
    ),
    key(
        "for",
        Form::Texts,
        "what is answered; else narrow expectations; else the columns",
        "list of what errors are of: columns, expressions, quantities such as last(kinetic), or \
         names of [[answer]]s",
    ),
    key(
        "reference",
        Form::Text,
        "\"LAW@FRAC\" of the first law and the smallest frac",
        "run that the others are compared with where no exact answer is known",
    ),
    key(
        "within",
        Form::Number(Bounds::POSITIVE),
        "nothing is marked",
        "error that is good enough: the fastest run within it is marked",
    ),
];

const fn key(name: &'static str, form: Form, absent: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form,
        unit: "-",
        absent: Absent::Said(absent),
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let texts = |name| reader.texts(name).unwrap_or_default().into_iter();
    let law = texts("law").filter_map(|(text, place)| law(reader, text, place));
    let sweep = texts("sweep").filter_map(|(text, place)| sweep(reader, text, place));
    let questions = texts("for").filter_map(|(text, place)| question(draft, text, place));
    let reference = reader.text("reference");
    let study = Study {
        frac: reader.numbers("frac").unwrap_or_default(),
        law: law.collect(),
        sweep: sweep.collect(),
        questions: questions.collect(),
        reference: reference.and_then(|(text, place)| reference_run(reader, text, place)),
        within: reader.number("within"),
    };
    draft.study = study;
}

fn law(reader: &Reader<'_>, text: &str, place: Place) -> Option<String> {
    let names = LAWS.iter().map(|law| law.name);
    if names.clone().any(|name| name == text) {
        return Some(text.to_owned());
    }
    reader.report.add(
        Problem::new(format!("there is no contact law {}", quoted(text)), place)
            .expected("expected the name of a law")
            .remedy(nearest(text, names)),
    );
    None
}

fn sweep(reader: &Reader<'_>, text: &str, place: Place) -> Option<Sweep> {
    let refuse = |message: String, remedy: &str| {
        reader.report.add(
            Problem::new(message, place)
                .expected("expected PATH=VALUE,VALUE")
                .remedy(remedy),
        );
        None
    };
    let example = "write for instance material.disc.friction=0.1,0.3";
    let Some((path, values)) = text.split_once('=') else {
        return refuse(format!("{} has no `=`", quoted(text)), example);
    };
    let path = path.trim();
    for (own, option) in [("model.frac", "frac"), ("model.law", "law")] {
        if path == own {
            let remedy = format!("list its values in `{option}`");
            return refuse(format!("`{own}` is varied by `{option}`"), &remedy);
        }
    }
    let values: Vec<String> = elements(values).map(str::to_owned).collect();
    if values.iter().any(String::is_empty) {
        return refuse(format!("a value of {} is missing", quoted(text)), example);
    }
    let path = path.to_owned();
    Some(Sweep { path, values })
}

/// A name of answers comes first; then whatever of the two the text can be read as.
fn question(draft: &Draft<'_>, text: &str, place: Place) -> Option<Question> {
    if draft.answers.iter().any(|answer| answer.to == text) {
        return Some(Question::Answered(text.to_owned()));
    }
    let defined = &draft.known.definitions;
    let parsed = (
        Quantity::parse_with(text, defined),
        Expression::parse_with(text, defined),
    );
    let read = match parsed {
        (Ok(quantity), _) => quantity
            .check(&draft.ever)
            .map(|()| Question::Number(text.to_owned(), quantity)),
        (_, Ok(course)) if course.is_condition() => Err(Mistake::new(
            "a condition has no error",
            "name a number: a column, an expression or a quantity such as last(kinetic)",
            0..text.len(),
        )),
        (_, Ok(course)) => course
            .check(&draft.ever)
            .map(|()| Question::Course(text.to_owned(), course)),
        // Whoever wrote an aggregate meant a quantity.
        (Err(quantity), Err(course)) => {
            let aggregates = ["last(", "mean(", "at("];
            let meant = aggregates.iter().any(|word| text.contains(word));
            Err(if meant { quantity } else { course })
        }
    };
    phrase::accept(draft.report, read, text, place)
}

/// `LAW@FRAC`, or one of the two.
fn reference_run(reader: &Reader<'_>, text: &str, place: Place) -> Option<Reference> {
    let (name, number) = match text.split_once('@') {
        Some((name, number)) => (name.trim(), Some(number.trim())),
        None if text.trim().parse::<f64>().is_ok() => ("", Some(text.trim())),
        None => (text.trim(), None),
    };
    let frac = match number.map(str::parse::<f64>) {
        None => None,
        Some(Ok(frac)) if Bounds::POSITIVE.contains(frac) => Some(frac),
        Some(_) => {
            reader.report.add(
                Problem::new(format!("{} names no run", quoted(text)), place)
                    .expected("expected LAW@FRAC with a number > 0")
                    .remedy("write for instance linear@0.01, or only the one or the other"),
            );
            return None;
        }
    };
    let law = match name {
        "" => None,
        name => Some(law(reader, name, place)?),
    };
    Some(Reference { law, frac })
}

/// The option of `ballast study` that an override stands for: its keys and options have the same
/// names.
pub(crate) fn option(set: &str) -> Option<String> {
    let (key, _) = set.strip_prefix("study.")?.split_once('=')?;
    let known = KEYS.iter().find(|known| known.name == key)?;
    Some(format!("--{}", known.name))
}

/// The parts of a text between commas that stand outside of brackets and quotes, without blanks
/// around them.
pub fn elements(text: &str) -> impl Iterator<Item = &str> {
    let (mut depth, mut quote) = (0usize, None);
    text.split(move |c| {
        match (quote, c) {
            (Some(open), _) if open == c => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, '(' | '[' | '{') => depth += 1,
            (None, ')' | ']' | '}') => depth = depth.saturating_sub(1),
            (None, ',') => return depth == 0,
            _ => {}
        }
        false
    })
    .map(str::trim)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn commas_inside_brackets_and_quotes_separate_nothing() {
        let parts: Vec<&str> = elements("max(a, b) , [0, 1],\"x,y\", {a=1,b=2} ,z").collect();
        assert_eq!(parts, ["max(a, b)", "[0, 1]", "\"x,y\"", "{a=1,b=2}", "z"]);
        assert_eq!(elements("").collect::<Vec<_>>(), [""]);
        assert_eq!(elements("a,").collect::<Vec<_>>(), ["a", ""]);
    }

    #[test]
    fn overrides_of_a_study_are_called_by_their_options() {
        assert_eq!(option("study.for=[\"x\"]").as_deref(), Some("--for"));
        assert_eq!(option("study.four=1"), None);
        assert_eq!(option("model.frac=1"), None);
    }
}
