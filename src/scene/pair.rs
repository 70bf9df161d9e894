//! `[[pair]]`: what two materials do differently from what each of them implies.

use super::draft::Draft;
use super::key::{Absent, Bounds, Form, Key};
use super::problem::Problem;
use super::reader::Reader;
use super::section::{Section, Shape};
use crate::engine::setup::PairOverride;

/// The declaration.
pub(crate) const SECTION: Section = Section {
    name: "pair",
    shape: Shape::Listed,
    required: false,
    summary: "what two materials do differently from what each of them implies",
    keys: KEYS,
    read,
};

const KEYS: &[Key] = &[
    Key {
        name: "materials",
        form: Form::TwoTexts,
        unit: "-",
        absent: Absent::Wrong,
        summary: "names of the two materials, which may be the same",
    },
    number(
        "friction",
        Bounds::NOT_NEGATIVE,
        "-",
        "the smaller of the two",
        "friction coefficient",
    ),
    number(
        "cohesion",
        Bounds::NOT_NEGATIVE,
        "N",
        "the smaller of the two",
        "cohesion in shear",
    ),
    number(
        "bond_tension",
        Bounds::NOT_NEGATIVE,
        "N",
        "the smaller of the two",
        "normal pull that a bond bears",
    ),
    number(
        "bond_shear",
        Bounds::NOT_NEGATIVE,
        "N",
        "the smaller of the two",
        "shear that a bond bears without normal force",
    ),
    number(
        "rolling_friction",
        Bounds::NOT_NEGATIVE,
        "-",
        "the smaller of the two",
        "coefficient of rolling friction",
    ),
    number(
        "restitution",
        super::damping::RESTITUTION,
        "-",
        "the damping of the scene",
        "coefficient of restitution of a normal impact",
    ),
    number(
        "normal_stiffness",
        Bounds::POSITIVE,
        "N/m",
        "2 k1 k2 / (k1 + k2)",
        "normal stiffness of the linear law",
    ),
    number(
        "shear_stiffness",
        Bounds::NOT_NEGATIVE,
        "N/m",
        "2 k1 k2 / (k1 + k2)",
        "shear stiffness of the linear law",
    ),
];

const fn number(
    name: &'static str,
    bounds: Bounds,
    unit: &'static str,
    absent: &'static str,
    summary: &'static str,
) -> Key {
    Key {
        name,
        form: Form::Number(bounds),
        unit,
        absent: Absent::Said(absent),
        summary,
    }
}

fn read<'a>(reader: &Reader<'a>, draft: &mut Draft<'a>) {
    let friction = reader.number("friction");
    let rolling_friction = reader.number("rolling_friction");
    let cohesion = reader.number("cohesion");
    let bond_tension = reader.number("bond_tension");
    let bond_shear = reader.number("bond_shear");
    let restitution = reader.number("restitution");
    let normal_stiffness = reader.number("normal_stiffness");
    let shear_stiffness = reader.number("shear_stiffness");
    if KEYS[1..].iter().all(|key| !reader.has(key.name)) {
        let overrides: Vec<&str> = KEYS[1..].iter().map(|key| key.name).collect();
        reader.refuse(
            "",
            &format!("{} overrides nothing", reader.title),
            "only `materials` is given",
            &format!("add one of {}", overrides.join(", ")),
        );
    }
    let Some(names) = reader.texts("materials") else {
        return;
    };
    let [(first, here), (second, there)] = names.as_slice() else {
        return;
    };
    let first = draft.material(first, *here, reader);
    let second = draft.material(second, *there, reader);
    let (Some(first), Some(second)) = (first, second) else {
        return;
    };
    let materials = [first.min(second), first.max(second)];
    if draft.setup.pairs.iter().any(|p| p.materials == materials) {
        draft.report.add(
            Problem::new(
                format!("{} names a pair that an earlier one names", reader.title),
                reader.place_of("materials"),
            )
            .expected("a second [[pair]] of these materials")
            .remedy("merge the two tables; the order of the names does not matter"),
        );
    }
    draft.setup.pairs.push(PairOverride {
        materials,
        friction,
        rolling_friction,
        cohesion,
        bond_tension,
        bond_shear,
        restitution,
        normal_stiffness,
        shear_stiffness,
    });
}
