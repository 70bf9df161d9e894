//! Whether a whole state can go on in another scene: forces and what contacts remember must mean the
//! same there.

use super::trouble;
use crate::engine::World;
use crate::engine::setup::Material;
use crate::scene::{Scene, Trouble};

/// Why it cannot.
pub(super) fn misfit(world: &World, scene: &Scene) -> Option<Trouble> {
    if let Some(what) = change(world, scene) {
        return Some(trouble(
            "keep",
            format!("the state of the sample cannot go on here: {what}"),
            "forces and memory of its contacts would mean something else",
            "write keep = \"particles\": forces then follow anew from the overlaps, and the sample has to \
             come to rest again",
        ));
    }
    let unbooked = scene.setup.ledger && world.ledger().is_none();
    unbooked.then(|| {
        let columns = scene.booked_for().join(", ");
        trouble(
            "keep",
            format!("the run of the sample booked no energies, and this preset asks for {columns}"),
            "the bookings of its contacts would be missing",
            "name one of them in [history] columns of the run that makes the sample, or write keep = \
             \"particles\"",
        )
    })
}

/// The first difference between a world and a scene that gives the same overlaps other forces.
pub(super) fn change(world: &World, scene: &Scene) -> Option<String> {
    let (old, new) = (world.model(), &scene.setup);
    let model = [
        ("body", old.body == new.body),
        ("law", old.law == new.law),
        ("normal", old.normal == new.normal),
        ("unloading", old.unloading == new.unloading),
        ("nodes", old.nodes == new.nodes),
    ];
    if let Some((what, _)) = model.into_iter().find(|(_, same)| !same) {
        return Some(format!("model.{what} is another one"));
    }
    old.materials.iter().find_map(|material| {
        let name = &material.name;
        // What has no counterpart is a wall with a friction of its own, or nothing is made of it.
        let own = new.materials.iter().find(|own| own.name == *name)?;
        let what = difference(material, own)?;
        Some(format!("material.{name}.{what} is another one"))
    })
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
