//! What moves particles besides contacts: integration, gravity, damping, prescribed motion, the strain
//! of a cell.

use super::misfit::Fit;
use crate::control::Control;
use crate::engine::World;
use crate::engine::boundary::{Kind, Ring, Tensor};
use crate::engine::setup::{Body, Gravity};
use crate::record::number::real;

/// Groups of LAMMPS, but those used elsewhere.
const GROUPS: usize = 24;

/// The lines after the time step.
pub(super) fn fixes(world: &World, control: &Control, fit: &mut Fit) -> String {
    let mut text = prescribed(world, fit);
    let disc = match world.model().body {
        Body::Disc => " disc",
        Body::Sphere => "",
    };
    if world.model().rotation {
        text += &format!("fix motion free nve/sphere{disc}\n");
    } else {
        fit.maps("particles that do not turn");
        text += "fix motion free nve\n";
    }
    text += "fix plane all enforce2d\n";
    text += &gravity(world, fit);
    text += &applied(world, fit);
    text += &damping(world, fit);
    text += &boundary(world, fit);
    steering(control, fit);
    text
}

/// Groups of particles whose motion is prescribed in full or in part, and the group `free`.
fn prescribed(world: &World, fit: &mut Fit) -> String {
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
    let mut text = group("ring", &ring_ids) + &group("driven", &driven);
    let mut held = Vec::new();
    if !ring_ids.is_empty() {
        held.push("ring");
        text += &ring_motion(world, fit);
    }
    if !driven.is_empty() {
        held.push("driven");
        text += "fix driven driven nve/noforce\n";
        fit.maps("particles whose whole motion is prescribed: they keep velocity and spin");
    }
    if held.is_empty() {
        text += "group free union all\n";
    } else {
        text += &format!(
            "group held union {}\ngroup free subtract all held\n",
            held.join(" ")
        );
        // Contacts take the mass of a partner that is held as infinite.
        text += "fix held held freeze\n";
    }
    for (axis, force) in [(0, "0.0 NULL NULL"), (1, "NULL 0.0 NULL")] {
        let name = ["heldx", "heldy"][axis];
        let ids = listed(&|k| p.fixed[k][axis] && !p.is_driven(k) && !in_ring(k));
        if !ids.is_empty() {
            text += &group(name, &ids);
            text += &format!("fix {name} {name} setforce {force}\n");
            fit.maps("particles whose velocity in one direction is prescribed");
        }
    }
    if (0..p.len()).any(|k| p.fixed[k][2] && !p.is_driven(k) && !in_ring(k)) {
        fit.lacks(
            "particles whose spin alone is prescribed",
            "particles that turn as their contacts make them",
        );
    }
    text
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

/// Variables per particle with the velocity of a flow at their places.
fn flow(name: &str, rate: &Tensor, centre: [f64; 2]) -> String {
    let line = |axis: usize| {
        format!(
            "variable {name}{} atom \"-({}*(x-({}))+{}*(y-({})))\"\n",
            ["x", "y"][axis],
            real(rate[axis][0]),
            real(centre[0]),
            real(rate[axis][1]),
            real(centre[1])
        )
    };
    line(0) + &line(1)
}

/// Lines that put particles into a group, ranges as such.
fn group(name: &str, ids: &[u32]) -> String {
    let mut ranges: Vec<[u32; 2]> = Vec::new();
    for &id in ids {
        match ranges.last_mut() {
            Some([_, last]) if *last + 1 == id => *last = id,
            _ => ranges.push([id, id]),
        }
    }
    let mut text = String::new();
    for some in ranges.chunks(40) {
        let words: Vec<String> = (some.iter())
            .map(|[a, b]| {
                if a == b {
                    a.to_string()
                } else {
                    format!("{a}:{b}")
                }
            })
            .collect();
        text += &format!("group {name} id {}\n", words.join(" "));
    }
    text
}

fn gravity(world: &World, fit: &mut Fit) -> String {
    match world.model().gravity {
        None => String::new(),
        Some(Gravity::Uniform([x, y])) => {
            fit.maps("gravity");
            let g = (x * x + y * y).sqrt();
            format!(
                "fix gravity free gravity {} vector {} {} 0\n",
                real(g),
                real(x),
                real(y)
            )
        }
        Some(Gravity::Centripetal { towards, g }) => {
            fit.maps("gravity towards a point");
            let [x, y] = towards.map(real);
            format!(
                "variable far atom \"sqrt((x-({x}))^2+(y-({y}))^2)+1e-300\"\n\
                 variable pullx atom \"mass*{g}*(({x})-x)/v_far\"\n\
                 variable pully atom \"mass*{g}*(({y})-y)/v_far\"\n\
                 fix gravity free addforce v_pullx v_pully 0.0\n",
                g = real(g)
            )
        }
    }
}

/// Forces that particles were given.
fn applied(world: &World, fit: &mut Fit) -> String {
    let p = world.particles();
    let mut forces: Vec<[f64; 2]> = (0..p.len())
        .map(|q| p.applied(q))
        .filter(|f| *f != [0.0; 2])
        .collect();
    forces.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    forces.dedup();
    if forces.len() > GROUPS {
        fit.lacks(
            format!(
                "{} different applied forces: LAMMPS has 32 groups",
                forces.len()
            ),
            "no applied forces",
        );
        return String::new();
    }
    let mut text = String::new();
    for (k, force) in forces.iter().enumerate() {
        let ids: Vec<u32> = (0..p.len())
            .filter(|&q| p.applied(q) == *force)
            .map(|q| p.id[q])
            .collect();
        let name = format!("pulled{}", k + 1);
        text += &group(&name, &ids);
        text += &format!(
            "fix {name} {name} addforce {} {} 0.0\n",
            real(force[0]),
            real(force[1])
        );
        fit.maps("applied forces");
    }
    text
}

fn damping(world: &World, fit: &mut Fit) -> String {
    let damping = &world.model().damping;
    let mut text = String::new();
    if damping.local > 0.0 {
        fit.maps("local damping, as damping/cundall");
        let local = real(damping.local);
        text += &format!("fix local free damping/cundall {local} {local}\n");
    }
    let con1 = (1.0 - damping.con1) / world.dt();
    if damping.con1 != 1.0 {
        fit.lacks(
            "con1, which takes a share of every velocity in each cycle",
            "a force of (1 - con1)/dt times mass and velocity, against it",
        );
    }
    if damping.global > 0.0 {
        fit.lacks(
            "global damping, which damps spins too",
            "a force of alpha times mass and velocity, against it; spins are not damped",
        );
    }
    let drag = damping.global + con1;
    if drag > 0.0 {
        let rate = world.imposed_rate().unwrap_or([[0.0; 2]; 2]);
        let carried = world.cell().is_some();
        let rate = if carried { rate } else { [[0.0; 2]; 2] };
        let origin = world.origin();
        let centre = world.boundary().map_or([0.0; 2], |boundary| {
            [0, 1].map(|k| boundary.centre[k] + origin[k])
        });
        text += &flow("flow", &rate, centre);
        for axis in ["x", "y"] {
            let drag = real(drag);
            text += &format!("variable drag{axis} atom \"-{drag}*mass*(v{axis}-v_flow{axis})\"\n");
        }
        text += "fix drag free addforce v_dragx v_dragy 0.0\n";
    }
    text
}

fn boundary(world: &World, fit: &mut Fit) -> String {
    let mut text = String::new();
    if let Some(boundary) = world.boundary() {
        let rate = boundary.straining.target();
        if rate != boundary.straining.rate() {
            fit.differs("the strain rate is at its end at once: a ramp is not written");
        }
        match &boundary.kind {
            Kind::Cell(cell) => {
                let [a, b] = cell.edges;
                if a[1] != 0.0 || b[0] != 0.0 {
                    fit.refuses("a cell whose edges are not along x and y");
                }
                if rate[0][1] != 0.0 || rate[1][0] != 0.0 {
                    fit.lacks("shear of the cell", "its strain rate in x and y alone");
                }
                fit.maps("periodic cell, with its strain rate as fix deform ... trate ... remap v");
                fit.differs(
                    "velocities are whole there and those beside the flow here: inertia of the flow \
                     itself, of second order in the strain rate, is in LAMMPS alone",
                );
                if rate != [[0.0; 2]; 2] {
                    fit.differs(
                        "LAMMPS gives images of particles the velocity of the straining cell from \
                         its second step on: forces of the first compare in a cell at rest only",
                    );
                    text += &format!(
                        "fix cell all deform 1 x trate {} y trate {} remap v\n",
                        real(-rate[0][0]),
                        real(-rate[1][1])
                    );
                }
            }
            Kind::Walls if rate != [[0.0; 2]; 2] => fit.lacks(
                "walls that move as lines of a strained plane",
                "walls that keep the velocities they have now",
            ),
            Kind::Walls | Kind::Ring(_) => {}
        }
    }
    if world.continuum().is_some() && world.cell().is_none() {
        fit.lacks(
            "a continuum whose flow carries all particles",
            "particles with the velocity it gives them now, and no flow from there on",
        );
    }
    text
}

fn steering(control: &Control, fit: &mut Fit) {
    if control.servo.is_some() || !control.walls.is_empty() {
        fit.lacks(
            "servos: LAMMPS steers neither strain rate nor walls by these stresses",
            "what they impose now, from there on",
        );
    }
    if control.growth.is_some() {
        fit.lacks("radii that change", "radii as they are now");
    }
}
