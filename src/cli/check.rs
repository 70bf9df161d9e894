//! `ballast check`: what a preset models, what it costs, and how its time step stands.

use std::fmt::Write;
use std::time::{Duration, Instant};

use super::output::{complain, load, print};
use super::{BAD_INPUT, Check, FAILED};
use crate::engine::World;
use crate::engine::neighbours::list::ContactList;
use crate::engine::particles::{Mobility, Row, Sum};
use crate::engine::setup::{Body, Dashpot, NormalForm, TimeStepChoice};
use crate::scene::Scene;

/// The speed is measured for so long.
const TRIAL: Duration = Duration::from_millis(100);

/// Checks it; answers the exit status.
pub(super) fn check(options: &Check) -> u8 {
    let Some(scene) = load(&options.preset, &options.set) else {
        return BAD_INPUT;
    };
    let world = match World::build(scene.setup.clone(), 1) {
        Ok(world) => world,
        Err(fault) => {
            complain(&fault.to_string());
            return FAILED;
        }
    };
    let mut text = String::new();
    let _ = writeln!(text, "{}: {}", scene.name, scene.about.title);
    modelled(&mut text, &world);
    sizes(&mut text, &world);
    step(&mut text, &world);
    time(&mut text, &scene, world);
    print(&text);
    0
}

fn modelled(text: &mut String, world: &World) {
    let (model, plan) = (world.model(), world.plan());
    let (mut yes, mut no) = (Vec::new(), Vec::new());
    let mut note = |is: bool, what: &str| {
        if is {
            yes.push(what.to_owned())
        } else {
            no.push(what.to_owned())
        }
    };
    note(
        true,
        if model.body == Body::Disc {
            "discs"
        } else {
            "spheres in a plane"
        },
    );
    note(true, "linear law");
    note(
        plan.normal == NormalForm::Incremental,
        "incremental normal force",
    );
    note(plan.friction, "friction and tangential forces");
    note(model.rotation && plan.friction, "spin");
    note(plan.dashpots, "contact dashpots");
    note(
        model.damping.wall.is_some_and(|w| w != Dashpot::None),
        "separate wall damping",
    );
    note(model.damping.global != 0.0, "global damping");
    note(model.damping.local != 0.0, "local damping");
    note(model.damping.con1 != 1.0, "CON1 damping");
    note(model.gravity.is_some(), "gravity");
    note(!world.walls().is_empty(), "walls");
    note(plan.ledger, "energy ledger");
    let _ = writeln!(text, "modelled:      {}", yes.join(", "));
    let _ = writeln!(text, "not modelled:  {}", no.join(", "));
}

fn sizes(text: &mut String, world: &World) {
    let (p, list) = (world.particles(), world.contacts());
    let _ = writeln!(
        text,
        "sizes:         {} particles, {} walls, {} contacts listed within TOL = {:.3e} m",
        p.len(),
        world.walls().len(),
        list.len(),
        world.tol()
    );
    let [contact, index] = ContactList::bytes();
    let particle = size_of::<Row>()
        + size_of::<Mobility>()
        + size_of::<Sum>()
        + index
        + if p.body.is_empty() {
            0
        } else {
            size_of::<[f64; 2]>()
        }
        + size_of::<(u32, f64, f64, u16, [f64; 2], [bool; 3])>();
    let [law, memory, book] = world.pass().bytes();
    let contact = contact + law + 2 * (memory + book);
    let total = (particle * p.len() + contact * list.len()) as f64 / 1024.0;
    let _ = writeln!(
        text,
        "memory:        {particle} bytes per particle, {contact} per contact \
         ({memory} of them the law's memory), {total:.1} KiB in all"
    );
}

fn step(text: &mut String, world: &World) {
    let model = world.model();
    let kind = match model.time_step {
        TimeStepChoice::Rayleigh => "Rayleigh step",
        TimeStepChoice::RayleighExact => "Rayleigh step (exact)",
        TimeStepChoice::Critical => "critical step 2 sqrt(m/k)",
        TimeStepChoice::Seconds(_) => "given step",
    };
    let limit = world.frac_limit();
    let _ = writeln!(
        text,
        "time step:     dt = {:.6e} s = {} x {kind} {:.6e} s",
        world.dt(),
        model.frac,
        world.base_step()
    );
    let verdict = if model.frac > limit {
        "  ABOVE THE LIMIT: expect instability"
    } else {
        ""
    };
    let limit = if limit.is_finite() {
        format!("{limit:.4}")
    } else {
        "none yet, nothing touches".into()
    };
    let _ = writeln!(
        text,
        "frac limit:    {limit} by the stiffness bound of the contacts at the start{verdict}"
    );
}

fn time(text: &mut String, scene: &Scene, mut world: World) {
    let cycles: Option<u64> = scene.stages.iter().map(|stage| stage.max_cycles).sum();
    let (start, mut done) = (Instant::now(), 0u64);
    while start.elapsed() < TRIAL {
        if world.cycle().is_err() {
            break;
        }
        done += 1;
    }
    let rate = done as f64 / start.elapsed().as_secs_f64();
    let length = match cycles {
        Some(cycles) if cycles > 0 => format!(
            "{cycles} cycles at most, {:.3e} s simulated, about {:.1} s at {rate:.0} cycles/s here",
            cycles as f64 * world.dt(),
            cycles as f64 / rate
        ),
        _ => format!("no end given; {rate:.0} cycles/s here"),
    };
    let names: Vec<&str> = scene
        .stages
        .iter()
        .map(|stage| stage.name.as_str())
        .collect();
    let _ = writeln!(
        text,
        "stages:        {}",
        if names.is_empty() {
            "none".into()
        } else {
            names.join(", ")
        }
    );
    let _ = writeln!(text, "length:        {length}");
}
