//! `model.gravity`: a vector, or a point that everything falls towards.

use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use crate::engine::setup::Gravity;

/// The declaration.
pub(crate) const KEY: Key = Key {
    name: "gravity",
    form: Form::VectorOrTable(TOWARDS),
    unit: "m/s^2",
    absent: Absent::Said("none"),
    summary: "acceleration of every free particle: the same everywhere, or towards a point",
};

const TOWARDS: &[Key] = &[
    Key {
        name: "towards",
        form: Form::Vector,
        unit: "m",
        absent: Absent::Wrong,
        summary: "point that gravity points to",
    },
    Key {
        name: "g",
        form: Form::Number(Bounds::NOT_NEGATIVE),
        unit: "m/s^2",
        absent: Absent::Wrong,
        summary: "magnitude, the same at any distance",
    },
];

/// Gravity, if there is any.
pub(crate) fn read(reader: &Reader<'_>) -> Option<Gravity> {
    if let Some(table) = reader.table(KEY.name) {
        let (towards, g) = (table.vector("towards"), table.number("g"));
        return Some(Gravity::Centripetal {
            towards: towards?,
            g: g?,
        });
    }
    // No gravity and gravity of zero are the same physics; the engine need not add zeros.
    reader
        .vector(KEY.name)
        .filter(|g| *g != [0.0; 2])
        .map(Gravity::Uniform)
}
