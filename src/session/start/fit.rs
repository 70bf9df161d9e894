//! Whether a whole state can go on in another scene: forces and what contacts remember must mean the
//! same there.

use super::trouble;
use crate::engine::World;
use crate::engine::setup::Material;
use crate::scene::{Scene, Trouble};

/// The first reason why it cannot.
pub(super) fn misfit(world: &World, scene: &Scene) -> Option<Trouble> {
    let (old, new) = (world.model(), &scene.setup);
    let refuse = |what: String| {
        Some(trouble(
            "keep",
            format!("the state of the sample cannot go on here: {what}"),
            "forces and memory of its contacts would mean something else",
            "write keep = \"particles\": forces then follow anew from the overlaps, and the sample \
             has to come to rest again",
        ))
    };
    for (what, same) in [
        ("body", old.body == new.body),
        ("law", old.law == new.law),
        ("normal", old.normal == new.normal),
        ("unloading", old.unloading == new.unloading),
        ("nodes", old.nodes == new.nodes),
    ] {
        if !same {
            return refuse(format!("model.{what} is another one"));
        }
    }
    if new.ledger && world.ledger().is_none() {
        return refuse("its run booked no energies, and this preset asks for some".into());
    }
    for material in &old.materials {
        let name = material.name.as_str();
        let Some(own) = new.materials.iter().find(|own| own.name == name) else {
            // A wall with a friction of its own; or a material that nothing is made of.
            continue;
        };
        if let Some(what) = difference(material, own) {
            return refuse(format!("material.{name}.{what} is another one"));
        }
    }
    None
}

/// What of the stiffness or mass of a material differs.
fn difference(a: &Material, b: &Material) -> Option<&'static str> {
    let same = [
        ("density", a.density == b.density),
        ("young", a.young == b.young),
        ("poisson", a.poisson == b.poisson),
        ("normal_stiffness", a.normal_stiffness == b.normal_stiffness),
        ("shear_stiffness", a.shear_stiffness == b.shear_stiffness),
        ("rigid", a.rigid == b.rigid),
    ];
    let found = same.into_iter().find(|(_, same)| !same);
    found.map(|(what, _)| what)
}
