//! The keys of `[[generate]]`.

use crate::scene::key::{Absent, Bounds, COUNT_MAX, Form, Key};

pub(super) const KEYS: &[Key] = &[
    Key {
        absent: Absent::Said("none"),
        ..key(
            "name",
            Form::Text,
            "-",
            "name in messages and paths of --set",
        )
    },
    key("in", Form::Table(IN), "-", "where: one of the three"),
    key("material", Form::Text, "-", "name of the material"),
    Key {
        absent: Absent::Said("required: what is placed"),
        ..key(
            "grading",
            Form::Tables(GRADING),
            "-",
            "sizes that are placed at random without contacts, the largest first",
        )
    },
    Key {
        form: Form::Number(Bounds::NOT_NEGATIVE),
        absent: Absent::Number(0.0),
        ..key(
            "gap",
            Form::Flag,
            "m",
            "least distance between surfaces, walls included",
        )
    },
    Key {
        absent: Absent::Said("until there is certainly no room"),
        ..key(
            "tries",
            Form::Count(1, COUNT_MAX),
            "-",
            "failures in a row, anywhere in the region, after which a size no longer fits",
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
