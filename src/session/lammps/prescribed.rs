//! Particles whose motion is prescribed, in full or in part.

use super::misfit::Fit;
use super::motion::{flow, group};
use crate::engine::World;
use crate::engine::boundary::Ring;

/// What prescribes motion, in three parts, as other lines come between them.
#[derive(Debug, Clone, Default)]
pub(super) struct Prescribed {
    /// Groups, among them `free` of all whose motion is not prescribed in full.
    pub(super) groups: String,
    /// Motion of those that are not free.
    pub(super) motion: String,
    /// What takes forces away again. LAMMPS lets fixes change forces in the order they are given: these
    /// come after all that add any.
    pub(super) holds: String,
}

/// Lines for particles whose motion is prescribed in full or in part.
pub(super) fn prescribed(world: &World, fit: &mut Fit) -> Prescribed {
    let p = world.particles();
    let ring = world.boundary().and_then(|boundary| boundary.ring());
    let in_ring = |k: usize| ring.is_some_and(|r| r.members.binary_search(&p.id[k]).is_ok());
    let listed = |wanted: &dyn Fn(usize) -> bool| -> Vec<u32> {
        (0..p.len())
            .filter(|&k| wanted(k))
            .map(|k| p.id[k])
            .collect()
    };
    let ring_ids = listed(&|k| in_ring(k));
    let driven = listed(&|k| p.is_driven(k) && !in_ring(k));
    let mut lines = Prescribed {
        groups: group("ring", &ring_ids) + &group("driven", &driven),
        ..Prescribed::default()
    };
    let mut held = Vec::new();
    if !ring_ids.is_empty() {
        held.push("ring");
        lines.motion += &ring_motion(world, fit);
    }
    if !driven.is_empty() {
        held.push("driven");
        lines.motion += "fix driven driven nve/noforce\n";
        fit.maps("particles whose whole motion is prescribed: they keep velocity and spin");
    }
    if held.is_empty() {
        lines.groups += "group free union all\n";
    } else {
        lines.groups += &format!(
            "group held union {}\ngroup free subtract all held\n",
            held.join(" ")
        );
        // Contacts take the mass of a partner that is held as infinite.
        lines.holds += "fix held held freeze\n";
    }
    for (axis, force) in [(0, "0.0 NULL NULL"), (1, "NULL 0.0 NULL")] {
        let name = ["heldx", "heldy"][axis];
        let ids = listed(&|k| p.fixed[k][axis] && !p.is_driven(k) && !in_ring(k));
        if !ids.is_empty() {
            lines.groups += &group(name, &ids);
            lines.holds += &format!("fix {name} {name} setforce {force}\n");
            fit.maps("particles whose velocity in one direction is prescribed");
        }
    }
    if (0..p.len()).any(|k| p.fixed[k][2] && !p.is_driven(k) && !in_ring(k)) {
        fit.lacks(
            "particles whose spin alone is prescribed",
            "particles that turn as their contacts make them",
        );
    }
    lines
}

fn ring_motion(world: &World, fit: &mut Fit) -> String {
    fit.lacks(
        "a ring of boundary particles, which others join when they leave it",
        "the particles of the ring now, moving as the strain rate says; nobody joins them, and what \
         stress they carry is not imposed",
    );
    let Some(boundary) = world.boundary() else {
        return String::new();
    };
    let loaded = boundary.ring().is_some_and(Ring::is_loaded);
    let rate = if loaded {
        [[0.0; 2]; 2]
    } else {
        boundary.straining.target()
    };
    let origin = world.origin();
    let centre = [0, 1].map(|k| boundary.centre[k] + origin[k]);
    flow("ring", &rate, centre)
        + "fix ring ring move variable NULL NULL NULL v_ringx v_ringy NULL\n"
}
