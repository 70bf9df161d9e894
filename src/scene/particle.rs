//! `[[particle]]`: one particle, numbered from 1 in the order of the preset.

use super::draft::{Draft, Mark};
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::ParticleSetup;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "particle",
    shape: Shape::Listed,
    required: false,
    summary: "one particle; they are numbered from 1 in the order of the preset, before generated ones",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        absent: Absent::Wrong,
        ..vector("at", "m", "position of the centre")
    },
    Key {
        form: Form::Number(Bounds::POSITIVE),
        absent: Absent::Wrong,
        ..vector("radius", "m", "radius of the particle")
    },
    Key {
        form: Form::Text,
        absent: Absent::Wrong,
        ..vector("material", "-", "name of the material")
    },
    vector("velocity", "m/s", "velocity at the start"),
    number("spin", "rad/s", "spin at the start, counter-clockwise"),
    number("angle", "rad", "angle at the start, counter-clockwise"),
    vector("force", "N", "applied force"),
    Key {
        form: Form::Flag,
        absent: Absent::Flag(false),
        ..vector(
            "driven",
            "-",
            "mark of a particle that keeps its velocity and spin: all three are fixed",
        )
    },
    Key {
        form: Form::Words(FREEDOMS),
        absent: Absent::Said("[]"),
        ..vector(
            "fixed",
            "-",
            "velocity components that are prescribed: they keep their given value; dashpots \
             take a particle for immovable if both x and y are",
        )
    },
];

/// The degrees of freedom, in the order of [`ParticleSetup::fixed`].
const FREEDOMS: &[&str] = &["x", "y", "spin"];

/// How many radii from the origin a centre may be: at 1e12 a double resolves 1e-4 of the radius,
/// and overlaps beyond would be rounding.
const FARTHEST: f64 = 1e12;

const fn vector(name: &'static str, unit: &'static str, summary: &'static str) -> Key {
    Key {
        name,
        form: Form::Vector,
        unit,
        absent: Absent::Zero,
        summary,
    }
}

const fn number(name: &'static str, unit: &'static str, summary: &'static str) -> Key {
    Key {
        form: Form::Number(Bounds::FINITE),
        absent: Absent::Number(0.0),
        ..vector(name, unit, summary)
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let (at, radius) = (reader.vector("at"), reader.number("radius"));
    if let (Some(at), Some(radius)) = (at, radius)
        && at.iter().any(|x| x.abs() > FARTHEST * radius)
    {
        reader.refuse(
            "at",
            &format!("the centre of {} is too far away", reader.title),
            "expected less than 1e12 radii from the origin",
            "move the scene towards the origin: overlaps would be lost in rounding",
        );
    }
    let material = reader
        .text("material")
        .and_then(|(name, place)| draft.material(name, place, reader));
    if let Some(index) = material
        && draft.setup.materials[index].rigid
    {
        reader.refuse(
            "material",
            &format!("{} cannot be rigid", reader.title),
            "a rigid material is for walls only",
            "choose a material with a stiffness; `driven = true` makes a particle immovable",
        );
    }
    let (velocity, force) = (reader.vector("velocity"), reader.vector("force"));
    let (spin, angle) = (reader.number("spin"), reader.number("angle"));
    let fixed = fixed(reader);
    if fixed == [true; 3] && force.is_some_and(|force| force != [0.0; 2]) {
        reader.refuse(
            "force",
            &format!("a force cannot move {}: it is fixed", reader.title),
            "without effect",
            "leave `force` out, or fix less",
        );
    }
    if !draft.setup.rotation && spin.is_some_and(|spin| spin != 0.0) {
        reader.refuse(
            "spin",
            &format!("{} spins in a scene without rotation", reader.title),
            "expected 0, or no `spin`",
            "leave `spin` out, or write rotation = true in [model]",
        );
    }
    let number = draft.next_number();
    draft.setup.particles.push(ParticleSetup {
        at: at.unwrap_or_default(),
        radius: radius.unwrap_or_default(),
        material: material.unwrap_or_default(),
        velocity: velocity.unwrap_or_default(),
        spin: spin.unwrap_or_default(),
        angle: angle.unwrap_or_default(),
        force: force.unwrap_or_default(),
        fixed,
    });
    draft.known.names.particles.push(number);
    draft.ever.particles.push(number);
    draft.particles.push(Mark {
        place: reader.place_of("at"),
        sound: at.is_some() && radius.is_some() && material.is_some() && reader.is_sound(),
    });
}

fn fixed(reader: &Reader<'_>) -> [bool; 3] {
    let driven = reader.flag("driven").unwrap_or_default();
    let words = reader.words("fixed").unwrap_or_default();
    if driven {
        if reader.has("fixed") {
            reader.one_of(&["driven", "fixed"]);
        }
        return [true; 3];
    }
    let mut fixed = [false; 3];
    for (freedom, name) in fixed.iter_mut().zip(FREEDOMS) {
        *freedom = words.contains(name);
    }
    fixed
}
