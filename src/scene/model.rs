//! `[model]`: law, body, time step and what acts everywhere.

use super::draft::{Draft, Mark};
use super::gravity;
use super::key::{Absent, Bounds, Form, Key};
use super::reader::{Reader, WordOrNumber};
use super::section::{Section, Shape};
use crate::engine::auto_step::USUAL_SHARE;
use crate::engine::contact::laws;
use crate::engine::setup::{Body, LawChoice, NormalForm, TimeStepChoice, Unloading};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "model",
    shape: Shape::Single,
    required: true,
    summary: "law, body, time step and gravity",
    keys: KEYS,
    read,
};

/// Contact laws by name.
const LAW_NAMES: &[&str] = &laws::NAMES;

const KEYS: &[Key] = &[
    Key {
        name: "law",
        form: Form::Word(LAW_NAMES),
        unit: "-",
        absent: Absent::Said("\"mindlin-deresiewicz-exact\" for spheres, \"linear\" for discs"),
        summary: "contact law",
    },
    Key {
        name: "normal",
        form: Form::Word(&["total", "incremental"]),
        unit: "-",
        absent: Absent::Word("total"),
        summary: "normal force from the overlap itself, or summed from increments as in 1979",
    },
    Key {
        name: "unloading",
        form: Form::Word(&["rescale", "keep"]),
        unit: "-",
        absent: Absent::Word("rescale"),
        summary: "what the shear force of hertz-mindlin does while the normal force falls: it falls \
                  with the contact radius, or stays (and can gain energy)",
    },
    Key {
        name: "nodes",
        form: Form::Count(4, 64),
        unit: "-",
        absent: Absent::Count(16),
        summary: "most nodes in the memory of a contact with exact partial slip",
    },
    Key {
        name: "body",
        form: Form::Word(&["sphere", "disc"]),
        unit: "-",
        absent: Absent::Word("sphere"),
        summary: "kind of particle: a sphere with its centre in the plane, or a disc of unit length",
    },
    Key {
        name: "time_step",
        form: Form::WordOrNumber(
            &["rayleigh", "rayleigh-exact", "critical"],
            Bounds::POSITIVE,
        ),
        unit: "s",
        absent: Absent::Said("\"critical\" for discs with the linear law, else \"rayleigh\""),
        summary: "step that `frac` multiplies; a number is in seconds",
    },
    Key {
        name: "frac",
        form: Form::WordOrNumber(&["auto"], Bounds::POSITIVE),
        unit: "-",
        absent: Absent::Said("0.1; 1 if time_step is a number"),
        summary: "multiple of `time_step` that is used (FRAC), or \"auto\": half of the stability bound",
    },
    Key {
        name: "seed",
        form: Form::Count(0, u64::MAX),
        unit: "-",
        absent: Absent::Count(1),
        summary: "seed of everything random",
    },
    Key {
        name: "rotation",
        form: Form::Flag,
        unit: "-",
        absent: Absent::Flag(true),
        summary: "whether particles can turn",
    },
    gravity::KEY,
    Key {
        name: "overlap",
        form: Form::Word(&["refuse", "allow"]),
        unit: "-",
        absent: Absent::Word("refuse"),
        summary: "what happens to overlaps at the start above 5 % of the smaller radius",
    },
    Key {
        name: "fracc_every",
        form: Form::Count(1, u32::MAX as u64),
        unit: "cycles",
        absent: Absent::Count(1),
        summary: "number of cycles between evaluations of FRACC",
    },
    Key {
        name: "tol",
        form: Form::Number(Bounds::POSITIVE),
        unit: "m",
        absent: Absent::Said(
            "a tenth of the smallest radius, then what motion makes best, where there are many as wide as motion there asks",
        ),
        summary: "gap within which a pair is listed as neighbours (TOL)",
    },
];

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let body = match reader.word("body") {
        Some("disc") => Body::Disc,
        _ => Body::Sphere,
    };
    let law = law(reader, body);
    let given = reader.has("time_step").then(|| time_step(reader)).flatten();
    let setup = &mut draft.setup;
    setup.body = body;
    setup.normal = match reader.word("normal") {
        Some("incremental") => NormalForm::Incremental,
        _ => NormalForm::Total,
    };
    setup.unloading = match reader.word("unloading") {
        Some("keep") => Unloading::Keep,
        _ => Unloading::Rescale,
    };
    setup.nodes = reader.count("nodes").unwrap_or_default() as u8;
    if law == Some(LawChoice::exact()) && setup.normal == NormalForm::Incremental {
        reader.refuse(
            "normal",
            "normal = \"incremental\" contradicts the exact law of partial slip",
            "its memory belongs to the overlap, not to a sum of increments",
            "leave `normal` out, or write law = \"mindlin-deresiewicz\", which ran that way in 1989",
        );
    }
    if law.is_some_and(LawChoice::has_bonds) && setup.normal == NormalForm::Incremental {
        reader.refuse(
            "normal",
            "normal = \"incremental\" contradicts the law with bonds",
            "a bond is at rest where its particles just touch, whatever was summed",
            "leave `normal` out, or write law = \"linear\"",
        );
    }
    setup.time_step = given.unwrap_or(match (body, law) {
        (Body::Disc, Some(law)) if law.has_constant_springs() => TimeStepChoice::Critical,
        _ => TimeStepChoice::Rayleigh,
    });
    if given == Some(TimeStepChoice::Critical)
        && let Some(law) = law
        && !law.has_constant_springs()
    {
        let name = law.card().name;
        reader.refuse(
            "time_step",
            &format!("time_step = \"critical\" needs constant springs, and {name} has none"),
            "the stiffness of these contacts follows the load",
            "write time_step = \"rayleigh\", or frac = \"auto\" to follow the stability bound",
        );
    }
    let frac = reader.word_or_number("frac");
    setup.frac_auto = matches!(frac, Some(WordOrNumber::Word(_))).then_some(USUAL_SHARE);
    setup.frac = match (frac, setup.time_step) {
        (Some(WordOrNumber::Number(frac)), _) => frac,
        (_, TimeStepChoice::Seconds(_)) => 1.0,
        _ => 0.1,
    };
    setup.rotation = reader.flag("rotation").unwrap_or_default();
    setup.gravity = gravity::read(reader);
    setup.overlap_allowed = reader.word("overlap") == Some("allow");
    setup.fracc_every = reader
        .count("fracc_every")
        .and_then(|every| u32::try_from(every).ok())
        .unwrap_or_default();
    setup.tol = reader.number("tol");
    draft.seed = reader.count("seed").unwrap_or_default();
    draft.own_seed = reader.has("seed").then_some(draft.seed);
    draft.model = Mark {
        place: reader.place_of("time_step"),
        // What a wrong law or step would need is not known.
        sound: law.is_some() && (given.is_some() || !reader.has("time_step")),
    };
    if let Some(law) = law {
        setup.law = law;
    }
}

fn law(reader: &Reader<'_>, body: Body) -> Option<LawChoice> {
    match (reader.has("law"), body) {
        (true, _) => LawChoice::named(reader.word("law")?),
        // Which default is meant is not known.
        (false, _) if reader.has("body") && reader.word("body").is_none() => None,
        (false, Body::Disc) => Some(LawChoice::linear()),
        (false, Body::Sphere) => Some(LawChoice::exact()),
    }
}

fn time_step(reader: &Reader<'_>) -> Option<TimeStepChoice> {
    match reader.word_or_number("time_step")? {
        WordOrNumber::Word("rayleigh") => Some(TimeStepChoice::Rayleigh),
        WordOrNumber::Word("rayleigh-exact") => Some(TimeStepChoice::RayleighExact),
        WordOrNumber::Word(_) => Some(TimeStepChoice::Critical),
        WordOrNumber::Number(seconds) => Some(TimeStepChoice::Seconds(seconds)),
    }
}
