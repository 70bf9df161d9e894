//! `[boundary]`: what strain and stress are imposed by, if it is not a periodic cell.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::{BoundarySetup, Tensor};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "boundary",
    shape: Shape::Single,
    required: false,
    summary: "a ring of particles or the walls, by which strain and stress are imposed",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        name: "kind",
        form: Form::Word(&["circle", "walls"]),
        unit: "-",
        absent: Absent::Said("none"),
        summary: "\"circle\": a ring of all particles with their centre outside; \"walls\": the walls",
    },
    Key {
        name: "radius",
        form: Form::Number(Bounds::POSITIVE),
        unit: "m",
        absent: Absent::Said("required for a circle"),
        summary: "radius of the circle",
    },
    Key {
        name: "centre",
        form: Form::Vector,
        unit: "m",
        absent: Absent::Zero,
        summary: "centre; the imposed strain leaves it where it is",
    },
    Key {
        name: "turning",
        form: Form::Flag,
        unit: "-",
        absent: Absent::Flag(false),
        summary: "whether particles of the ring may turn",
    },
    STRAIN_RATE,
];

/// `strain_rate`, of this table and of [cell].
pub(super) const STRAIN_RATE: Key = Key {
    name: "strain_rate",
    form: Form::Numbers(Bounds::FINITE),
    unit: "1/s",
    absent: Absent::Said("[0, 0, 0, 0]"),
    summary: "strain rate from the start: components 11, 12, 21, 22, compression positive",
};

/// The strain rate of a table.
pub(super) fn strain_rate(reader: &Reader<'_>) -> Tensor {
    let Some(rate) = reader.numbers("strain_rate") else {
        return [[0.0; 2]; 2];
    };
    if let [e11, e12, e21, e22] = rate[..] {
        return [[e11, e12], [e21, e22]];
    }
    reader.refuse(
        "strain_rate",
        &format!(
            "`strain_rate` of {} has {} numbers",
            reader.title,
            rate.len()
        ),
        "expected four: components 11, 12, 21, 22",
        "[0.1, 0, 0, 0.1] compresses both directions alike",
    );
    [[0.0; 2]; 2]
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let Some(kind) = reader.word("kind") else {
        for key in ["radius", "centre", "turning", "strain_rate"] {
            if reader.has(key) && !reader.has("kind") {
                reader.refuse(
                    key,
                    &format!("`{key}` of {} is without effect", reader.title),
                    "there is no `kind`",
                    "add kind = \"circle\" or kind = \"walls\"",
                );
                break;
            }
        }
        return;
    };
    let centre = reader.vector("centre").unwrap_or_default();
    let radius = reader.number("radius");
    draft.setup.strain_rate = strain_rate(reader);
    if kind == "walls" {
        for key in ["radius", "turning"] {
            if reader.has(key) {
                reader.refuse(
                    key,
                    &format!("walls have no `{key}`"),
                    "not expected here",
                    "leave it out, or write kind = \"circle\"",
                );
            }
        }
        draft.set_boundary(BoundarySetup::Walls { centre });
        return;
    }
    if radius.is_none() && !reader.has("radius") {
        reader.refuse(
            "kind",
            "a circle needs a `radius`",
            "`radius` is missing",
            "add radius = number [m]",
        );
    }
    draft.set_boundary(BoundarySetup::Ring {
        centre,
        radius: radius.unwrap_or(1.0),
        turning: reader.flag("turning").unwrap_or_default(),
    });
}
