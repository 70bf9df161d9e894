//! `[[wall]]`: a straight wall, from one point to another or along a direction.

use super::draft::{Draft, Mark};
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::WallSetup;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "wall",
    shape: Shape::Listed,
    required: false,
    summary: "a straight two-sided wall: from/to, or point/direction with h1 and h2",
    keys: KEYS,
    read,
};

const EITHER: Absent = Absent::Said("required: from and to, or point and direction");

const KEYS: &[Key] = &[
    Key {
        form: Form::Text,
        absent: Absent::Wrong,
        ..vector("name", "-", "name in columns and commands")
    },
    Key {
        form: Form::Text,
        absent: Absent::Wrong,
        ..vector("material", "-", "name of the material")
    },
    Key {
        absent: EITHER,
        ..vector("from", "m", "one end")
    },
    Key {
        absent: EITHER,
        ..vector("to", "m", "other end")
    },
    Key {
        absent: EITHER,
        ..vector("point", "m", "point P of the line")
    },
    Key {
        absent: EITHER,
        ..vector(
            "direction",
            "-",
            "direction e of the line, of any length but 0",
        )
    },
    Key {
        form: Form::Number(Bounds::ANY),
        absent: Absent::Number(f64::NEG_INFINITY),
        ..vector("h1", "m", "beginning of the wall, at P + h1 e")
    },
    Key {
        form: Form::Number(Bounds::ANY),
        absent: Absent::Number(f64::INFINITY),
        ..vector("h2", "m", "end of the wall, at P + h2 e")
    },
    vector("velocity", "m/s", "velocity"),
    Key {
        form: Form::Number(Bounds::FINITE),
        absent: Absent::Number(0.0),
        ..vector(
            "angular_velocity",
            "rad/s",
            "angular velocity about `about`, counter-clockwise",
        )
    },
    Key {
        absent: Absent::Said("`from` or `point`"),
        ..vector(
            "about",
            "m",
            "point the wall turns about and moments refer to",
        )
    },
];

const fn vector(name: &'static str, unit: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Vector,
        unit,
        absent: Absent::Zero,
        summary,
    }
}

/// The part of a line that is wall.
struct Course {
    point: [f64; 2],
    direction: [f64; 2],
    h1: f64,
    h2: f64,
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let name = reader.text("name");
    if let Some((name, place)) = name {
        draft.check_column_name(name, place, "wall", "wall:NAME:f1");
        let taken = draft.setup.walls.iter().map(|wall| wall.name.as_str());
        let places = draft.walls.iter().map(|mark| mark.place);
        draft.check_unique(name, place, taken.zip(places));
    }
    let material = reader
        .text("material")
        .and_then(|(name, place)| draft.material(name, place, reader));
    let course = course(reader);
    let (velocity, about) = (reader.vector("velocity"), reader.vector("about"));
    let angular_velocity = reader.number("angular_velocity");
    let sound = reader.is_sound() && course.is_some();
    let course = course.unwrap_or(Course {
        point: [0.0; 2],
        direction: [1.0, 0.0],
        h1: 0.0,
        h2: 0.0,
    });
    let name = name.map_or_else(String::new, |(name, _)| name.to_owned());
    draft.known.names.walls.push(name.clone());
    draft.ever.walls.push(name.clone());
    draft.setup.walls.push(WallSetup {
        name,
        material: material.unwrap_or_default(),
        point: course.point,
        direction: course.direction,
        h1: course.h1,
        h2: course.h2,
        velocity: velocity.unwrap_or_default(),
        angular_velocity: angular_velocity.unwrap_or_default(),
        about: about.unwrap_or(course.point),
    });
    draft.walls.push(Mark {
        place: reader.place_of("name"),
        sound,
    });
}

fn course(reader: &Reader<'_>) -> Option<Course> {
    let ends = ["from", "to"].map(|name| (name, reader.vector(name)));
    let line = ["point", "direction"].map(|name| (name, reader.vector(name)));
    let (h1, h2) = (reader.number("h1"), reader.number("h2"));
    let by_ends = ends.iter().any(|(name, _)| reader.has(name));
    let mixed = ["point", "direction", "h1", "h2"]
        .into_iter()
        .find(|name| reader.has(name));
    if let (true, Some(other)) = (by_ends, mixed) {
        let end = if reader.has("from") { "from" } else { "to" };
        reader.one_of(&[end, other]);
        return None;
    }
    let needed = if by_ends { &ends } else { &line };
    for (name, _) in needed.iter().filter(|(name, _)| !reader.has(name)) {
        reader.refuse(
            name,
            &format!("{} has no `{name}`", reader.title),
            &format!("`{name}` is missing here"),
            "give `from` and `to`, or `point` and `direction` with h1 and h2",
        );
    }
    let [(_, first), (second_name, second)] = *needed;
    let (first, second) = (first?, second?);
    let along = if by_ends {
        [second[0] - first[0], second[1] - first[1]]
    } else {
        second
    };
    let length = libm::hypot(along[0], along[1]);
    if !(length > 0.0 && length.is_finite()) {
        reader.refuse(
            second_name,
            &format!("{} has no direction", reader.title),
            if by_ends {
                "expected a point other than `from`"
            } else {
                "expected a vector other than [0, 0]"
            },
            "a wall needs two different points, or a direction and a length",
        );
        return None;
    }
    let (h1, h2) = if by_ends { (0.0, length) } else { (h1?, h2?) };
    if h1 >= h2 || h1 == f64::INFINITY || h2 == f64::NEG_INFINITY {
        reader.refuse(
            if reader.has("h2") { "h2" } else { "h1" },
            &format!(
                "{} ends before it begins: h1 = {h1}, h2 = {h2}",
                reader.title
            ),
            "expected h1 < h2",
            "exchange h1 and h2, or leave one out: -inf to inf is the whole line",
        );
        return None;
    }
    Some(Course {
        point: first,
        direction: along.map(|component| component / length),
        h1,
        h2,
    })
}
