//! `[material.NAME]`: density, elasticity and friction.

use super::draft::{Draft, Mark};
use super::key::{Absent, Bounds, Form, Key};
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::Material;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "material",
    shape: Shape::Named,
    required: true,
    summary: "density, elasticity and friction",
    keys: KEYS,
    read,
};

const LAW_SAYS: Absent = Absent::Said("required if the law or the time step uses it");

const KEYS: &[Key] = &[
    number(
        "density",
        Bounds::POSITIVE,
        "kg/m^3",
        Absent::Said("required unless rigid"),
        "mass per volume",
    ),
    number("young", Bounds::POSITIVE, "Pa", LAW_SAYS, "Young's modulus"),
    number(
        "poisson",
        Bounds::above(-1.0, 0.5),
        "-",
        LAW_SAYS,
        "Poisson's ratio",
    ),
    number(
        "friction",
        Bounds::NOT_NEGATIVE,
        "-",
        Absent::Number(0.0),
        "friction coefficient; a pair uses the smaller",
    ),
    number(
        "cohesion",
        Bounds::NOT_NEGATIVE,
        "N",
        Absent::Number(0.0),
        "cohesion of a touching contact in shear; a pair uses the smaller",
    ),
    number(
        "bond_tension",
        Bounds::NOT_NEGATIVE,
        "N",
        Absent::Number(0.0),
        "normal pull that a bond bears; a pair uses the smaller",
    ),
    number(
        "bond_shear",
        Bounds::NOT_NEGATIVE,
        "N",
        Absent::Number(0.0),
        "shear that a bond bears without normal force; a pair uses the smaller",
    ),
    number(
        "rolling_friction",
        Bounds::NOT_NEGATIVE,
        "-",
        Absent::Number(0.0),
        "coefficient of rolling friction; a pair uses the smaller",
    ),
    number(
        "normal_stiffness",
        Bounds::POSITIVE,
        "N/m",
        LAW_SAYS,
        "normal stiffness of the linear law",
    ),
    number(
        "shear_stiffness",
        Bounds::NOT_NEGATIVE,
        "N/m",
        Absent::Said("required for the linear law with friction, cohesion or bonds"),
        "shear stiffness of the linear law",
    ),
    Key {
        name: "rigid",
        form: Form::Flag,
        unit: "-",
        absent: Absent::Flag(false),
        summary: "mark of an infinitely stiff partner, for walls only",
    },
];

const fn number(
    name: &'static str,
    bounds: Bounds,
    unit: &'static str,
    absent: Absent,
    summary: &'static str,
) -> Key {
    Key {
        name,
        form: Form::Number(bounds),
        unit,
        absent,
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let Some(entry) = reader.entry else {
        return;
    };
    draft.check_name(&entry.key, entry.place);
    let taken = draft.setup.materials.iter().map(|m| m.name.as_str());
    let places = draft.materials.iter().map(|mark| mark.place);
    draft.check_unique(&entry.key, entry.place, taken.zip(places));

    let rigid = reader.flag("rigid");
    let density = reader.number("density");
    if rigid == Some(true) {
        refuse_stiffness(reader);
    } else if !reader.has("density") {
        reader.refuse(
            "density",
            &format!("{} has no `density`", reader.title),
            "`density` is missing here",
            "add density = number > 0 [kg/m^3], or rigid = true if it is for walls only",
        );
    }
    let (friction, cohesion) = (reader.number("friction"), reader.number("cohesion"));
    draft.setup.materials.push(Material {
        name: entry.key.clone(),
        density: density.unwrap_or_default(),
        young: reader.number("young"),
        poisson: reader.number("poisson"),
        friction: friction.unwrap_or_default(),
        cohesion: cohesion.unwrap_or_default(),
        bond_tension: reader.number("bond_tension").unwrap_or_default(),
        bond_shear: reader.number("bond_shear").unwrap_or_default(),
        normal_stiffness: reader.number("normal_stiffness"),
        shear_stiffness: reader.number("shear_stiffness"),
        rolling_friction: reader.number("rolling_friction").unwrap_or_default(),
        rigid: rigid.unwrap_or_default(),
    });
    draft.known.names.materials.push(entry.key.clone());
    draft.ever.materials.push(entry.key.clone());
    draft.materials.push(Mark {
        place: entry.place,
        // A stiffness that could not be read is not missing.
        sound: reader.is_sound(),
    });
}

fn refuse_stiffness(reader: &Reader<'_>) {
    for name in ["young", "poisson", "normal_stiffness", "shear_stiffness"] {
        if reader.has(name) {
            reader.refuse(
                name,
                &format!("`{name}` of {} contradicts rigid = true", reader.title),
                "a rigid material has no stiffness of its own",
                &format!("leave `{name}` out, or write rigid = false"),
            );
        }
    }
}
