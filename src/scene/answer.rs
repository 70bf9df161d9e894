//! `[[answer]]`: the exact answer of a problem, which a study measures its errors against.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::phrase;
use super::place::Place;
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::language::Quantity;

/// Numbers that a run would give if it made no error.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// The question it answers; answers to one question are judged together.
    pub to: String,
    /// Rows of this stage are measured; `None`: all rows.
    pub stage: Option<String>,
    /// What is measured and what is exact: the components of one vector, in one unit.
    pub parts: Vec<(Quantity, f64)>,
    /// Errors are taken relative to this, in the unit of the parts.
    pub scale: f64,
    /// Where the answer comes from.
    pub source: String,
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "answer",
    shape: Shape::Listed,
    required: false,
    summary: "numbers that an exact run would give: `ballast study` measures errors against them",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    key(
        "to",
        Form::Text,
        Absent::Wrong,
        "question it answers; the error of a question is the root mean square over its answers",
    ),
    key(
        "stage",
        Form::Text,
        Absent::Said("all rows"),
        "stage whose rows are measured",
    ),
    key(
        "what",
        Form::Texts,
        Absent::Wrong,
        "list of quantities that are measured, the components of one vector",
    ),
    key(
        "value",
        Form::Numbers(Bounds::FINITE),
        Absent::Wrong,
        "list of their exact values",
    ),
    key(
        "scale",
        Form::Number(Bounds::POSITIVE),
        Absent::Said("the magnitude of `value`"),
        "number that the error is divided by",
    ),
    key(
        "source",
        Form::Text,
        Absent::Said("empty"),
        "origin of the numbers",
    ),
];

const fn key(name: &'static str, form: Form, absent: Absent, summary: &'static str) -> Key {
    Key {
        name,
        form,
        unit: "-",
        absent,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let to = reader.text("to").map(|(text, _)| text.to_owned());
    let stage = reader.text("stage");
    if let Some((name, place)) = stage {
        draft.check_stage(name, place);
    }
    let what = quantities(reader, draft);
    let value = reader.numbers("value");
    let scale = reader.number("scale");
    let source = reader.text("source").map(|(text, _)| text.to_owned());
    let (Some(to), Some(what), Some(value)) = (to, what, value) else {
        return;
    };
    if what.len() != value.len() || what.is_empty() {
        let (given, wanted) = (value.len(), what.len());
        reader.refuse(
            "value",
            &format!(
                "{} has {given} values for {wanted} quantities",
                reader.title
            ),
            "expected one number for each element of `what`",
            "give as many numbers as quantities, at least one",
        );
        return;
    }
    let magnitude = value.iter().map(|x| x * x).sum::<f64>().sqrt();
    if scale.is_none() && magnitude == 0.0 {
        reader.refuse(
            "value",
            &format!("{} has nothing to compare its error with", reader.title),
            "the exact answer is zero",
            "add scale = the size that an error is measured by, such as the speed at the start",
        );
        return;
    }
    draft.answers.push(Answer {
        to,
        stage: stage.map(|(name, _)| name.to_owned()),
        parts: what.into_iter().zip(value).collect(),
        scale: scale.unwrap_or(magnitude),
        source: source.unwrap_or_default(),
    });
}

/// The quantities of `what`, if all of them are.
fn quantities(reader: &Reader<'_>, draft: &Draft<'_>) -> Option<Vec<Quantity>> {
    let texts = reader.texts("what")?;
    let all: Vec<Option<Quantity>> = texts
        .into_iter()
        .map(|(text, place)| quantity(draft, text, place))
        .collect();
    all.into_iter().collect()
}

fn quantity(draft: &Draft<'_>, text: &str, place: Place) -> Option<Quantity> {
    let parsed = Quantity::parse_with(text, &draft.known.definitions);
    let what = phrase::accept(draft.report, parsed, text, place)?;
    let checked = what.check(&draft.ever);
    phrase::accept(draft.report, checked, text, place).map(|()| what)
}
