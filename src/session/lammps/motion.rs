//! What moves particles besides contacts: integration, gravity, applied forces, damping.

use super::misfit::Fit;
use super::prescribed::{Prescribed, prescribed};
use super::strain::{boundary, steering};
use crate::control::Control;
use crate::engine::World;
use crate::engine::boundary::Tensor;
use crate::engine::setup::{Body, Gravity};
use crate::record::number::real;

/// Groups of LAMMPS, but those used elsewhere.
const GROUPS: usize = 24;

/// The lines after the time step.
pub(super) fn fixes(world: &World, control: &Control, fit: &mut Fit) -> String {
    let Prescribed {
        groups,
        motion,
        holds,
    } = prescribed(world, fit);
    let mut text = groups + &motion;
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
    if !holds.is_empty() {
        text += "# last, whatever adds forces; where LAMMPS warns of that beside damping/cundall, it is meant\n";
        text += &holds;
    }
    steering(control, fit);
    text
}

/// Variables per particle with the velocity of a flow at their places.
pub(super) fn flow(name: &str, rate: &Tensor, centre: [f64; 2]) -> String {
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
pub(super) fn group(name: &str, ids: &[u32]) -> String {
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
