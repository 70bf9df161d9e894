//! `[cell]`: a periodic cell.

use super::boundary::{STRAIN_RATE, strain_rate};
use super::draft::Draft;
use super::key::{Absent, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::{BoundarySetup, WallSetup};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "cell",
    shape: Shape::Single,
    required: false,
    summary: "a periodic cell: what leaves through one side comes in through the opposite one",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        absent: Absent::Said("no cell"),
        ..vector("size", "its edges along 1 and 2")
    },
    vector("corner", "its lower left corner"),
    Key {
        absent: Absent::Said("[0, 0]"),
        ..vector(
            "lean",
            "what its second edge leans by: shifts edge 2 along 1, edge 1 along 2",
        )
    },
    STRAIN_RATE,
];

const fn vector(name: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Vector,
        unit: "m",
        absent: Absent::Zero,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    if !reader.has("size") {
        for key in ["corner", "lean", "strain_rate"] {
            if reader.has(key) {
                reader.refuse(
                    key,
                    &format!("`{key}` of {} is without effect", reader.title),
                    "there is no `size`",
                    "add size = [width, height]",
                );
                return;
            }
        }
        return;
    }
    let corner = reader.vector("corner").unwrap_or_default();
    let lean = if reader.has("lean") {
        reader.vector("lean").unwrap_or_default()
    } else {
        [0.0; 2]
    };
    draft.setup.strain_rate = strain_rate(reader);
    let Some(size) = reader.vector("size") else {
        return;
    };
    let edges = [[size[0], lean[1]], [lean[0], size[1]]];
    let area = edges[0][0] * edges[1][1] - edges[0][1] * edges[1][0];
    if size[0] <= 0.0 || size[1] <= 0.0 || area <= 0.0 {
        reader.refuse(
            "size",
            "the cell has no area",
            "expected two lengths above 0",
            "write size = [width, height] in m",
        );
        return;
    }
    if draft.setup.boundary.is_some() && draft.sampled == [0, 0] {
        reader.refuse(
            "size",
            "a periodic cell leaves nothing for [boundary] to hold",
            "not together with [boundary]",
            "keep [cell] or [boundary], whichever is meant",
        );
        return;
    }
    let ends = |wall: &WallSetup| (wall.h2 - wall.h1).is_finite();
    if let Some(wall) = draft.setup.walls.iter().find(|wall| ends(wall)) {
        reader.refuse(
            "size",
            &format!(
                "wall `{}` ends, and a periodic cell has no place for ends",
                wall.name
            ),
            "walls are not repeated in the images of the cell",
            "leave the wall out, or let it run from h1 = -inf to h2 = inf along an edge",
        );
        return;
    }
    draft.set_boundary(BoundarySetup::Cell { corner, edges });
}
