//! What a preset gives and its law has no use for.

use super::Report;
use crate::engine::World;

/// Warns of it.
pub(super) fn warn(report: &mut Report, world: &World) {
    let model = world.model();
    let law = model.law.card();
    let springs = model.law.has_constant_springs();
    let mut useless = |key: &str, of: &str, why: String| {
        let warning = format!("{key} of {of} does nothing: {why}");
        report.warnings.push(warning);
    };
    let frictionless = || format!("law {} has no tangential force", law.name);
    for material in &model.materials {
        if material.friction <= 0.0 || material.rigid {
            continue;
        }
        if !law.reads("friction") {
            useless("friction", &material.name, frictionless());
        } else if springs && material.shear_stiffness == Some(0.0) {
            let why = "shear_stiffness = 0 has no tangential force".to_owned();
            useless("friction", &material.name, why);
        }
    }
    for pair in &model.pairs {
        let [a, b] = pair.materials.map(|k| model.materials[k].name.as_str());
        let of = format!("the pair {a}, {b}");
        if pair.friction > Some(0.0) && !law.reads("friction") {
            useless("friction", &of, frictionless());
        }
        let given = [
            ("normal_stiffness", pair.normal_stiffness),
            ("shear_stiffness", pair.shear_stiffness),
        ];
        for (key, value) in given {
            if value.is_some() && !springs {
                let why = format!("law {} takes stiffness from moduli", law.name);
                useless(key, &of, why);
            }
        }
    }
}
