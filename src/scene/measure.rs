//! `[[measure]]`: a region that stress, fabric and porosity are measured over.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape as Written};
use crate::measure::region::{Region, Shape};

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "measure",
    shape: Written::Listed,
    required: false,
    summary: "regions that are measured; the first is the default, without one it is everything",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        name: "name",
        form: Form::Text,
        unit: "-",
        absent: Absent::Wrong,
        summary: "name, as in region:NAME:porosity",
    },
    Key {
        name: "circle",
        form: Form::Table(CIRCLE),
        unit: "-",
        absent: Absent::Said("required without `rectangle`"),
        summary: "a circle",
    },
    Key {
        name: "rectangle",
        form: Form::Table(RECTANGLE),
        unit: "-",
        absent: Absent::Said("required without `circle`"),
        summary: "a rectangle along the axes",
    },
];

const CIRCLE: &[Key] = &[
    point("centre", "its centre"),
    Key {
        name: "radius",
        form: Form::Number(Bounds::POSITIVE),
        unit: "m",
        absent: Absent::Wrong,
        summary: "its radius",
    },
];

const RECTANGLE: &[Key] = &[
    point("min", "its lower left corner"),
    point("max", "its upper right corner"),
];

const fn point(name: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Vector,
        unit: "m",
        absent: Absent::Wrong,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let name = reader.text("name");
    if let Some((name, place)) = name {
        draft.check_column_name(name, place, "region", "region:NAME:porosity");
        let taken = draft.regions.iter().map(|region| region.name.as_str());
        let places = draft.region_places.iter().copied();
        draft.check_unique(name, place, taken.zip(places));
    }
    // A region that is wrong keeps its name, so that columns of it are not complained about too.
    let name = name.map_or_else(String::new, |(name, _)| name.to_owned());
    draft.known.names.regions.push(name.clone());
    draft.ever.regions.push(name.clone());
    draft.region_places.push(reader.place_of("name"));
    draft.regions.push(Region {
        name,
        shape: shape(reader).unwrap_or(Shape::All),
    });
}

fn shape(reader: &Reader<'_>) -> Option<Shape> {
    let Some(written) = reader.one_of(&["circle", "rectangle"]) else {
        reader.refuse(
            "",
            &format!("{} is nowhere", reader.title),
            "neither `circle` nor `rectangle` is given",
            "add circle = { centre = [x, y], radius = r } or rectangle = { min = [x, y], max = [x, y] }",
        );
        return None;
    };
    let table = reader.table(written)?;
    if written == "circle" {
        let (centre, radius) = (table.vector("centre"), table.number("radius"));
        return Some(Shape::Circle {
            centre: centre?,
            radius: radius?,
        });
    }
    let (min, max) = (table.vector("min"), table.vector("max"));
    let (min, max) = (min?, max?);
    if (0..2).any(|k| min[k] >= max[k]) {
        table.refuse(
            "max",
            &format!("{} has no area", reader.title),
            "expected numbers above those of `min`",
            "`min` is the lower left corner, `max` the upper right one",
        );
        return None;
    }
    Some(Shape::Rectangle { min, max })
}
