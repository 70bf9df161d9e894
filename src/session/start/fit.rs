//! Whether a whole state can go on in another scene: forces and what contacts remember must mean the
//! same there.

use super::trouble;
use crate::engine::World;
use crate::engine::setup::{Material, PairOverride};
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
    // What has no counterpart is a wall with a friction of its own, or nothing is made of it.
    let counterpart = |name: &str| new.materials.iter().position(|own| own.name == name);
    let common: Vec<[usize; 2]> = (old.materials.iter().enumerate())
        .filter_map(|(k, material)| Some([k, counterpart(&material.name)?]))
        .collect();
    let material = |&[k, own]: &[usize; 2]| {
        let (a, b) = (&old.materials[k], &new.materials[own]);
        let what = difference(a, b)?;
        Some(format!("material.{}.{what} is another one", a.name))
    };
    let pair = |[a, b]: [[usize; 2]; 2]| {
        let what = pair_difference(old.pair([a[0], b[0]]), new.pair([a[1], b[1]]))?;
        let [a, b] = [a, b].map(|[k, _]| &old.materials[k].name);
        Some(format!("{what} of the [[pair]] {a}, {b} is another one"))
    };
    let pairs = |(k, &a): (usize, &[usize; 2])| common[k..].iter().find_map(|&b| pair([a, b]));
    (common.iter().find_map(material)).or_else(|| common.iter().enumerate().find_map(pairs))
}

/// What of the stiffness that overrides give to a pair differs.
fn pair_difference(a: Option<&PairOverride>, b: Option<&PairOverride>) -> Option<&'static str> {
    let normal = |pair: Option<&PairOverride>| pair.and_then(|pair| pair.normal_stiffness);
    let shear = |pair: Option<&PairOverride>| pair.and_then(|pair| pair.shear_stiffness);
    if normal(a) != normal(b) {
        Some("normal_stiffness")
    } else if shear(a) != shear(b) {
        Some("shear_stiffness")
    } else {
        None
    }
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
