//! The keys of `[[generate]]`.

use super::{distribution, lattice};
use crate::scene::key::{Absent, Bounds, COUNT_MAX, Form, Key};

pub(super) const KEYS: &[Key] = &[
    said(
        "name",
        Form::Text,
        "-",
        "none",
        "name in messages and paths of --set",
    ),
    said(
        "in",
        Form::Table(IN),
        "-",
        "required but for `import`",
        "where: one of the three",
    ),
    said(
        "material",
        Form::Text,
        "-",
        "required; of `import` if its file has no column for it",
        "name of the material",
    ),
    said(
        "grading",
        Form::Tables(GRADING),
        "-",
        SOURCE,
        "sizes that are placed at random without contacts, the largest first",
    ),
    said(
        "grading_file",
        Form::Text,
        "-",
        SOURCE,
        "the same from a CSV file beside the preset, with columns radius [m] and count",
    ),
    said(
        "distribution",
        Form::Table(distribution::KEYS),
        "-",
        SOURCE,
        "the same with radii drawn from a distribution",
    ),
    said(
        "lattice",
        Form::Word(lattice::KINDS),
        "-",
        SOURCE,
        "a regular arrangement, along the first axis; in a circle around its centre, else from the \
         lower left corner",
    ),
    said(
        "import",
        Form::Text,
        "-",
        SOURCE,
        "a CSV file beside the preset with columns x, y, radius and any of material, vx, vy, spin, \
         angle: what `export particles` writes",
    ),
    Key {
        absent: Absent::Word("file"),
        ..key(
            "order",
            Form::Word(&["file", "curve"]),
            "-",
            "how imported particles are numbered: in the order of the file, or along a curve on which \
             neighbours stay together, for many whose order in the file has nothing to do with their \
             places",
        )
    },
    Key {
        absent: Absent::Said("required for `lattice`"),
        ..key(
            "radius",
            RADIUS,
            "m",
            "radius of the particles of a lattice",
        )
    },
    said(
        "spacing",
        RADIUS,
        "m",
        "2 radius + gap",
        "distance of neighbours of a lattice: below 2 radius they overlap; circles of this diameter \
         lie wholly inside",
    ),
    Key {
        absent: Absent::Number(0.0),
        ..key(
            "gap",
            Form::Number(Bounds::NOT_NEGATIVE),
            "m",
            "least distance between surfaces, walls included",
        )
    },
    said(
        "tries",
        Form::Count(1, COUNT_MAX),
        "-",
        "until there is certainly no room",
        "failures in a row, anywhere in the region, after which a size no longer fits",
    ),
    Key {
        absent: Absent::Word("next"),
        ..key(
            "when_full",
            Form::Word(&["next", "stop"]),
            "-",
            "what follows when a size no longer fits: the next smaller one, or nothing, as before 1989",
        )
    },
    Key {
        absent: Absent::Flag(false),
        ..key(
            "exact",
            Form::Flag,
            "-",
            "whether it is an error if not all fit; else a notice",
        )
    },
    Key {
        absent: Absent::Flag(false),
        ..key(
            "periodic",
            Form::Flag,
            "-",
            "whether the rectangle is a periodic cell: its border is none",
        )
    },
    Key {
        absent: Absent::Zero,
        ..key(
            "velocity",
            Form::Vector,
            "m/s",
            "velocity of all at the start",
        )
    },
];

const SOURCE: &str = "one of the five is required";
const RADIUS: Form = Form::Number(Bounds::POSITIVE);

const IN: &[Key] = &[
    part("circle", Form::Table(CIRCLE), "a circle"),
    part(
        "rectangle",
        Form::Table(RECTANGLE),
        "a rectangle along the axes",
    ),
    part(
        "polygon",
        Form::Vectors,
        "the corners of a polygon whose sides do not cross",
    ),
];

const CIRCLE: &[Key] = &[
    key("centre", Form::Vector, "m", "its centre"),
    key("radius", Form::Number(Bounds::POSITIVE), "m", "its radius"),
];

const RECTANGLE: &[Key] = &[
    key("min", Form::Vector, "m", "its lower left corner"),
    key("max", Form::Vector, "m", "its upper right corner"),
];

const GRADING: &[Key] = &[
    key("radius", Form::Number(Bounds::POSITIVE), "m", "radius"),
    Key {
        absent: Absent::Said("as many as fit"),
        ..key("count", Form::Count(0, super::MOST), "-", "how many")
    },
];

const fn said(
    name: &'static str,
    form: Form,
    unit: &'static str,
    absent: &'static str,
    summary: &'static str,
) -> Key {
    Key {
        absent: Absent::Said(absent),
        ..key(name, form, unit, summary)
    }
}

const fn part(name: &'static str, form: Form, summary: &'static str) -> Key {
    Key {
        absent: Absent::Said("one of the three is required"),
        ..key(name, form, "-", summary)
    }
}

const fn key(name: &'static str, form: Form, unit: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form,
        unit,
        absent: Absent::Wrong,
        summary,
    }
}
