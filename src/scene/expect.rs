//! `[[expect]]`: what a run must give, and who says so.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::phrase;
use super::reader::Reader;
use super::section::{Section, Shape};
use super::seeds::Seeds;
use crate::language::Quantity;

/// A number that a run must reproduce.
#[derive(Debug, Clone, PartialEq)]
pub struct Expect {
    /// Rows of this stage are measured; `None`: all rows.
    pub stage: Option<String>,
    /// What is measured.
    pub what: Quantity,
    /// `what` as written in the preset.
    pub text: String,
    /// The mean over these seeds is measured; `None`: the run of the preset's own seed.
    pub seeds: Option<Seeds>,
    /// The number, in the units of `what`.
    pub value: f64,
    /// How far from it a run may be.
    pub within: Band,
    /// Where the number comes from.
    pub source: String,
    /// Why the source's number is not reproduced, if it is not.
    pub differs: Option<Differs>,
}

/// How far from a number a result may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Band {
    /// By this much, in the units of the number.
    Absolute(f64),
    /// By this fraction of the number's magnitude.
    Relative(f64),
}

/// What a run gives instead of the source's number.
#[derive(Debug, Clone, PartialEq)]
pub struct Differs {
    /// Why.
    pub reason: String,
    /// Our own number, in the units of what is measured.
    pub ours: f64,
    /// How far from our own number a run may be.
    pub within: Band,
}

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "expect",
    shape: Shape::Listed,
    required: false,
    summary: "a number that a run must reproduce: `ballast verify` compares",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        form: Form::Text,
        ..number(
            "stage",
            Absent::Said("all rows"),
            "stage whose rows are measured",
        )
    },
    Key {
        form: Form::Text,
        ..number(
            "what",
            Absent::Wrong,
            "quantity that is measured, such as max(kinetic)",
        )
    },
    Key {
        form: Form::Text,
        ..number(
            "seeds",
            Absent::Said("the seed of the preset"),
            "seeds, \"1..10\" for 1 to 10, whose mean of `what` is compared",
        )
    },
    Key {
        form: Form::Number(Bounds::FINITE),
        ..number("value", Absent::Wrong, "number that is expected")
    },
    number(
        "within",
        Absent::Said("required, or within_rel"),
        "accepted difference from `value`",
    ),
    number(
        "within_rel",
        Absent::Said("required, or within"),
        "accepted difference from `value` as a fraction of it",
    ),
    Key {
        form: Form::Text,
        ..number("source", Absent::Said("empty"), "origin of the number")
    },
    Key {
        form: Form::Text,
        ..number(
            "differs",
            Absent::Said("the value is reproduced"),
            "reason why the source's number is not reproduced; needs `ours`",
        )
    },
    Key {
        form: Form::Number(Bounds::FINITE),
        ..number("ours", Absent::Said("not used"), "number found instead")
    },
    number(
        "ours_within",
        Absent::Said("required with `ours`, or ours_within_rel"),
        "accepted difference from `ours`",
    ),
    number(
        "ours_within_rel",
        Absent::Said("required with `ours`, or ours_within"),
        "accepted difference from `ours` as a fraction of it",
    ),
];

const fn number(name: &'static str, absent: Absent, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Number(Bounds::NOT_NEGATIVE),
        unit: "-",
        absent,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let what = reader.text("what").and_then(|(text, place)| {
        let parsed = Quantity::parse_with(text, &draft.known.definitions);
        let what = phrase::accept(reader.report, parsed, text, place)?;
        let checked = what.check(&draft.ever);
        phrase::accept(reader.report, checked, text, place).map(|()| (what, text))
    });
    let seeds = seeds(reader);
    let value = reader.number("value");
    let within = band(reader, "within", "within_rel", value);
    let differs = differs(reader);
    let source = reader.text("source").map(|(text, _)| text.to_owned());
    let stage = stage(reader, draft);
    let (Some((what, text)), Some(value), Some(within)) = (what, value, within) else {
        return;
    };
    draft.expects.push(Expect {
        stage,
        what,
        text: text.to_owned(),
        seeds,
        value,
        within,
        source: source.unwrap_or_default(),
        differs,
    });
}

fn stage(reader: &Reader<'_>, draft: &Draft<'_>) -> Option<String> {
    let (name, place) = reader.text("stage")?;
    draft.check_stage(name, place);
    Some(name.to_owned())
}

fn seeds(reader: &Reader<'_>) -> Option<Seeds> {
    let (text, _) = reader.text("seeds")?;
    let seeds = text.parse::<Seeds>();
    seeds
        .map_err(|why| {
            reader.refuse(
                "seeds",
                &format!("`seeds` of {} is no range of seeds", reader.title),
                &why,
                "write seeds = \"1..10\" for the ten seeds from 1 to 10",
            );
        })
        .ok()
}

fn band(
    reader: &Reader<'_>,
    absolute: &'static str,
    relative: &'static str,
    value: Option<f64>,
) -> Option<Band> {
    let bands = (reader.number(absolute), reader.number(relative));
    let band = match reader.one_of(&[absolute, relative]) {
        Some(name) if name == relative => bands.1.map(Band::Relative),
        Some(_) => bands.0.map(Band::Absolute),
        None => {
            reader.refuse(
                absolute,
                &format!("{} has no `{absolute}`", reader.title),
                &format!("`{absolute}` is missing here"),
                &format!("add {absolute} = accepted difference, or {relative} = as a fraction"),
            );
            None
        }
    };
    if let (Some(Band::Relative(_)), Some(0.0)) = (band, value) {
        reader.refuse(
            relative,
            &format!("a fraction of zero accepts nothing in {}", reader.title),
            "a fraction of the expected 0",
            &format!("write {absolute} = accepted difference"),
        );
    }
    band
}

fn differs(reader: &Reader<'_>) -> Option<Differs> {
    let (reason, ours) = (reader.text("differs"), reader.number("ours"));
    let own = ["ours", "ours_within", "ours_within_rel"];
    if reader.has("differs") {
        if !reader.has("ours") {
            reader.refuse(
                "differs",
                &format!("{} differs, but not from what", reader.title),
                "`ours` is missing",
                "add ours = the number that comes out, with ours_within",
            );
            return None;
        }
        let within = band(reader, "ours_within", "ours_within_rel", ours)?;
        return Some(Differs {
            reason: reason?.0.to_owned(),
            ours: ours?,
            within,
        });
    }
    for name in own.into_iter().filter(|name| reader.has(name)) {
        reader.number(name);
        reader.refuse(
            name,
            &format!("`{name}` of {} needs a reason", reader.title),
            "without `differs`",
            "add differs = \"why the source's number is not reproduced\"",
        );
    }
    None
}
